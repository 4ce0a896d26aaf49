(** * The traversal of a connected surface, and why it visits everything

    Clauses: EB-GATE-1, EB-GATE-2 (gates; closed and open edges), EB-COMPONENT-1 and -2 (how a
    component is begun), EB-TRAVERSE-1 to -7 (the walk), EB-HANDLE-1 and -2 (which S gets a record,
    of which kind).

    The walk turns right at a C and at an S, and only an S leaves its left gate on the stack. What
    is behind the left edge of a C nobody remembers. It is visited all the same: the corners around
    the new vertex form one orbit of a swing that is injective, and what the swing maps into itself
    it maps onto itself ([comes_round]). An S that reaches a curve is the same with the curve in
    place of the vertex: so its left gate is always passed over, which is to say, it always has a
    record. At the end no edge is open, and the surface is connected: so all faces were visited
    ([visits_all]). *)

Require Import ZArith List Lia Arith Bool Permutation.
From Clers Require Import Letters Surface.
Import ListNotations.
Open Scope nat_scope.

(** ** The walk, as section 5.4 has it *)

(** The stack has the left gates of S, each with whether its S reached a curve. The word is kept
    with the last symbol first, the visited faces as well. A record is told by its kind alone: true
    is boundary. Where the gate is None the component is finished. *)
Record state := State {
  gate : option corner;
  stack : list (corner * bool);
  visited : list nat;
  marked : list nat;
  word : list symbol;
  records : list bool
}.

(** The gate behind an edge, if the edge is open (EB-GATE-2). *)
Definition behind (M : table) (vis : list nat) (x : corner) : option corner :=
  match opposite M x with
  | Some d => if mem (face d) vis then None else Some d
  | None => None
  end.

(** EB-TRAVERSE-5: gates are popped until one is found whose triangle is not visited. By
    EB-HANDLE-1 each that is passed over makes a record. *)
Fixpoint pop (vis : list nat) (st : list (corner * bool)) (rec : list bool)
  : option corner * list (corner * bool) * list bool :=
  match st with
  | [] => (None, [], rec)
  | (d, b) :: r => if mem (face d) vis then pop vis r (b :: rec) else (Some d, r, rec)
  end.

(** The vertices that are reached together: those of one curve; a vertex inside is reached alone. *)
Definition ring (M : table) (v w : nat) : bool :=
  match curve M v, curve M w with
  | Some j, Some k => j =? k
  | None, None => v =? w
  | _, _ => false
  end.
Definition whole (M : table) (v : nat) : list nat := filter (ring M v) (seq 0 (vertices M)).

Definition step (M : table) (s : state) : option state :=
  match gate s with
  | None => None
  | Some c =>
      let vis := face c :: visited s in
      let v := vertex M c in
      let known := mem v (marked s) in
      Some
        (if negb known && inner_vertex M v
         then State (behind M vis (next c)) (stack s) vis (v :: marked s) (sC :: word s) (records s)
         else
           match behind M vis (prev c), behind M vis (next c) with
           | Some l, None => State (Some l) (stack s) vis (marked s) (sR :: word s) (records s)
           | None, Some r => State (Some r) (stack s) vis (marked s) (sL :: word s) (records s)
           | None, None =>
               let '(g, st, rec) := pop vis (stack s) (records s) in
               State g st vis (marked s) (sE :: word s) rec
           | Some l, Some r =>
               State (Some r) ((l, negb known) :: stack s) vis
                 (if known then marked s else whole M v ++ marked s) (sS :: word s) (records s)
           end)
  end.

Fixpoint run (M : table) (n : nat) (s : state) : state :=
  match n with
  | 0 => s
  | S k => match step M s with None => s | Some s' => run M k s' end
  end.

(** EB-COMPONENT-2: a closed component begins at a triangle P, any. *)
Definition begin_closed (M : table) (t : nat) : state :=
  State (opposite M (t, p0)) [] [t] (map (vertex M) (at_face t)) [] [].
(** EB-COMPONENT-1: one with boundary at an edge of a curve, any; that curve is reached. *)
Definition begin_border (M : table) (c : corner) : state :=
  State (Some c) [] [] (whole M (vertex M (next c))) [] [].

(** ** What holds on the way *)

Section Surface.
Variable M : table.
Hypothesis HM : surface M.
Notation v := (vertex M).
Notation opp := (opposite M).
Notation T := (triangles M).

Lemma ring_refl : forall a, ring M a a = true.
Proof. intros a; unfold ring; destruct (curve M a); apply Nat.eqb_refl. Qed.
Lemma ring_sym : forall a b, ring M a b = ring M b a.
Proof. intros a b; unfold ring; destruct (curve M a), (curve M b); auto using Nat.eqb_sym. Qed.
Lemma ring_trans : forall a b c, ring M a b = true -> ring M b c = true -> ring M a c = true.
Proof.
  intros a b c; unfold ring; destruct (curve M a) eqn:A, (curve M b) eqn:B, (curve M c) eqn:C;
    intros H G; try discriminate; apply Nat.eqb_eq in H; apply Nat.eqb_eq in G; subst; try congruence;
    apply Nat.eqb_refl.
Qed.

Lemma in_whole : forall a b, In b (whole M a) <-> b < vertices M /\ ring M a b = true.
Proof. intros; unfold whole; rewrite filter_In, in_seq; intuition lia. Qed.

Lemma behind_some : forall vis x d, behind M vis x = Some d <-> opp x = Some d /\ ~ In (face d) vis.
Proof.
  intros vis x d; unfold behind; destruct (opp x) as [e|]; [|split; [|intros []]; congruence].
  destruct (mem (face e) vis) eqn:E.
  - apply mem_true in E; split; [discriminate|intros [H G]; congruence].
  - apply mem_false in E; split; [intros H; injection H as ->; auto|intros [H _]; auto].
Qed.

(** The visited faces and the marked vertices. *)
Record sane (vis mk : list nat) : Prop := {
  vis_once : NoDup vis;
  vis_in : forall t, In t vis -> t < T;
  mk_once : NoDup mk;
  mk_in : forall a, In a mk -> a < vertices M;
  vis_marked : forall c, In (face c) vis -> In (v c) mk;
  mk_whole : forall a b, In a mk -> ring M a b = true -> b < vertices M -> In b mk
}.

(** A list of gates in the order in which they will be met. [None] is for one that the walk does
    not remember (behind the left edge of a C, or an edge of P), [Some b] for one on its stack. *)
Definition gates : Type := list (corner * option bool).

(** Why a gate d will be visited before its turn: it is behind the left edge of a triangle with the
    apex corner c, and no gate that is left after it touches what was reached at c. *)
Definition guarded (d : corner) (rest : gates) : Prop :=
  exists c, opp d = Some (prev c) /\ ring M (v c) (v (next c)) = false
  /\ forall e k, In (e, k) rest ->
       ring M (v c) (v (next e)) = false /\ ring M (v c) (v (prev e)) = false.

Fixpoint sound (vis mk : list nat) (l : gates) : Prop :=
  match l with
  | [] => True
  | (d, k) :: rest =>
      (face d < T /\ In (v (next d)) mk /\ In (v (prev d)) mk
       /\ match opp d with None => True | Some x => In (face x) vis end)
      /\ (k <> Some false -> guarded d rest)
      /\ sound vis mk rest
  end.

(** No open edge is forgotten: the gate behind it is in the list. *)
Record ready (vis mk : list nat) (l : gates) : Prop := {
  ready_sane : sane vis mk;
  ready_open : forall x d, In (face x) vis -> opp x = Some d -> ~ In (face d) vis ->
    In d (map fst l);
  ready_sound : sound vis mk l
}.

Lemma sound_more : forall vis mk vis' mk' l, incl vis vis' -> incl mk mk' ->
  sound vis mk l -> sound vis' mk' l.
Proof.
  intros vis mk vis' mk' l I J; induction l as [|[d k] l IH]; cbn; auto.
  intros [[A [B [C D]]] [G S]]; repeat split; auto.
  destruct (opp d); auto.
Qed.

Lemma sound_ends : forall vis mk l e k, sound vis mk l -> In (e, k) l ->
  In (v (next e)) mk /\ In (v (prev e)) mk.
Proof.
  intros vis mk; induction l as [|[d j] l IH]; intros e k H I; [destruct I|].
  cbn in H; destruct H as [[A [B [C D]]] [G S]].
  destruct I as [I|I]; [injection I as -> ->; auto|eauto].
Qed.

(** *** Coming round *)

(** The swing of a corner: across its right edge, and where that is a border edge, to the corner at
    the edge's other end. *)
Definition swing (e : corner) : corner :=
  match opp (next e) with Some d => next d | None => prev e end.

Lemma swing_injective : forall e e', face e < T -> face e' < T -> swing e = swing e' -> e = e'.
Proof.
  intros e e' F F'; unfold swing.
  destruct (opp (next e)) as [d|] eqn:O, (opp (next e')) as [d'|] eqn:O'; intros H.
  - apply next_inj in H; subst d'.
    destruct (opposite_sound M HM (next e) d F O) as (_ & P & _).
    destruct (opposite_sound M HM (next e') d F' O') as (_ & P' & _).
    apply next_inj; congruence.
  - assert (d = next e') as -> by (apply next_inj; rewrite H; reflexivity).
    destruct (opposite_sound M HM (next e) (next e') F O) as (_ & P & _); congruence.
  - assert (d' = next e) as -> by (apply next_inj; rewrite <- H; reflexivity).
    destruct (opposite_sound M HM (next e') (next e) F' O') as (_ & P & _); congruence.
  - apply prev_inj; exact H.
Qed.

Lemma swing_ring : forall e, face e < T -> ring M (v e) (v (swing e)) = true.
Proof.
  intros e F; unfold swing; destruct (opp (next e)) as [d|] eqn:O.
  - destruct (opposite_sound M HM (next e) d F O) as (_ & _ & _ & P & _).
    rewrite P, prev_next; apply ring_refl.
  - destruct (border_curve M HM (next e) F O) as (k & P & Q).
    rewrite prev_next in Q; rewrite next_next in P; unfold ring; rewrite P, Q; apply Nat.eqb_refl.
Qed.

(** A guarded gate on top of the list has been visited. *)
Theorem comes_round : forall vis mk d k rest,
  ready vis mk ((d, k) :: rest) -> guarded d rest -> In (face d) vis.
Proof.
  intros vis mk d k rest R (c & OD & NR & G).
  destruct R as [[VN VI _ _ _ _] RO [[DT [_ [_ DX]]] _]].
  rewrite OD in DX; rewrite face_prev in DX.
  destruct (mem (face d) vis) eqn:E; [apply mem_true; auto|exfalso; apply mem_false in E].
  set (P := filter (fun e => ring M (v c) (v e)) (corners vis)).
  assert (PI : forall e, In e P <-> In (face e) vis /\ ring M (v c) (v e) = true).
  { intros e; unfold P; rewrite filter_In, in_corners; tauto. }
  assert (PN : NoDup P) by (apply NoDup_filter, nodup_corners; auto).
  assert (SI : forall e, In e P -> In (swing e) P).
  { intros e I; pose proof I as I'; apply PI in I; destruct I as [I Q].
    pose proof (swing_ring e (VI _ I)) as W; apply PI; split.
    - unfold swing in *; destruct (opp (next e)) as [x|] eqn:O; [|exact I].
      destruct (mem (face x) vis) eqn:X; [apply mem_true; auto|exfalso; apply mem_false in X].
      destruct (opposite_sound M HM (next e) x (VI _ I) O) as (_ & OX & _ & V1 & V2).
      rewrite prev_next in V1.
      destruct (RO (next e) x I O X) as [Y|Y].
      + cbn in Y; subst x.
        assert (Z : prev c = next e) by congruence.
        assert (c = prev e) as -> by (rewrite <- (next_prev c), Z; reflexivity).
        rewrite next_prev in NR; congruence.
      + apply in_map_iff in Y; destruct Y as [[y j] [Y1 Y2]]; cbn in Y1; subst y.
        destruct (G x j Y2) as [G1 _]; rewrite V1 in G1; congruence.
    - eapply ring_trans; eauto. }
  assert (PM : NoDup (map swing P)).
  { clear - HM PN PI VI.
    assert (forall l, NoDup l -> (forall e, In e l -> face e < T) -> NoDup (map swing l)) as K.
    { induction 1 as [|e l NI N IH]; intros F; cbn; constructor.
      - intros I; apply in_map_iff in I; destruct I as [x [X1 X2]]; apply NI.
        assert (x = e) as <- by (apply swing_injective; auto; apply F; cbn; auto); auto.
      - apply IH; intros; apply F; cbn; auto. }
    apply K; auto; intros e I; apply PI in I; apply VI; tauto. }
  assert (CP : In c P) by (apply PI; split; auto using ring_refl).
  assert (In c (map swing P)) as CM.
  { apply (NoDup_length_incl (l' := P) PM); [rewrite map_length; auto| |exact CP].
    intros x I; apply in_map_iff in I; destruct I as [y [Y1 Y2]]; subst; auto. }
  apply in_map_iff in CM; destruct CM as [e [Y1 Y2]]; apply PI in Y2; destruct Y2 as [I Q].
  unfold swing in Y1; destruct (opp (next e)) as [x|] eqn:O.
  - destruct (opposite_sound M HM (next e) x (VI _ I) O) as (_ & OX & _).
    assert (x = prev c) as -> by (subst c; symmetry; apply prev_next).
    destruct (opposite_sound M HM d (prev c) DT OD) as (_ & OC & _).
    rewrite OC in OX; injection OX as ->; apply E; exact I.
  - subst c; rewrite next_prev in NR; congruence.
Qed.

(** *** Going on *)

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
  rewrite V1, V2, prev_prev, next_prev, Q; repeat split; auto; try (left; reflexivity); apply I; exact A.
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
  - destruct (sound_ends _ _ _ _ _ U H); auto.
  - destruct (sound_ends _ _ _ _ _ U H); auto.
Qed.

(** *** The steps *)

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
  inversion MV as [r l N C BR BL|l VC BR BL|r VC BR BL|g st rec VC BR BL PP|r l VC BR BL|r l k N C BR BL];
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
      * unfold behind in BR; rewrite OX in BR; apply mem_false in ND; rewrite ND in BR; discriminate.
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

(** *** At the end *)

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

(** *** At the beginning *)

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
