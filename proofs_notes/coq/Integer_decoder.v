(** The state of the decoder of the 32-bit arithmetic coder: spec/02-arithmetic.md, section 2.4.

    A decoder keeps a value in place of a base, and reads a bit with each shift. Proved here, for any
    bits and any slots (ARITH-DECODE-2):
    - the value is what the bits read so far write, less the base
    - shifts lose nothing: the value lies in a state exactly if it did before them
    - a step is that of the symbol meant exactly if the search finds its slot *)
Require Import ZArith List Lia Bool.
From Clers Require Import Bits Model Interval Integer_encoder.
Import ListNotations.
Open Scope Z_scope.

(** What a decoder keeps: the state, the value, the bits not yet read, and the number of shifts. *)
Record receiver := Receiver { rlow : Z; rhigh : Z; seen_value : Z; rest : list bool; taken : Z }.

(** The next bit, 0 where they are used up, and what is left. ARITH-DECODE-1. *)
Definition next_bit (l : list bool) : Z * list bool :=
  match l with [] => (0, []) | b :: k => (bit b, k) end.

Fixpoint first_bits (n : nat) (v : Z) (l : list bool) : Z * list bool :=
  match n with
  | O => (v, l)
  | S k => let (b, r) := next_bit l in first_bits k (2 * v + b) r
  end.

Definition receiver0 (l : list bool) : receiver :=
  let (v, r) := first_bits 32 0 l in Receiver 0 (4 * quarter - 1) v r 0.

(** Shifts, each reading a bit. ARITH-DECODE-2. *)
Fixpoint receive_all (fuel : nat) (x : receiver) : receiver :=
  match fuel with
  | O => x
  | S f => match away (rlow x) (rhigh x) with
           | None => x
           | Some o =>
               let (b, r) := next_bit (rest x) in
               receive_all f (Receiver (2 * (rlow x - o)) (2 * (rhigh x - o) + 1)
                                       (2 * (seen_value x - o) + b) r (taken x + 1))
           end
  end.

Definition receive (x : receiver) (s : slot) : receiver :=
  let (l, h) := narrow s (rlow x) (rhigh x) in
  receive_all most_shifts (Receiver l h (seen_value x) (rest x) (taken x)).

(** ** The decoder follows the place *)

(** Receiver and place are at the same point of these bits. *)
Definition follows (l : list bool) (x : receiver) (p : place) : Prop :=
  rlow x = low p /\ rhigh x = high p /\ seen_value x = seen l p /\
  rest x = skipn (shifts p + 32) l /\ taken x = Z.of_nat (shifts p).

Definition holds (l : list bool) (p : place) : Prop := low p <= seen l p <= high p.

Lemma next_bit_of_skipn : forall n l,
  next_bit (skipn n l) = (bit (nth n l false), skipn (S n) l).
Proof.
  induction n as [|n IH]; intros [|b l]; try reflexivity; cbn [skipn nth]; apply IH.
Qed.

Lemma first_bits_are : forall n k l,
  first_bits n (first k l) (skipn k l) = (first (k + n) l, skipn (k + n) l).
Proof.
  induction n as [|n IH]; intros k l; cbn [first_bits]; [rewrite Nat.add_0_r; reflexivity|].
  rewrite next_bit_of_skipn; change (2 * first k l + bit (nth k l false)) with (first (S k) l).
  rewrite IH; replace (S k + n)%nat with (k + S n)%nat by lia; reflexivity.
Qed.

Lemma receiver0_follows : forall l, follows l (receiver0 l) start.
Proof.
  intros l; unfold receiver0; pose proof (first_bits_are 32 0 l) as F.
  change (first 0 l) with 0 in F; change (skipn 0 l) with l in F.
  rewrite Nat.add_0_l in F; rewrite F; unfold follows, seen.
  cbn [rlow rhigh seen_value rest taken start low high shifts base].
  rewrite Nat.add_0_l, Z.sub_0_r; auto.
Qed.

Lemma receive_all_follows : forall l f x p, follows l x p ->
  follows l (receive_all f x) (settle f p).
Proof.
  induction f as [|f IH]; intros x p F; cbn [receive_all settle]; [exact F|].
  pose proof F as (L & H & V & R & T); rewrite L, H.
  destruct (away (low p) (high p)) as [o|]; [|exact F].
  rewrite R, next_bit_of_skipn; apply IH; unfold follows, seen in *.
  cbn [rlow rhigh seen_value rest taken low high shifts base].
  cbn [Nat.add first]; repeat split; try assumption; lia.
Qed.

Lemma receive_follows : forall l x p s, follows l x p -> follows l (receive x s) (step p s).
Proof.
  intros l x p s F; pose proof F as (L & H & V & R & T); unfold receive, step; rewrite L, H.
  destruct (narrow s (low p) (high p)) as [lo hi]; apply receive_all_follows.
  unfold follows, seen in *; cbn [rlow rhigh seen_value rest taken low high shifts base]; auto.
Qed.

(** Shifts lose nothing: a place holds what is seen exactly if it did before them. *)
Lemma settle_holds : forall l f p, holds l (settle f p) <-> holds l p.
Proof.
  induction f as [|f IH]; intros p; cbn [settle]; [tauto|].
  destruct (away (low p) (high p)) as [o|]; [|tauto].
  rewrite IH; unfold holds, seen; cbn [low high shifts base]; cbn [Nat.add].
  pose proof (first_step (shifts p + 32) l); lia.
Qed.

(** The step of a symbol holds what is seen exactly if the search finds its slot. ARITH-DECODE-2. *)
Lemma step_holds : forall l p s, holds l p -> valid s ->
  holds l (step p s) <->
  below s <= target (whole s) (low p) (high p) (seen l p) < upto s.
Proof.
  intros l p s H V; pose proof (search_finds s (low p) (high p) (seen l p) H) as F.
  unfold step; destruct (narrow s (low p) (high p)) as [lo hi].
  rewrite settle_holds; unfold holds, seen in *; cbn [low high shifts base].
  apply F; unfold valid in V; lia.
Qed.

Lemma holds_back : forall l p s, at_rest p -> valid s -> holds l (step p s) -> holds l p.
Proof.
  intros l p s R V; unfold step; destruct (narrow s (low p) (high p)) as [lo hi] eqn:N.
  apply narrow_inside in N; try assumption.
  rewrite settle_holds; unfold holds, seen; cbn [low high shifts base]; lia.
Qed.

Lemma run_holds_back : forall l ss p, at_rest p -> Forall valid ss ->
  holds l (run ss p) -> holds l p.
Proof.
  induction ss as [|s ss IH]; intros p R V H; [exact H|].
  inversion_clear V; rewrite fold_left_cons in H; apply IH in H; try apply step_settles;
    try assumption.
  eapply holds_back; eassumption.
Qed.

Lemma start_holds : forall l, holds l start.
Proof.
  intros l; unfold holds, seen; cbn [start low high shifts base]; rewrite Nat.add_0_l, Z.sub_0_r.
  rewrite <- first_firstn.
  assert (G : forall n k, 0 <= first n k <= power n - 1).
  { induction n as [|n IH]; intros k; [change (power 0) with 1; cbn; lia|].
    cbn [first]; rewrite power_S; specialize (IH k); destruct (nth n k false); cbn [bit]; lia. }
  specialize (G 32%nat (firstn 32 l)).
  replace (power 32) with (4 * quarter) in G by (rewrite quarter_is; reflexivity); exact G.
Qed.
