(** How many handle records a connected closed surface has: 2 - chi, that is 2g.

    EB-COUNT-2, EB-COUNT-3, EB-COUNT-4 for connected closed surfaces of any genus. By counting edges
    alone: every edge is met twice, the second time as a gate or as a closed side of an L, R or E
    ([pairs_counted]); every S puts one gate on the stack ([stack_counted]); every vertex but three is
    the apex of one C. So a sphere has no records ([sphere_without_records]). *)
Require Import List Arith Lia Bool Permutation.
Require Import Clers.Letters Clers.Words Clers.Meshes Clers.Discs Clers.Traversal Clers.Visited.
Import ListNotations.
Open Scope nat_scope.

Definition mem (e : edge) (l : list edge) : bool := if in_dec edge_eq_dec e l then true else false.
Definition one (b : bool) : nat := if b then 1 else 0.

(** How many of these edges are run in both directions. *)
Definition pairs (l : list edge) : nat := length (filter (fun e => mem (flip e) l) l).

Lemma mem_In : forall e l, mem e l = true <-> In e l.
Proof. intros; unfold mem; destruct (in_dec edge_eq_dec e l); intuition congruence. Qed.

Lemma mem_yes : forall e l, In e l -> mem e l = true.
Proof. intros; apply mem_In; assumption. Qed.

Lemma mem_no : forall e l, ~ In e l -> mem e l = false.
Proof. intros; unfold mem; destruct (in_dec edge_eq_dec e l); congruence. Qed.

Lemma flip_flip : forall e, flip (flip e) = e.
Proof. intros [x y]; reflexivity. Qed.

Lemma filter_one_more : forall (q : edge -> bool) d l, NoDup l -> q d = false ->
  length (filter (fun e => if edge_eq_dec e d then true else q e) l) = length (filter q l) + one (mem d l).
Proof.
  intros q d; induction l as [|e l IH]; intros N Q; [reflexivity|].
  inversion N as [|? ? X N']; subst; specialize (IH N' Q); cbn [filter].
  destruct (edge_eq_dec e d) as [->|D].
  - rewrite Q; cbn [length]; rewrite IH, (mem_no d l X), mem_yes by (left; reflexivity); cbn; lia.
  - assert (Me : mem d (e :: l) = mem d l).
    { destruct (mem d l) eqn:B; [apply mem_yes; right; apply mem_In; exact B|].
      apply mem_no; intros [I|I]; [congruence|apply mem_In in I; congruence]. }
    rewrite Me; destruct (q e); cbn [length]; lia.
Qed.

Lemma pairs_cons : forall e l, NoDup (e :: l) -> flip e <> e ->
  pairs (e :: l) = pairs l + 2 * one (mem (flip e) l).
Proof.
  intros e l N D; inversion N as [|? ? X N']; subst; unfold pairs; cbn [filter].
  assert (A : mem (flip e) (e :: l) = mem (flip e) l).
  { destruct (mem (flip e) l) eqn:B; [apply mem_yes; right; apply mem_In; exact B|].
    apply mem_no; intros [I|I]; [congruence|apply mem_In in I; congruence]. }
  rewrite A.
  assert (B : length (filter (fun d => mem (flip d) (e :: l)) l)
    = length (filter (fun d => mem (flip d) l) l) + one (mem (flip e) l)).
  { rewrite <- (filter_one_more (fun d => mem (flip d) l) (flip e) l N').
    - f_equal; apply filter_ext; intros d; destruct (edge_eq_dec d (flip e)) as [->|F].
      + rewrite flip_flip; apply mem_yes; left; reflexivity.
      + destruct (mem (flip d) l) eqn:M; [apply mem_yes; right; apply mem_In; exact M|].
        apply mem_no; intros [I|I]; [|apply mem_In in I; congruence].
        apply F; rewrite I, flip_flip; reflexivity.
    - rewrite flip_flip; apply mem_no; exact X. }
  destruct (mem (flip e) l); cbn [length one] in *; lia.
Qed.

Lemma pairs_all : forall l, (forall e, In e l -> In (flip e) l) -> pairs l = length l.
Proof.
  intros l H; unfold pairs; f_equal.
  assert (A : forall m, incl m l -> filter (fun e => mem (flip e) l) m = m).
  { induction m as [|e m IH]; intros I; [reflexivity|]; cbn [filter].
    rewrite mem_yes, IH; auto; [intros d J; apply I; right; exact J|apply H, I; left; reflexivity]. }
  apply A, incl_refl.
Qed.

Section Surface.
  Variable M : list face.
  Hypothesis SM : surface M.

  (** A new triangle closes its gate, and the sides whose other triangle has been visited. *)
  Lemma pairs_step : forall K m a b st v, good M K m a b st -> has M a b v ->
    pairs (edges ((v, a, b) :: K))
    = pairs (edges K) + 2 + 2 * one (mem (a, v) (edges K)) + 2 * one (mem (v, b) (edges K)).
  Proof.
    intros K m a b st v G H; destruct (advance M SM _ _ _ _ _ _ G H) as (_ & N & _).
    destruct (face_distinct M SM _ _ _ H) as (VA & VB & AB).
    change (edges ((v, a, b) :: K)) with ((v, a) :: (a, b) :: (b, v) :: edges K) in *.
    assert (Skip : forall e d l, e <> d -> mem e (d :: l) = mem e l).
    { intros e d l D; destruct (mem e l) eqn:B; [apply mem_yes; right; apply mem_In; exact B|].
      apply mem_no; intros [I|I]; [congruence|apply mem_In in I; congruence]. }
    assert (N1 := N); apply NoDup_cons_iff in N1; destruct N1 as [_ N1].
    assert (N2 := N1); apply NoDup_cons_iff in N2; destruct N2 as [_ N2].
    rewrite !pairs_cons by (auto; unfold flip; cbn; congruence).
    change (flip (v, a)) with (a, v); change (flip (a, b)) with (b, a); change (flip (b, v)) with (v, b).
    rewrite !Skip by congruence; rewrite (mem_yes (b, a)) by apply (behind _ _ _ _ _ _ G); cbn [one]; lia.
  Qed.

  Lemma pairs_counted : forall K m a b st tr p, Walk M K m a b st tr p -> good M K m a b st ->
    let w := map fst tr in
    pairs (edges (after tr K))
    = pairs (edges K) + 2 * length tr + 2 * many sL w + 2 * many sR w + 4 * many sE w.
  Proof.
    apply (walk_induction M SM (fun K m a b st tr p => let w := map fst tr in
      pairs (edges (after tr K))
      = pairs (edges K) + 2 * length tr + 2 * many sL w + 2 * many sR w + 4 * many sE w)); cbv zeta.
    - intros K m a b v st tr p G H V G' IH; rewrite after_cons, IH, (pairs_step _ _ _ _ _ _ G H).
      destruct (advance M SM _ _ _ _ _ _ G H) as (_ & _ & _ & _ & A5 & A6).
      rewrite !mem_no by auto; cbn [map fst many is length one]; lia.
    - intros K m a b v st tr p G H V X Y G' IH; rewrite after_cons, IH, (pairs_step _ _ _ _ _ _ G H).
      rewrite (mem_yes _ _ X), (mem_no _ _ Y); cbn [map fst many is length one]; lia.
    - intros K m a b v st tr p G H V X Y G' IH; rewrite after_cons, IH, (pairs_step _ _ _ _ _ _ G H).
      rewrite (mem_no _ _ X), (mem_yes _ _ Y); cbn [map fst many is length one]; lia.
    - intros K m a b v st tr p G H V X Y G' IH; rewrite after_cons, IH, (pairs_step _ _ _ _ _ _ G H).
      rewrite (mem_no _ _ X), (mem_no _ _ Y); cbn [map fst many is length one]; lia.
    - intros K m a b v st G H V X Y Q; change (after [(sE, (v, a, b))] K) with ((v, a, b) :: K).
      rewrite (pairs_step _ _ _ _ _ _ G H), (mem_yes _ _ X), (mem_yes _ _ Y).
      cbn [map fst many is length one]; lia.
    - intros K m a b v passed a' b' rest tr p G H V X Y Q O G' IH.
      rewrite after_cons, IH, (pairs_step _ _ _ _ _ _ G H).
      rewrite (mem_yes _ _ X), (mem_yes _ _ Y); cbn [map fst many is length one]; lia.
  Qed.

  Lemma stack_counted : forall K m a b st tr p, Walk M K m a b st tr p ->
    many sS (map fst tr) + length st + 1 = many sE (map fst tr) + length p.
  Proof. induction 1; cbn [map fst many is length] in *; rewrite ?app_length in *; cbn [length]; lia. Qed.

  Lemma created_counted : forall tr, length (created tr) = many sC (map fst tr).
  Proof.
    induction tr as [|[s [[v a] b]] tr IH]; [reflexivity|].
    unfold created in *; cbn [flat_map map fst many]; rewrite app_length, IH; destruct s; reflexivity.
  Qed.

  Lemma same_counts : forall F G, (forall x y z, has F x y z <-> has G x y z) ->
    NoDup (edges F) -> NoDup (edges G) -> length F = length G /\ vertex_count F = vertex_count G.
  Proof.
    intros F G H NF NG; split.
    - assert (P : Permutation (edges F) (edges G)).
      { apply NoDup_Permutation; auto; intros [x y]; split; intros I; apply edge_has in I;
          destruct I as [z I]; apply has_edge with z, H, I. }
      apply Permutation_length in P; rewrite !length_edges in P; lia.
    - apply Permutation_length, NoDup_Permutation; try apply NoDup_nodup.
      intros x; rewrite !nodup_In; split; intros I; apply vertex_has in I; destruct I as (y & z & I);
        apply has_vertex with y z, H, I.
  Qed.

  Section Whole.
    Variables x0 x1 x2 : nat.
    Variable rest : list face.
    Hypothesis start : M = (x0, x1, x2) :: rest.
    Variable tr : list step.
    Variable p : list edge.
    Hypothesis W : Walk M [(x0, x1, x2)] [x0; x1; x2] x2 x1 [] tr p.
    Hypothesis connected_M : connected M.
    Let G := good_start M SM x0 x1 x2 rest start.

    Theorem walk_counts : length M = length tr + 1 /\ vertex_count M = many sC (map fst tr) + 3.
    Proof.
      destruct (visited M SM _ _ _ _ _ _ _ W G) as (In_M & N & Nc & New & V).
      destruct (same_counts M (after tr [(x0, x1, x2)])) as [A B]; auto using once.
      { intros x y z; apply (all_visited M SM x0 x1 x2 rest start tr p W connected_M). }
      split.
      - rewrite A; unfold after; rewrite app_length, rev_length, map_length; cbn; lia.
      - rewrite B, <- created_counted; destruct (face_distinct M SM x0 x1 x2) as (D1 & D2 & D3).
        { rewrite start; left; left; reflexivity. }
        assert (N0 : NoDup ([x0; x1; x2] ++ created tr)).
        { apply NoDup_app_join; auto; [repeat constructor; cbn; intuition congruence|].
          intros x I J; exact (New x J I). }
        assert (Q : vertex_count (after tr [(x0, x1, x2)]) = length ([x0; x1; x2] ++ created tr)).
        { apply Permutation_length, NoDup_Permutation; auto using NoDup_nodup.
          intros x; rewrite nodup_In, V, in_app_iff; reflexivity. }
        rewrite Q; cbn [app length]; lia.
    Qed.

    (** 2 (number of records) = 4 - 2 chi, with 2 chi = 2V - T. *)
    Theorem gates_passed : 2 * length p + 2 * vertex_count M = length M + 4.
    Proof.
      destruct walk_counts as [A B].
      assert (Pairs := pairs_counted _ _ _ _ _ _ _ W G); cbv zeta in Pairs.
      assert (St := stack_counted _ _ _ _ _ _ _ W); cbn [length] in St.
      assert (Le := length_of_counts (map fst tr)); rewrite map_length in Le.
      assert (Closed := all_closed M SM x0 x1 x2 rest start tr p W).
      rewrite pairs_all in Pairs by (intros [x y]; apply Closed).
      assert (T : length (edges (after tr [(x0, x1, x2)])) = 3 * (length tr + 1)).
      { rewrite length_edges; unfold after; rewrite app_length, rev_length, map_length; cbn; lia. }
      assert (Z : pairs (edges [(x0, x1, x2)]) = 0).
      { destruct (face_distinct M SM x0 x1 x2) as (D1 & D2 & D3); [rewrite start; left; left; reflexivity|].
        unfold pairs; cbn [edges flat_map runs app filter]; unfold flip; cbn [fst snd].
        rewrite !mem_no by (cbn; intuition congruence); reflexivity. }
      lia.
    Qed.
  End Whole.

  (** EB-COUNT-1: after a C no triangle closes its left edge, for that would double the C's gate. *)
  Lemma no_CL_no_CE : forall K m a b st tr p, Walk M K m a b st tr p -> good M K m a b st ->
    forall before after s f g, tr = before ++ (sC, f) :: (s, g) :: after -> s <> sL /\ s <> sE.
  Proof.
    assert (Left : forall K a b v w, In (b, a) (edges K) -> ~ In v (vertices K) -> has M a b v ->
      (forall x y z, has K x y z -> has M x y z) ->
      has M v b w -> ~ In (b, w) (edges K) -> ~ In (v, w) (edges ((v, a, b) :: K))).
    { intros K a b v w BA V H In_M H' New I; destruct (face_distinct M SM _ _ _ H) as (VA & VB & AB).
      change (edges ((v, a, b) :: K)) with ((v, a) :: (a, b) :: (b, v) :: edges K) in I.
      destruct I as [I|[I|[I|I]]]; [|congruence|congruence|].
      - injection I as <-; contradiction.
      - apply V; apply edge_has in I; destruct I as [u I]; apply has_vertex with w u, I. }
    assert (Skip : forall (s0 : symbol) (f0 : face) tr before after s f g,
      (s0, f0) :: tr = before ++ (sC, f) :: (s, g) :: after ->
      (s0 = sC /\ tr = (s, g) :: after) \/ exists before', tr = before' ++ (sC, f) :: (s, g) :: after).
    { intros s0 f0 tr [|x before] after s f g E0; injection E0; intros; subst; eauto. }
    intros K m a b st tr p W; induction W as [K m a b v st tr p H V W IH|K m a b v st tr p H V X Y W IH
      |K m a b v st tr p H V X Y W IH|K m a b v st tr p H V X Y W IH|K m a b v st H V X Y Q
      |K m a b v passed a' b' rest tr p H V X Y Q O W IH]; intros G before after0 s f g E0;
      destruct (Skip _ _ _ _ _ _ _ _ E0) as [[E1 E2]|[before' E2]]; try discriminate.
    - destruct (advance M SM _ _ _ _ _ _ G H) as (A1 & A2 & A3 & A4 & A5 & A6).
      assert (V' : ~ In v (vertices K)) by (intros J; apply V, (marks _ _ _ _ _ _ G), J).
      assert (G' : good M ((v, a, b) :: K) (v :: m) v b st).
      { apply good_right with m st; auto; cbn; intuition auto. }
      assert (No : forall w, has M v b w -> ~ In (v, w) (edges ((v, a, b) :: K))).
      { intros w H'; apply (Left K a b v w); auto; [apply (behind _ _ _ _ _ _ G)|apply (inside _ _ _ _ _ _ G)|].
        destruct (advance M SM _ _ _ _ _ _ G' H') as (_ & _ & B & _); intros J.
        apply (B (b, w)); [right; right; left; reflexivity|do 3 right; exact J]. }
      subst tr; inversion W; subst; split; try discriminate; intros _;
        match goal with
        | H1 : has M v b ?w, H2 : In (v, ?w) _ |- _ => exact (No w H1 H2)
        end.
    - apply (fun G' => IH G' before' after0 s f g E2).
      destruct (advance M SM _ _ _ _ _ _ G H) as (_ & _ & _ & _ & A5 & _).
      apply good_right with m st; auto; cbn; intuition auto.
    - exact (IH (good_left M SM _ _ _ _ _ _ G H Y V) before' after0 s f g E2).
    - apply (fun G' => IH G' before' after0 s f g E2).
      apply good_right with m st; auto; intros x; intuition (subst; auto).
    - apply (fun G' => IH G' before' after0 s f g E2).
      apply good_right with m st; auto; [intros x; intuition (subst; auto)|intros x y [J|J]; auto].
    - destruct before' as [|? [|? ?]]; discriminate.
    - exact (IH (good_popped M SM _ _ _ _ _ _ _ _ _ G H O V) before' after0 s f g E2).
  Qed.
End Surface.

(** The encoder is total on connected closed surfaces, and visits every face. *)
Theorem encode_total : forall M, surface M -> connected M -> exists tr p x y z rest,
  M = (x, y, z) :: rest /\ encode M = Some (tr, p) /\ Walk M [(x, y, z)] [x; y; z] z y [] tr p.
Proof.
  intros M SM CM; assert (NE := not_empty M SM).
  assert (H : exists x y z rest, M = (x, y, z) :: rest).
  { destruct M as [|[[x y] z] rest]; [congruence|eauto]. }
  destruct H as (x & y & z & rest & H).
  assert (Le : length M < length M + length [(x, y, z)]) by (cbn [length]; lia).
  destruct (Walk_ends M SM _ _ _ _ _ _ Le (good_start M SM x y z rest H)) as (tr & p & W).
  exists tr, p, x, y, z, rest; repeat split; auto.
  destruct (walk_counts M SM x y z rest H tr p W CM) as [A _].
  unfold encode; rewrite H at 1; apply Walk_is_walk; auto using once; lia.
Qed.

(** EB-COUNT-4: as many records as 2 - chi. *)
Theorem records_are_two_minus_chi : forall M tr p, surface M -> connected M ->
  encode M = Some (tr, p) -> 2 * length p + 2 * vertex_count M = length M + 4.
Proof.
  intros M tr p SM CM H; destruct (encode_total M SM CM) as (tr' & p' & x & y & z & rest & E1 & E2 & W).
  rewrite H in E2; injection E2 as <- <-; exact (gates_passed M SM x y z rest E1 tr p W CM).
Qed.

Theorem sphere_without_records : forall M, sphere M -> exists tr, encode M = Some (tr, []).
Proof.
  intros M (SM & CM & X); destruct (encode_total M SM CM) as (tr & p & x & y & z & rest & E1 & E2 & W).
  assert (H := records_are_two_minus_chi M tr p SM CM E2); rewrite length_edges in X.
  destruct p as [|g p]; [eauto|cbn [length] in H; lia].
Qed.

(** EB-COUNT-1. *)
Theorem no_word_contains_CL_or_CE : forall M tr p before after s f g, surface M -> connected M ->
  encode M = Some (tr, p) -> tr = before ++ (sC, f) :: (s, g) :: after -> s <> sL /\ s <> sE.
Proof.
  intros M tr p before after0 s f g SM CM H E0.
  destruct (encode_total M SM CM) as (tr' & p' & x & y & z & rest & E1 & E2 & W).
  rewrite H in E2; injection E2 as <- <-.
  exact (no_CL_no_CE M SM _ _ _ _ _ _ _ W (good_start M SM x y z rest E1) _ _ _ _ _ E0).
Qed.

(** EB-COUNT-2, and EB-COUNT-3 with 2 chi = 2V - T: #C = V - 3, 2 (#S - #E) = 2 - 2 chi. *)
Theorem closed_counts : forall M tr p, surface M -> connected M -> encode M = Some (tr, p) ->
  let w := map fst tr in
  length M = length w + 1 /\ vertex_count M = many sC w + 3 /\
  2 * many sS w + 2 * vertex_count M = 2 * many sE w + length M + 2.
Proof.
  intros M tr p SM CM H w; assert (P := records_are_two_minus_chi M tr p SM CM H).
  destruct (encode_total M SM CM) as (tr' & p' & x & y & z & rest & E1 & E2 & W).
  rewrite H in E2; injection E2 as <- <-.
  assert (St := stack_counted M _ _ _ _ _ _ _ W); cbn [length] in St.
  destruct (walk_counts M SM x y z rest E1 tr p W CM) as [A B].
  unfold w; rewrite map_length; repeat split; auto; lia.
Qed.
