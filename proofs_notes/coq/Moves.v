(** * Moves that exchange one set of simplices for another keep the Euler characteristic

    Clauses: OPER-MOVE-6 for bistellar moves and for subdivisions and welds (OPER-BISTELLAR-1,
    OPER-STELLAR-1, OPER-STELLAR-2): the simplices that go and those that come are written out as
    the clauses have them, what stays is any list. Collapses and expansions are in [Collapse]. *)

Require Import ZArith List Lia Arith Bool Permutation.
From Clers Require Import Complex Collapse.
Import ListNotations.
Open Scope Z_scope.

(** The union of two sets of vertices. *)
Definition join (s t : simplex) : simplex := fold_right insert t s.
Definition apart (s t : simplex) : Prop := forall x, In x s -> ~ In x t.

(** The proper subsets of a set, the empty one among them: ∂s in the sense of OPER-MOVE-1. *)
Definition proper_subsets (s : simplex) : list simplex :=
  filter (fun t => negb (is t s)) (subsets s).

Lemma in_join : forall s t x, In x (join s t) <-> In x s \/ In x t.
Proof.
  induction s as [|y s IH]; intros t x; cbn [join fold_right].
  - cbn [In]; tauto.
  - fold (join s t); rewrite in_insert, IH; cbn [In]; intuition.
Qed.

Lemma parity_insert : forall x s, ~ In x s -> parity (insert x s) = - parity s.
Proof.
  intros x s N; unfold parity; rewrite length_insert by auto.
  rewrite Nat.even_succ, <- Nat.negb_even; destruct (Nat.even (length s)); reflexivity.
Qed.

(** The size of a union of sets that have nothing in common is the sum of their sizes. *)
Lemma parity_join : forall s t, NoDup s -> apart s t -> parity (join s t) = parity s * parity t.
Proof.
  induction s as [|x s IH]; intros t N D; cbn [join fold_right].
  - change (parity []) with 1; lia.
  - fold (join s t); apply NoDup_cons_iff in N; destruct N as [NX N].
    rewrite parity_insert, parity_cons, IH; [lia|auto|intros y Y; apply D; right; auto|].
    rewrite in_join; intros [H|H]; [auto|apply (D x); [left|]; auto].
Qed.

Lemma in_proper : forall s t, sorted s -> In t (proper_subsets s) -> sorted t /\ incl t s.
Proof.
  intros s t S H; unfold proper_subsets in H; apply filter_In in H; destruct H as [H _].
  apply in_subsets; auto.
Qed.

Lemma parity_proper : forall s, proper_form s -> total parity (proper_subsets s) = - parity s.
Proof.
  intros s [N S]; pose proof (parity_subsets s) as P.
  destruct s as [|x s]; [congruence|]; cbn [nonempty] in P; set (u := x :: s) in *.
  rewrite (total_split _ (fun t => negb (is t u))) in P; fold (proper_subsets u) in P.
  enough (total parity (filter (fun t => negb (negb (is t u))) (subsets u)) = parity u) by lia.
  transitivity (total parity [u]); [|cbn; lia].
  apply total_same.
  - apply NoDup_filter, nodup_subsets; auto.
  - repeat constructor; intros [].
  - intros t; rewrite filter_In, negb_involutive, is_true; cbn [In]; split.
    + intros [_ ->]; auto.
    + intros [<-|[]]; split; auto; apply in_subsets; auto; split; auto; intros y; auto.
Qed.

Lemma total_scaled : forall (f g : simplex -> Z) c L, (forall t, In t L -> f t = c * g t) ->
  total f L = c * total g L.
Proof.
  intros f g c; unfold total; induction L as [|t L IH]; intros H; cbn [fold_right]; [lia|].
  rewrite IH by (intros; apply H; right; auto); rewrite (H t) by (left; auto); lia.
Qed.

Lemma total_map : forall f (h : simplex -> simplex) L, total f (map h L) = total (fun t => f (h t))
  L.
Proof. intros f h; unfold total; induction L; cbn [map fold_right]; rewrite ?IHL; auto. Qed.

(** What goes and what comes have the same sum: so has the whole. *)
Lemma exchange : forall K K' gone come rest, Permutation K (gone ++ rest) ->
  Permutation K' (come ++ rest) -> chi gone = chi come -> chi K' = chi K.
Proof.
  intros K K' gone come rest P P' E; unfold chi in *.
  rewrite (total_perm _ _ _ P), (total_perm _ _ _ P'), !total_app; lia.
Qed.

Lemma chi_join : forall A L, sorted A -> (forall t, In t L -> apart A t) ->
  chi (map (join A) L) = - parity A * total parity L.
Proof.
  intros A L S D; unfold chi; rewrite total_map; apply total_scaled.
  intros t T; unfold sign; rewrite parity_join; [lia|apply sorted_nodup; auto|auto].
Qed.

(** OPER-BISTELLAR-1: the simplices A * ∂B go and ∂A * B come. *)
Theorem bistellar_keeps_chi : forall K K' A B rest, proper_form A -> proper_form B -> apart A B ->
  Permutation K (map (join A) (proper_subsets B) ++ rest) ->
  Permutation K' (map (join B) (proper_subsets A) ++ rest) -> chi K' = chi K.
Proof.
  intros K K' A B rest PA PB D P P'; apply (exchange K K' _ _ rest P P').
  rewrite !chi_join; try apply PA; try apply PB.
  - rewrite !parity_proper by auto; lia.
  - intros t T x X Y; apply in_proper in T; [|apply PA]; apply (D x); auto; apply T; auto.
  - intros t T x X Y; apply in_proper in T; [|apply PB]; apply (D x); auto; apply T; auto.
Qed.

(** OPER-STELLAR-1: with L the link of A (∅ included), A * L goes and v * ∂A * L comes. Read
    backwards it is the weld, OPER-STELLAR-2. *)
Theorem subdivision_keeps_chi : forall K K' A v L rest, proper_form A ->
  (forall t, In t L -> apart A t /\ ~ In v t) -> ~ In v A ->
  Permutation K (map (join A) L ++ rest) ->
  Permutation K' (flat_map (fun l => map (fun t => insert v (join t l)) (proper_subsets A)) L ++
    rest) ->
  chi K' = chi K.
Proof.
  intros K K' A v L rest PA DL NV P P'; apply (exchange K K' _ _ rest P P').
  rewrite chi_join; [|apply PA|intros t T; apply DL; auto].
  clear P P'; induction L as [|l L IH]; cbn [flat_map map]; [cbn; lia|].
  unfold chi in *; rewrite total_app, <- IH by (intros; apply DL; right; auto).
  destruct (DL l (or_introl eq_refl)) as [DA Nl].
  rewrite total_map,
    (total_scaled (fun t => sign (insert v (join t l))) parity (parity l) (proper_subsets A)).
  - rewrite parity_proper by auto; unfold total at 1; cbn [fold_right]; fold (total parity L); lia.
  - intros t T; apply in_proper in T; [|apply PA]; destruct T as [ST IT].
    unfold sign; rewrite parity_insert, parity_join.
    + lia.
    + apply sorted_nodup; auto.
    + intros x X; apply DA; auto.
    + rewrite in_join; intros [X|X]; auto.
Qed.
