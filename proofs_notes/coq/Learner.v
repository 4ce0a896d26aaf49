(** Static, uniform and adaptive models: spec/01-information.md, INFO-STATIC-1 to INFO-ADAPT-3.

    Proved here:
    - a list of frequencies gives a proper table                                (INFO-MODEL-1)
    - models that pass the checks stay proper, and no total is ever over 2^30   (INFO-ADAPT-3)
    - with these models the coder of Integer_coder.v is strict: nothing is left to suppose
                                                                                (ARITH-STRICT-1) *)
Require Import ZArith List Lia Bool.
From Clers Require Import Bits Model Integer_encoder Integer_coder.
Import ListNotations.
Open Scope Z_scope.

(** ** Tables of frequencies *)

Definition sum (fs : list Z) : Z := fold_right Z.add 0 fs.

Fixpoint find_in (fs : list Z) (x : Z) : Z :=
  match fs with
  | [] => 0
  | f :: rest => if x <? f then 0 else 1 + find_in rest (x - f)
  end.

(** INFO-MODEL-1. *)
Definition of_frequencies (fs : list Z) : table :=
  Table (Z.of_nat (length fs)) (fun s => sum (firstn (Z.to_nat s) fs)) (find_in fs).

(** INFO-STATIC-2: without a list of ones. *)
Definition of_equals (n : Z) : table := Table n (fun s => s) (fun x => x).

Definition no_negative (fs : list Z) : Prop := Forall (fun f => 0 <= f) fs.

Lemma sum_next : forall n fs, (n < length fs)%nat ->
  sum (firstn (S n) fs) = sum (firstn n fs) + nth n fs 0.
Proof.
  induction n as [|n IH]; intros [|f fs] L; cbn [length] in L; try lia; [cbn; lia|].
  change (f + sum (firstn (S n) fs) = f + sum (firstn n fs) + nth n fs 0); rewrite IH; lia.
Qed.

Lemma find_in_finds : forall fs x, no_negative fs -> 0 <= x < sum fs ->
  exists n, find_in fs x = Z.of_nat n /\ (n < length fs)%nat /\
    sum (firstn n fs) <= x < sum (firstn (S n) fs).
Proof.
  induction fs as [|f fs IH]; intros x N X; [cbn in X; lia|].
  inversion_clear N as [|? ? F N']; cbn [find_in].
  change (sum (f :: fs)) with (f + sum fs) in X.
  destruct (x <? f) eqn:E; rewrite ?Z.ltb_lt, ?Z.ltb_ge in E.
  - exists O; cbn; lia.
  - destruct (IH (x - f) N') as (n & I & L & B); [lia|]; exists (S n).
    change (sum (firstn (S n) (f :: fs))) with (f + sum (firstn n fs)).
    change (sum (firstn (S (S n)) (f :: fs))) with (f + sum (firstn (S n) fs)).
    cbn [length]; lia.
Qed.

Theorem of_frequencies_proper : forall fs, no_negative fs -> proper (of_frequencies fs).
Proof.
  intros fs N; constructor; unfold of_frequencies, total; cbn [size cumulative find].
  - lia.
  - reflexivity.
  - intros s S; rewrite Z2Nat.inj_add, Nat.add_1_r, sum_next by lia.
    assert (0 <= nth (Z.to_nat s) fs 0); [|lia].
    apply (proj1 (Forall_forall _ _) N), nth_In; lia.
  - intros x X; rewrite Nat2Z.id, firstn_all in X.
    destruct (find_in_finds fs x N X) as (n & -> & L & S).
    rewrite Z2Nat.inj_add, Nat2Z.id, Nat.add_1_r by lia; lia.
Qed.

Theorem of_equals_proper : forall n, 0 <= n -> proper (of_equals n).
Proof. intros n N; constructor; unfold of_equals, total; cbn [size cumulative find]; lia. Qed.

(** ** Models *)

Inductive learner :=
| Static (fs : list Z)
| Uniform (n : Z)
| Adaptive (fs : list Z) (increment limit : Z).

Definition now (m : learner) : table :=
  match m with
  | Static fs | Adaptive fs _ _ => of_frequencies fs
  | Uniform n => of_equals n
  end.

Fixpoint raise (fs : list Z) (s : nat) (by_ : Z) : list Z :=
  match fs, s with
  | [], _ => []
  | f :: rest, O => f + by_ :: rest
  | f :: rest, S k => f :: raise rest k by_
  end.

(** INFO-ADAPT-2. *)
Definition halved (fs : list Z) : list Z := map (fun f => f - f / 2) fs.

(** INFO-STATIC-1, INFO-ADAPT-1, INFO-ADAPT-2. *)
Definition after (m : learner) (s : Z) : learner :=
  match m with
  | Static _ | Uniform _ => m
  | Adaptive fs increment limit =>
      let raised := raise fs (Z.to_nat s) increment in
      Adaptive (if limit <? sum raised then halved raised else raised) increment limit
  end.

(** The first symbol of a negative frequency. *)
Fixpoint first_negative (index : Z) (fs : list Z) : option Z :=
  match fs with
  | [] => None
  | f :: rest => if f <? 0 then Some index else first_negative (index + 1) rest
  end.

Definition in_range (n : Z) : bool := (1 <=? n) && (n <=? quarter).

(** INFO-STATIC-3, INFO-ADAPT-3: a model from outside. *)
Definition checked (m : learner) : result learner :=
  match m with
  | Uniform n => if in_range n then accepted m else rejected bad_table None
  | Static fs | Adaptive fs _ _ =>
      match first_negative 0 fs with
      | Some s => rejected bad_table (Some s)
      | None =>
          if negb (in_range (sum fs)) then rejected bad_table None
          else match m with
               | Adaptive _ increment limit =>
                   if (1 <=? increment) && (sum fs <=? limit)
                      && (increment + Z.of_nat (length fs) <=? limit) && (limit <=? quarter)
                   then accepted m else rejected bad_table None
               | _ => accepted m
               end
      end
  end.

(** What the checks establish, and every symbol keeps. *)
Definition good (m : learner) : Prop :=
  match m with
  | Uniform n => 1 <= n <= quarter
  | Static fs => no_negative fs /\ 1 <= sum fs <= quarter
  | Adaptive fs increment limit =>
      no_negative fs /\ 0 <= sum fs <= limit /\ limit <= quarter /\ 1 <= increment /\
      increment + Z.of_nat (length fs) <= limit
  end.

Lemma first_negative_none : forall fs i, first_negative i fs = None -> no_negative fs.
Proof.
  induction fs as [|f fs IH]; intros i; cbn [first_negative]; [constructor|].
  destruct (f <? 0) eqn:F; [discriminate|]; apply Z.ltb_ge in F; intros E.
  constructor; [exact F|exact (IH _ E)].
Qed.

Lemma raise_facts : forall fs s by_, no_negative fs -> 1 <= by_ ->
  no_negative (raise fs s by_) /\ length (raise fs s by_) = length fs /\
  sum fs <= sum (raise fs s by_) <= sum fs + by_.
Proof.
  induction fs as [|f fs IH]; intros s by_ N B; [cbn; repeat split; try constructor; lia|].
  inversion_clear N as [|? ? F N']; destruct s as [|s]; cbn [raise].
  - repeat split; [constructor; [lia|exact N']|cbn [sum fold_right]; lia..].
  - destruct (IH s by_ N' B) as (A & L & S); repeat split; [constructor; assumption|cbn [length];
      lia|..];
      unfold sum in *; cbn [fold_right]; lia.
Qed.

Lemma halved_facts : forall fs, no_negative fs ->
  no_negative (halved fs) /\ length (halved fs) = length fs /\
  0 <= sum (halved fs) /\ 2 * sum (halved fs) <= sum fs + Z.of_nat (length fs).
Proof.
  induction 1 as [|f fs F N IH]; [cbn; repeat split; try constructor; lia|].
  destruct IH as (A & L & S & T); pose proof (Z.div_mod f 2); pose proof (Z.mod_pos_bound f 2).
  repeat split; [constructor; [lia|exact A]|cbn [length halved map]; unfold halved in L; lia|..];
    unfold halved, sum in *; cbn [map fold_right length]; lia.
Qed.

Theorem checked_good : forall m k, checked m = accepted k -> k = m /\ good m.
Proof.
  assert (R : forall n, in_range n = true -> 1 <= n <= quarter).
  { unfold in_range; intros n H; rewrite andb_true_iff, !Z.leb_le in H; lia. }
  intros [fs|n|fs increment limit] k; cbn [checked].
  - destruct (first_negative 0 fs) eqn:N; [discriminate|]; apply first_negative_none in N.
    destruct (in_range _) eqn:I; cbn [negb]; [|discriminate]; intros [= <-]; cbn; auto.
  - destruct (in_range n) eqn:I; [|discriminate]; intros [= <-]; cbn; auto.
  - destruct (first_negative 0 fs) eqn:N; [discriminate|]; apply first_negative_none in N.
    destruct (in_range _) eqn:I; cbn [negb]; [|discriminate]; apply R in I.
    destruct (_ && _) eqn:E; [|discriminate]; intros [= <-]; rewrite !andb_true_iff, !Z.leb_le in E.
    cbn [good]; split; [reflexivity|]; split; [exact N|lia].
Qed.

Lemma good_now : forall m, good m -> proper (now m).
Proof.
  intros [fs|n|fs increment limit]; cbn [good now].
  - intros [N _]; apply of_frequencies_proper, N.
  - intros N; apply of_equals_proper; lia.
  - intros [N _]; apply of_frequencies_proper, N.
Qed.

Lemma good_always : forall m s, good m -> good (after m s).
Proof.
  intros [fs|n|fs increment limit] s; cbn [good after]; auto.
  intros (N & S & L & I & E).
  destruct (raise_facts fs (Z.to_nat s) increment N I) as (A & B & C).
  destruct (_ <? _) eqn:O; rewrite ?Z.ltb_lt, ?Z.ltb_ge in O.
  - destruct (halved_facts _ A) as (D & F & G & H); split; [exact D|]; lia.
  - split; [exact A|]; lia.
Qed.

(** INFO-ADAPT-3: what the checks establish holds after every message; so no total of an adaptive
    model is ever over its limit. *)
Theorem stays_good : forall ms m, good m -> good (then_ learner after m ms).
Proof.
  induction ms as [|s ms IH]; intros m G; [exact G|].
  unfold then_; cbn [fold_left]; apply IH, good_always, G.
Qed.

(** INFO-MODEL-2: no table of these models is too large. *)
Theorem totals_stay_small : forall m ms, good m ->
  total (now (then_ learner after m ms)) <= quarter.
Proof.
  intros m ms G; apply (stays_good ms) in G; destruct (then_ _ _ m ms) as [fs|n|fs increment limit];
    unfold total; cbn [good now of_equals size cumulative] in *; [|lia|];
    unfold of_frequencies; cbn [size cumulative]; rewrite Nat2Z.id, firstn_all; lia.
Qed.

(** ** The coder with these models *)

Definition encode_with : learner -> list Z -> result (list bool) := encode learner now after.
Definition decode_with : learner -> list bool -> nat -> result (list Z) := decode learner now after.

(** ARITH-STRICT-1, for these models: a strict reader accepts the code of a message and nothing
    else. *)
Theorem strict_with_learners : forall m k l n ms, checked m = accepted k ->
  decode_with m l n = accepted ms <->
  encode_with m ms = accepted l /\ is_whole learner now after m n ms.
Proof.
  intros m k l n ms C; apply checked_good in C as [_ G].
  apply (strict_reader learner now after good); auto using good_now, good_always.
Qed.
