(** * What the walk does not remember comes round

    Clauses: EB-TRAVERSE-2, EB-TRAVERSE-7 and EB-HANDLE-1, for what they leave unsaid.

    The walk turns right at a C and at an S, and only an S leaves its left gate on the stack. What
    is behind the left edge of a C nobody remembers. It is visited all the same: the corners around
    the new vertex form orbits of a swing that is injective, and what the swing maps into itself it
    maps onto itself ([comes_round]). An S that reaches a curve is the same with the curve in place
    of the vertex: so its left gate is always passed over, which is to say, it has a record. *)

Require Import ZArith List Lia Arith Bool Permutation.
From Clers Require Import Letters Surface Edges Walk.
Import ListNotations.
Open Scope nat_scope.

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
    intros H G; try discriminate; apply Nat.eqb_eq in H; apply Nat.eqb_eq in G; subst;
      try congruence;
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
End Surface.
