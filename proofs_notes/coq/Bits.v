(** Strings of bits and the numbers that they write: spec/02-arithmetic.md, section 2.1.

    Nothing here is about coders. A string of bits, the most significant first, has a value; the
    first n bits of a string with zeros after it are a number too. The facts are those that the
    coders need: what more bits do to the value, and that the value and the length say it all. *)
Require Import ZArith List Lia Bool.
Import ListNotations.
Open Scope Z_scope.

Definition bit (b : bool) : Z := if b then 1 else 0.
Definition value (l : list bool) : Z := fold_left (fun a b => 2 * a + bit b) l 0.
Definition power (n : nat) : Z := 2 ^ Z.of_nat n.

Lemma power_S : forall n, power (S n) = 2 * power n.
Proof. intros; unfold power; rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia; reflexivity. Qed.

Lemma power_pos : forall n, 1 <= power n.
Proof. induction n; [unfold power; cbn; lia|rewrite power_S; lia]. Qed.

Lemma power_add : forall n k, power (n + k) = power n * power k.
Proof. intros; unfold power; rewrite Nat2Z.inj_add, Z.pow_add_r by lia; reflexivity. Qed.

Lemma value_snoc : forall l b, value (l ++ [b]) = 2 * value l + bit b.
Proof. intros; unfold value; rewrite fold_left_app; reflexivity. Qed.

Lemma value_range : forall l, 0 <= value l < power (length l).
Proof.
  induction l as [|b l IH] using rev_ind; [change (power (length [])) with 1; cbn; lia|].
  rewrite value_snoc, app_length, Nat.add_1_r, power_S; destruct b; cbn [bit]; lia.
Qed.

(** Bits are known by their number and their value. *)
Lemma value_injective : forall l k, length l = length k -> value l = value k -> l = k.
Proof.
  induction l as [|b l IH] using rev_ind; intros k L V.
  - destruct k; [reflexivity|discriminate].
  - destruct k as [|c k _] using rev_ind; [rewrite app_length, Nat.add_1_r in L; discriminate|].
    rewrite !app_length, !Nat.add_1_r in L; rewrite !value_snoc in V; f_equal.
    + apply IH; [lia|destruct b, c; cbn [bit] in V; lia].
    + f_equal; destruct b, c; cbn [bit] in V; auto; lia.
Qed.

Lemma value_repeat : forall b n l,
  value (l ++ repeat b n) = power n * value l + bit b * (power n - 1).
Proof.
  intros b; induction n as [|n IH]; intros l; cbn [repeat].
  - rewrite app_nil_r; change (power 0) with 1; lia.
  - change (b :: repeat b n) with ([b] ++ repeat b n).
    rewrite app_assoc, IH, value_snoc, power_S; nia.
Qed.

Lemma value_app : forall k l, value (l ++ k) = power (length k) * value l + value k.
Proof.
  induction k as [|b k IH] using rev_ind; intros l.
  - rewrite app_nil_r; change (power (length [])) with 1; cbn [value fold_left]; lia.
  - rewrite app_assoc, !value_snoc, IH, app_length, Nat.add_1_r, power_S; lia.
Qed.

(** ** The first n bits of a string with zeros after it. ARITH-DECODE-1. *)
Fixpoint first (n : nat) (l : list bool) : Z :=
  match n with O => 0 | S k => 2 * first k l + bit (nth k l false) end.

Lemma first_step : forall n l, 2 * first n l <= first (S n) l <= 2 * first n l + 1.
Proof. intros; cbn [first]; destruct (nth n l false); cbn [bit]; lia. Qed.

Lemma first_of_app : forall l k, first (length l) (l ++ k) = value l.
Proof.
  induction l as [|b l IH] using rev_ind; intros k; [reflexivity|].
  rewrite app_length, Nat.add_1_r; cbn [first]; rewrite value_snoc, <- app_assoc, (IH ([b] ++ k)).
  rewrite app_nth2, Nat.sub_diag by lia; reflexivity.
Qed.

(** Bits that follow add less than one unit of the last bit before them. *)
Lemma first_after : forall l k n,
  power n * value l <= first (n + length l) (l ++ k) <= power n * value l + power n - 1.
Proof.
  intros l k; induction n as [|n IH].
  - rewrite Nat.add_0_l, first_of_app; change (power 0) with 1; lia.
  - cbn [Nat.add first]; rewrite power_S; destruct (nth _ _ _); cbn [bit]; lia.
Qed.

(** If nothing follows, zeros do. *)
Lemma first_beyond : forall l n, first (n + length l) l = power n * value l.
Proof.
  intros l; induction n as [|n IH].
  - pose proof (first_of_app l []) as E; rewrite app_nil_r in E; rewrite Nat.add_0_l, E.
    change (power 0) with 1; lia.
  - cbn [Nat.add first]; rewrite IH, power_S, nth_overflow by lia; cbn [bit]; lia.
Qed.

(** The first bits of a string are those of what it starts with. *)
Lemma first_firstn : forall n l, first n (firstn n l) = first n l.
Proof.
  intros n l; assert (H : forall k, (k <= n)%nat -> first k (firstn n l) = first k l); [|apply H;
    lia].
  induction k as [|k IH]; intros K; [reflexivity|].
  cbn [first]; rewrite IH by lia; f_equal; f_equal.
  clear IH; revert k l K; induction n as [|n IHn]; intros k l K; [lia|].
  destruct l as [|b l]; [reflexivity|]; destruct k as [|k]; [reflexivity|]; cbn; apply IHn; lia.
Qed.
