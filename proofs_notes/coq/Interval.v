(** The interval of the 32-bit arithmetic coder: spec/02-arithmetic.md, section 2.3.

    Proved here, for every settled state and every slot of a table of total at most 2^30:
    - a settled state is at least 2^30 + 2 wide, and one is no wider     (ARITH-STATE-2)
    - narrowing partitions the state, and no part is empty               (ARITH-NARROW-2)
    - 32 shifts are enough to settle                                     (ARITH-SHIFT-1)
    - no state leaves its range                                          (ARITH-STATE-1)
    - the search finds the slot that the value points into               (ARITH-DECODE-2)

    The state is kept with its base (ARITH-CARRY-1): where it lies among all numbers. Which bits are
    sent for it is the matter of Integer_encoder.v. *)
Require Import ZArith List Lia Bool.
From Clers Require Import Model.
Import ListNotations.
Open Scope Z_scope.

Notation half := (2 * quarter).

(** ** States *)

Definition within (lo hi : Z) : Prop := 0 <= lo <= hi /\ hi <= 4 * quarter - 1.

Definition settled (lo hi : Z) : Prop :=
  within lo hi /\ lo < half <= hi /\ ~ (quarter <= lo /\ hi < 3 * quarter).

(** ARITH-STATE-2: a settled state is at least Q + 2 wide. *)
Theorem settled_is_wide : forall lo hi, settled lo hi -> quarter + 2 <= hi - lo + 1.
Proof. unfold settled, within; lia. Qed.

(** ARITH-STATE-2: the bound is sharp. *)
Theorem settled_is_no_wider :
  settled (quarter - 1) half /\ half - (quarter - 1) + 1 = quarter + 2.
Proof. pose proof quarter_pos; unfold settled, within; lia. Qed.

(** ** Narrowing *)

(** ARITH-NARROW-1. *)
Definition narrow (s : slot) (lo hi : Z) : Z * Z :=
  let w := hi - lo + 1 in (lo + w * below s / whole s, lo + w * upto s / whole s - 1).

(** Where the part of a table of total t begins whose cumulative frequency is c. *)
Definition beginning (lo hi t c : Z) : Z := lo + (hi - lo + 1) * c / t.

Lemma narrow_by_beginnings : forall s lo hi,
  narrow s lo hi = (beginning lo hi (whole s) (below s), beginning lo hi (whole s) (upto s) - 1).
Proof. reflexivity. Qed.

(** ARITH-NARROW-2: the parts begin at the lower end, each after the one before by at least one
    number for each unit of frequency, and end at the upper end. So they are not empty, and
    partition the state. *)
Theorem narrowing_partitions : forall lo hi t, settled lo hi -> 1 <= t <= quarter ->
  beginning lo hi t 0 = lo /\ beginning lo hi t t = hi + 1 /\
  forall c d, 0 <= c <= d -> beginning lo hi t c + (d - c) <= beginning lo hi t d.
Proof.
  intros lo hi t S T; apply settled_is_wide in S; unfold beginning.
  set (w := hi - lo + 1) in *; repeat split.
  - rewrite Z.mul_0_r, Z.div_0_l; lia.
  - rewrite Z.div_mul; lia.
  - intros c d C. assert (w * c / t + (d - c) <= w * d / t); [|lia].
    rewrite <- Z.div_add by lia. apply Z.div_le_mono; nia.
Qed.

Lemma narrow_inside : forall s lo hi l h, settled lo hi -> valid s -> narrow s lo hi = (l, h) ->
  lo <= l <= h /\ h <= hi.
Proof.
  intros s lo hi l h S V N; rewrite narrow_by_beginnings in N; injection N as <- <-.
  destruct V as [[B U] [W T]]; destruct (narrowing_partitions lo hi (whole s) S) as (A & Z & M);
    [lia|].
  pose proof (M 0 (below s)); pose proof (M (below s) (upto s)); pose proof (M (upto s) (whole s));
    lia.
Qed.

(** ** The search *)

(** ARITH-DECODE-2. *)
Definition target (t lo hi value : Z) : Z := ((value - lo + 1) * t - 1) / (hi - lo + 1).

(** ARITH-DECODE-2: what is found lies in a slot exactly if the value lies in the slot's part. *)
Theorem search_finds : forall s lo hi value, lo <= value <= hi -> 1 <= whole s ->
  let (l, h) := narrow s lo hi in
  l <= value <= h <-> below s <= target (whole s) lo hi value < upto s.
Proof.
  intros s lo hi v V T; unfold narrow, target.
  set (w := hi - lo + 1) in *; set (t := whole s) in *.
  assert (W : 0 < w) by lia.
  assert (E : forall c, lo + w * c / t <= v <-> c <= ((v - lo + 1) * t - 1) / w).
  { intros c; split; intros H.
    - apply Z.div_le_lower_bound; [lia|].
      pose proof (Z.mul_succ_div_gt (w * c) t); nia.
    - assert (w * c / t < v - lo + 1); [|lia].
      apply Z.div_lt_upper_bound; [lia|].
      pose proof (Z.mul_div_le ((v - lo + 1) * t - 1) w); nia. }
  pose proof (E (below s)); pose proof (E (upto s)); lia.
Qed.

(** The target is a number below the total, so that some slot has it. *)
Lemma target_in_table : forall t lo hi value, lo <= value <= hi -> 1 <= t ->
  0 <= target t lo hi value < t.
Proof.
  intros t lo hi v V T; unfold target; split.
  - apply Z.div_pos; nia.
  - apply Z.div_lt_upper_bound; nia.
Qed.

(** ** Shifting *)

(** ARITH-SHIFT-1: what a shift takes away; nothing if the state is settled. *)
Definition away (lo hi : Z) : option Z :=
  if hi <? half then Some 0
  else if half <=? lo then Some half
  else if (quarter <=? lo) && (hi <? 3 * quarter) then Some quarter
  else None.

(** A split of all cases of [away]. *)
Ltac cases_of_away :=
  unfold away;
  repeat match goal with |- context [if ?c then _ else _] => destruct c eqn:? end;
  repeat match goal with
  | H : (_ && _) = true |- _ => apply andb_true_iff in H as []
  | H : (_ && _) = false |- _ => apply andb_false_iff in H
  end;
  rewrite ?Z.ltb_lt, ?Z.ltb_ge, ?Z.leb_le, ?Z.leb_gt in *.

Lemma away_none : forall lo hi, within lo hi -> away lo hi = None <-> settled lo hi.
Proof. intros lo hi; cases_of_away; unfold settled, within; split; intros; try discriminate;
  try reflexivity; lia || (exfalso; lia). Qed.

Lemma away_some : forall lo hi o, within lo hi -> away lo hi = Some o ->
  (o = 0 \/ o = quarter \/ o = half) /\ within (2 * (lo - o)) (2 * (hi - o) + 1).
Proof.
  assert (I : forall a b : Z, Some a = Some b -> b = a) by congruence.
  intros lo hi o W; cases_of_away; intros E; try discriminate E; apply I in E; subst o;
    pose proof quarter_pos; unfold within in *; lia.
Qed.

(** ** Places: a state, with the base and the number of shifts of ARITH-CARRY-1 *)

Record place := Place { base : Z; shifts : nat; low : Z; high : Z }.

Definition start : place := Place 0 0 0 (4 * quarter - 1).

Fixpoint settle (fuel : nat) (p : place) : place :=
  match fuel with
  | O => p
  | S f => match away (low p) (high p) with
           | None => p
           | Some o => settle f (Place (2 * (base p + o)) (S (shifts p))
                                       (2 * (low p - o)) (2 * (high p - o) + 1))
           end
  end.

(** One symbol: narrow, and shift. 32 shifts are enough: [shifting_settles]. *)
Definition most_shifts : nat := 32.

Definition step (p : place) (s : slot) : place :=
  let (l, h) := narrow s (low p) (high p) in settle most_shifts (Place (base p) (shifts p) l h).

Notation run := (fold_left step).

(** Said for any function, so that Coq does not try to unfold [step] to see it. *)
Lemma fold_left_cons : forall (f : place -> slot -> place) s ss p,
  fold_left f (s :: ss) p = fold_left f ss (f p s).
Proof. reflexivity. Qed.

Definition at_rest (p : place) : Prop := settled (low p) (high p).

Lemma start_at_rest : at_rest start.
Proof. pose proof quarter_pos; unfold at_rest, settled, within; cbn [start low high]; lia. Qed.

Lemma settle_from_width : forall f p, within (low p) (high p) ->
  4 * quarter <= 2 ^ Z.of_nat f * (high p - low p + 1) -> at_rest (settle f p).
Proof.
  pose proof quarter_pos.
  induction f as [|f IH]; intros p H0 W; cbn [settle].
  - change (2 ^ Z.of_nat 0) with 1 in W; unfold at_rest, settled, within in *; lia.
  - rewrite Nat2Z.inj_succ, Z.pow_succ_r in W by lia.
    destruct (away (low p) (high p)) as [o|] eqn:A; [|apply away_none in A; assumption].
    apply away_some in A as [_ A]; [|assumption]; apply IH; cbn [low high]; [exact A|nia].
Qed.

(** ARITH-SHIFT-1: after 32 shifts at most, any state is settled; it never leaves its range. *)
Theorem shifting_settles : forall p, within (low p) (high p) -> at_rest (settle most_shifts p).
Proof.
  intros p W; apply settle_from_width; [exact W|].
  replace (2 ^ Z.of_nat most_shifts) with (4 * quarter) by (rewrite quarter_is; reflexivity).
  pose proof quarter_pos; unfold within in W; nia.
Qed.

(** ARITH-STATE-2: before each symbol the state is settled. *)
Theorem step_settles : forall p s, at_rest p -> valid s -> at_rest (step p s).
Proof.
  intros p s R V; unfold step; destruct (narrow s (low p) (high p)) as [l h] eqn:N.
  apply narrow_inside in N; try assumption.
  apply shifting_settles; cbn [low high]; unfold at_rest, settled, within in *; lia.
Qed.

Theorem run_settles : forall ss p, at_rest p -> Forall valid ss -> at_rest (run ss p).
Proof.
  induction ss as [|s ss IH]; intros p R V; [exact R|].
  inversion_clear V; rewrite fold_left_cons; apply IH; [apply step_settles|]; assumption.
Qed.

Lemma settle_shifts : forall f p, (shifts p <= shifts (settle f p) <= shifts p + f)%nat.
Proof.
  induction f as [|f IH]; intros p; cbn [settle]; [lia|].
  destruct (away _ _) as [o|]; [|lia].
  match goal with |- context [settle f ?x] => specialize (IH x) end; cbn [shifts] in IH; lia.
Qed.

(** ARITH-SHIFT-1: one symbol shifts at most 32 times. *)
Theorem step_shifts : forall p s, (shifts p <= shifts (step p s) <= shifts p + 32)%nat.
Proof.
  intros p s; unfold step; destruct (narrow s (low p) (high p)) as [l h].
  pose proof (settle_shifts most_shifts (Place (base p) (shifts p) l h)) as H; cbn [shifts] in H.
  unfold most_shifts in *; lia.
Qed.

Lemma run_shifts : forall ss p,
  (shifts p <= shifts (run ss p) <= shifts p + 32 * length ss)%nat.
Proof.
  induction ss as [|s ss IH]; intros p; [cbn; lia|]; rewrite fold_left_cons; cbn [length].
  pose proof (step_shifts p s); specialize (IH (step p s)); lia.
Qed.
