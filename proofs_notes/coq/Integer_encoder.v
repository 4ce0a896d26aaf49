(** The encoder of the 32-bit arithmetic coder: spec/02-arithmetic.md, sections 2.3 and 2.5.

    The encoder sends bits, and counts those that it cannot send yet. Proved here:
    - bits sent and pending write the base of the state: its carry          (ARITH-CARRY-1)
    - the code is the digits of one number                                  (ARITH-CARRY-1)
    - there are N + 2 of them for N shifts                                  (ARITH-END-1)
    - whatever bits follow the code, they name a number in the last state   (ARITH-END-2)
    - the length lies between two bounds by the probability (ARITH-LENGTH-1, ARITH-LENGTH-2) *)
Require Import ZArith List Lia Bool.
From Clers Require Import Bits Model Interval Interval_length.
Import ListNotations.
Open Scope Z_scope.

(** [sent] has the last bit first. *)
Record sender := Sender { sent : list bool; pending : nat; slow : Z; shigh : Z }.

(** A bit, and then as many of the opposite. ARITH-SHIFT-2. *)
Definition put (b : bool) (n : nat) (l : list bool) : list bool := repeat (negb b) n ++ b :: l.

(** One shift that takes o away. ARITH-SHIFT-2. *)
Definition send (o : Z) (x : sender) : sender :=
  let l := 2 * (slow x - o) in
  let h := 2 * (shigh x - o) + 1 in
  if o =? 0 then Sender (put false (pending x) (sent x)) 0 l h
  else if o =? quarter then Sender (sent x) (S (pending x)) l h
  else Sender (put true (pending x) (sent x)) 0 l h.

Fixpoint send_all (fuel : nat) (x : sender) : sender :=
  match fuel with
  | O => x
  | S f => match away (slow x) (shigh x) with
           | None => x
           | Some o => send_all f (send o x)
           end
  end.

Definition send_slot (x : sender) (s : slot) : sender :=
  let (l, h) := narrow s (slow x) (shigh x) in
  send_all most_shifts (Sender (sent x) (pending x) l h).

(** ARITH-END-1. *)
Definition finish (x : sender) : list bool :=
  rev (put (quarter <=? slow x) (S (pending x)) (sent x)).

Definition sender0 : sender := Sender [] 0 0 (4 * quarter - 1).

(** The bits of a message, by its slots. ARITH-ENCODE-1. *)
Definition code (ss : list slot) : list bool := finish (fold_left send_slot ss sender0).

(** ** Pending bits are the carry *)

Lemma rev_repeat : forall (b : bool) n, rev (repeat b n) = repeat b n.
Proof.
  intros b; induction n as [|n IH]; [reflexivity|].
  cbn [repeat rev]; rewrite IH; symmetry; apply repeat_cons.
Qed.

Lemma rev_put : forall b n l, rev (put b n l) = (rev l ++ [b]) ++ repeat (negb b) n.
Proof. intros; unfold put; rewrite rev_app_distr, rev_repeat; reflexivity. Qed.

Lemma value_put : forall b n l,
  value (rev (put b n l)) = 2 * power n * value (rev l) + (if b then power n else power n - 1).
Proof. intros b n l; rewrite rev_put, value_repeat, value_snoc; destruct b; cbn [negb bit];
  nia. Qed.

Lemma length_put : forall b n l, length (put b n l) = (length l + S n)%nat.
Proof. intros; unfold put; rewrite app_length, repeat_length; cbn [length]; lia. Qed.

(** Sender and place are at the same point, and what is sent and pending writes the base. *)
Definition prints (x : sender) (p : place) : Prop :=
  low p = slow x /\ high p = shigh x /\ shifts p = (length (sent x) + pending x)%nat /\
  base p = 4 * quarter * power (pending x) * value (rev (sent x))
           + 2 * quarter * (power (pending x) - 1).

Lemma prints_start : prints sender0 start.
Proof. repeat split; cbn [start sender0 base pending sent]; change (power 0) with 1; cbn; lia. Qed.

Lemma send_all_prints : forall f x p, within (low p) (high p) -> prints x p ->
  prints (send_all f x) (settle f p).
Proof.
  pose proof quarter_pos as Q.
  induction f as [|f IH]; intros x p W P; cbn [send_all settle]; [exact P|].
  pose proof P as (L & H & N & B); rewrite L, H in *.
  destruct (away (slow x) (shigh x)) as [o|] eqn:A; [|exact P].
  apply away_some in A as [O A]; [|exact W].
  apply IH; [exact A|]; clear IH P; unfold prints, send; cbn [low high shifts base].
  destruct O as [->|[->| ->]].
  - rewrite Z.eqb_refl; cbn [slow shigh sent pending]; rewrite length_put, value_put.
    change (power 0) with 1; repeat split; try lia; nia.
  - rewrite (proj2 (Z.eqb_neq quarter 0)), Z.eqb_refl by lia; cbn [slow shigh sent pending].
    rewrite power_S; repeat split; try lia; nia.
  - rewrite (proj2 (Z.eqb_neq half 0)), (proj2 (Z.eqb_neq half quarter)) by lia.
    cbn [slow shigh sent pending]; rewrite length_put, value_put.
    change (power 0) with 1; repeat split; try lia; nia.
Qed.

Lemma send_slot_prints : forall x p s, at_rest p -> valid s -> prints x p ->
  prints (send_slot x s) (step p s).
Proof.
  intros x p s R V P; pose proof P as (L & H & N & B); unfold send_slot, step; rewrite <- L, <- H.
  destruct (narrow s (low p) (high p)) as [l h] eqn:E; apply narrow_inside in E; try assumption.
  apply send_all_prints; [|repeat split; assumption].
  cbn [low high]; unfold at_rest, settled, within in *; lia.
Qed.

Lemma fold_send_cons : forall (f : sender -> slot -> sender) s ss x,
  fold_left f (s :: ss) x = fold_left f ss (f x s).
Proof. reflexivity. Qed.

Lemma send_prints : forall ss x p, at_rest p -> Forall valid ss -> prints x p ->
  prints (fold_left send_slot ss x) (run ss p).
Proof.
  induction ss as [|s ss IH]; intros x p R V P; [exact P|].
  inversion_clear V; rewrite fold_send_cons, fold_left_cons; apply IH;
    [apply step_settles|assumption|apply send_slot_prints]; assumption.
Qed.

(** ** What the code is *)

(** The q of ARITH-CARRY-1. *)
Definition ending (p : place) : Z := if low p <? quarter then quarter else half.

(** ARITH-END-1: the length is the number of shifts plus 2. *)
Theorem code_length : forall ss, Forall valid ss ->
  length (code ss) = (shifts (run ss start) + 2)%nat.
Proof.
  intros ss V; destruct (send_prints ss _ _ start_at_rest V prints_start) as (_ & _ & N & _).
  unfold code, finish; rewrite rev_length, length_put, N; lia.
Qed.

(** ARITH-END-1: the empty message is 01. *)
Theorem code_of_nothing : code [] = [false; true].
Proof.
  unfold code, finish; cbn [fold_left sender0 slow pending sent].
  rewrite (proj2 (Z.leb_gt quarter 0)) by (pose proof quarter_pos; lia); reflexivity.
Qed.

Lemma code_times_quarter : forall ss, Forall valid ss ->
  quarter * value (code ss) = base (run ss start) + ending (run ss start).
Proof.
  intros ss V; pose proof quarter_pos.
  destruct (send_prints ss _ _ start_at_rest V prints_start) as (L & _ & _ & B).
  unfold code, finish, ending; rewrite value_put, L, B, power_S.
  destruct (quarter <=? _) eqn:E; [apply Z.leb_le in E|apply Z.leb_gt in E].
  - rewrite (proj2 (Z.ltb_ge _ _) E); lia.
  - rewrite (proj2 (Z.ltb_lt _ _) E); lia.
Qed.

(** ARITH-CARRY-1: the code is the digits of one number, and pending bits its carry. *)
Theorem code_is_the_carried_sum : forall ss, Forall valid ss ->
  value (code ss) = (base (run ss start) + ending (run ss start)) / quarter.
Proof.
  intros ss V; pose proof quarter_pos; rewrite <- code_times_quarter by exact V.
  rewrite Z.mul_comm, Z.div_mul; lia.
Qed.

(** The quarter that the last bits name lies in the state. *)
Lemma ending_inside : forall p, at_rest p -> low p <= ending p /\ ending p + quarter - 1 <= high p.
Proof.
  intros p R; unfold at_rest, settled, within, ending in *.
  destruct (low p <? quarter) eqn:E; rewrite ?Z.ltb_lt, ?Z.ltb_ge in E; lia.
Qed.

(** The value that a decoder has at a place, when it reads these bits. ARITH-DECODE-1. *)
Definition seen (l : list bool) (p : place) : Z := first (shifts p + 32) l - base p.

Lemma seen_of_code : forall ss rest p, Forall valid ss -> p = run ss start ->
  ending p <= seen (code ss ++ rest) p <= ending p + quarter - 1.
Proof.
  intros ss rest p V P; pose proof (first_after (code ss) rest 30) as U.
  replace (power 30) with quarter in U by (rewrite quarter_is; reflexivity).
  rewrite code_length, code_times_quarter, <- P in U by exact V.
  unfold seen; replace (shifts p + 32)%nat with (30 + (shifts p + 2))%nat by lia; lia.
Qed.

(** ARITH-END-2: whatever follows the code, what is seen at its end lies in the last state. *)
Theorem code_points_inside : forall ss rest p, Forall valid ss -> p = run ss start ->
  low p <= seen (code ss ++ rest) p <= high p.
Proof.
  intros ss rest p V P; pose proof (seen_of_code ss rest p V P) as S.
  pose proof (run_settles ss start start_at_rest V) as R; rewrite <- P in R.
  apply ending_inside in R; lia.
Qed.

Lemma quarters_of_ending : forall p, ending p / quarter * quarter = ending p.
Proof.
  intros p; pose proof quarter_pos; unfold ending.
  destruct (_ <? _); [rewrite Z.div_same|rewrite Z.div_mul]; lia.
Qed.

(** ARITH-STRICT-1: the length, and the quarter that is seen at the end, tell whether bits are the
    code. *)
Theorem code_by_last_quarter : forall ss l p, Forall valid ss -> p = run ss start ->
  l = code ss <-> length l = (shifts p + 2)%nat /\ seen l p / quarter = ending p / quarter.
Proof.
  intros ss l p V P; pose proof quarter_pos as Q; pose proof (quarters_of_ending p) as E.
  pose proof (code_length ss V) as N; pose proof (code_times_quarter ss V) as C;
    rewrite <- P in N, C.
  split.
  - intros ->; split; [exact N|].
    pose proof (seen_of_code ss [] p V P) as S; rewrite app_nil_r in S.
    symmetry; apply (Z.div_unique _ _ _ (seen (code ss) p - ending p)); lia.
  - intros [L S]; apply value_injective; [lia|].
    unfold seen in S; replace (shifts p + 32)%nat with (30 + length l)%nat in S by lia.
    rewrite first_beyond in S; replace (power 30) with quarter in S by (rewrite quarter_is;
      reflexivity).
    replace (quarter * value l - base p) with ((value l - value (code ss)) * quarter + ending p)
      in S by lia.
    rewrite Z.div_add_l in S; lia.
Qed.

(** ** Length *)

(** ARITH-LENGTH-1: 2^(L-2) times the product of f/T (1 - e) is at most 1. *)
Theorem length_bounded_above : forall ss, Forall valid ss ->
  power (length (code ss)) * product least ss <= 4 * product wholes ss.
Proof.
  intros ss V; rewrite code_length, power_add by exact V; change (power 2) with 4.
  pose proof (shifts_at_most ss V); unfold power; lia.
Qed.

(** ARITH-LENGTH-2: 2^L times the product of f/T (1 + e) is above 1. *)
Theorem length_bounded_below : forall ss, Forall valid ss ->
  product wholes ss < power (length (code ss)) * product most ss.
Proof.
  intros ss V; rewrite code_length, power_add by exact V; change (power 2) with 4.
  pose proof (shifts_at_least ss V); unfold power; lia.
Qed.
