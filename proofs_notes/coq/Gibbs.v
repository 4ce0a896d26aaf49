(** * No table costs a word less than its own frequencies

    Clauses: INFO-CROSS-2 for whole numbers (Gibbs' inequality), for section 4 of the note on the
    golden code and section 2 of the one on minimax codes.

    Symbols that occur n_1, n_2, … times, n together, have under a table of frequencies f_1, f_2, …
    of sum M the probability Π (f_i/M)^(n_i); under their own frequencies Π (n_i/n)^(n_i). The
    second
    is never less. Multiplied out, this is about whole numbers, and no logarithm occurs. *)

Require Import ZArith List Lia.
Import ListNotations.
Open Scope Z_scope.

Fixpoint pow (x : Z) (n : nat) : Z := match n with O => 1 | S k => x * pow x k end.

Lemma pow_nonneg : forall x n, 0 <= x -> 0 <= pow x n.
Proof. intros x n H; induction n; cbn [pow]; nia. Qed.
Lemma pow_pos : forall x n, 0 < x -> 0 < pow x n.
Proof. intros x n H; induction n; cbn [pow]; nia. Qed.
Lemma pow_add : forall x m n, pow x (m + n) = pow x m * pow x n.
Proof. intros x m n; induction m; cbn [pow Nat.add]; [lia|rewrite IHm; ring]. Qed.
Lemma pow_mul : forall x y n, pow (x * y) n = pow x n * pow y n.
Proof. intros x y n; induction n; cbn [pow]; [reflexivity|rewrite IHn; ring]. Qed.

(** Bernoulli: a power lies above its tangent. *)
Lemma tangent : forall m p q, 0 <= p -> 0 <= q ->
  (Z.of_nat m + 1) * q * pow p m <= pow q (S m) + Z.of_nat m * pow p (S m).
Proof.
  induction m as [|m IH]; intros p q P Q; [cbn [pow Z.of_nat]; lia|].
  specialize (IH p q P Q); rewrite Nat2Z.inj_succ; cbn [pow] in *.
  set (u := pow p m) in *; set (w := pow q m) in *; set (k := Z.of_nat m) in *.
  assert (0 <= u) by (apply pow_nonneg; auto); assert (0 <= k) by lia.
  assert (A : q * ((k + 1) * q * u) <= q * (q * w + k * (p * u))).
  { apply Z.mul_le_mono_nonneg_l; auto. }
  assert (B : 0 <= (k + 1) * u * ((q - p) * (q - p))).
  { apply Z.mul_nonneg_nonneg; [apply Z.mul_nonneg_nonneg; lia|apply Z.square_nonneg]. }
  unfold Z.succ; apply Z.le_sub_0.
  replace ((k + 1 + 1) * q * (p * u) - (q * (q * w) + (k + 1) * (p * (p * u))))
    with ((q * ((k + 1) * q * u) - q * (q * w + k * (p * u))) - (k + 1) * u * ((q - p) * (q - p)))
      by ring.
  lia.
Qed.

Definition sum (l : list Z) : Z := fold_right Z.add 0 l.
Definition product (l : list Z) : Z := fold_right Z.mul 1 l.

Lemma sum_nonneg : forall l, (forall x, In x l -> 0 <= x) -> 0 <= sum l.
Proof.
  induction l as [|x l IH]; intros H; cbn; [lia|].
  pose proof (H x (or_introl eq_refl)); assert (0 <= sum l) by (apply IH; intros; apply H; right;
    auto).
  unfold sum in *; lia.
Qed.

(** The geometric mean is at most the arithmetic mean. *)
Theorem means : forall l, (forall x, In x l -> 0 <= x) ->
  pow (Z.of_nat (length l)) (length l) * product l <= pow (sum l) (length l).
Proof.
  induction l as [|x l IH]; intros H; [cbn; lia|].
  assert (X : 0 <= x) by (apply H; left; auto).
  assert (HL : forall y, In y l -> 0 <= y) by (intros; apply H; right; auto).
  specialize (IH HL); pose proof (sum_nonneg l HL) as SN.
  cbn [sum product fold_right length]; fold (sum l) (product l).
  set (k := length l) in *; set (s := sum l) in *; set (r := product l) in *.
  destruct k as [|k'] eqn:K.
  { destruct l; [|discriminate]; unfold r, s; cbn [sum product fold_right pow].
    change (Z.of_nat 1) with 1; lia. }
  rewrite <- K in *; set (z := Z.of_nat k) in *; assert (Z0 : 0 < z) by lia.
  replace (Z.of_nat (S k)) with (z + 1) by lia.
  (* the tangent at p = (k+1)s to the power of q = k(s+x) *)
  pose proof (tangent k ((z + 1) * s) (z * (x + s)) ltac:(nia) ltac:(nia)) as T; fold z in T.
  cbn [pow] in T |- *; rewrite !pow_mul in T.
  set (a := pow (z + 1) k) in *; set (b := pow s k) in *; set (c := pow (x + s) k) in *.
  set (d := pow z k) in *.
  assert (A : 0 < a) by (apply pow_pos; lia); assert (D : 0 < d) by (apply pow_pos; lia).
  (* what is wanted, times d * z *)
  assert (E : (z + 1) * a * b * (z * x) <= z * (x + s) * (d * c)) by nia.
  assert (G : (z + 1) * a * (x * (d * r)) <= (z + 1) * a * (x * b)).
  { apply Z.mul_le_mono_nonneg_l; [nia|]; apply Z.mul_le_mono_nonneg_l; auto. }
  assert (F : d * ((z + 1) * a * (x * r)) <= d * ((x + s) * c)).
  { apply Z.mul_le_mono_pos_l with z; [lia|]; nia. }
  apply Z.mul_le_mono_pos_l in F; auto.
Qed.

Lemma sum_repeat : forall x n l, sum (repeat x n ++ l) = Z.of_nat n * x + sum l.
Proof.
  intros x n l; induction n as [|n IH]; [cbn [repeat app Z.of_nat pow]; lia|].
  cbn [repeat app sum fold_right]; fold (sum (repeat x n ++ l)); rewrite IH; lia.
Qed.
Lemma product_repeat : forall x n l, product (repeat x n ++ l) = pow x n * product l.
Proof.
  intros x n l; induction n as [|n IH]; [cbn [repeat app Z.of_nat pow]; lia|].
  cbn [repeat app product fold_right pow]; fold (product (repeat x n ++ l)); rewrite IH; ring.
Qed.

(** Two symbols. *)
Lemma two_symbols : forall a b x y, 0 <= x -> 0 <= y ->
  pow (Z.of_nat (a + b)) (a + b) * (pow x a * pow y b)
  <= pow (x + y) (a + b) * (pow (Z.of_nat a) a * pow (Z.of_nat b) b).
Proof.
  intros a b x y X Y; destruct a as [|a'] eqn:EA; [|destruct b as [|b'] eqn:EB].
  - cbn [Nat.add pow]; rewrite !Z.mul_1_l.
    assert (pow y b <= pow (x + y) b).
    { clear - X Y; induction b as [|b IH]; cbn [pow]; [lia|].
      assert (0 <= pow y b) by (apply pow_nonneg; auto); nia. }
    assert (0 <= pow (Z.of_nat b) b) by (apply pow_nonneg; lia); nia.
  - rewrite Nat.add_0_r; set (c := S a'); cbn [pow]; rewrite !Z.mul_1_r.
    assert (pow x c <= pow (x + y) c).
    { clear - X Y; induction c as [|c IH]; cbn [pow]; [lia|].
      assert (0 <= pow x c) by (apply pow_nonneg; auto); nia. }
    assert (0 <= pow (Z.of_nat c) c) by (apply pow_nonneg; lia); nia.
  - rewrite <- EA, <- EB; set (p := Z.of_nat a); set (q := Z.of_nat b).
    assert (P : 0 < p) by lia; assert (Q : 0 < q) by lia.
    (* a times x·b, and b times y·a *)
    pose proof (means (repeat (x * q) a ++ repeat (y * p) b ++ [])) as M.
    rewrite !app_length, !repeat_length, app_nil_r in M; cbn [length] in M.
    assert (HM : forall z, In z (repeat (x * q) a ++ repeat (y * p) b) -> 0 <= z).
    { intros z I; apply in_app_iff in I; destruct I as [I|I]; apply repeat_spec in I; subst; nia. }
    specialize (M HM); rewrite <- (app_nil_r (repeat (y * p) b)) in M.
    rewrite !sum_repeat, !product_repeat in M; cbn [sum product fold_right] in M.
    rewrite Nat.add_0_r in M; fold p q in M.
    replace (p * (x * q) + (q * (y * p) + 0)) with ((p * q) * (x + y)) in M by ring.
    rewrite !pow_mul, !(pow_add p), !(pow_add q) in M.
    set (pa := pow p a) in *; set (pb := pow p b) in *; set (qa := pow q a) in *; set (qb :=
      pow q b) in *.
    set (xa := pow x a) in *; set (yb := pow y b) in *; set (s := pow (x + y) (a + b)) in *.
    set (n := pow (Z.of_nat (a + b)) (a + b)) in *.
    assert (0 < qa) by (apply pow_pos; auto); assert (0 < pb) by (apply pow_pos; auto).
    apply Z.mul_le_mono_pos_l with (qa * pb); [nia|].
    replace (qa * pb * (n * (xa * yb))) with (n * (xa * qa * (yb * pb * 1))) by ring.
    replace (qa * pb * (s * (pa * qb))) with (pa * pb * (qa * qb) * s) by ring; exact M.
Qed.

(** How often a symbol occurs, and its frequency in the table. *)
Definition occurs (l : list (nat * Z)) : nat := fold_right (fun e t => (fst e + t)%nat) 0%nat l.
Definition whole (l : list (nat * Z)) : Z := fold_right (fun e t => snd e + t) 0 l.
Definition in_table (l : list (nat * Z)) : Z := fold_right (fun e t => pow (snd e) (fst e) * t) 1 l.
Definition in_own (l : list (nat * Z)) : Z :=
  fold_right (fun e t => pow (Z.of_nat (fst e)) (fst e) * t) 1 l.

(** Gibbs: Π (f_i/M)^(n_i) ≤ Π (n_i/n)^(n_i). *)
Theorem own_frequencies_cost_least : forall l, (forall n f, In (n, f) l -> 0 <= f) ->
  pow (Z.of_nat (occurs l)) (occurs l) * in_table l <= pow (whole l) (occurs l) * in_own l.
Proof.
  assert (W : forall l, (forall n f, In (n, f) l -> 0 <= f) ->
    0 <= whole l /\ 0 <= in_table l /\ 0 < in_own l
    /\ (whole l = 0 -> occurs l <> 0%nat -> in_table l = 0)).
  { induction l as [|[n f] l IH]; intros H; [cbn; repeat split; try lia; congruence|].
    assert (F : 0 <= f) by (apply (H n f); left; auto).
    destruct IH as (A & B & C & D); [intros; apply (H n0 f0); right; auto|].
    cbn [whole in_table in_own occurs fold_right fst snd].
    fold (whole l) (in_table l) (in_own l) (occurs l).
    assert (0 <= pow f n) by (apply pow_nonneg; auto).
    assert (0 < pow (Z.of_nat n) n) by (destruct n; [cbn; lia|apply pow_pos; lia]).
    repeat split; try nia; intros E N; destruct n as [|n].
    - rewrite D; [lia|lia|exact N].
    - assert (f = 0) as -> by lia; cbn [pow]; lia. }
  induction l as [|[n f] l IH]; intros H; [cbn; lia|].
  assert (F : 0 <= f) by (apply (H n f); left; auto).
  assert (HL : forall m g, In (m, g) l -> 0 <= g) by (intros; apply (H m g); right; auto).
  specialize (IH HL); destruct (W l HL) as (W1 & W2 & W3 & W4).
  cbn [whole in_table in_own occurs fold_right fst snd].
  fold (whole l) (in_table l) (in_own l) (occurs l).
  pose proof (two_symbols n (occurs l) f (whole l) F W1) as T.
  set (m := occurs l) in *; set (M := whole l) in *; set (t := in_table l) in *; set (o :=
    in_own l) in *.
  set (N := pow (Z.of_nat (n + m)) (n + m)) in *; set (S := pow (f + M) (n + m)) in *.
  set (fn := pow f n) in *; set (nn := pow (Z.of_nat n) n) in *.
  set (mm := pow (Z.of_nat m) m) in *; set (Mm := pow M m) in *.
  assert (0 <= fn) by (apply pow_nonneg; auto); assert (0 <= N) by (apply pow_nonneg; lia).
  assert (0 <= S) by (apply pow_nonneg; lia); assert (0 <= nn) by (apply pow_nonneg; lia).
  assert (MM : 0 < mm) by (unfold mm; destruct m; [cbn; lia|apply pow_pos; lia]).
  destruct (Z.eq_dec M 0) as [Z|Z].
  - destruct (Nat.eq_dec m 0) as [E|E].
    + unfold mm, Mm in *; rewrite E in *; cbn [pow] in *; rewrite !Z.mul_1_l, ?Z.mul_1_r in *.
      assert (N * fn * t <= S * nn * t) by (apply Z.mul_le_mono_nonneg_r; auto).
      assert (S * nn * t <= S * nn * o) by (apply Z.mul_le_mono_nonneg_l; nia); lia.
    + rewrite (W4 Z E); assert (0 <= S * (nn * o)) by nia; lia.
  - assert (Mp : 0 < Mm) by (apply pow_pos; lia).
    apply Z.mul_le_mono_pos_l with (mm * Mm); [nia|].
    assert (A : (N * (fn * Mm)) * (mm * t) <= (S * (nn * mm)) * (Mm * o)).
    { apply Z.mul_le_mono_nonneg; auto; [|nia]; apply Z.mul_nonneg_nonneg; nia. }
    replace (mm * Mm * (N * (fn * t))) with ((N * (fn * Mm)) * (mm * t)) by ring.
    replace (mm * Mm * (S * (nn * o))) with ((S * (nn * mm)) * (Mm * o)) by ring; exact A.
Qed.
