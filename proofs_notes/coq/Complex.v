(** * Simplicial complexes as finite sets, and their Euler characteristic

    Clauses: CPLX-COMPLEX-1 (simplices and complexes), CPLX-COMPLEX-2 (the numbers of simplices),
    CPLX-COMPLEX-3 (χ), OPER-ATTACH-5 (an attachment changes χ by 1 - χ(A)).

    A simplex is the list of its vertices in increasing order, so that equal sets are equal lists. A
    complex is a list of simplices, each once, with all their faces. *)

Require Import ZArith List Lia Arith Bool Permutation Sorted.
Import ListNotations.

(** ** Simplices *)

Definition simplex := list nat.
Definition sorted (s : simplex) : Prop := StronglySorted lt s.

(** The vertices in increasing order, one at least. *)
Definition proper_form (s : simplex) : Prop := s <> [] /\ sorted s.

Lemma eq_dec : forall s t : simplex, {s = t} + {s <> t}.
Proof. apply list_eq_dec, Nat.eq_dec. Qed.

Lemma sorted_cons : forall x s, sorted (x :: s) <-> sorted s /\ forall y, In y s -> x < y.
Proof.
  intros x s; unfold sorted; split.
  - intros H; apply StronglySorted_inv in H; destruct H as [H F]; split; auto.
    apply Forall_forall; exact F.
  - intros [H F]; constructor; auto; apply Forall_forall; exact F.
Qed.

Lemma sorted_nodup : forall s, sorted s -> NoDup s.
Proof.
  induction s as [|x s IH]; intros H; constructor; apply sorted_cons in H; destruct H as [H F];
    auto.
  intros I; apply F in I; lia.
Qed.

(** Equal sets are equal lists. *)
Lemma same_vertices : forall s t, sorted s -> sorted t -> incl s t -> incl t s -> s = t.
Proof.
  induction s as [|x s IH]; intros [|y t] S T I J; auto.
  - destruct (J y (or_introl eq_refl)).
  - destruct (I x (or_introl eq_refl)).
  - apply sorted_cons in S; destruct S as [S F]; apply sorted_cons in T; destruct T as [T G].
    assert (x = y) as <-.
    { destruct (I x (or_introl eq_refl)) as [E|E]; auto.
      destruct (J y (or_introl eq_refl)) as [E'|E']; auto; apply G in E; apply F in E'; lia. }
    f_equal; apply IH; auto; intros z Z.
    + destruct (I z (or_intror Z)) as [<-|E]; auto; apply F in Z; lia.
    + destruct (J z (or_intror Z)) as [<-|E]; auto; apply G in Z; lia.
Qed.

Lemma same_length : forall s t, sorted s -> sorted t -> incl s t -> length t <= length s -> s = t.
Proof. intros s t S T I L; apply same_vertices; auto; apply NoDup_length_incl;
  auto using sorted_nodup. Qed.

(** A set with one vertex more. *)
Fixpoint insert (x : nat) (s : simplex) : simplex :=
  match s with
  | [] => [x]
  | y :: t => if x <? y then x :: s else if x =? y then s else y :: insert x t
  end.

Lemma in_insert : forall x y s, In y (insert x s) <-> y = x \/ In y s.
Proof.
  intros x y; induction s as [|z s IH]; cbn [insert In]; [intuition|].
  destruct (Nat.ltb_spec x z), (Nat.eqb_spec x z); cbn [In]; rewrite ?IH; subst; intuition.
Qed.

Lemma sorted_insert : forall x s, sorted s -> sorted (insert x s).
Proof.
  intros x; induction s as [|z s IH]; intros H; cbn [insert].
  - apply sorted_cons; split; [exact H|intros y []].
  - pose proof H as K; apply sorted_cons in H; destruct H as [H F].
    destruct (Nat.ltb_spec x z); [|destruct (Nat.eqb_spec x z); auto].
    + apply sorted_cons; split; auto; intros y [<-|Y]; [|apply F in Y]; lia.
    + apply sorted_cons; split; auto; intros y Y; apply in_insert in Y; destruct Y as [->|Y]; auto;
        lia.
Qed.

Lemma length_insert : forall x s, ~ In x s -> length (insert x s) = S (length s).
Proof.
  intros x; induction s as [|z s IH]; intros N; cbn [insert]; auto.
  destruct (Nat.ltb_spec x z); [auto|destruct (Nat.eqb_spec x z)]; cbn [length].
  - destruct N; left; auto.
  - rewrite IH; auto; intros I; apply N; right; auto.
Qed.

(** ** All faces of a simplex *)

(** The subsets of a list, the empty one among them. *)
Fixpoint subsets (s : simplex) : list simplex :=
  match s with [] => [[]] | x :: t => subsets t ++ map (cons x) (subsets t) end.

Lemma in_subsets : forall s t, sorted s -> (In t (subsets s) <-> sorted t /\ incl t s).
Proof.
  induction s as [|x s IH]; intros t S; cbn.
  - split.
    + intros [<-|[]]; split; [constructor|intros y []].
    + intros [_ I]; destruct t as [|y t]; auto; destruct (I y (or_introl eq_refl)).
  - apply sorted_cons in S; destruct S as [S F]; rewrite in_app_iff, in_map_iff; split.
    + intros [I|[u [<- I]]]; apply IH in I; auto; destruct I as [U I].
      * split; auto; intros y Y; right; auto.
      * split; [|intros y [<-|Y]; [left|right]; auto].
        apply sorted_cons; split; auto.
    + intros [U I]; destruct t as [|y t].
      * left; apply IH; auto; split; auto; intros y [].
      * apply sorted_cons in U; destruct U as [U G].
        destruct (I y (or_introl eq_refl)) as [<-|Y].
        -- right; exists t; split; auto; apply IH; auto; split; auto.
           intros z Z; destruct (I z (or_intror Z)) as [<-|E]; auto; apply G in Z; lia.
        -- left; apply IH; auto; split; [apply sorted_cons; auto|].
           intros z [<-|Z]; auto.
           destruct (I z (or_intror Z)) as [<-|E]; auto.
           apply F in Y; apply G in Z; lia.
Qed.

Lemma nodup_subsets : forall s, sorted s -> NoDup (subsets s).
Proof.
  induction s as [|x s IH]; intros S; cbn; [repeat constructor; intros []|].
  apply sorted_cons in S; destruct S as [S F].
  assert (K : forall p q : list simplex, NoDup p -> NoDup q -> (forall a, In a p -> ~ In a q) ->
    NoDup (p ++ q)).
  { clear; induction p as [|a p IH]; intros q P Q D; cbn; auto.
    apply NoDup_cons_iff in P; destruct P as [P1 P2]; constructor.
    - rewrite in_app_iff; intros [Y|Y]; auto; apply (D a); cbn; auto.
    - apply IH; auto; intros b Y; apply D; cbn; auto. }
  apply K; auto.
  - apply FinFun.Injective_map_NoDup; auto; intros a b E; injection E; auto.
  - intros a A B; apply in_map_iff in B; destruct B as [u [<- _]].
    apply in_subsets in A; auto; destruct A as [_ A].
    pose proof (F x (A x (or_introl eq_refl))); lia.
Qed.

Definition nonempty (s : simplex) : bool := match s with [] => false | _ => true end.
(** The closure of one simplex: itself and its faces. *)
Definition closure (s : simplex) : list simplex := filter nonempty (subsets s).

Lemma in_closure : forall s t, sorted s -> (In t (closure s) <-> proper_form t /\ incl t s).
Proof.
  intros s t S; unfold closure; rewrite filter_In, in_subsets by auto; unfold proper_form.
  destruct t; cbn; intuition congruence.
Qed.

Lemma nodup_closure : forall s, sorted s -> NoDup (closure s).
Proof. intros; apply NoDup_filter, nodup_subsets; auto. Qed.

(** ** Sums over complexes *)

Open Scope Z_scope.

Definition total (f : simplex -> Z) (K : list simplex) : Z := fold_right (fun s t => f s + t) 0 K.

Lemma total_perm : forall f K L, Permutation K L -> total f K = total f L.
Proof. intros f; unfold total; induction 1; cbn [fold_right]; lia. Qed.
Lemma total_app : forall f K L, total f (K ++ L) = total f K + total f L.
Proof. intros f; unfold total; induction K; intros L; cbn [app fold_right]; rewrite ?IHK; lia. Qed.
Lemma total_same : forall f K L, NoDup K -> NoDup L -> (forall s, In s K <-> In s L) ->
  total f K = total f L.
Proof. intros; apply total_perm, NoDup_Permutation; auto. Qed.
Lemma total_split : forall f (p : simplex -> bool) K,
  total f K = total f (filter p K) + total f (filter (fun s => negb (p s)) K).
Proof.
  intros f p; unfold total; induction K as [|s K IH]; cbn [filter fold_right]; [reflexivity|].
  rewrite IH; destruct (p s); cbn [negb fold_right]; lia.
Qed.

(** (-1) to the number of vertices. *)
Definition parity (s : simplex) : Z := if Nat.even (length s) then 1 else -1.
(** (-1) to the dimension. *)
Definition sign (s : simplex) : Z := - parity s.
Definition chi (K : list simplex) : Z := total sign K.
(** Whether a simplex has k vertices; the sum of it is the number of those of dimension k - 1. *)
Definition has_size (k : nat) (s : simplex) : Z := if (length s =? k)%nat then 1 else 0.
Definition number (k : nat) (K : list simplex) : Z := total (has_size k) K.

Lemma parity_cons : forall x s, parity (x :: s) = - parity s.
Proof.
  intros x s; unfold parity; cbn [length]; rewrite Nat.even_succ, <- Nat.negb_even.
  destruct (Nat.even (length s)); reflexivity.
Qed.

Lemma total_map_cons : forall f x L, total f (map (cons x) L) = total (fun s => f (x :: s)) L.
Proof. intros f x; unfold total; induction L; cbn [map fold_right]; rewrite ?IHL; auto. Qed.

(** The subsets of a set that is not empty: as many even as odd ones. *)
Lemma parity_subsets : forall s, total parity (subsets s) = if nonempty s then 0 else 1.
Proof.
  destruct s as [|x s]; [reflexivity|]; cbn [subsets nonempty].
  rewrite total_app, total_map_cons.
  assert (K : forall L, total (fun t => parity (x :: t)) L = - total parity L).
  { unfold total; induction L as [|a L IH]; cbn [fold_right]; rewrite ?IH, ?parity_cons; lia. }
  rewrite K; lia.
Qed.

(** A simplex with its faces has χ = 1. *)
Theorem chi_closure : forall s, s <> [] -> chi (closure s) = 1.
Proof.
  intros s N; unfold chi, closure.
  assert (E : total sign (subsets s) = 0).
  { pose proof (parity_subsets s) as P; destruct s; [congruence|]; cbn [nonempty] in P.
    unfold sign; assert (K : forall L, total (fun t => - parity t) L = - total parity L).
    { unfold total; induction L as [|a L IH]; cbn [fold_right]; rewrite ?IH; lia. }
    rewrite K; lia. }
  rewrite (total_split sign nonempty) in E.
  assert (F : total sign (filter (fun t => negb (nonempty t)) (subsets s)) = -1); [|lia].
  clear; induction s as [|x s IH]; [reflexivity|]; cbn [subsets].
  rewrite filter_app, total_app, IH.
  assert (filter (fun t => negb (nonempty t)) (map (cons x) (subsets s)) = []) as ->;
    [|reflexivity].
  clear IH; induction (subsets s); cbn; auto.
Qed.

(** Pascal's triangle. *)
Fixpoint choose (n k : nat) : Z :=
  match n, k with
  | _, O => 1
  | O, S _ => 0
  | S m, S j => choose m j + choose m (S j)
  end.

Lemma number_subsets : forall s k, number k (subsets s) = choose (length s) k.
Proof.
  unfold number; induction s as [|x s IH]; intros [|k]; try reflexivity.
  - cbn [subsets]; rewrite total_app, total_map_cons, IH; cbn [length choose].
    assert (K : forall L, total (fun t => has_size 0 (x :: t)) L = 0).
    { unfold total; induction L as [|a L IH']; cbn [fold_right]; rewrite ?IH'; auto. }
    rewrite K; destruct (length s); reflexivity.
  - cbn [subsets length choose]; rewrite total_app, total_map_cons, IH.
    change (fun t => has_size (S k) (x :: t)) with (fun t => has_size k t).
    change (total (fun t => has_size k t) (subsets s)) with (total (has_size k) (subsets s)).
    rewrite IH; lia.
Qed.

Lemma number_closure : forall s k, number (S k) (closure s) = choose (length s) (S k).
Proof.
  intros s k; rewrite <- number_subsets; unfold number, closure.
  rewrite (total_split _ nonempty (subsets s)).
  assert (K : forall L, total (has_size (S k)) (filter (fun t => negb (nonempty t)) L) = 0);
    [|rewrite K; lia].
  unfold total; induction L as [|[|] L IH]; cbn [filter nonempty negb fold_right]; rewrite ?IH;
    auto.
Qed.

(** ** Complexes *)

Record complex (K : list simplex) : Prop := {
  each_once : NoDup K;
  simplices : forall s, In s K -> proper_form s;
  faces_too : forall s t, In t K -> proper_form s -> incl s t -> In s K
}.

Lemma closure_complex : forall s, proper_form s -> complex (closure s).
Proof.
  intros s [N S]; constructor.
  - apply nodup_closure; auto.
  - intros t T; apply in_closure in T; tauto.
  - intros a t T A I; apply in_closure in T; auto; apply in_closure; auto; split; auto.
    intros x X; apply T, I, X.
Qed.

(** ** Attachments *)

Definition among (K : list simplex) (s : simplex) : bool :=
  if in_dec eq_dec s K then true else false.
Lemma among_true : forall K s, among K s = true <-> In s K.
Proof. intros K s; unfold among; destruct (in_dec eq_dec s K); split; congruence. Qed.

(** OPER-ATTACH-2: K with a simplex and its faces. *)
Definition attach (K : list simplex) (s : simplex) : list simplex :=
  K ++ filter (fun t => negb (among K t)) (closure s).

Lemma in_attach : forall K s t, In t (attach K s) <-> In t K \/ In t (closure s).
Proof.
  intros K s t; unfold attach; rewrite in_app_iff, filter_In; destruct (among K t) eqn:E; cbn.
  - apply among_true in E; tauto.
  - assert (~ In t K) by (rewrite <- among_true; congruence); intuition.
Qed.

(** OPER-ATTACH-2: the result is a complex. *)
Theorem attach_complex : forall K s, complex K -> proper_form s -> complex (attach K s).
Proof.
  intros K s [N P F] PS; pose proof (closure_complex s PS) as [N' P' F']; constructor.
  - assert (D : forall p q : list simplex, NoDup p -> NoDup q -> (forall a, In a p -> ~ In a q) ->
      NoDup (p ++ q)).
    { clear; induction p as [|a p IH]; intros q P Q D; cbn; auto.
      apply NoDup_cons_iff in P; destruct P as [P1 P2]; constructor.
      - rewrite in_app_iff; intros [Y|Y]; auto; apply (D a); cbn; auto.
      - apply IH; auto; intros b Y; apply D; cbn; auto. }
    apply D; auto; [apply NoDup_filter; auto|].
    intros a A I; apply filter_In in I; destruct I as [_ I]; apply among_true in A; rewrite A in I.
    discriminate.
  - intros t T; apply in_attach in T; destruct T; auto.
  - intros a t T A I; apply in_attach in T; apply in_attach; destruct T; [left|right]; eauto.
Qed.

Section Attachment.
Variables (K A : list simplex) (s : simplex).
Hypothesis HK : complex K.
Hypothesis HS : proper_form s.
(** OPER-ATTACH-2: A is what K and the closed simplex have in common. *)
Hypothesis HA : NoDup A /\ forall t, In t A <-> In t K /\ In t (closure s).

Lemma total_attach : forall f,
  total f (attach K s) = total f K + total f (closure s) - total f A.
Proof.
  intros f; unfold attach; rewrite total_app.
  rewrite (total_split f (among K) (closure s)).
  rewrite (total_same f A (filter (among K) (closure s))); [lia|apply HA| |].
  - apply NoDup_filter, nodup_closure, HS.
  - intros t; rewrite filter_In, among_true; destruct HA as [_ H]; rewrite H; tauto.
Qed.

(** OPER-ATTACH-5, χ. *)
Theorem attach_chi : chi (attach K s) = chi K + (1 - chi A).
Proof.
  unfold chi; rewrite total_attach; fold (chi (closure s)); rewrite chi_closure by apply HS; lia.
Qed.

(** OPER-ATTACH-5, the number of k-simplices, which have k + 1 vertices, of the m + 1 of s. *)
Theorem attach_number : forall k,
  number (S k) (attach K s) = number (S k) K + (choose (length s) (S k) - number (S k) A).
Proof. intros k; unfold number at 1 2 3; rewrite total_attach; fold (number (S k) (closure s)).
  rewrite number_closure; lia. Qed.
End Attachment.
