(** * Collapses and expansions

    Clauses: OPER-COLLAPSE-1 to -3 (when they apply), OPER-MOVE-5 and OPER-MOVE-6 for them (they
    undo
    each other; they keep χ), OPER-COLLAPSE-4 (with A a vertex and an edge, with A an edge and a
    triangle: the same statements for one and for two vertices).

    All is said of complexes, not of counts: taking a free pair away from a complex gives a complex,
    and it has the same χ. *)

Require Import ZArith List Lia Arith Bool Permutation Relation_Operators.
From Clers Require Import Complex.
Import ListNotations.

(** B is A and one vertex more. *)
Definition covers (A B : simplex) : Prop := incl A B /\ length B = S (length A).

(** OPER-COLLAPSE-1: both are in K, and only A and B contain A. *)
Definition free_pair (K : list simplex) (A B : simplex) : Prop :=
  In A K /\ In B K /\ covers A B /\ forall t, In t K -> incl A t -> t = A \/ t = B.

Definition is (s t : simplex) : bool := if eq_dec s t then true else false.
Lemma is_true : forall s t, is s t = true <-> s = t.
Proof. intros s t; unfold is; destruct (eq_dec s t); split; congruence. Qed.

(** K without A and B. *)
Definition collapse (K : list simplex) (A B : simplex) : list simplex :=
  filter (fun s => negb (is s A || is s B)) K.

Lemma in_collapse : forall K A B s, In s (collapse K A B) <-> In s K /\ s <> A /\ s <> B.
Proof.
  intros K A B s; unfold collapse; rewrite filter_In, negb_true_iff, orb_false_iff.
  rewrite <- (is_true s A), <- (is_true s B), !not_true_iff_false; tauto.
Qed.

Lemma covers_not : forall A B, covers A B -> A <> B.
Proof. intros A B [_ L] ->; lia. Qed.

(** OPER-COLLAPSE-2, first equivalence: a collapse applies exactly if what is left is a complex. *)
Theorem collapse_applies : forall K A B, complex K -> In A K -> In B K -> covers A B ->
  (free_pair K A B <-> complex (collapse K A B)).
Proof.
  intros K A B [N P F] IA IB C; split.
  - intros (_ & _ & _ & H); constructor.
    + apply NoDup_filter; auto.
    + intros s S; apply in_collapse in S; apply P; tauto.
    + intros s t T S I; apply in_collapse in T; destruct T as (T & TA & TB).
      apply in_collapse; repeat split; [eauto| |].
      * intros ->; destruct (H t T I); auto.
      * intros ->; destruct (H t T (fun x X => I x (proj1 C x X))); auto.
  - intros [_ _ F']; repeat split; auto; try apply C; intros t T I.
    destruct (eq_dec t A) as [E|E], (eq_dec t B) as [E'|E']; auto; exfalso.
    assert (IT : In t (collapse K A B)) by (apply in_collapse; auto).
    pose proof (F' A t IT (P A IA) I) as X; apply in_collapse in X; tauto.
Qed.

(** OPER-COLLAPSE-2, second equivalence: exactly if A lies in only one simplex that has one vertex
    more. That this one is maximal need not be asked for. *)
Theorem collapse_applies_locally : forall K A B, complex K -> In A K -> In B K -> covers A B ->
  (free_pair K A B <-> forall t, In t K -> covers A t -> t = B).
Proof.
  intros K A B [N P F] IA IB C; split.
  - intros (_ & _ & _ & H) t T D; destruct (H t T (proj1 D)); auto; subst.
    destruct (covers_not A A D); auto.
  - intros H; repeat split; auto; try apply C; intros t T I.
    destruct (P A IA) as [NA SA], (P t T) as [NT ST], (P B IB) as [NB SB].
    destruct (eq_dec t A) as [E|E]; auto; right.
    (* Each vertex of t outside A makes B with A. *)
    assert (K1 : forall w, In w t -> ~ In w A -> insert w A = B).
    { intros w W NW; apply H.
      - apply (F (insert w A) t T).
        + split; [intros Z|apply sorted_insert; auto].
          assert (In w (insert w A)) as Y by (apply in_insert; auto); rewrite Z in Y; destruct Y.
        + intros x X; apply in_insert in X; destruct X as [->|X]; auto.
      - split; [intros x X; apply in_insert; auto|apply length_insert; auto]. }
    (* There is one, *)
    assert (K2 : exists w, In w t /\ ~ In w A).
    { destruct (forallb (fun w => if in_dec Nat.eq_dec w A then true else false) t) eqn:Z.
      - exfalso; apply E, same_vertices; auto; intros x X.
        rewrite forallb_forall in Z; specialize (Z x X); destruct (in_dec Nat.eq_dec x A); auto.
        discriminate.
      - assert (Y : existsb (fun w => negb (if in_dec Nat.eq_dec w A then true else false)) t =
          true).
        { clear - Z; induction t as [|x t IH]; cbn in *; [discriminate|].
          destruct (in_dec Nat.eq_dec x A); cbn in *; auto. }
        apply existsb_exists in Y; destruct Y as [w [W Y]]; exists w; split; auto.
        destruct (in_dec Nat.eq_dec w A); [discriminate|auto]. }
    (* and no other. *)
    destruct K2 as (w & W & NW); pose proof (K1 w W NW) as EB; rewrite <- EB.
    apply same_vertices; auto; [apply sorted_insert; auto| |].
    + intros x X; apply in_insert; destruct (in_dec Nat.eq_dec x A); auto; left.
      pose proof (K1 x X n) as EX; assert (Y : In x (insert w A)).
      { rewrite EB, <- EX; apply in_insert; auto. }
      apply in_insert in Y; destruct Y; [auto|contradiction].
    + intros x X; apply in_insert in X; destruct X as [->|X]; auto.
Qed.

Lemma sign_covers : forall A B, covers A B -> (sign A + sign B = 0)%Z.
Proof.
  intros A B [_ L]; unfold sign, parity; rewrite L, Nat.even_succ, <- Nat.negb_even.
  destruct (Nat.even (length A)); reflexivity.
Qed.

(** A complex is what is left and the two. *)
Lemma collapse_permutation : forall K A B, complex K -> In A K -> In B K -> A <> B ->
  Permutation K (A :: B :: collapse K A B).
Proof.
  intros K A B [N P F] IA IB D; apply NoDup_Permutation; auto.
  - constructor; [|constructor].
    + intros [E|E]; [congruence|apply in_collapse in E; tauto].
    + intros E; apply in_collapse in E; tauto.
    + apply NoDup_filter; auto.
  - intros s; cbn [In]; rewrite in_collapse; split.
    + intros S; destruct (eq_dec s A), (eq_dec s B); auto.
    + intros [<-|[<-|[S _]]]; auto.
Qed.

(** OPER-MOVE-6: a collapse keeps χ. *)
Theorem collapse_keeps_chi : forall K A B, complex K -> free_pair K A B ->
  chi (collapse K A B) = chi K.
Proof.
  intros K A B HK (IA & IB & C & _); pose proof (sign_covers A B C) as S; unfold chi.
  rewrite (total_perm sign K _ (collapse_permutation K A B HK IA IB (covers_not A B C))).
  unfold total; cbn [fold_right]; lia.
Qed.

(** And the number of simplices of a size falls by one for the sizes of A and B (first row of the
    table). *)
Theorem collapse_numbers : forall K A B k, complex K -> free_pair K A B ->
  number k (collapse K A B) = (number k K - has_size k A - has_size k B)%Z.
Proof.
  intros K A B k HK (IA & IB & C & _); unfold number.
  rewrite (total_perm (has_size k) K _ (collapse_permutation K A B HK IA IB (covers_not A B C))).
  unfold total; cbn [fold_right]; lia.
Qed.

(** ** Expansions *)

Definition expand (K : list simplex) (A B : simplex) : list simplex := A :: B :: K.

(** OPER-COLLAPSE-3: all proper faces of B but A are in K, and A is not. *)
Definition may_expand (K : list simplex) (A B : simplex) : Prop :=
  proper_form A /\ proper_form B /\ covers A B /\ ~ In A K
  /\ forall s, proper_form s -> incl s B -> s <> B -> s <> A -> In s K.

(** OPER-COLLAPSE-3, its parenthesis and its last sentence. *)
Theorem expand_applies : forall K A B, complex K -> proper_form A -> proper_form B -> covers A B ->
  (may_expand K A B <-> ~ In A K /\ ~ In B K /\ complex (expand K A B)).
Proof.
  intros K A B [N P F] PA PB C; split.
  - intros (_ & _ & _ & NA & H).
    assert (NB : ~ In B K) by (intros I; apply NA; apply (F A B I PA), C).
    split; auto; split; auto; constructor.
    + constructor; [intros [E|E]; [destruct (covers_not A B C); auto|auto]|constructor; auto].
    + intros s [<-|[<-|S]]; auto.
    + intros s t [<-|[<-|T]] S I.
      * destruct (eq_dec s A) as [->|E]; [left; auto|right; right].
        apply H; auto; [intros x X; apply C, I, X|intros ->].
        destruct C as [C L]; destruct PB as [_ SB]; apply sorted_nodup in SB.
        pose proof (NoDup_incl_length SB I); lia.
      * destruct (eq_dec s A) as [->|E]; [left; auto|].
        destruct (eq_dec s B) as [->|E']; [right; left; auto|right; right; auto].
      * right; right; eauto.
  - intros (NA & NB & [N' P' F']); repeat split; try apply PA; try apply PB; try apply C; auto.
    intros s S I SB SA.
    destruct (F' s B (or_intror (or_introl eq_refl)) S I) as [E|[E|E]]; auto; congruence.
Qed.

(** OPER-MOVE-5: expansion and collapse of the same simplices undo each other. *)
Theorem expand_collapse : forall K A B, complex K -> may_expand K A B ->
  free_pair (expand K A B) A B /\ collapse (expand K A B) A B = K.
Proof.
  intros K A B HK M; pose proof M as (PA & PB & C & NA & _).
  destruct (proj1 (expand_applies K A B HK PA PB C) M) as (_ & NB & HE).
  assert (E : collapse (expand K A B) A B = K).
  { unfold collapse, expand; cbn [filter].
    assert (is A A = true) as -> by (apply is_true; auto); cbn [orb negb].
    assert (is B B = true) as -> by (apply is_true; auto); rewrite orb_true_r; cbn [negb].
    assert (forall L, (forall s, In s L -> s <> A /\ s <> B) ->
      filter (fun s => negb (is s A || is s B)) L = L) as X.
    { clear; induction L as [|s L IH]; intros H; cbn [filter]; auto.
      destruct (H s (or_introl eq_refl)) as [H1 H2].
      rewrite <- is_true, not_true_iff_false in H1; rewrite <- is_true, not_true_iff_false in H2.
      rewrite H1, H2; cbn; f_equal; apply IH; intros; apply H; right; auto. }
    apply X; intros s S; split; intros ->; auto. }
  split; auto; apply (proj2 (collapse_applies (expand K A B) A B HE
    (or_introl eq_refl) (or_intror (or_introl eq_refl)) C)); rewrite E; auto.
Qed.

Theorem collapse_expand : forall K A B, complex K -> free_pair K A B ->
  may_expand (collapse K A B) A B /\ Permutation (expand (collapse K A B) A B) K.
Proof.
  intros K A B HK (IA & IB & C & H); pose proof HK as [N P F]; split.
  - repeat split; try (apply P; auto); try apply C.
    + intros X; apply in_collapse in X; tauto.
    + intros s S I SB SA; apply in_collapse; eauto.
  - symmetry; apply collapse_permutation; auto using covers_not.
Qed.

(** OPER-MOVE-6: an expansion keeps χ. *)
Theorem expansion_keeps_chi : forall K A B, may_expand K A B -> chi (expand K A B) = chi K.
Proof.
  intros K A B (_ & _ & C & _); pose proof (sign_covers A B C).
  unfold chi, total, expand; cbn [fold_right]; lia.
Qed.

(** So any collapses and expansions, in any order, keep it (OPER-SIMPLEX-1, its last sentence for
    χ: an Euler attachment is a sequence of expansions). *)
Inductive deforms : list simplex -> list simplex -> Prop :=
| by_nothing : forall K, deforms K K
| by_collapse : forall K L A B, deforms K L -> complex L -> free_pair L A B ->
    deforms K (collapse L A B)
| by_expansion : forall K L A B, deforms K L -> complex L -> may_expand L A B ->
    deforms K (expand L A B).

Theorem deformation_keeps_chi : forall K L, deforms K L -> chi L = chi K.
Proof.
  induction 1; [reflexivity|rewrite collapse_keeps_chi; auto|rewrite expansion_keeps_chi; auto].
Qed.
