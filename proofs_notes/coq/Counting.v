(** * What the words of surfaces count

    Clauses: EB-COMPONENT-3 (how many symbols), EB-COUNT-1 (no CL, no CE), EB-COUNT-2 (#C),
    EB-COUNT-3 (#S - #E), EB-COUNT-4 (#Sh = 2g, #Sb = b - 1), CODE-COUNT-1 and CODE-COUNT-2 (the
    same in terms of triangles), CODE-IMPLIED-1 (a closed component begins with C), EB-REMAINDER-2
    (the number 1 - 2g - b, as far as it is a count). The sentence that first contact with a curve
    is an S is [Walk.first_contact].

    All is proved of the walk of [Walk] over any surface of [Surface], not of words that a grammar
    allows. The genus enters by its definition alone, χ = 2 - 2g - b (CPLX-COMPONENT-3).

    How: a C marks one vertex inside, so the C count them. A symbol leaves as many edges open as it
    has open sides, and every inner edge is opened once; this gives #S - #E. Every gate that an S
    leaves is gone on at, which an E does, or passed over, which makes a record; this gives the
    number of records. Those of the kind [boundary] each reach a curve, and one curve was reached
    at the beginning. *)

Require Import ZArith List Lia Arith Bool Permutation.
From Clers Require Import Letters Surface Walk.
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

Definition when (b : bool) (k : Z) : Z := if b then k else 0.

(** The records of the kind [handle] and [boundary]: the S that are S_h and S_b (EB-HANDLE-2). *)
Definition handles (s : state) : Z := Z.of_nat (length (records s)) - Z.of_nat (truths (records s)).
Definition boundaries (s : state) : Z := Z.of_nat (truths (records s)).

Lemma count_rev : forall a w, count a (rev w) = count a w.
Proof. intros a; induction w; cbn [rev count]; rewrite ?count_app, ?IHw; cbn [count]; lia. Qed.
Lemma size_rev : forall w, size (rev w) = size w.
Proof. intros; unfold size; rewrite rev_length; auto. Qed.

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
    = when k 3 + 2 * count sC (word s) + count sL (word s) + count sR (word s) + 2 * count sS (word s);
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
    + (match behind M (face c :: vis) (prev c) with Some _ => 1 | None => 0 end) + opened M vis)%nat.
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

Lemma tame_snoc : forall w x, tame sE (rev w) -> match w with sC :: _ => x <> sL /\ x <> sE | _ => True end ->
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
  assert (AC : forall w, word s = sC :: w -> exists l, behind M (face c :: visited s) (prev c) = Some l).
  { intros w W; eapply after_a_c; eauto. }
  assert (FST : forall x, In (v c) (marked s) -> k = true -> exists u, rev (x :: word s) = sC :: u).
  { intros x VC K; apply first_snoc; destruct (T1 K) as [[W (t & VT & GT & IT)]|W]; auto; exfalso.
    rewrite G in GT; symmetry in GT; eapply first_is_c; eauto; rewrite <- VT; exact SN. }
  inversion MV as [r l N C BR BL|l VC BR BL|r VC BR BL|g st rec VC BR BL PP|r l VC BR BL|r l j N C BR BL];
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
      rewrite ?size_cons; cbn [count same length map snd]; try lia; auto; try discriminate; try exact I.
    apply tame_snoc; auto; destruct (word s) as [|[]]; auto; split; congruence.
  - (* S that reaches a curve *)
    assert (IN : forall a, In a (whole M (v c)) -> curve M a = Some j).
    { intros a X; apply in_whole in X; destruct X as [_ X]; unfold ring in X; rewrite C in X.
      destruct (curve M a); [|discriminate]; apply Nat.eqb_eq in X; subst; auto. }
    constructor; cbn [gate stack visited marked word records];
      rewrite ?size_cons; cbn [count same length map snd]; try lia; auto; try discriminate; try exact I.
    + rewrite filter_app, app_length.
      assert (filter (inner_vertex M) (whole M (v c)) = []) as ->.
      { assert (K : forall l, (forall a, In a l -> curve M a = Some j) -> filter (inner_vertex M) l = []).
        { clear; induction l as [|a l IH]; intros X; cbn; auto; unfold inner_vertex at 1.
          rewrite (X a) by (left; auto); apply IH; intros; apply X; right; auto. }
        apply K; exact IN. }
      cbn [length]; lia.
    + destruct TC as (rs & [RN RI] & L); exists (j :: rs); split; [split|].
      * constructor; auto; rewrite RI; intros [a [I E]]; apply N.
        eapply mk_whole; eauto; [unfold ring; rewrite E, C; apply Nat.eqb_refl|apply vertex_in; auto].
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
  constructor; cbn [gate stack visited marked word records negb when]; rewrite ?G; auto; try lia; try discriminate; try exact I.
  - cbn [opened at_face sum]; rewrite !O by reflexivity; cbn; lia.
  - cbn [map at_face filter]; unfold inner_vertex; rewrite !V; cbn; lia.
  - exists []; split; [split; [constructor|]|reflexivity]; intros k; split; [intros []|].
    intros [a [I E]]; cbn [map at_face In] in I; destruct I as [<-|[<-|[<-|[]]]]; rewrite V in E; discriminate.
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
  constructor; cbn [gate stack visited marked word records negb when]; auto; try (cbn; lia); try discriminate; try exact I.
  - assert (filter (inner_vertex M) (whole M (v (next c))) = []) as ->; [|reflexivity].
    assert (K : forall l, (forall a, In a l -> curve M a = Some k) -> filter (inner_vertex M) l = []).
    { clear; induction l as [|a l IH]; intros X; cbn; auto; unfold inner_vertex at 1.
      rewrite (X a) by (left; auto); apply IH; intros; apply X; right; auto. }
    apply K; exact W.
  - exists [k]; split; [split|reflexivity].
    + constructor; [intros []|constructor].
    + intros j; cbn [In]; split.
      * intros [<-|[]]; exists (v (next c)); split; auto; apply in_whole; split; auto using ring_refl.
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
      destruct (IH s' full' H' (tally_step k s c full s' G H TL NC MV)) as (A & B & C & D).
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

(** *** The numbers of the surface *)

Lemma all_inner : forall mk, NoDup mk -> (forall a, In a mk <-> (a < vertices M)%nat) ->
  (length (filter (inner_vertex M) mk) + border_edges M = vertices M)%nat.
Proof.
  intros mk N A.
  assert (P : Permutation mk (seq 0 (vertices M))).
  { apply NoDup_Permutation; auto using seq_NoDup; intros a; rewrite A, in_seq; lia. }
  pose proof (Permutation_length (starts M HM)) as B; rewrite map_length in B.
  fold (border_edges M) in B; rewrite B, !sum_filter, (sum_perm _ _ _ _ P), <- sum_plus.
  rewrite (sum_ext _ _ (fun _ => 1%nat)), sum_const, seq_length by
    (intros a _; destruct (inner_vertex M a); reflexivity); lia.
Qed.

Lemma curve_number : forall mk rs, reached mk rs -> (forall a, In a mk <-> (a < vertices M)%nat) ->
  length rs = length (curves M).
Proof.
  intros mk rs [N R] A; apply Permutation_length, NoDup_Permutation; auto; [apply (curves_once M HM)|].
  intros k; rewrite R, (curves_all M HM); split; intros [a [I E]]; exists a; split; auto; apply A; auto.
Qed.

Section Numbers.
Variables (k : bool) (s : state).
Hypothesis HW : walk M k s.
(** The word of the walk, in the order in which it is written. *)
Let w := rev (word s).
Let B := Z.of_nat (border_edges M).
Let V := Z.of_nat (vertices M).
Let t := Z.of_nat T.
Let b := Z.of_nat (length (curves M)).

(** EB-COMPONENT-3: T symbols with boundary, T - 1 in a closed component. *)
Theorem symbols : size w = if k then t - 1 else t.
Proof.
  destruct (walk_ends k s HW) as (_ & [N A] & _ & _ & TL & _).
  destruct (opened_all M (visited s) HM N A) as [_ L].
  pose proof (t_faces _ _ TL) as F; unfold w; rewrite size_rev; rewrite L in F; fold t in F.
  destruct k; cbn [when] in F; lia.
Qed.

(** EB-COUNT-1. *)
Theorem no_cl_no_ce : tame sE w.
Proof. destruct (walk_ends k s HW) as (_ & _ & _ & _ & TL & _); apply TL. Qed.

(** The last symbol is E. *)
Theorem ends_in_e : final sE w = sE.
Proof.
  destruct (walk_ends k s HW) as (G & _ & _ & _ & TL & _); destruct (t_last _ _ TL G) as [u E].
  unfold w; rewrite E; cbn [rev]; rewrite final_app; reflexivity.
Qed.

(** CODE-IMPLIED-1. *)
Theorem first_symbol : k = true -> exists u, w = sC :: u.
Proof.
  intros K; destruct (walk_ends k s HW) as (G & _ & _ & _ & TL & _).
  destruct (t_first _ _ TL K) as [[W _]|F]; auto.
  destruct (t_last _ _ TL G) as [u E]; congruence.
Qed.

(** EB-COUNT-2: #C is V - 3 in a closed component, and the number of vertices inside, which is
    V - B, in one with boundary. *)
Theorem creations : count sC w = V - if k then 3 else B.
Proof.
  destruct (walk_ends k s HW) as (_ & _ & [N A] & _ & TL & _ & NB & _).
  pose proof (all_inner _ N A) as I; pose proof (t_inner _ _ TL) as C.
  unfold w; rewrite count_rev; unfold V, B.
  destruct k; cbn [when] in C; [|lia].
  assert (border_edges M = 0%nat); [|lia].
  unfold border_edges, border_corners; destruct (filter (border M) (all_corners M)) as [|c l] eqn:E; auto.
  assert (J : In c (filter (border M) (all_corners M))) by (rewrite E; left; auto).
  apply filter_In in J; destruct J as [J1 J2]; apply in_corners, in_seq in J1; unfold border in J2.
  destruct (opp c) eqn:O; [discriminate|destruct (NB eq_refl c); auto; lia].
Qed.

Lemma closed_has_no : k = true -> border_edges M = 0%nat /\ curves M = [].
Proof.
  intros K; destruct (walk_ends k s HW) as (_ & _ & _ & _ & _ & NC & NB & _); split.
  - unfold border_edges, border_corners.
    destruct (filter (border M) (all_corners M)) as [|c l] eqn:E; auto.
    assert (J : In c (filter (border M) (all_corners M))) by (rewrite E; left; auto).
    apply filter_In in J; destruct J as [J1 J2]; apply in_corners, in_seq in J1; unfold border in J2.
    destruct (opp c) eqn:O; [discriminate|destruct (NB K c); auto; lia].
  - destruct (curves M) as [|j l] eqn:E; auto; exfalso.
    assert (J : In j (curves M)) by (rewrite E; left; auto).
    apply (curves_all M HM) in J; destruct J as [a [A1 A2]]; rewrite (NC K a A1) in A2; discriminate.
Qed.

(** #S - #E, before any genus: it is -χ, and one more in a closed component. *)
Theorem splits_and_ends : count sS w - count sE w = (if k then 1 else 0) - euler M.
Proof.
  destruct (walk_ends k s HW) as (_ & [N A] & _ & _ & TL & _).
  destruct (opened_all M (visited s) HM N A) as [O _].
  pose proof (t_opened _ _ TL) as P; pose proof symbols as S; pose proof creations as C.
  pose proof (twice_the_edges M HM) as E; pose proof (size_counts w) as Z.
  unfold w in *; rewrite size_rev in *; rewrite !count_rev in *; unfold euler, V, B, t in *.
  pose proof closed_has_no as N0; destruct k; cbn [when] in P; [|lia].
  destruct (N0 eq_refl) as [X _]; lia.
Qed.

(** #Sh + #Sb = #S - #E + 1: of the gates that S leave, all but those gone on at. *)
Theorem all_records : handles s + boundaries s = count sS w - count sE w + 1.
Proof.
  destruct (walk_ends k s HW) as (G & _ & _ & ST & TL & _); pose proof (t_stack _ _ TL) as S.
  rewrite G, ST in S; cbn [length] in S; unfold w; rewrite !count_rev; unfold handles, boundaries; lia.
Qed.

(** EB-COUNT-4, second part: #Sb is 0 in a closed component, and b - 1 in one with boundary. *)
Theorem boundary_records : boundaries s = if k then 0 else b - 1.
Proof.
  destruct (walk_ends k s HW) as (_ & _ & [_ A] & ST & TL & _).
  destruct (t_curves _ _ TL) as (rs & R & L); rewrite (curve_number _ _ R A), ST in L.
  pose proof closed_has_no as N; unfold boundaries, b in *.
  change (truths (map snd [])) with 0%nat in L; destruct k; cbn [negb when] in L; [|lia].
  destruct (N eq_refl) as [_ X]; rewrite X in L; cbn [length] in L; lia.
Qed.

Section Genus.
Variable g : Z.
Hypothesis HG : has_genus M g.

(** EB-COUNT-3: #S - #E is 2g - 1 in a closed component, and 2g + b - 2 in one with boundary. *)
Theorem splits_less_ends : count sS w - count sE w = if k then 2 * g - 1 else 2 * g + b - 2.
Proof.
  pose proof closed_has_no as N; rewrite splits_and_ends; unfold has_genus in HG; rewrite HG; fold b.
  destruct k; [|lia]; destruct (N eq_refl) as [_ X]; unfold b; rewrite X; cbn [length]; lia.
Qed.

(** EB-COUNT-4, first part: #Sh = 2g. So no genus is negative. *)
Theorem handle_records : handles s = 2 * g.
Proof.
  pose proof all_records; pose proof boundary_records; pose proof splits_less_ends.
  destruct k; lia.
Qed.

Theorem genus_not_negative : 0 <= g.
Proof.
  pose proof handle_records as H; unfold handles in H.
  assert (forall l, (truths l <= length l)%nat) as K.
  { clear; unfold truths; induction l as [|[] l IH]; cbn [sum one_if length]; lia. }
  specialize (K (records s)); lia.
Qed.

(** CODE-COUNT-1: the counts in terms of triangles, where T = 2m or T - B = 2m. *)
Theorem counts_in_triangles : exists m,
  (if k then t else t - B) = 2 * m
  /\ count sC w = if k then m - 1 - 2 * g else m + 2 - 2 * g - b.
Proof.
  pose proof (twice_the_edges M HM) as E; pose proof creations as C; unfold has_genus, euler in HG.
  pose proof closed_has_no as N; unfold t, B, V, b in *; destruct k.
  - destruct (N eq_refl) as [X Y]; rewrite Y in HG; cbn [length] in HG.
    exists (Z.of_nat (edges M) - Z.of_nat T); lia.
  - exists (2 * Z.of_nat T - Z.of_nat (edges M)); lia.
Qed.

(** EB-REMAINDER-2, the number: the walk crosses an edge for each triangle but one, and leaves
    E - (T - 1). Then V less these is 1 - 2g - b. (That what it crosses is a tree, and what is left
    is connected, is not proved here.) *)
Theorem remainder : V - (Z.of_nat (edges M) - (t - 1)) = 1 - 2 * g - b.
Proof. unfold has_genus, euler in HG; unfold V, t, b; lia. Qed.
End Genus.
End Numbers.
End Surface.
