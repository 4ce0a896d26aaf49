(** * Every step of the walk, and what it keeps

    Clauses: EB-TRAVERSE-2 to -7, EB-TRAVERSE-8 as far as it says which sides are open. The sentence
    that first contact with a curve is an S is [first_contact]. Each step forgets no open edge
    ([step_holds]). *)

Require Import ZArith List Lia Arith Bool Permutation.
From Clers Require Import Letters Surface Edges Walk Gates.
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

(** ** Going on *)

Lemma ready_pop : forall vis mk e l, ready vis mk (e :: l) -> In (face (fst e)) vis ->
  ready vis mk l.
Proof.
  intros vis mk [d k] l [A B [_ [_ C]]] I; constructor; auto.
  intros x y X O Y; destruct (B x y X O Y) as [E|E]; auto; cbn in *; congruence.
Qed.

(** The stack that the walk has is the list of gates without those it does not remember. *)
Definition real (l : gates) : list (corner * bool) :=
  flat_map (fun e => match snd e with Some b => [(fst e, b)] | None => [] end) l.

Definition truths (l : list bool) : nat := sum one_if l.

(** Popping: what is passed over and not on the stack was visited, and so was what an S that
    reached a curve has left. The one gone on at is an ordinary left gate. *)
Lemma resume : forall vis mk l rec, ready vis mk l ->
  let '(g, st, rec') := pop vis (real l) rec in
  truths rec' + truths (map snd st) = truths rec + truths (map snd (real l))
  /\ match g with
     | None => st = [] /\ ready vis mk [] /\ length rec' = length rec + length (real l)
     | Some d => exists l', st = real l' /\ ~ In (face d) vis
                 /\ ready vis mk ((d, Some false) :: l')
                 /\ length rec' + length st + 1 = length rec + length (real l)
     end.
Proof.
  intros vis mk; induction l as [|[d k] l IH]; intros rec R.
  - cbn; do 3 (split; [auto|]); lia.
  - assert (V : k <> Some false -> In (face d) vis).
    { intros K; eapply comes_round; eauto; destruct R as [_ _ [_ [G _]]]; auto. }
    destruct k as [b|].
    + cbn [real flat_map snd fst app pop]; fold (real l).
      destruct (mem (face d) vis) eqn:E.
      * apply mem_true in E; specialize (IH (b :: rec) (ready_pop _ _ _ _ R E)).
        destruct (pop vis (real l) (b :: rec)) as [[g st] rec'].
        destruct IH as [IH1 IH2]; cbn [map snd length] in *; unfold truths in *; cbn [sum] in *.
        split; [lia|]; destruct g as [x|].
        -- destruct IH2 as (l' & A & B & C & D); exists l'; do 3 (split; [auto|]); lia.
        -- destruct IH2 as (A & B & C); do 2 (split; [auto|]); lia.
      * apply mem_false in E; destruct b; [exfalso; apply E, V; discriminate|].
        cbn [map snd length]; unfold truths; cbn [sum one_if]; split; [lia|].
        exists l; do 3 (split; [auto|]); lia.
    + change (real ((d, None) :: l)) with (real l); apply IH.
      eapply ready_pop; eauto; cbn; apply V; discriminate.
Qed.

(** Visiting the triangle of a gate c: if every edge of it that is open gets its gate into the
    list, no open edge is forgotten. *)
Lemma ready_visit : forall vis mk c k full mk' new,
  ready vis mk ((c, k) :: full) -> ~ In (face c) vis ->
  sane (face c :: vis) mk' -> incl mk mk' ->
  (forall x d, x = next c \/ x = prev c -> opp x = Some d -> ~ In (face d) (face c :: vis) ->
    In d (map fst new)) ->
  sound (face c :: vis) mk' (new ++ full) ->
  ready (face c :: vis) mk' (new ++ full).
Proof.
  intros vis mk c k full mk' new [S O U] NV S' I N U'; constructor; auto.
  intros x d FX OX ND; rewrite map_app, in_app_iff.
  destruct FX as [FX|FX].
  - destruct (same_face c x FX) as [X|X]; [subst x|left; eapply N; eauto].
    destruct U as [[_ [_ [_ D]]] _]; rewrite OX in D; exfalso; apply ND; right; exact D.
  - destruct (O x d FX OX) as [E|E]; auto; [intros G; apply ND; right; exact G|].
    cbn in E; subst d; exfalso; apply ND; left; reflexivity.
Qed.

(** The gates behind the right and the left edge of a triangle with the gate c. *)
Lemma sound_right : forall vis mk mk' c r, face c < T -> In (v (prev c)) mk ->
  incl mk mk' -> In (v c) mk' -> opp (next c) = Some r ->
  face r < T /\ In (v (next r)) mk' /\ In (v (prev r)) mk'
  /\ match opp r with None => True | Some x => In (face x) (face c :: vis) end.
Proof.
  intros vis mk mk' c r F A I B O.
  destruct (opposite_sound M HM (next c) r F O) as (P & Q & _ & V1 & V2).
  rewrite V1, V2, prev_next, Q; repeat split; auto; try (left; reflexivity); apply I; exact A.
Qed.

Lemma sound_left : forall vis mk mk' c l, face c < T -> In (v (next c)) mk ->
  incl mk mk' -> In (v c) mk' -> opp (prev c) = Some l ->
  face l < T /\ In (v (next l)) mk' /\ In (v (prev l)) mk'
  /\ match opp l with None => True | Some x => In (face x) (face c :: vis) end.
Proof.
  intros vis mk mk' c l F A I B O.
  destruct (opposite_sound M HM (prev c) l F O) as (P & Q & _ & V1 & V2).
  rewrite V1, V2, prev_prev, next_prev, Q; repeat split; auto; try (left; reflexivity); apply I;
    exact A.
Qed.

(** At a new vertex or curve the left gate is guarded. *)
Lemma guarded_left : forall vis mk c k full l, ready vis mk ((c, k) :: full) ->
  ~ In (v c) mk -> opp (prev c) = Some l -> guarded l full.
Proof.
  intros vis mk c k full l [S O U] N OL; destruct U as [[F [A [B _]]] [_ U]].
  assert (R : forall a, In a mk -> ring M (v c) a = false).
  { intros a I; destruct (ring M (v c) a) eqn:E; auto; exfalso; apply N.
    eapply mk_whole; eauto; [rewrite ring_sym; auto|apply vertex_in; auto]. }
  destruct (opposite_sound M HM (prev c) l F OL) as (_ & P & _).
  exists c; repeat split; auto.
  - destruct (sound_ends M _ _ _ _ _ U H); auto.
  - destruct (sound_ends M _ _ _ _ _ U H); auto.
Qed.

(** ** The steps *)

(** What a step is, with what the walk does not look at but is so: at a C and at an S that reaches
    a curve both edges are open. *)
Inductive moves (s : state) (c : corner) : state -> Prop :=
| move_C : forall r l, ~ In (v c) (marked s) -> curve M (v c) = None ->
    behind M (face c :: visited s) (next c) = Some r ->
    behind M (face c :: visited s) (prev c) = Some l ->
    moves s c (State (Some r) (stack s) (face c :: visited s) (v c :: marked s)
      (sC :: word s) (records s))
| move_R : forall l, In (v c) (marked s) ->
    behind M (face c :: visited s) (next c) = None ->
    behind M (face c :: visited s) (prev c) = Some l ->
    moves s c (State (Some l) (stack s) (face c :: visited s) (marked s) (sR :: word s) (records s))
| move_L : forall r, In (v c) (marked s) ->
    behind M (face c :: visited s) (next c) = Some r ->
    behind M (face c :: visited s) (prev c) = None ->
    moves s c (State (Some r) (stack s) (face c :: visited s) (marked s) (sL :: word s) (records s))
| move_E : forall g st rec, In (v c) (marked s) ->
    behind M (face c :: visited s) (next c) = None ->
    behind M (face c :: visited s) (prev c) = None ->
    pop (face c :: visited s) (stack s) (records s) = (g, st, rec) ->
    moves s c (State g st (face c :: visited s) (marked s) (sE :: word s) rec)
| move_S : forall r l, In (v c) (marked s) ->
    behind M (face c :: visited s) (next c) = Some r ->
    behind M (face c :: visited s) (prev c) = Some l ->
    moves s c (State (Some r) ((l, false) :: stack s) (face c :: visited s) (marked s)
      (sS :: word s) (records s))
| move_Sb : forall r l k, ~ In (v c) (marked s) -> curve M (v c) = Some k ->
    behind M (face c :: visited s) (next c) = Some r ->
    behind M (face c :: visited s) (prev c) = Some l ->
    moves s c (State (Some r) ((l, true) :: stack s) (face c :: visited s)
      (whole M (v c) ++ marked s) (sS :: word s) (records s)).

(** First contact with a new vertex or curve finds both edges open: were one of them closed, the
    apex would be marked. *)
Theorem first_contact : forall vis mk c k full, ready vis mk ((c, k) :: full) ->
  ~ In (face c) vis -> ~ In (v c) mk ->
  (exists r, behind M (face c :: vis) (next c) = Some r)
  /\ (exists l, behind M (face c :: vis) (prev c) = Some l).
Proof.
  intros vis mk c k full [S O U] NV N; destruct U as [[F [A [B _]]] _].
  assert (K : forall x, face x = face c -> (v (next x) = v c /\ In (v (prev x)) mk)
    \/ (v (prev x) = v c /\ In (v (next x)) mk) -> exists d, behind M (face c :: vis) x = Some d).
  { intros x FX D; destruct (opp x) as [d|] eqn:OX.
    - exists d; apply behind_some; split; auto; intros [Y|Y].
      + destruct (opposite_sound M HM x d ltac:(congruence) OX) as (_ & _ & Z & _); congruence.
      + destruct (opposite_sound M HM x d ltac:(congruence) OX) as (_ & _ & _ & V1 & V2).
        apply N; destruct D as [[D _]|[D _]].
        * rewrite <- D, <- V2; eapply vis_marked; eauto.
        * rewrite <- D, <- V1; eapply vis_marked; eauto.
    - exfalso; destruct (border_curve M HM x ltac:(congruence) OX) as (j & P & Q); apply N.
      destruct D as [[D I]|[D I]]; rewrite D in *;
        (eapply mk_whole; [eauto|exact I| |apply vertex_in; auto]);
        unfold ring; rewrite P, Q; apply Nat.eqb_refl. }
  split; apply K; auto; [right|left]; rewrite ?prev_next, ?next_prev, ?next_next, ?prev_prev; auto.
Qed.

Theorem step_moves : forall s c full, gate s = Some c ->
  ready (visited s) (marked s) ((c, Some false) :: full) -> ~ In (face c) (visited s) ->
  exists s', step M s = Some s' /\ moves s c s'.
Proof.
  intros s c full G R NV; unfold step; rewrite G; eexists; split; [reflexivity|].
  pose proof (first_contact _ _ _ _ _ R NV) as FC.
  destruct (mem (v c) (marked s)) eqn:K; cbn [negb andb].
  - apply mem_true in K.
    destruct (behind M (face c :: visited s) (prev c)) as [l|] eqn:L,
      (behind M (face c :: visited s) (next c)) as [r|] eqn:Rr.
    + eapply move_S; eauto.
    + eapply move_R; eauto.
    + eapply move_L; eauto.
    + destruct (pop (face c :: visited s) (stack s) (records s)) as [[g st] rec] eqn:P.
      eapply move_E; eauto.
  - apply mem_false in K; destruct (FC K) as [[r Er] [l El]]; rewrite Er, El.
    unfold inner_vertex; destruct (curve M (v c)) as [j|] eqn:J.
    + eapply move_Sb; eauto.
    + eapply move_C; eauto.
Qed.

(** Where the walk is: [full] is the list of gates, of which its stack is a part. *)
Definition holds (s : state) (full : gates) : Prop :=
  stack s = real full
  /\ match gate s with
     | Some c => ~ In (face c) (visited s)
                 /\ ready (visited s) (marked s) ((c, Some false) :: full)
     | None => full = [] /\ ready (visited s) (marked s) []
     end.

Lemma ready_step_right : forall vis mk c k full r mk' extra, ready vis mk ((c, k) :: full) ->
  ~ In (face c) vis -> sane (face c :: vis) mk' -> incl mk mk' -> In (v c) mk' ->
  behind M (face c :: vis) (next c) = Some r ->
  (behind M (face c :: vis) (prev c) = None /\ extra = []
   \/ exists l j, behind M (face c :: vis) (prev c) = Some l /\ extra = [(l, j)]
        /\ (j <> Some false -> guarded l full)) ->
  ready (face c :: vis) mk' ((r, Some false) :: extra ++ full).
Proof.
  intros vis mk c k full r mk' extra R NV S' I VC BR E.
  pose proof R as [S O U]; destruct U as [[F [A [B D]]] [_ U]].
  apply behind_some in BR; destruct BR as [OR NR].
  change ((r, Some false) :: extra ++ full) with (((r, Some false) :: extra) ++ full).
  eapply ready_visit; eauto.
  - intros x d [X|X] OX ND; subst x.
    + rewrite OR in OX; injection OX as <-; cbn; auto.
    + destruct E as [[E _]|[l [j [E [-> _]]]]].
      * unfold behind in E; rewrite OX in E; apply mem_false in ND; rewrite ND in E; discriminate.
      * apply behind_some in E; destruct E as [E _]; rewrite E in OX; injection OX as <-; cbn; auto.
  - assert (U' : sound (face c :: vis) mk' full).
    { eapply sound_more; [|exact I|exact U]; intros y Y; right; exact Y. }
    cbn [app sound]; split; [|split].
    + eapply sound_right; eauto.
    + intros Q; congruence.
    + destruct E as [[_ ->]|[l [j [E [-> Q]]]]]; cbn [app sound]; auto.
      apply behind_some in E; destruct E as [E _]; split; [|split; auto].
      eapply sound_left; eauto.
Qed.

Lemma sane_visit : forall vis mk c, sane vis mk -> face c < T -> ~ In (face c) vis ->
  (forall mk', NoDup mk' -> (forall a, In a mk' -> a < vertices M) -> incl mk mk' ->
    In (v c) mk' -> In (v (next c)) mk -> In (v (prev c)) mk ->
    (forall a b, In a mk' -> ring M a b = true -> b < vertices M -> In b mk') ->
    sane (face c :: vis) mk').
Proof.
  intros vis mk c S F N mk' N' I' IN VC A B W; constructor; auto.
  - constructor; auto; apply S.
  - intros t [<-|X]; auto; apply S; auto.
  - intros e [X|X]; [|apply IN; eapply vis_marked; eauto].
    destruct (same_face c e X) as [->|[-> | ->]]; auto.
Qed.

(** EB-TRAVERSE: every step goes from such a place to such a place. *)
Theorem step_holds : forall s c full s', gate s = Some c -> holds s full -> moves s c s' ->
  exists full', holds s' full'.
Proof.
  intros s c full s' G [HS H] MV; rewrite G in H; destruct H as [NV R].
  pose proof R as [S O U]; destruct U as [[F [A [B D]]] [_ U]].
  assert (V : v c < vertices M) by (apply vertex_in; auto).
  assert (SAME : In (v c) (marked s) -> sane (face c :: visited s) (marked s)).
  { intros VC; eapply sane_visit; eauto using incl_refl; try apply S. }
  inversion MV as [r l N C BR BL|l VC BR BL|r VC BR BL|g st rec VC BR BL PP|r l VC BR BL|r l k N C
    BR BL];
    subst s'.
  - (* C *)
    assert (S' : sane (face c :: visited s) (v c :: marked s)).
    { eapply sane_visit; eauto.
      - constructor; auto; apply S.
      - intros a [<-|X]; auto; apply S; auto.
      - intros a X; right; exact X.
      - left; auto.
      - intros a b [<-|X] Q Y.
        + left; unfold ring in Q; rewrite C in Q.
          destruct (curve M b); [discriminate|]; apply Nat.eqb_eq; auto.
        + right; eapply mk_whole; eauto. }
    exists ((l, None) :: full); split; [exact HS|]; cbn [gate visited marked].
    split; [apply behind_some in BR; tauto|].
    eapply (ready_step_right _ _ c _ full r _ [(l, None)]); eauto.
    + intros a X; right; exact X.
    + left; auto.
    + right; exists l, None; repeat split; auto; intros _.
      eapply guarded_left; eauto; apply behind_some in BL; tauto.
  - (* R *)
    exists full; split; [exact HS|]; cbn [gate visited marked].
    pose proof BL as BL'; apply behind_some in BL'; destruct BL' as [OL NL]; split; [auto|].
    change ((l, Some false) :: full) with ([(l, Some false)] ++ full).
    eapply ready_visit; eauto using incl_refl.
    + intros x d [X|X] OX ND; subst x.
      * unfold behind in BR; rewrite OX in BR; apply mem_false in ND; rewrite ND in BR;
          discriminate.
      * rewrite OL in OX; injection OX as <-; cbn; auto.
    + cbn [app sound]; split; [eapply sound_left; eauto using incl_refl|split; [congruence|]].
      eapply sound_more; [|apply incl_refl|exact U]; intros y Y; right; exact Y.
  - (* L *)
    exists full; split; [exact HS|]; cbn [gate visited marked].
    split; [apply behind_some in BR; tauto|].
    eapply (ready_step_right _ _ c _ full r _ []); eauto using incl_refl.
  - (* E *)
    assert (R' : ready (face c :: visited s) (marked s) full).
    { change full with ([] ++ full); eapply ready_visit; eauto using incl_refl.
      - intros x d [X|X] OX ND; subst x; exfalso; apply mem_false in ND;
          [unfold behind in BR; rewrite OX, ND in BR|unfold behind in BL; rewrite OX, ND in BL];
          discriminate.
      - eapply sound_more; [|apply incl_refl|exact U]; intros y Y; right; exact Y. }
    pose proof (resume _ _ full (records s) R') as Q; rewrite <- HS, PP in Q.
    destruct Q as [_ Q]; destruct g as [d|].
    + destruct Q as (l' & Q1 & Q2 & Q3 & _); exists l'; split; [exact Q1|]; cbn; auto.
    + destruct Q as (Q1 & Q2 & _); exists []; split; [exact Q1|]; cbn; auto.
  - (* S *)
    exists ((l, Some false) :: full); split; [cbn; rewrite HS; reflexivity|].
    cbn [gate visited marked]; split; [apply behind_some in BR; tauto|].
    eapply (ready_step_right _ _ c _ full r _ [(l, Some false)]); eauto using incl_refl.
    right; exists l, (Some false); repeat split; auto; congruence.
  - (* S that reaches a curve *)
    assert (S' : sane (face c :: visited s) (whole M (v c) ++ marked s)).
    { assert (X : forall a, In a (whole M (v c)) -> ~ In a (marked s)).
      { intros a Y Z; apply in_whole in Y; destruct Y as [Y1 Y2]; apply N.
        eapply mk_whole; eauto; rewrite ring_sym; auto. }
      eapply sane_visit; eauto.
      - assert (K : forall p q : list nat, NoDup p -> NoDup q ->
          (forall a, In a p -> ~ In a q) -> NoDup (p ++ q)).
        { clear; induction p as [|a p IH]; intros q P Q D; cbn; auto.
          apply NoDup_cons_iff in P; destruct P as [P1 P2]; constructor.
          - rewrite in_app_iff; intros [Y|Y]; auto; apply (D a); cbn; auto.
          - apply IH; auto; intros b Y; apply D; cbn; auto. }
        apply K; auto; [apply NoDup_filter, seq_NoDup|apply S].
      - intros a Y; apply in_app_iff in Y; destruct Y as [Y|Y];
          [apply in_whole in Y; tauto|apply S; auto].
      - intros a Y; apply in_app_iff; auto.
      - apply in_app_iff; left; apply in_whole; split; auto using ring_refl.
      - intros a b Y Q Z; apply in_app_iff; apply in_app_iff in Y; destruct Y as [Y|Y].
        + left; apply in_whole; apply in_whole in Y; split; auto; eapply ring_trans; [apply Y|auto].
        + right; eapply mk_whole; eauto. }
    exists ((l, Some true) :: full); split; [cbn; rewrite HS; reflexivity|].
    cbn [gate visited marked]; split; [apply behind_some in BR; tauto|].
    eapply (ready_step_right _ _ c _ full r _ [(l, Some true)]); eauto.
    + intros a Y; apply in_app_iff; auto.
    + apply in_app_iff; left; apply in_whole; split; auto using ring_refl.
    + right; exists l, (Some true); repeat split; auto; intros _.
      eapply guarded_left; eauto; apply behind_some in BL; tauto.
Qed.
End Surface.
