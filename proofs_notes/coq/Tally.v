(** * What each step of the walk adds

    Clauses: EB-COUNT-1 (no CL, no CE) is proved here step by step; the rest is for [Counting]. *)

Require Import ZArith List Lia Arith Bool Permutation.
From Clers Require Import Letters Surface Edges Walk Gates Steps.
Import ListNotations.
Open Scope Z_scope.

Definition when (b : bool) (k : Z) : Z := if b then k else 0.

Section Surface.
Variable M : table.
Hypothesis HM : surface M.
Notation v := (vertex M).
Notation opp := (opposite M).
Notation T := (triangles M).

(** ** What each step keeps *)

(** The curves that are reached. *)
Definition reached (mk : list nat) (rs : list nat) : Prop :=
  NoDup rs /\ forall k, In k rs <-> exists a, In a mk /\ curve M a = Some k.

(** After a C the walk is at the gate right of it, and no other face at its apex was visited. *)
Definition just_created (s : state) : Prop :=
  match word s with
  | sC :: _ => exists c d, gate s = Some d /\ opp (next c) = Some d /\ In (face c) (visited s)
      /\ curve M (v c) = None
      /\ forall e, In (face e) (visited s) -> v e = v c -> face e = face c
  | _ => True
  end.

Record tally (k : bool) (s : state) : Prop := {
  t_faces : Z.of_nat (length (visited s)) = when k 1 + size (word s);
  t_opened : Z.of_nat (opened M (visited s))
    = when k 3 + 2 * count sC (word s) + count sL (word s) + count sR (word s) + 2 * count sS (word
      s);
  t_inner : Z.of_nat (length (filter (inner_vertex M) (marked s))) = when k 3 + count sC (word s);
  t_stack : count sS (word s)
    = Z.of_nat (length (stack s)) + Z.of_nat (length (records s)) + count sE (word s)
      - match gate s with None => 1 | Some _ => 0 end;
  t_curves : exists rs, reached (marked s) rs /\ Z.of_nat (length rs)
    = when (negb k) 1 + Z.of_nat (truths (records s)) + Z.of_nat (truths (map snd (stack s)));
  t_tame : tame sE (rev (word s));
  t_created : just_created s;
  t_last : gate s = None -> exists w, word s = sE :: w;
  t_first : k = true ->
    (word s = [] /\ exists t, visited s = [t] /\ gate s = opp (t, p0)
       /\ forall a, In a (marked s) -> exists j, v (t, j) = a)
    \/ exists w, rev (word s) = sC :: w
}.

Lemma in_mem : forall t l, mem t l = true <-> In t l. Proof. apply mem_true. Qed.

Lemma behind_open : forall vis x,
  one_if (open M vis x) = match behind M vis x with Some _ => 1%nat | None => 0%nat end.
Proof.
  intros vis x; unfold open, behind; destruct (opp x) as [d|]; auto.
  destruct (mem (face d) vis); auto.
Qed.

(** How many sides of the triangle of a gate are open. *)
Lemma opened_step : forall vis mk c k full, ready M vis mk ((c, k) :: full) ->
  opened M (face c :: vis)
  = ((match behind M (face c :: vis) (next c) with Some _ => 1 | None => 0 end)
    + (match behind M (face c :: vis) (prev c) with Some _ => 1 | None => 0 end) + opened M
        vis)%nat.
Proof.
  intros vis mk c k full [_ _ [[_ [_ [_ D]]] _]]; cbn [opened]; f_equal.
  unfold at_face; cbn [sum]; rewrite !behind_open.
  set (f := fun x => match behind M (face c :: vis) x with Some _ => 1%nat | None => 0%nat end).
  change (f (face c, p0) + (f (face c, p1) + (f (face c, p2) + 0)) = f (next c) + f (prev c))%nat.
  pose proof (three_corners f c).
  assert (f c = 0%nat); [|lia].
  unfold f, behind; destruct (opp c) as [x|]; auto.
  assert (mem (face x) (face c :: vis) = true) as -> by (apply mem_true; right; auto); auto.
Qed.

(** EB-COUNT-1: the left edge of the triangle after a C is open. *)
Theorem after_a_c : forall s d full w, gate s = Some d -> holds M s full -> just_created s ->
  word s = sC :: w -> exists l, behind M (face d :: visited s) (prev d) = Some l.
Proof.
  intros s d full w G H J W; unfold just_created in J; rewrite W in J.
  destruct J as (c & d' & G' & OC & FC & NC & ONLY).
  rewrite G in G'; injection G' as <-.
  destruct H as [_ H]; rewrite G in H; destruct H as [NV [S _ U]].
  destruct U as [[FD _] _]; pose proof (vis_in _ _ _ S _ FC) as FT.
  destruct (opposite_sound M HM (next c) d FT OC) as (_ & OD & NF & V1 & V2).
  rewrite prev_next in V1; rewrite next_next in V2.
  destruct (opp (prev d)) as [z|] eqn:O.
  - exists z; apply behind_some; split; auto; intros [Z|Z].
    + destruct (opposite_sound M HM (prev d) z FD O) as (_ & _ & N & _).
      rewrite face_prev in N; congruence.
    + destruct (opposite_sound M HM (prev d) z FD O) as (_ & OZ & _ & W1 & W2).
      rewrite prev_prev in W1; rewrite next_prev in W2.
      assert (FZ : face z = face c).
      { rewrite <- face_next; apply ONLY; [exact Z|congruence]. }
      assert (next z = c) as NZ.
      { assert (FN : face c = face (next z)) by (rewrite face_next; auto).
        destruct (same_face c (next z) FN) as [E|[E|E]]; auto; exfalso.
        - pose proof (distinct M HM c FT) as D; apply D; rewrite <- E; congruence.
        - pose proof (distinct M HM (prev c) FT) as D; rewrite next_prev in D; apply D.
          rewrite <- E; congruence. }
      assert (z = prev c) as -> by (rewrite <- NZ; symmetry; apply prev_next).
      rewrite prev_prev in W2.
      apply NF; change (face (next c)) with (face c); apply (simple M HM); auto.
      intros k; destruct (same_face c (face c, k) eq_refl) as [E|[E|E]]; rewrite E.
      * exists (snd (next d)); change (face d, snd (next d)) with (next d); congruence.
      * exists (snd d); destruct d; cbn [face fst snd] in *; congruence.
      * exists (snd (prev d)); change (face d, snd (prev d)) with (prev d); congruence.
  - exfalso; destruct (border_curve M HM (prev d) FD O) as (k & _ & Q).
    rewrite prev_prev, V1 in Q; congruence.
Qed.

Lemma tame_snoc : forall w x, tame sE (rev w) -> match w with sC :: _ => x <> sL /\ x <> sE | _ =>
  True end ->
  tame sE (rev (x :: w)).
Proof.
  intros w x H G; cbn [rev]; apply tame_app; auto.
  destruct w as [|y w]; [destruct x; cbn; auto|].
  cbn [rev]; rewrite final_app; cbn [final]; destruct y, x; cbn; auto; intuition congruence.
Qed.

Lemma reached_more : forall mk rs a, reached mk rs -> curve M a = None -> reached (a :: mk) rs.
Proof.
  intros mk rs a [N R] C; split; auto; intros k; rewrite R; split; intros [b [I E]].
  - exists b; split; auto; right; auto.
  - destruct I as [<-|I]; [congruence|]; exists b; auto.
Qed.

Lemma first_snoc : forall x w, (exists u, rev w = sC :: u) -> exists u, rev (x :: w) = sC :: u.
Proof. intros x w [u E]; exists (u ++ [x]); cbn [rev]; rewrite E; reflexivity. Qed.

(** The first triangle after P has a new apex, or it would be P over again. *)
Lemma first_is_c : forall t mk d, opp (t, p0) = Some d -> sane M [t] mk ->
  (forall a, In a mk -> exists k, v (t, k) = a) -> (face d < T)%nat -> ~ In (v d) mk.
Proof.
  intros t mk d O S K FD I; assert (FT : (t < T)%nat) by (eapply vis_in; [exact S|left; auto]).
  destruct (opposite_sound M HM (t, p0) d FT O) as (_ & OD & NF & V1 & V2).
  apply NF; symmetry; apply (simple M HM); auto.
  intros k; destruct (same_face d (face d, k) eq_refl) as [E|[E|E]]; rewrite E; cbn [face fst].
  - destruct (K _ I) as [j J]; exists j; auto.
  - exists p2; exact V1.
  - exists p1; exact V2.
Qed.

Lemma tally_step : forall k s c full s', gate s = Some c -> holds M s full -> tally k s ->
  (k = true -> forall a, (a < vertices M)%nat -> curve M a = None) ->
  moves M s c s' -> tally k s'.
Proof.
  intros k s c full s' G H TL P MV.
  pose proof H as [HS R]; rewrite G in R; destruct R as [NV R].
  pose proof (opened_step _ _ _ _ _ R) as OP.
  pose proof R as [SN O U]; destruct U as [[F [A [B D]]] [_ U]].
  destruct TL as [TF TO TI TS TC TT TJ TE T1]; rewrite G in TS.
  assert (AC : forall w, word s = sC :: w -> exists l, behind M (face c :: visited s) (prev c) =
    Some l).
  { intros w W; eapply after_a_c; eauto. }
  assert (FST : forall x, In (v c) (marked s) -> k = true -> exists u, rev (x :: word s) = sC :: u).
  { intros x VC K; apply first_snoc; destruct (T1 K) as [[W (t & VT & GT & IT)]|W]; auto; exfalso.
    rewrite G in GT; symmetry in GT; eapply first_is_c; eauto; rewrite <- VT; exact SN. }
  inversion MV as [r l N C BR BL|l VC BR BL|r VC BR BL|g st rec VC BR BL PP|r l VC BR BL|r l j N C
    BR BL];
    subst s'; rewrite BR, BL in OP.
  - (* C *)
    constructor; cbn [gate stack visited marked word records];
      rewrite ?size_cons; cbn [count same length filter]; try lia; auto; try discriminate.
    + unfold inner_vertex at 1; rewrite C; cbn [length]; lia.
    + destruct TC as (rs & RS & L); exists rs; split; auto using reached_more.
    + apply tame_snoc; auto; destruct (word s) as [|[]]; auto; split; congruence.
    + unfold just_created; cbn [word gate visited]; exists c, r.
      repeat split; auto; [apply behind_some in BR; tauto|left; auto|].
      intros e [E|E] V; auto; exfalso; apply N; rewrite <- V; eapply vis_marked; eauto.
    + intros K; right; destruct (T1 K) as [[W _]|W]; [rewrite W; exists []; reflexivity|].
      apply first_snoc; auto.
  - (* R *)
    constructor; cbn [gate stack visited marked word records];
      rewrite ?size_cons; cbn [count same length]; try lia; auto; try discriminate; try exact I.
    apply tame_snoc; auto; destruct (word s) as [|[]]; auto; split; congruence.
  - (* L *)
    constructor; cbn [gate stack visited marked word records];
      rewrite ?size_cons; cbn [count same length]; try lia; auto; try discriminate; try exact I.
    apply tame_snoc; auto; destruct (word s) as [|[]] eqn:W; auto.
    destruct (AC _ eq_refl); congruence.
  - (* E *)
    assert (R' : ready M (face c :: visited s) (marked s) full).
    { change full with ([] ++ full); eapply ready_visit; eauto using incl_refl.
      - eapply sane_visit; eauto using incl_refl; apply SN.
      - intros x d [X|X] OX ND; subst x; exfalso; apply mem_false in ND;
          [unfold behind in BR; rewrite OX, ND in BR|unfold behind in BL; rewrite OX, ND in BL];
          discriminate.
      - eapply sound_more; [|apply incl_refl|exact U]; intros y Y; right; exact Y. }
    pose proof (resume M HM _ _ full (records s) R') as Q; rewrite <- HS, PP in Q.
    destruct Q as [Q1 Q2].
    constructor; cbn [gate stack visited marked word records];
      rewrite ?size_cons; cbn [count same length]; try lia; auto; try exact I.
    + destruct g as [d|].
      * destruct Q2 as (l' & _ & _ & _ & Q2); lia.
      * destruct Q2 as (-> & _ & Q2); cbn [length]; lia.
    + destruct TC as (rs & RS & L); exists rs; split; auto; lia.
    + apply tame_snoc; auto; destruct (word s) as [|[]] eqn:W; auto.
      destruct (AC _ eq_refl); congruence.
    + intros _; eauto.
  - (* S *)
    constructor; cbn [gate stack visited marked word records];
      rewrite ?size_cons; cbn [count same length map snd]; try lia; auto; try discriminate;
        try exact I.
    apply tame_snoc; auto; destruct (word s) as [|[]]; auto; split; congruence.
  - (* S that reaches a curve *)
    assert (IN : forall a, In a (whole M (v c)) -> curve M a = Some j).
    { intros a X; apply in_whole in X; destruct X as [_ X]; unfold ring in X; rewrite C in X.
      destruct (curve M a); [|discriminate]; apply Nat.eqb_eq in X; subst; auto. }
    constructor; cbn [gate stack visited marked word records];
      rewrite ?size_cons; cbn [count same length map snd]; try lia; auto; try discriminate;
        try exact I.
    + rewrite filter_app, app_length.
      assert (filter (inner_vertex M) (whole M (v c)) = []) as ->.
      { assert (K : forall l, (forall a, In a l -> curve M a = Some j) ->
          filter (inner_vertex M) l = []).
        { clear; induction l as [|a l IH]; intros X; cbn; auto; unfold inner_vertex at 1.
          rewrite (X a) by (left; auto); apply IH; intros; apply X; right; auto. }
        apply K; exact IN. }
      cbn [length]; lia.
    + destruct TC as (rs & [RN RI] & L); exists (j :: rs); split; [split|].
      * constructor; auto; rewrite RI; intros [a [I E]]; apply N.
        eapply mk_whole; eauto; [unfold ring; rewrite E, C; apply Nat.eqb_refl|apply vertex_in;
          auto].
      * intros i; cbn [In]; rewrite RI; split.
        -- intros [<-|[a [I E]]].
           ++ exists (v c); split; auto; apply in_app_iff; left; apply in_whole; split;
                auto using ring_refl; apply vertex_in; auto.
           ++ exists a; split; auto; apply in_app_iff; auto.
        -- intros [a [I E]]; apply in_app_iff in I; destruct I as [I|I]; eauto.
           left; apply IN in I; congruence.
      * unfold truths in *; cbn [length sum one_if]; lia.
    + apply tame_snoc; auto; destruct (word s) as [|[]]; auto; split; congruence.
    + intros K; rewrite (P K) in C by (apply vertex_in; auto); discriminate.
Qed.
End Surface.
