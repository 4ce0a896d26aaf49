(** * The primal remainder is connected

    Clauses: EB-REMAINDER-1 (each triangle but the first is entered from one that was visited
    before), EB-REMAINDER-2 (the remainder is connected; its number is [Counting.remainder]).

    Take the crossed edges away one after another, in the order of the walk. When the gate of a
    triangle goes, its two other sides are still there: they lead to triangles that come later, or
    are not crossed at all. So its ends stay joined, by way of the apex. *)

Require Import ZArith List Lia Arith Bool Permutation Relation_Operators.
From Clers Require Import Letters Surface Edges Walk Gates Steps Complete Tally Walks.
Import ListNotations.
Open Scope nat_scope.

Section Surface.
Variable M : table.
Hypothesis HM : surface M.
Notation v := (vertex M).
Notation opp := (opposite M).
Notation T := (triangles M).

(** The gates by which triangles were entered, the last first, after the triangles [base] (P, or
    none). Each leads into a triangle that was not visited, across an edge of one that was. The
    first gate of a component with boundary has nothing on its other side and crosses no edge. *)
Fixpoint entered (base : list nat) (l : list corner) : Prop :=
  match l with
  | [] => True
  | c :: r => entered base r /\ face c < T /\ ~ In (face c) (map face r ++ base)
      /\ match opp c with Some x => In (face x) (map face r ++ base) | None => True end
  end.

(** The gates that the walk goes through, the last first. *)
Fixpoint gone_through (n : nat) (s : state) (l : list corner) : list corner :=
  match n, gate s, step M s with
  | S k, Some c, Some s' => gone_through k s' (c :: l)
  | _, _, _ => l
  end.

Lemma run_entered : forall base n s full l, holds M s full -> entered base l ->
  visited s = map face l ++ base ->
  entered base (gone_through n s l) /\ visited (run M n s) = map face (gone_through n s l) ++ base.
Proof.
  intros base; induction n as [|n IH]; intros s full l H E V; cbn [run gone_through]; [auto|].
  destruct (gate s) as [c|] eqn:G.
  - pose proof H as [_ R]; rewrite G in R; destruct R as [NV R].
    destruct (step_moves M HM s c full G R NV) as (s' & -> & MV).
    destruct (step_holds M HM s c full s' G H MV) as [full' H'].
    pose proof (moves_visited M s c s' MV) as V'.
    destruct R as [_ _ [[F [_ [_ D]]] _]].
    apply (IH s' full' (c :: l) H').
    + cbn [entered]; rewrite <- V; repeat split; auto; destruct (opp c); auto.
    + rewrite V', V; reflexivity.
  - unfold step; rewrite G; auto.
Qed.

(** How a walk begins, and the triangles that are visited without a gate: P, or none. *)
Inductive begins : bool -> state -> list nat -> Prop :=
| with_p : forall t, t < T -> (forall c, face c < T -> opp c <> None) ->
    begins true (begin_closed M t) [t]
| with_curve : forall c, face c < T -> opp c = None -> begins false (begin_border M c) [].

(** EB-REMAINDER-1: the whole walk enters every triangle but P so, once. *)
Theorem walk_enters : forall k s base, begins k s base -> entered base (gone_through T s [])
  /\ Permutation (map face (gone_through T s []) ++ base) (seq 0 T).
Proof.
  intros k s base W.
  assert (K : (exists full, holds M s full) /\ visited s = map face [] ++ base
    /\ walk M k (run M T s)).
  { destruct W as [t L NB|c L OC]; split; [|split| |split]; try reflexivity.
    - apply (begin_closed_holds M HM t L NB).
    - constructor; auto.
    - apply (begin_border_holds M HM c L OC).
    - constructor; auto. }
  destruct K as ([full H] & V & WK).
  destruct (run_entered base T s full [] H I V) as [E V']; split; [exact E|].
  destruct (walk_ends M HM k _ WK) as (_ & [N A] & _).
  rewrite <- V'; apply NoDup_Permutation; auto using seq_NoDup.
  intros t; rewrite A, in_seq; lia.
Qed.

(** An edge, by a corner opposite to it, that none of the gates crosses. *)
Definition uncrossed (l : list corner) (x : corner) : Prop :=
  match opp x with None => True | Some d => ~ In x l /\ ~ In d l end.

(** Two vertices are joined along edges that are not crossed. *)
Definition joined_beside (l : list corner) : nat -> nat -> Prop :=
  clos_refl_sym_trans nat (fun a b => exists x, face x < T /\ uncrossed l x
    /\ a = v (next x) /\ b = v (prev x)).

Lemma beside_refl : forall l a, joined_beside l a a. Proof. intros; apply rst_refl. Qed.
Lemma beside_sym : forall l a b, joined_beside l a b -> joined_beside l b a.
Proof. intros; apply rst_sym; auto. Qed.
Lemma beside_trans : forall l a b c, joined_beside l a b -> joined_beside l b c ->
  joined_beside l a c.
Proof. intros; eapply rst_trans; eauto. Qed.
Lemma beside_edge : forall l x, face x < T -> uncrossed l x ->
  joined_beside l (v (next x)) (v (prev x)).
Proof. intros l x F U; apply rst_step; exists x; auto. Qed.

Lemma entered_before : forall base l d, entered base l -> In d l ->
  match opp d with Some x => In (face x) (map face l ++ base) | None => True end.
Proof.
  intros base; induction l as [|c l IH]; intros d E I; [destruct I|].
  destruct E as (E & _ & _ & D); destruct I as [<-|I].
  - destruct (opp c); auto; right; auto.
  - specialize (IH d E I); destruct (opp d); auto; right; auto.
Qed.

(** The other sides of a triangle are not crossed when it is entered, nor before. *)
Lemma other_side : forall base c r x, entered base (c :: r) -> x = next c \/ x = prev c ->
  uncrossed (c :: r) x.
Proof.
  intros base c r x (E & F & N & _) X; unfold uncrossed.
  assert (FX : face x = face c) by (destruct X; subst; reflexivity).
  assert (NC : x <> c) by
    (destruct c as [t []], X; subst x; unfold prev, next; cbn [fst snd turn]; congruence).
  destruct (opp x) as [d|] eqn:O; [|exact I].
  destruct (opposite_sound M HM x d ltac:(congruence) O) as (_ & OD & ND & _); split.
  - intros [H|H]; [congruence|]; apply N, in_app_iff; left; rewrite <- FX; apply in_map; auto.
  - intros [H|H]; [congruence|]; pose proof (entered_before base r d E H) as K.
    rewrite OD in K; apply N; rewrite <- FX; exact K.
Qed.

(** Whatever the gates, the vertices of the surface stay joined. *)
Theorem stays_joined : forall base l, entered base l -> forall a b, a < vertices M ->
  b < vertices M -> joined_beside l a b.
Proof.
  intros base; induction l as [|c r IH]; intros E a b A B.
  - (* the whole graph: a surface is connected *)
    destruct (vertex_used M HM a A) as [x [FX <-]], (vertex_used M HM b B) as [y [FY <-]].
    assert (S : forall z, face z < T -> joined_beside [] (v z) (v (next z))).
    { intros z FZ; pose proof (beside_edge [] (prev z) FZ) as K.
      rewrite next_prev, prev_prev in K; apply K.
      unfold uncrossed; destruct (opp (prev z)); [split; intros []|exact I]. }
    assert (S' : forall z w, face z < T -> face w = face z -> joined_beside [] (v z) (v w)).
    { intros z w FZ FW; destruct (same_face z w (eq_sym FW)) as [->|[->| ->]].
      - apply beside_refl.
      - apply S; auto.
      - apply beside_trans with (v (next z)); [apply S; auto|apply (S (next z)); auto]. }
    assert (J : forall g, joined M (face x) g -> g < T /\
      forall w, face w = g -> joined_beside [] (v x) (v w)).
    { intros g J; induction J as [|c d J IHJ FC O]; [split; auto; intros w FW; apply S'; auto|].
      destruct IHJ as [_ IHJ]; destruct (opposite_sound M HM c d FC O) as (FD & _ & _ & V1 & _).
      split; auto; intros w FW; apply beside_trans with (v (prev c)).
      - apply IHJ; apply face_prev.
      - rewrite <- V1; apply S'; [exact FD|rewrite FW; reflexivity]. }
    destruct (J (face y) (connected M HM (face x) (face y) FX FY)) as [_ K]; apply K; reflexivity.
  - pose proof E as (E' & F & N & D).
    pose proof (other_side base c r (next c) E (or_introl eq_refl)) as U1.
    pose proof (other_side base c r (prev c) E (or_intror eq_refl)) as U2.
    assert (P : joined_beside (c :: r) (v (next c)) (v (prev c))).
    { apply beside_trans with (v c); apply beside_sym.
      - pose proof (beside_edge (c :: r) (prev c) F U2) as K.
        rewrite next_prev, prev_prev in K; exact K.
      - pose proof (beside_edge (c :: r) (next c) F U1) as K.
        rewrite next_next, prev_next in K; exact K. }
    specialize (IH E' a b A B); clear A B.
    induction IH as [p q (x & FX & UX & -> & ->)|p|p q _ IH|p q s _ IH _ IH'].
    + destruct (opp x) as [d|] eqn:O.
      * destruct (corner_eqb x c) eqn:XC; [apply corner_eqb_eq in XC; subst; exact P|].
        destruct (corner_eqb d c) eqn:DC.
        -- apply corner_eqb_eq in DC; subst d.
           destruct (opposite_sound M HM x c FX O) as (_ & _ & _ & V1 & V2).
           rewrite <- V1, <- V2; apply beside_sym; exact P.
        -- apply beside_edge; auto; unfold uncrossed in *; rewrite O in *; destruct UX as [U3 U4].
           split; intros [Z|Z]; auto; symmetry in Z; apply corner_eqb_eq in Z; congruence.
      * apply beside_edge; auto; unfold uncrossed; rewrite O; exact I.
    + apply beside_refl.
    + apply beside_sym; auto.
    + eapply beside_trans; eauto.
Qed.

(** EB-REMAINDER-2: the primal remainder is connected. *)
Theorem remainder_connected : forall k s base, begins k s base -> forall a b, a < vertices M ->
  b < vertices M -> joined_beside (gone_through T s []) a b.
Proof.
  intros k s base W; apply (stays_joined base); apply (walk_enters k s base W).
Qed.
End Surface.
