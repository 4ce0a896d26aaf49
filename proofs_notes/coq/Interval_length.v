(** How much the interval of the 32-bit coder shrinks: spec/02-arithmetic.md, section 2.5.

    Each symbol shrinks the width by its probability, but for what two floors take away; each shift
    doubles it. Proved here, for every list of slots that a coder can meet: the number of shifts lies
    between two bounds by the probability (ARITH-LENGTH-1, ARITH-LENGTH-2). The bounds have their
    denominators multiplied out: all is in integers. *)
Require Import ZArith List Lia Bool.
From Clers Require Import Model Interval.
Import ListNotations.
Open Scope Z_scope.

Definition width (p : place) : Z := high p - low p + 1.
Definition frequency (s : slot) : Z := upto s - below s.

Lemma settle_width : forall f p,
  width (settle f p) * 2 ^ Z.of_nat (shifts p) = width p * 2 ^ Z.of_nat (shifts (settle f p)).
Proof.
  unfold width; induction f as [|f IH]; intros p; cbn [settle]; [reflexivity|].
  destruct (away _ _) as [o|]; [|reflexivity].
  match goal with |- context [settle f ?x] => specialize (IH x); set (r := settle f x) in * end.
  cbn [shifts low high] in IH; rewrite Nat2Z.inj_succ, Z.pow_succ_r in IH by lia; nia.
Qed.

(** What floors take away of a part, times the total: less than the total. *)
Lemma narrow_width : forall s lo hi, 1 <= whole s ->
  let (l, h) := narrow s lo hi in
  Z.abs ((h - l + 1) * whole s - (hi - lo + 1) * frequency s) <= whole s - 1.
Proof.
  intros s lo hi T; unfold narrow, frequency; set (w := hi - lo + 1).
  pose proof (Z.mul_div_le (w * below s) (whole s));
    pose proof (Z.mul_succ_div_gt (w * below s) (whole s)).
  pose proof (Z.mul_div_le (w * upto s) (whole s));
    pose proof (Z.mul_succ_div_gt (w * upto s) (whole s)).
  nia.
Qed.

(** The products of the specification, with all denominators T (Q + 2) multiplied out:
    the product of f/T (1 - e) is [product shortest] / [product wholes], that of f/T (1 + e) is
    [product longest] / [product wholes], where e = (T - 1) / ((Q + 2) f). *)
Definition product (f : slot -> Z) (ss : list slot) : Z := fold_right (fun s n => f s * n) 1 ss.
Definition wholes (s : slot) : Z := whole s * (quarter + 2).
Definition least (s : slot) : Z := frequency s * (quarter + 2) - (whole s - 1).
Definition most (s : slot) : Z := frequency s * (quarter + 2) + (whole s - 1).

Lemma factors_positive : forall s, valid s -> 1 <= wholes s /\ 1 <= least s /\ 1 <= most s.
Proof.
  intros s V; unfold wholes, least, most, frequency, valid in *; pose proof quarter_pos; nia.
Qed.

Lemma products_positive : forall ss, Forall valid ss ->
  1 <= product least ss /\ 1 <= product wholes ss /\ 1 <= product most ss.
Proof.
  induction 1 as [|s ss V _ IH]; cbn [product fold_right]; [lia|].
  pose proof (factors_positive s V); fold (product least ss) (product wholes ss) (product most ss);
    nia.
Qed.

Lemma power_positive : forall n, 1 <= 2 ^ Z.of_nat n.
Proof. intros n; pose proof (Z.pow_pos_nonneg 2 (Z.of_nat n)); lia. Qed.

Lemma step_width : forall p s, at_rest p -> valid s ->
  width p * 2 ^ Z.of_nat (shifts (step p s)) * least s
    <= width (step p s) * 2 ^ Z.of_nat (shifts p) * wholes s
    <= width p * 2 ^ Z.of_nat (shifts (step p s)) * most s.
Proof.
  intros p s R V; pose proof (settled_is_wide _ _ R) as W; unfold step.
  pose proof (narrow_width s (low p) (high p)) as N.
  destruct (narrow s (low p) (high p)) as [l h].
  pose proof (settle_width most_shifts (Place (base p) (shifts p) l h)) as E.
  set (r := settle _ _) in *; cbn [shifts] in E; unfold width at 2 in E; cbn [low high] in E.
  rewrite E; unfold width, wholes, least, most; fold (width p) in *.
  pose proof (power_positive (shifts r)); set (k := 2 ^ Z.of_nat (shifts r)) in *.
  assert (1 <= whole s) by (unfold valid in V; lia); specialize (N ltac:(assumption)).
  set (w := width p) in *; set (n := h - l + 1) in *; clear E; pose proof quarter_pos.
  assert (T : (whole s - 1) * (quarter + 2) <= (whole s - 1) * w) by (apply Z.mul_le_mono_nonneg_l;
    lia).
  assert (N' : - (whole s - 1) <= n * whole s - w * frequency s <= whole s - 1) by lia.
  destruct N' as [N1 N2]; apply (Z.mul_le_mono_nonneg_r _ _ (quarter + 2)) in N1, N2; try lia.
  assert (A : w * (frequency s * (quarter + 2) - (whole s - 1)) <= n * whole s * (quarter + 2))
    by lia.
  assert (B : n * whole s * (quarter + 2) <= w * (frequency s * (quarter + 2) + (whole s - 1)))
    by lia.
  apply (Z.mul_le_mono_nonneg_l _ _ k) in A, B; lia.
Qed.

Lemma run_width : forall ss p, at_rest p -> Forall valid ss ->
  width p * 2 ^ Z.of_nat (shifts (run ss p)) * product least ss
    <= width (run ss p) * 2 ^ Z.of_nat (shifts p) * product wholes ss
    <= width p * 2 ^ Z.of_nat (shifts (run ss p)) * product most ss.
Proof.
  induction ss as [|s ss IH]; intros p R V; [cbn; lia|].
  inversion_clear V as [|? ? V0 VS].
  pose proof (step_width p s R V0) as W; specialize (IH (step p s) (step_settles p s R V0) VS).
  rewrite fold_left_cons; cbn [product fold_right];
    fold (product least ss) (product wholes ss) (product most ss).
  destruct (factors_positive s V0) as (P1 & P2 & P3).
  destruct (products_positive ss VS) as (PL & PW & PM).
  set (q := step p s) in *; set (r := run ss q) in *.
  pose proof (power_positive (shifts p)); pose proof (power_positive (shifts q));
    pose proof (power_positive (shifts r)).
  set (kp := 2 ^ Z.of_nat (shifts p)) in *; set (kq := 2 ^ Z.of_nat (shifts q)) in *;
    set (kr := 2 ^ Z.of_nat (shifts r)) in *.
  set (L := product least ss) in *; set (W' := product wholes ss) in *;
    set (M := product most ss) in *.
  (* Multiply the bounds of the step by those of the rest, and take kq away. *)
  destruct W as [W1 W2], IH as [I1 I2].
  split; apply Z.mul_le_mono_pos_l with (p := kq); try lia.
  - transitivity (width q * kp * wholes s * (kr * L)).
    + apply (Z.mul_le_mono_nonneg_r _ _ (kr * L)) in W1; nia.
    + apply (Z.mul_le_mono_nonneg_r _ _ (kp * wholes s)) in I1; nia.
  - transitivity (width q * kp * wholes s * (kr * M)).
    + apply (Z.mul_le_mono_nonneg_r _ _ (kp * wholes s)) in I2; nia.
    + apply (Z.mul_le_mono_nonneg_r _ _ (kr * M)) in W2; nia.
Qed.

(** ARITH-LENGTH-1 with N = L - 2 shifts: 2^N times the product of f/T (1 - e) is at most 1. *)
Theorem shifts_at_most : forall ss, Forall valid ss ->
  2 ^ Z.of_nat (shifts (run ss start)) * product least ss <= product wholes ss.
Proof.
  intros ss V; destruct (run_width ss start start_at_rest V) as [A _].
  pose proof (run_settles ss start start_at_rest V) as R; pose proof quarter_pos.
  assert (B : width (run ss start) <= 4 * quarter) by (unfold at_rest, settled, within, width in *;
    lia).
  change (width start) with (4 * quarter) in A; change (2 ^ Z.of_nat (shifts start)) with 1 in A.
  destruct (products_positive ss V).
  nia.
Qed.

(** ARITH-LENGTH-2 with N = L - 2 shifts: 2^(N + 2) times the product of f/T (1 + e) is above 1. *)
Theorem shifts_at_least : forall ss, Forall valid ss ->
  product wholes ss < 4 * 2 ^ Z.of_nat (shifts (run ss start)) * product most ss.
Proof.
  intros ss V; destruct (run_width ss start start_at_rest V) as [_ A].
  pose proof (settled_is_wide _ _ (run_settles ss start start_at_rest V)) as R;
    pose proof quarter_pos.
  change (width start) with (4 * quarter) in A; change (2 ^ Z.of_nat (shifts start)) with 1 in A.
  fold (width (run ss start)) in R.
  destruct (products_positive ss V).
  nia.
Qed.
