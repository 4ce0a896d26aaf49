(** * Whole walks: they end, and have visited everything

    Clauses: EB-COMPONENT-1 to -3, EB-TRAVERSE-1. *)

Require Import ZArith List Lia Arith Bool Permutation.
From Clers Require Import Letters Surface Edges Walk Gates Steps Complete Tally.
Import ListNotations.
Open Scope Z_scope.

(** ** Walks *)

(** A whole walk over a closed component (true), from any triangle, or over one with boundary
    (false), from any edge of a curve. T steps are enough (see [walk_ends]). *)
Inductive walk (M : table) : bool -> state -> Prop :=
| closed_walk : forall t, (t < triangles M)%nat ->
    (forall c, (face c < triangles M)%nat -> opposite M c <> None) ->
    walk M true (run M (triangles M) (begin_closed M t))
| border_walk : forall c, (face c < triangles M)%nat -> opposite M c = None ->
    walk M false (run M (triangles M) (begin_border M c)).

Section Surface.
Variable M : table.
Hypothesis HM : surface M.
Notation v := (vertex M).
Notation opp := (opposite M).
Notation T := (triangles M).
Notation tally := (tally M).
Notation reached := (reached M).

(** ** Whole walks *)

Lemma no_curves : (forall c, (face c < T)%nat -> opp c <> None) ->
  forall a, (a < vertices M)%nat -> curve M a = None.
Proof.
  intros NB a A; destruct (curve M a) as [j|] eqn:E; auto; exfalso.
  assert (I : In a (filter (fun b => negb (inner_vertex M b)) (seq 0 (vertices M)))).
  { apply filter_In; rewrite in_seq; unfold inner_vertex; rewrite E; split; [lia|reflexivity]. }
  apply (Permutation_in _ (Permutation_sym (starts M HM))) in I.
  apply in_map_iff in I; destruct I as [c [_ I]]; apply filter_In in I; destruct I as [I1 I2].
  apply in_corners, in_seq in I1; unfold border in I2.
  destruct (opp c) eqn:Q; [discriminate|apply (NB c); auto; lia].
Qed.

Lemma begin_closed_tally : forall t, (t < T)%nat -> (forall c, (face c < T)%nat -> opp c <> None) ->
  tally true (begin_closed M t).
Proof.
  intros t L NB; pose proof (no_curves NB) as NC.
  assert (O : forall c, face c = t -> one_if (open M [t] c) = 1%nat).
  { intros c FC; unfold open; destruct (opp c) as [d|] eqn:E.
    - destruct (opposite_sound M HM c d ltac:(lia) E) as (_ & _ & N & _).
      unfold mem; cbn [existsb]; destruct (Nat.eqb_spec (face d) t); [congruence|reflexivity].
    - destruct (NB c); auto; lia. }
  assert (V : forall k, curve M (v (t, k)) = None) by (intros; apply NC, vertex_in; auto).
  assert (G : exists d, opp (t, p0) = Some d).
  { destruct (opp (t, p0)) as [d|] eqn:E; eauto; destruct (NB (t, p0) L E). }
  destruct G as [d G]; unfold begin_closed.
  constructor; cbn [gate stack visited marked word records negb when]; rewrite ?G; auto; try lia;
    try discriminate; try exact I.
  - cbn [opened at_face sum]; rewrite !O by reflexivity; cbn; lia.
  - cbn [map at_face filter]; unfold inner_vertex; rewrite !V; cbn; lia.
  - exists []; split; [split; [constructor|]|reflexivity]; intros k; split; [intros []|].
    intros [a [I E]]; cbn [map at_face In] in I; destruct I as [<-|[<-|[<-|[]]]]; rewrite V in E;
      discriminate.
  - intros _; left; split; auto; exists t; repeat split; auto.
    cbn [map at_face In]; intros a [<-|[<-|[<-|[]]]]; eauto.
Qed.

Lemma begin_border_tally : forall c, (face c < T)%nat -> opp c = None ->
  tally false (begin_border M c).
Proof.
  intros c L OC; destruct (border_curve M HM c L OC) as (k & K1 & _).
  assert (W : forall a, In a (whole M (v (next c))) -> curve M a = Some k).
  { intros a X; apply in_whole in X; destruct X as [_ X]; unfold ring in X; rewrite K1 in X.
    destruct (curve M a); [|discriminate]; apply Nat.eqb_eq in X; subst; auto. }
  unfold begin_border.
  constructor; cbn [gate stack visited marked word records negb when]; auto; try (cbn; lia);
    try discriminate; try exact I.
  - assert (filter (inner_vertex M) (whole M (v (next c))) = []) as ->; [|reflexivity].
    assert (K : forall l, (forall a, In a l -> curve M a = Some k) ->
      filter (inner_vertex M) l = []).
    { clear; induction l as [|a l IH]; intros X; cbn; auto; unfold inner_vertex at 1.
      rewrite (X a) by (left; auto); apply IH; intros; apply X; right; auto. }
    apply K; exact W.
  - exists [k]; split; [split|reflexivity].
    + constructor; [intros []|constructor].
    + intros j; cbn [In]; split.
      * intros [<-|[]]; exists (v (next c)); split; auto; apply in_whole; split;
          auto using ring_refl.
        apply vertex_in; auto.
      * intros [a [I E]]; apply W in I; left; congruence.
Qed.

Lemma moves_visited : forall s c s', moves M s c s' -> visited s' = face c :: visited s.
Proof. intros s c s' MV; destruct MV; reflexivity. Qed.

Lemma run_keeps : forall k, (k = true -> forall a, (a < vertices M)%nat -> curve M a = None) ->
  forall n s full, holds M s full -> tally k s ->
  let e := run M n s in (exists full', holds M e full') /\ tally k e
  /\ (length (visited s) <= length (visited e))%nat
  /\ (gate e = None \/ length (visited e) = length (visited s) + n)%nat.
Proof.
  intros k NC; induction n as [|n IH]; intros s full H TL; cbn [run].
  - repeat split; eauto; try apply TL; right; lia.
  - destruct (gate s) as [c|] eqn:G.
    + pose proof H as [_ R]; rewrite G in R; destruct R as [NV R].
      destruct (step_moves M HM s c full G R NV) as (s' & -> & MV).
      destruct (step_holds M HM s c full s' G H MV) as [full' H'].
      destruct (IH s' full' H' (tally_step M HM k s c full s' G H TL NC MV)) as (A & B & C & D).
      apply moves_visited in MV; rewrite MV in C, D; cbn [length] in C, D.
      split; [exact A|split; [exact B|split; [lia|]]]; destruct D; [left; auto|right; lia].
    + unfold step; rewrite G; split; [eauto|split; [exact TL|split; [lia|left; exact G]]].
Qed.

(** EB-TRAVERSE-1: a walk ends, after T steps at most; then every face has been visited, each once,
    and every vertex is marked. *)
Theorem walk_ends : forall k s, walk M k s -> gate s = None
  /\ (NoDup (visited s) /\ forall t, In t (visited s) <-> (t < T)%nat)
  /\ (NoDup (marked s) /\ forall a, In a (marked s) <-> (a < vertices M)%nat)
  /\ stack s = [] /\ tally k s
  /\ (k = true -> forall a, (a < vertices M)%nat -> curve M a = None)
  /\ (k = true -> forall c, (face c < T)%nat -> opp c <> None)
  /\ (k = false -> (0 < border_edges M)%nat).
Proof.
  intros k s W.
  assert (A : exists s0 full, s = run M T s0 /\ holds M s0 full /\ tally k s0
    /\ (0 < length (visited s0) + T)%nat
    /\ (k = true -> forall a, (a < vertices M)%nat -> curve M a = None)
    /\ (k = true -> forall c, (face c < T)%nat -> opp c <> None)
    /\ (k = false -> (0 < border_edges M)%nat)).
  { destruct W as [t L NB|c L OC].
    - destruct (begin_closed_holds M HM t L NB) as [full H].
      exists (begin_closed M t), full; split; [reflexivity|split; [exact H|]].
      split; [apply begin_closed_tally; auto|split; [cbn; lia|]].
      split; [intros _; apply no_curves; auto|split; [auto|discriminate]].
    - destruct (begin_border_holds M HM c L OC) as [full H].
      exists (begin_border M c), full; split; [reflexivity|split; [exact H|]].
      split; [apply begin_border_tally; auto|split; [cbn; lia|]].
      split; [discriminate|split; [discriminate|intros _]].
      unfold border_edges, border_corners.
      assert (I : In c (filter (border M) (all_corners M))).
      { apply filter_In; unfold border; rewrite OC; split; auto; apply in_corners, in_seq; lia. }
      destruct (filter (border M) (all_corners M)); [destruct I|cbn; lia]. }
  destruct A as (s0 & full & -> & H & TL & L & NC & NB & BB).
  destruct (run_keeps k NC T s0 full H TL) as ((full' & H') & TL' & L1 & D); cbn zeta in *.
  set (e := run M T s0) in *.
  assert (VT : (length (visited e) <= T)%nat).
  { destruct H' as [_ R]; destruct (gate e).
    - destruct R as [_ [S _ _]]; rewrite <- (seq_length T 0); apply NoDup_incl_length; [apply S|].
      intros t I; apply in_seq; apply (vis_in M _ _ S) in I; lia.
    - destruct R as [_ [S _ _]]; rewrite <- (seq_length T 0); apply NoDup_incl_length; [apply S|].
      intros t I; apply in_seq; apply (vis_in M _ _ S) in I; lia. }
  assert (GN : gate e = None).
  { destruct (gate e) as [c|] eqn:G; auto; exfalso; destruct D as [D|D]; [discriminate|].
    destruct H' as [_ R]; rewrite G in R; destruct R as [NV [S _ U]]; destruct U as [[F _] _].
    assert (N : NoDup (face c :: visited e)) by (constructor; auto; apply S).
    apply (NoDup_incl_length (l' := seq 0 T)) in N.
    - rewrite seq_length in N; cbn [length] in N; lia.
    - intros t [<-|I]; apply in_seq; [|apply (vis_in M _ _ S) in I]; lia. }
  assert (NE : visited e <> []).
  { destruct TL' as [TF _ _ _ _ _ _ TE _]; destruct (TE GN) as [w W'].
    rewrite W', size_cons in TF; intros E; rewrite E in TF; cbn [length] in TF.
    unfold size in TF; destruct k; cbn [when] in TF; lia. }
  destruct (visits_all M HM e full' H' GN NE) as [VA MA].
  pose proof H' as [HS R]; rewrite GN in R; destruct R as [-> [S _ _]].
  split; [auto|]; split; [split; auto; apply S|]; split; [split; auto; apply S|].
  split; [exact HS|]; auto.
Qed.
End Surface.
