(** The exact arithmetic coder: spec/02-arithmetic.md, section 2.2.

    A message is an interval of rational numbers, narrowed symbol by symbol. For every model whose
    tables are proper, adaptive or not. Proved here:
    - the width of the interval is the probability of the message           (ARITH-EXACT-4)
    - an interval lies in the one before                                    (ARITH-EXACT-1)
    - every number of the interval decodes to the message; so do the bits
      of a code, whatever follows them                                      (ARITH-EXACT-3)
    - there is a code                                                       (ARITH-EXACT-2)
    - a shortest has at least I and less than I + 2 bits, where I is the
      information content                                                   (ARITH-EXACT-5) *)
Require Import ZArith QArith Qround Lqa List Lia Bool.
From Clers Require Import Bits Model.
Import ListNotations.
Open Scope Q_scope.

(** A part of a whole, as a rational number. *)
Definition ratio (a t : Z) : Q := inject_Z a / inject_Z t.

Definition probability (s : slot) : Q := ratio (upto s - below s) (whole s).

(** ARITH-EXACT-1: lower end and width of the interval of a message. *)
Fixpoint interval (ss : list slot) (l w : Q) : Q * Q :=
  match ss with
  | [] => (l, w)
  | s :: rest => interval rest (l + w * ratio (below s) (whole s)) (w * probability s)
  end.

Lemma ratio_facts : forall s, valid s ->
  0 <= ratio (below s) (whole s) /\ 0 < probability s /\
  ratio (below s) (whole s) + probability s == ratio (upto s) (whole s) /\
  ratio (upto s) (whole s) <= 1.
Proof.
  intros s [[B U] [W _]]; unfold probability, ratio.
  assert (T : 0 < inject_Z (whole s)) by (change 0 with (inject_Z 0); rewrite <- Zlt_Qlt; lia).
  repeat split.
  - apply Qle_shift_div_l; [exact T|]; rewrite Qmult_0_l; change 0 with (inject_Z 0);
      rewrite <- Zle_Qle; lia.
  - apply Qlt_shift_div_l; [exact T|]; rewrite Qmult_0_l; change 0 with (inject_Z 0);
      rewrite <- Zlt_Qlt; lia.
  - unfold Z.sub; rewrite inject_Z_plus, inject_Z_opp; field; lra.
  - apply Qle_shift_div_r; [exact T|]; rewrite Qmult_1_l, <- Zle_Qle; lia.
Qed.

(** ARITH-EXACT-4: the width of the interval of a message is its probability. *)
Theorem width_is_probability : forall ss l w,
  snd (interval ss l w) == w * fold_right (fun s p => probability s * p) 1 ss.
Proof.
  induction ss as [|s ss IH]; intros l w; cbn [interval fold_right snd]; [ring|].
  rewrite IH; ring.
Qed.

(** ARITH-EXACT-1: intervals are not empty, and each lies in the one before. *)
Theorem interval_inside : forall ss l w, Forall valid ss -> 0 < w ->
  let (a, v) := interval ss l w in l <= a /\ 0 < v /\ a + v <= l + w.
Proof.
  induction ss as [|s ss IH]; intros l w V W; cbn [interval]; [lra|].
  inversion_clear V as [|? ? V0 VS]; destruct (ratio_facts s V0) as (A & B & C & D).
  assert (P : 0 < w * probability s) by nra.
  specialize (IH (l + w * ratio (below s) (whole s)) _ VS P).
  destruct (interval ss _ _) as [a v]; nra.
Qed.

(** The unit in which a number of a table lies, out of t. *)
Definition unit_of (t : Z) (l w x : Q) : Z := Qfloor ((x - l) / w * inject_Z t).

(** ARITH-EXACT-3, ARITH-EXACT-4: a number lies in the part of a slot exactly if its unit does. So
    the parts of a table do not overlap, and leave nothing out. *)
Theorem unit_tells_the_part : forall s l w x, (1 <= whole s)%Z -> 0 < w ->
  l + w * ratio (below s) (whole s) <= x /\ x < l + w * ratio (upto s) (whole s) <->
  (below s <= unit_of (whole s) l w x < upto s)%Z.
Proof.
  intros s l w x T W; unfold unit_of; set (y := (x - l) / w * inject_Z (whole s)).
  assert (T' : 0 < inject_Z (whole s)) by (change 0 with (inject_Z 0); rewrite <- Zlt_Qlt; lia).
  assert (X : x == l + w * (y / inject_Z (whole s))) by (unfold y; field; lra).
  assert (F : forall c, inject_Z c <= y <-> (c <= Qfloor y)%Z).
  { intros c; split; intros H.
    - rewrite <- (Qfloor_Z c); apply Qfloor_resp_le, H.
    - apply Qle_trans with (inject_Z (Qfloor y)); [rewrite <- Zle_Qle; exact H|apply Qfloor_le]. }
  assert (E : forall c, l + w * ratio c (whole s) <= x <-> inject_Z c <= y).
  { intros c; rewrite X; unfold ratio; split; intros H.
    - assert (K : inject_Z c / inject_Z (whole s) <= y / inject_Z (whole s)) by nra.
      apply Qmult_le_r with (z := / inject_Z (whole s)); [apply Qinv_lt_0_compat, T'|exact K].
    - assert (K : inject_Z c / inject_Z (whole s) <= y / inject_Z (whole s)); [|nra].
      apply Qmult_le_r; [apply Qinv_lt_0_compat, T'|exact H]. }
  rewrite (E (below s)), (F (below s)).
  assert (N : x < l + w * ratio (upto s) (whole s) <-> ~ (upto s <= Qfloor y)%Z).
  { rewrite <- F, <- E; split; [intros H K; lra|intros H; apply Qnot_le_lt, H]. }
  rewrite N; lia.
Qed.

(** ** Decoding *)

Section Coder.
  Variable Model : Type.
  Variable now : Model -> table.
  Variable after : Model -> Z -> Model.
  Variable good : Model -> Prop.
  Hypothesis good_now : forall m, good m -> proper (now m).
  Hypothesis good_after : forall m s sl, good m -> (total (now m) <= quarter)%Z ->
    slot_of (now m) s = Some sl -> good (after m s).

  (** ARITH-EXACT-3: up to n symbols of the number x. *)
  Fixpoint decode (n : nat) (m : Model) (l w x : Q) : list Z :=
    match n with
    | O => []
    | S k =>
        let t := now m in
        if (total t =? 0)%Z then []
        else
          let s := find t (unit_of (total t) l w x) in
          let sl := Slot (cumulative t s) (cumulative t (s + 1)) (total t) in
          s :: decode k (after m s) (l + w * ratio (below sl) (whole sl)) (w * probability sl) x
    end.

  (** ARITH-EXACT-3: every number of the interval of a message decodes to the message. *)
  Theorem exact_round_trip : forall n i m ms ss l w x, good m ->
    slots Model now after i m ms = accepted ss -> is_whole Model now after m n ms -> 0 < w ->
    (let (a, v) := interval ss l w in a <= x /\ x < a + v) -> decode n m l w x = ms.
  Proof.
    unfold is_whole; induction n as [|n IH]; intros i m ms ss l w x G E W P X; cbn [decode].
    - destruct ms; [reflexivity|cbn in W; lia].
    - destruct ms as [|s ms].
      + destruct W as [W|[_ W]]; [discriminate|]; unfold then_ in W; cbn [fold_left] in W.
        rewrite W; reflexivity.
      + apply slots_cons in E as (sl & rest & Q & S & E & ->).
        pose proof (slot_valid _ _ _ (good_now m G) Q S) as V.
        pose proof (slot_of_some _ _ _ S) as (B & C & SL).
        assert (G' : good (after m s)) by exact (good_after m s sl G Q S).
        pose proof (slots_valid _ _ _ _ good_now good_after _ _ _ _ G' E) as VS.
        destruct (ratio_facts sl V) as (R1 & R2 & R3 & R4).
        assert (P' : 0 < w * probability sl) by nra.
        cbn [interval] in X.
        pose proof (interval_inside rest (l + w * ratio (below sl) (whole sl)) _ VS P') as I.
        assert (T : (1 <= whole sl)%Z) by (unfold valid in V; lia).
        assert (F : find (now m) (unit_of (total (now m)) l w x) = s).
        { apply found_is_the_one; [exact (good_now m G)|exact B|].
          pose proof (proj1 (unit_tells_the_part sl l w x T P)) as U; rewrite SL in U at 3 4 5.
          cbn [below upto whole] in U; rewrite SL in U; cbn [below upto whole] in U.
          rewrite SL in X, I, R1, R2, R3, R4, P';
            cbn [below upto whole] in X, I, R1, R2, R3, R4, P'.
          apply U; destruct (interval _ _ _) as [a v]; split; nra. }
        rewrite (proj2 (Z.eqb_neq (total (now m)) 0))
          by (rewrite SL in T; cbn [whole] in T; lia).
        rewrite F, <- SL; f_equal; eapply IH; try eassumption.
        destruct W as [W|[W W']]; cbn [length] in W; [left; lia|right; split; [lia|exact W']].
  Qed.
End Coder.

(** ** Codes *)

Definition unit_of_length (n : nat) : Q := / inject_Z (power n).

(** ARITH-EXACT-2: the dyadic interval of the bits lies inside. *)
Definition names (b : list bool) (l w : Q) : Prop :=
  let u := unit_of_length (length b) in
  l <= inject_Z (value b) * u /\ inject_Z (value b + 1) * u <= l + w.

Lemma power_Q : forall n, 0 < inject_Z (power n).
Proof. intros n; change 0 with (inject_Z 0); rewrite <- Zlt_Qlt; pose proof (power_pos n); lia. Qed.

Lemma unit_positive : forall n, 0 < unit_of_length n.
Proof. intros n; apply Qinv_lt_0_compat, power_Q. Qed.

Lemma unit_S : forall n, unit_of_length n == 2 * unit_of_length (S n).
Proof.
  intros n; unfold unit_of_length; rewrite power_S, inject_Z_mult; pose proof (power_Q n); field;
    lra.
Qed.

(** ARITH-EXACT-3: whatever follows, the number stays in the dyadic interval. *)
Theorem followed_by_anything : forall b more l w, names b l w ->
  let x := inject_Z (value (b ++ more)) * unit_of_length (length (b ++ more)) in
  l <= x /\ x < l + w.
Proof.
  intros b more l w [A B] x; unfold x; clear x; rewrite value_app, app_length.
  unfold unit_of_length in *; rewrite power_add.
  rewrite !inject_Z_plus, !inject_Z_mult in *.
  pose proof (power_Q (length b)) as P; pose proof (power_Q (length more)) as R.
  pose proof (value_range more) as [V1 V2].
  rewrite Zle_Qle in V1; rewrite Zlt_Qlt in V2; change (inject_Z 0) with 0 in V1;
    change (inject_Z 1) with 1 in B.
  set (p := inject_Z (power (length b))) in *; set (r := inject_Z (power (length more))) in *.
  set (v := inject_Z (value b)) in *; set (k := inject_Z (value more)) in *.
  assert (E : (r * v + k) * / (p * r) == v * / p + k / r * / p) by (field; lra).
  assert (0 < / p) by (apply Qinv_lt_0_compat, P).
  assert (K1 : 0 <= k / r) by (apply Qle_shift_div_l; lra).
  assert (K2 : k / r < 1) by (apply Qlt_shift_div_r; lra).
  rewrite E; split; nra.
Qed.

Lemma bits_exist : forall n k, (0 <= k < power n)%Z -> exists b, length b = n /\ value b = k.
Proof.
  induction n as [|n IH]; intros k K.
  - exists []; change (power 0) with 1%Z in K; cbn; lia.
  - rewrite power_S in K; destruct (IH (k / 2)%Z) as (b & L & V).
    { split; [apply Z.div_pos; lia|apply Z.div_lt_upper_bound; lia]. }
    exists (b ++ [negb (k mod 2 =? 0)%Z]); rewrite app_length, value_snoc, L, V; split; [cbn; lia|].
    pose proof (Z.div_mod k 2); pose proof (Z.mod_pos_bound k 2).
    destruct (k mod 2 =? 0)%Z eqn:E; cbn [negb bit]; rewrite ?Z.eqb_eq, ?Z.eqb_neq in E; lia.
Qed.

(** An interval twice as wide as the unit of n bits has a code of n bits. *)
Lemma code_of_length : forall n l w, 0 <= l -> l + w <= 1 -> 2 * unit_of_length n <= w ->
  exists b, length b = n /\ names b l w.
Proof.
  intros n l w L H W; pose proof (unit_positive n) as U; pose proof (power_Q n) as P.
  set (k := Qceiling (l / unit_of_length n)).
  assert (A : l <= inject_Z k * unit_of_length n).
  { pose proof (Qle_ceiling (l / unit_of_length n)) as C; fold k in C.
    setoid_replace l with (l / unit_of_length n * unit_of_length n) at 1 by (field; lra); nra. }
  assert (B : inject_Z (k + 1) * unit_of_length n < l + 2 * unit_of_length n).
  { pose proof (Qceiling_lt (l / unit_of_length n)) as C; fold k in C.
    replace (k + 1)%Z with ((k - 1) + 2)%Z by lia; rewrite inject_Z_plus.
    setoid_replace l with (l / unit_of_length n * unit_of_length n) at 1 by (field; lra).
    change (inject_Z 2) with 2; nra. }
  assert (E : unit_of_length n * inject_Z (power n) == 1) by (unfold unit_of_length; field; lra).
  destruct (bits_exist n k) as (b & N & V).
  - split.
    + assert (Q0 : inject_Z (-1) < inject_Z k); [|rewrite <- Zlt_Qlt in Q0; lia].
      change (inject_Z (-1)) with (-1); nra.
    + assert (Q1 : inject_Z (k + 1) < inject_Z (power n + 1)); [|rewrite <- Zlt_Qlt in Q1; lia].
      rewrite (inject_Z_plus (power n)); change (inject_Z 1) with 1; nra.
  - exists b; split; [exact N|]; unfold names; rewrite N, V; lra.
Qed.

(** ARITH-EXACT-2: every interval has a code. *)
Theorem code_exists : forall l w, 0 <= l -> 0 < w -> l + w <= 1 -> exists b, names b l w.
Proof.
  intros l w L W H.
  assert (N : exists n, 2 * unit_of_length n <= w).
  { exists (Z.to_nat (Qceiling (2 / w))); unfold unit_of_length, power.
    pose proof (Qle_ceiling (2 / w)) as C; set (k := Qceiling (2 / w)) in *.
    assert (K : 0 < inject_Z k) by (apply Qlt_le_trans with (2 / w); [apply Qlt_shift_div_l;
      lra|exact C]).
    assert (Kz : (0 < k)%Z) by (change 0 with (inject_Z 0) in K; rewrite <- Zlt_Qlt in K; exact K).
    rewrite Z2Nat.id by lia.
    assert (G : (k <= 2 ^ k)%Z) by (apply Z.lt_le_incl, Z.pow_gt_lin_r; lia).
    rewrite Zle_Qle in G; set (p := inject_Z (2 ^ k)) in *.
    apply Qle_shift_div_r; [lra|].
    assert (2 <= inject_Z k * w); [|nra].
    setoid_replace 2 with (2 / w * w) by (field; lra); nra. }
  destruct N as [n N]; destruct (code_of_length n l w L H N) as (b & _ & B); exists b; exact B.
Qed.

(** ARITH-EXACT-5: with w = 2^-I, a shortest code of L bits has I <= L < I + 2. *)
Theorem exact_length : forall b l w, 0 <= l -> l + w <= 1 -> names b l w ->
  (forall c, names c l w -> (length b <= length c)%nat) ->
  unit_of_length (length b) <= w /\ w < 4 * unit_of_length (length b).
Proof.
  intros b l w L H N S; split.
  - destruct N as [A B]; rewrite inject_Z_plus in B; change (inject_Z 1) with 1 in B; lra.
  - apply Qnot_le_lt; intros W; destruct (length b) as [|n] eqn:E.
    + assert (unit_of_length 0 == 1) by reflexivity; lra.
    + destruct (code_of_length n l w L H) as (c & C & D); [rewrite unit_S; lra|].
      apply S in D; lia.
Qed.
