(** * The beginning and the end of the walk

    Clauses: EB-COMPONENT-1 and -2 (how a component is begun), EB-COMPONENT-3 (every face of it is
    visited). At the end no edge is open, and the surface is connected: so all faces were visited
    ([visits_all]). *)

Require Import ZArith List Lia Arith Bool Permutation.
From Clers Require Import Letters Surface Edges Walk Gates Steps.
Import ListNotations.
Open Scope nat_scope.

Section Surface.
Variable M : table.
Hypothesis HM : surface M.
Notation v := (vertex M).
Notation opp := (opposite M).
Notation T := (triangles M).
Notation sane := (sane M).
Notation guarded := (guarded M).
Notation sound := (sound M).
Notation ready := (ready M).
Notation holds := (holds M).

(** ** At the end *)

(** A walk that has ended has visited every face and marked every vertex. *)
Theorem visits_all : forall s full, holds s full -> gate s = None -> visited s <> [] ->
  (forall t, In t (visited s) <-> t < T) /\ (forall a, In a (marked s) <-> a < vertices M).
Proof.
  intros s full [_ H] G N; rewrite G in H; destruct H as [_ [S O _]].
  assert (A : forall t, In t (visited s) <-> t < T).
  { intros t; split; [apply S|intros L].
    destruct (visited s) as [|t0 l] eqn:E; [congruence|].
    assert (J : joined M t0 t) by (apply connected; auto; apply S; cbn; auto).
    clear L; induction J as [|c d J IH L OC]; [cbn; auto|].
    destruct (mem (face d) (t0 :: l)) eqn:D; [apply mem_true; auto|].
    apply mem_false in D; destruct (O c d IH OC D). }
  split; auto; intros a; split; [apply S|intros L].
  destruct (vertex_used M HM a L) as [c [C <-]]; eapply vis_marked; eauto; apply A; auto.
Qed.

(** ** At the beginning *)

Lemma begin_closed_holds : forall t, t < T -> (forall c, face c < T -> opp c <> None) ->
  exists full, holds (begin_closed M t) full.
Proof.
  intros t L NB.
  assert (O : forall k, exists d, opp (t, k) = Some d).
  { intros k; destruct (opp (t, k)) as [d|] eqn:E; [eauto|destruct (NB (t, k) L E)]. }
  destruct (O p0) as [d0 O0], (O p1) as [d1 O1], (O p2) as [d2 O2].
  assert (NC : forall a, a < vertices M -> curve M a = None).
  { intros a A; destruct (curve M a) as [j|] eqn:E; auto; exfalso.
    assert (I : In a (filter (fun b => negb (inner_vertex M b)) (seq 0 (vertices M)))).
    { apply filter_In; rewrite in_seq; unfold inner_vertex; rewrite E; split; [lia|reflexivity]. }
    apply (Permutation_in _ (Permutation_sym (starts M HM))) in I.
    apply in_map_iff in I; destruct I as [c [_ I]]; apply filter_In in I; destruct I as [I1 I2].
    apply in_corners, in_seq in I1; unfold border in I2.
    destruct (opp c) eqn:Q; [discriminate|apply (NB c); auto; lia]. }
  pose proof (distinct M HM (t, p0) L) as D0; pose proof (distinct M HM (t, p1) L) as D1.
  pose proof (distinct M HM (t, p2) L) as D2.
  pose proof (vertex_in M HM (t, p0) L) as V0; pose proof (vertex_in M HM (t, p1) L) as V1.
  pose proof (vertex_in M HM (t, p2) L) as V2.
  change (next (t, p0)) with (t, p1) in D0; change (next (t, p1)) with (t, p2) in D1.
  change (next (t, p2)) with (t, p0) in D2.
  assert (RF : forall a b, a < vertices M -> b < vertices M -> a <> b -> ring M a b = false).
  { intros a b A B N; unfold ring; rewrite (NC a A), (NC b B); apply Nat.eqb_neq; auto. }
  destruct (opposite_sound M HM (t, p0) d0 L O0) as (F0 & P0 & E0 & X0 & Y0).
  destruct (opposite_sound M HM (t, p1) d1 L O1) as (F1 & P1 & E1 & X1 & Y1).
  destruct (opposite_sound M HM (t, p2) d2 L O2) as (F2 & P2 & E2 & X2 & Y2).
  change (prev (t, p0)) with (t, p2) in X0; change (next (t, p0)) with (t, p1) in Y0.
  change (prev (t, p1)) with (t, p0) in X1; change (next (t, p1)) with (t, p2) in Y1.
  change (prev (t, p2)) with (t, p1) in X2; change (next (t, p2)) with (t, p0) in Y2.
  change (face (t, p0)) with t in E0; change (face (t, p1)) with t in E1.
  change (face (t, p2)) with t in E2.
  exists [(d1, None); (d2, None)]; unfold begin_closed; split; [reflexivity|].
  cbn [gate visited marked]; rewrite O0; split; [intros [E|[]]; congruence|].
  cbn [map at_face]; constructor.
  - constructor.
    + repeat constructor; auto.
    + intros u [<-|[]]; auto.
    + repeat constructor; cbn [In]; intuition congruence.
    + intros a [<-|[<-|[<-|[]]]]; auto.
    + intros [u k] [U|[]]; cbn in U; subst u; destruct k; cbn [In]; auto.
    + intros a b I R _; assert (A : a < vertices M) by (cbn [In] in I; intuition congruence).
      unfold ring in R; rewrite (NC a A) in R; destruct (curve M b); [discriminate|].
      apply Nat.eqb_eq in R; subst; auto.
  - intros [u k] d [U|[]] OX _; cbn in U; subst u; cbn [map fst In].
    destruct k; [left|right; left|right; right; left]; congruence.
  - cbn [sound]; rewrite P0, P1, P2, X0, Y0, X1, Y1, X2, Y2; cbn [In face fst].
    repeat split; auto; try congruence.
    + intros _; exists (t, p2); change (prev (t, p2)) with (t, p1).
      change (next (t, p2)) with (t, p0); split; [exact P1|split; [auto|]].
      intros e k [I|[]]; injection I as <- <-; rewrite X2, Y2; auto.
    + intros _; exists (t, p0); change (prev (t, p0)) with (t, p2).
      change (next (t, p0)) with (t, p1); split; [exact P2|split; [auto|]]; intros e k [].
Qed.

Lemma begin_border_holds : forall c, face c < T -> opp c = None ->
  exists full, holds (begin_border M c) full.
Proof.
  intros c L OC; destruct (border_curve M HM c L OC) as (k & K1 & K2).
  exists []; split; [reflexivity|]; cbn [gate visited marked begin_border]; split; [auto|].
  assert (W : forall a, a < vertices M -> curve M a = Some k -> In a (whole M (v (next c)))).
  { intros a A E; apply in_whole; split; auto; unfold ring; rewrite K1, E; apply Nat.eqb_refl. }
  constructor.
  - constructor; auto using NoDup_filter, seq_NoDup; try constructor; cbn; try tauto.
    + apply NoDup_filter, seq_NoDup.
    + intros a A; apply in_whole in A; tauto.
    + intros a b A R B; apply in_whole in A; destruct A as [_ A]; apply in_whole; split; auto.
      eapply ring_trans; eauto.
  - intros x d [].
  - cbn; rewrite OC; repeat split; auto; try congruence; apply W; auto; apply vertex_in; auto.
Qed.
End Surface.
