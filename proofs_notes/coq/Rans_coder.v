(** rANS, the coder that works on a state and bytes beside it: spec/02-bytewise.md, section 2.11.

    Proved here, for any slots of totals up to 2^30:
    - a symbol popped undoes a symbol pushed, state and bytes      (ARITH-RANS-2, ARITH-RANS-4)
    - a symbol pushed undoes a symbol popped                       (ARITH-RANS-5)
    - a message is found in its bytes, whatever follows them, and
      the reader ends with the first state and what follows        (ARITH-BYTES-3, ARITH-RANS-3) *)
Require Import ZArith List Lia Bool.
From Clers Require Import Bits Model Interval.
Import ListNotations.
Open Scope Z_scope.

(** M is the [quarter] of Model.v: 2^30. ARITH-RANS-1. The least state is 2^48: ARITH-RANS-2. *)
Definition bottom : Z := quarter * 262144.

(** A state, and the bytes that a decoder reads after it: the next first. *)
Record pushed := Pushed { state : Z; ahead : list Z }.

Definition settled_state (x : Z) : Prop := bottom <= x < 256 * bottom.

(** The slot of a symbol in a table whose total is made M. ARITH-RANS-1. *)
Definition begins (s : slot) : Z := quarter * below s / whole s.
Definition has_of (s : slot) : Z := quarter * upto s / whole s - quarter * below s / whole s.

Lemma stretched : forall s, valid s ->
  0 <= begins s /\ 1 <= has_of s /\ begins s + has_of s <= quarter.
Proof.
  intros s [[B U] [W T]]; unfold begins, has_of; pose proof quarter_pos as Q.
  assert (A : quarter * below s / whole s + 1 <= quarter * upto s / whole s).
  { rewrite <- Z.div_add by lia; apply Z.div_le_mono; nia. }
  assert (0 <= quarter * below s / whole s) by (apply Z.div_pos; nia).
  assert (quarter * upto s / whole s <= quarter) by (apply Z.div_le_upper_bound; nia).
  lia.
Qed.

(** Bytes out, until a symbol of frequency f fits: four at most. ARITH-RANS-2. *)
Fixpoint shrink (fuel : nat) (f : Z) (x : pushed) : pushed :=
  match fuel with
  | O => x
  | S k => if f * 67108864 <=? state x
           then shrink k f (Pushed (state x / 256) (state x mod 256 :: ahead x)) else x
  end.

(** Bytes in, until the state is settled; zeros where they are used up. ARITH-RANS-4. *)
Fixpoint grow (fuel : nat) (x : pushed) : pushed :=
  match fuel with
  | O => x
  | S k => if state x <? bottom
           then grow k (Pushed (256 * state x + hd 0 (ahead x)) (tl (ahead x))) else x
  end.

Definition push (s : slot) (x : pushed) : pushed :=
  let y := shrink 4 (has_of s) x in
  Pushed (quarter * (state y / has_of s) + begins s + state y mod has_of s) (ahead y).

(** Whose slot this must be: the place of the state. ARITH-RANS-4. *)
Definition place (x : pushed) : Z := state x mod quarter.

Definition pop (s : slot) (x : pushed) : pushed :=
  grow 4 (Pushed (has_of s * (state x / quarter) + place x - begins s) (ahead x)).

(** Between the two, a state lies in this range. *)
Definition fits (f x : Z) : Prop := f * 262144 <= x < f * 67108864.

Lemma shrink_fits : forall n f x l, 1 <= f <= quarter ->
  f * 262144 <= x < f * 67108864 * 256 ^ Z.of_nat n -> fits f (state (shrink n f (Pushed x l))).
Proof.
  unfold fits; induction n as [|n IH]; intros f x l F X; cbn [shrink state ahead].
  - change (256 ^ Z.of_nat 0) with 1 in X; lia.
  - rewrite Nat2Z.inj_succ, Z.pow_succ_r in X by lia.
    destruct (_ <=? x) eqn:E; [apply Z.leb_le in E|apply Z.leb_gt in E; cbn [state]; lia].
    apply IH; [exact F|]; split; [apply Z.div_le_lower_bound; lia|apply Z.div_lt_upper_bound; lia].
Qed.

Lemma grow_settled : forall k x l, bottom <= x -> grow k (Pushed x l) = Pushed x l.
Proof.
  intros [|k] x l B; cbn [grow state]; [reflexivity|].
  rewrite (proj2 (Z.ltb_ge _ _) B); reflexivity.
Qed.

Lemma shrink_fitting : forall k f y l, y < f * 67108864 -> shrink k f (Pushed y l) = Pushed y l.
Proof.
  intros [|k] f y l B; cbn [shrink state]; [reflexivity|].
  rewrite (proj2 (Z.leb_gt _ _) B); reflexivity.
Qed.

(** Bytes that went out come in again. *)
Lemma grow_undoes : forall n f x l, 0 <= x < 256 * bottom -> exists j, (j <= n)%nat /\
  forall k, grow (j + k) (shrink n f (Pushed x l)) = grow k (Pushed x l).
Proof.
  induction n as [|n IH]; intros f x l X; cbn [shrink state ahead]; [exists O; auto|].
  destruct (_ <=? x); [|exists O; split; [lia|reflexivity]].
  assert (N : 0 <= x / 256 < bottom) by (split; [apply Z.div_pos; lia|apply Z.div_lt_upper_bound;
    lia]).
  destruct (IH f (x / 256) (x mod 256 :: l)) as (j & J & G); [lia|].
  exists (S j); split; [lia|]; intros k; rewrite Nat.add_succ_comm, G; cbn [grow state ahead hd tl].
  rewrite (proj2 (Z.ltb_lt _ _)) by lia; f_equal; f_equal; pose proof (Z.div_mod x 256); lia.
Qed.

(** Bytes that came in go out again, if they were there. *)
Lemma shrink_undoes : forall n f y l, 0 <= f -> f * 262144 <= y -> (n <= length l)%nat ->
  Forall (fun b => 0 <= b < 256) l -> exists j, (j <= n)%nat /\
  forall k, shrink (j + k) f (grow n (Pushed y l)) = shrink k f (Pushed y l).
Proof.
  induction n as [|n IH]; intros f y l F Y L B; cbn [grow state ahead]; [exists O; auto|].
  destruct (_ <? _); [|exists O; split; [lia|reflexivity]].
  destruct l as [|b l]; [cbn in L; lia|]; inversion_clear B as [|? ? B0 BS];
    cbn [hd tl length] in *.
  destruct (IH f (256 * y + b) l) as (j & J & G); try assumption; try lia.
  exists (S j); split; [lia|]; intros k; rewrite Nat.add_succ_comm, G; cbn [shrink state ahead].
  rewrite (proj2 (Z.leb_le _ _)) by lia.
  assert (D : y = (256 * y + b) / 256) by (apply (Z.div_unique _ _ _ b); lia).
  assert (R : b = (256 * y + b) mod 256) by (apply (Z.mod_unique _ _ y); lia).
  rewrite <- D, <- R; reflexivity.
Qed.

Lemma bounds : forall f x, 1 <= f <= quarter -> settled_state x ->
  f * 262144 <= x < f * 67108864 * 256 ^ Z.of_nat 4.
Proof.
  unfold settled_state, bottom; intros f x F X.
  change (256 ^ Z.of_nat 4) with 4294967296; rewrite quarter_is in *; lia.
Qed.

(** ARITH-RANS-2: a pushed state is settled. *)
Theorem push_settles : forall s x, valid s -> settled_state (state x) ->
  settled_state (state (push s x)).
Proof.
  intros s [x l] V X; destruct (stretched s V) as (C & F & M); cbn [state] in X.
  assert (F' : 1 <= has_of s <= quarter) by lia.
  pose proof (shrink_fits 4 (has_of s) x l F' (bounds _ _ F' X)) as Y; unfold push; cbn [state].
  set (y := state (shrink _ _ _)) in *; set (f := has_of s) in *; unfold fits in Y.
  assert (D : 262144 <= y / f < 67108864)
    by (split; [apply Z.div_le_lower_bound; lia|apply Z.div_lt_upper_bound; lia]).
  pose proof (Z.mod_pos_bound y f); unfold settled_state, bottom; nia.
Qed.

(** ARITH-RANS-4: the place of a pushed state is in the slot pushed, so that the search finds it. *)
Theorem pushed_place : forall s x, valid s ->
  below s <= ((place (push s x) + 1) * whole s - 1) / quarter < upto s.
Proof.
  intros s x V; destruct (stretched s V) as (C & F & M); pose proof quarter_pos as Q.
  assert (P : begins s <= place (push s x) < begins s + has_of s).
  { unfold place, push; cbn [state]; set (y := state (shrink _ _ _)); set (f := has_of s) in *.
    pose proof (Z.mod_pos_bound y f).
    replace (quarter * (y / f) + begins s + y mod f) with (begins s + y mod f + y / f * quarter)
      by lia.
    rewrite Z.mod_add, (Z.mod_small (begins s + y mod f)) by lia; lia. }
  assert (T : 1 <= whole s) by (unfold valid in V; lia).
  set (p := place (push s x)) in *.
  assert (R : 0 <= p <= quarter - 1) by lia.
  pose proof (search_finds s 0 (quarter - 1) p R T) as S; unfold narrow, target in S.
  replace (quarter - 1 - 0 + 1) with quarter in S by lia.
  rewrite Z.sub_0_r, !Z.add_0_l in S; apply S; unfold begins, has_of in P; lia.
Qed.

(** ARITH-RANS-4: popping undoes pushing, state and bytes. *)
Theorem pop_push : forall s x, valid s -> settled_state (state x) -> pop s (push s x) = x.
Proof.
  intros s [x l] V X; destruct (stretched s V) as (C & F & M); cbn [state] in X.
  pose proof quarter_pos as Q; assert (F' : 1 <= has_of s <= quarter) by lia.
  unfold pop, place, push; cbn [state ahead].
  set (y := shrink 4 (has_of s) (Pushed x l)) in *; set (f := has_of s) in *.
  pose proof (Z.mod_pos_bound (state y) f) as R; pose proof (Z.div_mod (state y) f) as D.
  replace (quarter * (state y / f) + begins s + state y mod f)
    with (begins s + state y mod f + state y / f * quarter) by lia.
  set (c := begins s + state y mod f) in *; assert (Cq : 0 <= c < quarter) by lia.
  rewrite Z.mod_add, (Z.mod_small c), Z.div_add, (Z.div_small c) by lia; unfold c; clear c Cq.
  replace (f * (0 + state y / f) + (begins s + state y mod f) - begins s) with (state y) by lia.
  destruct (grow_undoes 4 f x l) as (j & J & G); [unfold settled_state, bottom in *; lia|].
  replace (Pushed (state y) (ahead y)) with y by (destruct y; reflexivity).
  replace 4%nat with (j + (4 - j))%nat at 1 by lia; unfold y; rewrite G.
  apply grow_settled; apply X.
Qed.

(** ARITH-RANS-5: pushing undoes popping, if the bytes are there and the slot is that of the place.
    So a state and bytes are pushed in one way only. *)
Theorem push_pop : forall s x, valid s -> settled_state (state x) ->
  begins s <= place x < begins s + has_of s -> (4 <= length (ahead x))%nat ->
  Forall (fun b => 0 <= b < 256) (ahead x) -> push s (pop s x) = x.
Proof.
  intros s [x l] V X P L B; destruct (stretched s V) as (C & F & M).
  pose proof quarter_pos as Q; unfold push, pop, place in *; cbn [state ahead] in *.
  set (f := has_of s) in *; set (y := f * (x / quarter) + x mod quarter - begins s).
  assert (D : 262144 <= x / quarter < 67108864).
  { unfold settled_state, bottom in X.
    split; [apply Z.div_le_lower_bound; lia|apply Z.div_lt_upper_bound; lia]. }
  assert (Y : f * 262144 <= y < f * 67108864) by (unfold y; nia).
  destruct (shrink_undoes 4 f y l) as (j & J & G); try assumption; try lia.
  replace (shrink 4 f (grow 4 (Pushed y l))) with (Pushed y l)
    by (replace 4%nat with (j + (4 - j))%nat at 1 by lia; rewrite G; symmetry;
      apply shrink_fitting; lia).
  cbn [state ahead]; f_equal.
  assert (A : x / quarter = y / f)
    by (apply (Z.div_unique _ _ _ (x mod quarter - begins s)); unfold y; lia).
  assert (R : x mod quarter - begins s = y mod f)
    by (apply (Z.mod_unique _ _ (x / quarter)); unfold y; lia).
  rewrite <- A, <- R.
  pose proof (Z.div_mod x quarter); lia.
Qed.

(** ** Messages *)

(** ARITH-RANS-3: the symbols are pushed from the last to the first; [more] is what follows. *)
Definition push_all (ss : list slot) (more : list Z) : pushed :=
  fold_right push (Pushed bottom more) ss.

Lemma push_all_settles : forall ss more, Forall valid ss ->
  settled_state (state (push_all ss more)).
Proof.
  intros ss more; induction 1 as [|s ss V _ IH]; cbn [push_all fold_right].
  - unfold settled_state, bottom; cbn [state]; pose proof quarter_pos; lia.
  - apply push_settles; assumption.
Qed.

Section Coder.
  Variable Model : Type.
  Variable now : Model -> table.
  Variable after : Model -> Z -> Model.
  Variable good : Model -> Prop.
  Hypothesis good_now : forall m, good m -> proper (now m).
  Hypothesis good_after : forall m s sl, good m -> total (now m) <= quarter ->
    slot_of (now m) s = Some sl -> good (after m s).

  (** Up to n symbols, and the state and bytes after them. ARITH-RANS-4. *)
  Fixpoint pop_all (n : nat) (m : Model) (x : pushed) : list Z * pushed :=
    match n with
    | O => ([], x)
    | S k =>
        let t := now m in
        if total t =? 0 then ([], x)
        else
          let s := find t (((place x + 1) * total t - 1) / quarter) in
          let (ms, y) := pop_all k (after m s)
                                 (pop (Slot (cumulative t s) (cumulative t (s + 1)) (total t)) x) in
          (s :: ms, y)
    end.

  (** ARITH-BYTES-3, ARITH-RANS-5: a message is found in its bytes whatever follows them; in the end
      the state is the first one, and what follows is left. *)
  Theorem rans_round_trip : forall n i m ms ss more, good m ->
    slots Model now after i m ms = accepted ss -> is_whole Model now after m n ms ->
    pop_all n m (push_all ss more) = (ms, Pushed bottom more).
  Proof.
    unfold is_whole; induction n as [|n IH]; intros i m ms ss more G E W; cbn [pop_all].
    - destruct ms; [injection E as <-; reflexivity|cbn in W; lia].
    - destruct ms as [|s ms].
      + destruct W as [W|[_ W]]; [discriminate|]; unfold then_ in W; cbn [fold_left] in W.
        injection E as <-; rewrite W; reflexivity.
      + apply slots_cons in E as (sl & rest & Q & S & E & ->).
        pose proof (slot_valid _ _ _ (good_now m G) Q S) as V.
        pose proof (slot_of_some _ _ _ S) as (B & C & SL).
        assert (G' : good (after m s)) by exact (good_after m s sl G Q S).
        pose proof (slots_valid _ _ _ _ good_now good_after _ _ _ _ G' E) as VS.
        cbn [push_all fold_right]; fold (push_all rest more).
        pose proof (pushed_place sl (push_all rest more) V) as P.
        assert (F : find (now m) (((place (push sl (push_all rest more)) + 1) * total (now m) - 1)
                                  / quarter) = s).
        { apply found_is_the_one; [exact (good_now m G)|exact B|].
          rewrite SL in P; cbn [below upto whole] in P; rewrite SL; exact P. }
        rewrite F, <- SL, pop_push by (try apply push_all_settles; assumption).
        rewrite (proj2 (Z.eqb_neq (total (now m)) 0))
          by (rewrite SL in V; unfold valid in V; cbn [below upto whole] in V; lia).
        rewrite (IH _ _ _ _ more G' E); [reflexivity|].
        destruct W as [W|[W W']]; cbn [length] in W; [left; lia|right; split; [lia|exact W']].
  Qed.
End Coder.
