(** Probability models, as coders see them: spec/01-information.md, INFO-MODEL-1 to INFO-MODEL-6.

    A table is its cumulative frequencies and a search in them; a symbol has a slot in a table; a
    model has a table for the next symbol and a model for what follows it. Proved here:
    - every number below the total lies in the slot of one symbol        (INFO-MODEL-1)
    - a message has its slots exactly if no symbol is at fault           (INFO-MODEL-5,
        INFO-MODEL-6) *)
Require Import ZArith List Lia Bool.
Import ListNotations.
Open Scope Z_scope.

(** What total functions answer. CONV-RESULT-1: a rejection has a reason, and the symbol blamed. *)
Inductive reason := bad_table | not_in_alphabet | truncated_bits | trailing_bits | not_canonical.
Inductive result (A : Type) := accepted (a : A) | rejected (why : reason) (blamed : option Z).
Arguments accepted {A} a.
Arguments rejected {A} why blamed.

(** The Q of chapter 2: a quarter of the range of 32 bits, and the largest total. INFO-MODEL-2. *)
Definition quarter : Z := 2 ^ 30.

Lemma quarter_is : quarter = 1073741824.
Proof. reflexivity. Qed.

Lemma quarter_pos : 1 <= quarter.
Proof. rewrite quarter_is; lia. Qed.

#[global] Opaque quarter.

(** A symbol's part of a table: from [below] up to [upto], out of [whole]. INFO-MODEL-1. *)
Record slot := Slot { below : Z; upto : Z; whole : Z }.

(** A slot that a coder meets: of a positive frequency, in a table that is not too large. *)
Definition valid (s : slot) : Prop := 0 <= below s < upto s /\ upto s <= whole s <= quarter.

(** A table: how many symbols, the cumulative frequencies, and whose slot a number lies in. *)
Record table := Table { size : Z; cumulative : Z -> Z; find : Z -> Z }.

Definition total (t : table) : Z := cumulative t (size t).

(** A table as it must be: INFO-MODEL-1, and the search keeps its promise. *)
Record proper (t : table) : Prop := {
  has_size : 0 <= size t;
  from_zero : cumulative t 0 = 0;
  rising : forall s, 0 <= s < size t -> cumulative t s <= cumulative t (s + 1);
  found : forall x, 0 <= x < total t ->
    0 <= find t x < size t /\ cumulative t (find t x) <= x < cumulative t (find t x + 1) }.

Lemma rises : forall t i j, proper t -> 0 <= i <= j -> j <= size t ->
  cumulative t i <= cumulative t j.
Proof.
  intros t i j P [I J] S; replace j with (i + Z.of_nat (Z.to_nat (j - i))) in * by lia.
  clear J; induction (Z.to_nat (j - i)) as [|n IH]; [rewrite Z.add_0_r; lia|].
  rewrite Nat2Z.inj_succ in *; pose proof (rising t P (i + Z.of_nat n)).
  replace (i + Z.succ (Z.of_nat n)) with (i + Z.of_nat n + 1) by lia; lia.
Qed.

(** INFO-MODEL-1: the slots of a table do not overlap, so that the search finds the only one. *)
Theorem found_is_the_one : forall t s x, proper t -> 0 <= s < size t ->
  cumulative t s <= x < cumulative t (s + 1) -> find t x = s.
Proof.
  intros t s x P S X.
  pose proof (rises t 0 s P); pose proof (rises t (s + 1) (size t) P); pose proof (from_zero t P).
  destruct (found t P x) as [F G]; [unfold total; lia|].
  pose proof (rises t (s + 1) (find t x) P); pose proof (rises t (find t x + 1) s P).
  destruct (Z.lt_trichotomy (find t x) s) as [L|[E|L]]; lia.
Qed.

(** The slot of a symbol; none if it is not in the alphabet. INFO-MODEL-1, INFO-MODEL-5. *)
Definition slot_of (t : table) (s : Z) : option slot :=
  if (0 <=? s) && (s <? size t) && (cumulative t s <? cumulative t (s + 1))
  then Some (Slot (cumulative t s) (cumulative t (s + 1)) (total t)) else None.

Lemma slot_of_some : forall t s sl, slot_of t s = Some sl ->
  0 <= s < size t /\ cumulative t s < cumulative t (s + 1) /\
  sl = Slot (cumulative t s) (cumulative t (s + 1)) (total t).
Proof.
  unfold slot_of; intros t s sl; destruct (_ && _) eqn:E; [|discriminate]; intros [= <-].
  rewrite !andb_true_iff, !Z.ltb_lt, Z.leb_le in E; repeat split; lia.
Qed.

Lemma slot_valid : forall t s sl, proper t -> total t <= quarter -> slot_of t s = Some sl ->
  valid sl.
Proof.
  intros t s sl P Q E; apply slot_of_some in E as (S & C & ->); unfold valid;
    cbn [below upto whole].
  pose proof (rises t 0 s P); pose proof (rises t (s + 1) (size t) P); pose proof (from_zero t P).
  unfold total in *; lia.
Qed.

Lemma slot_of_found : forall t x, proper t -> 0 <= x < total t ->
  slot_of t (find t x) =
    Some (Slot (cumulative t (find t x)) (cumulative t (find t x + 1)) (total t)).
Proof.
  intros t x P X; destruct (found t P x X) as [F G]; unfold slot_of.
  rewrite (proj2 (Z.leb_le 0 _)), (proj2 (Z.ltb_lt (find t x) _)),
    (proj2 (Z.ltb_lt (cumulative _ _) _)) by lia.
  reflexivity.
Qed.

(** ** Messages *)

Section Model.
  Variable Model : Type.
  Variable now : Model -> table.                (* the table of the next symbol *)
  Variable after : Model -> Z -> Model.         (* INFO-MODEL-4: what the model is after a symbol *)

  (** The slots of a message, or the fault of its first faulty symbol. INFO-MODEL-5, INFO-MODEL-6.
      *)
  Fixpoint slots (index : Z) (m : Model) (ms : list Z) : result (list slot) :=
    match ms with
    | [] => accepted []
    | s :: rest =>
        if quarter <? total (now m) then rejected bad_table (Some index)
        else match slot_of (now m) s with
             | None => rejected not_in_alphabet (Some index)
             | Some sl => match slots (index + 1) (after m s) rest with
                          | accepted sls => accepted (sl :: sls)
                          | rejected why blamed => rejected why blamed
                          end
             end
    end.

  (** The model after a message. *)
  Definition then_ (m : Model) (ms : list Z) : Model := fold_left after ms m.

  (** A message that a reader who asks for n symbols should find: n of them, or to the model's end.
      INFO-MODEL-3, ARITH-DECODE-3. *)
  Definition is_whole (m : Model) (n : nat) (ms : list Z) : Prop :=
    length ms = n \/ (length ms < n)%nat /\ total (now (then_ m ms)) = 0.

  (** What keeps all tables that a message can meet proper. *)
  Variable good : Model -> Prop.
  Hypothesis good_now : forall m, good m -> proper (now m).
  Hypothesis good_after : forall m s sl, good m -> total (now m) <= quarter ->
    slot_of (now m) s = Some sl -> good (after m s).

  Lemma slots_cons : forall i m s ms ss, slots i m (s :: ms) = accepted ss ->
    exists sl rest, total (now m) <= quarter /\ slot_of (now m) s = Some sl /\
      slots (i + 1) (after m s) ms = accepted rest /\ ss = sl :: rest.
  Proof.
    intros i m s ms ss; cbn [slots]; destruct (quarter <? _) eqn:Q; [discriminate|].
    destruct (slot_of _ s) as [sl|]; [|discriminate].
    destruct (slots _ _ ms) as [rest|]; [|discriminate].
    intros [= <-]; exists sl, rest; apply Z.ltb_ge in Q; auto.
  Qed.

  Lemma slots_valid : forall ms i m ss, good m -> slots i m ms = accepted ss -> Forall valid ss.
  Proof.
    induction ms as [|s ms IH]; intros i m ss G E; [injection E as <-; constructor|].
    apply slots_cons in E as (sl & rest & T & S & E & ->); constructor.
    - exact (slot_valid _ _ _ (good_now m G) T S).
    - exact (IH _ _ _ (good_after m s sl G T S) E).
  Qed.

  Lemma slots_length : forall ms i m ss, slots i m ms = accepted ss -> length ss = length ms.
  Proof.
    induction ms as [|s ms IH]; intros i m ss E; [injection E as <-; reflexivity|].
    apply slots_cons in E as (sl & rest & _ & _ & E & ->); cbn [length]; f_equal; eauto.
  Qed.

  (** INFO-MODEL-5, INFO-MODEL-6: these are the only faults, the symbol blamed is the first that has
      one, and the larger fault is named where it has both. *)
  Theorem faults : forall ms i m why blamed, slots i m ms = rejected why blamed ->
    exists before s rest, ms = before ++ s :: rest /\
      blamed = Some (i + Z.of_nat (length before)) /\
      (exists ss, slots i m before = accepted ss) /\
      let t := now (then_ m before) in
      (why = bad_table /\ quarter < total t \/
       why = not_in_alphabet /\ total t <= quarter /\ slot_of t s = None).
  Proof.
    induction ms as [|s ms IH]; intros i m why blamed; cbn [slots]; [discriminate|].
    destruct (quarter <? _) eqn:Q.
    - intros [= <- <-]; exists [], s, ms; cbn; rewrite Z.add_0_r; apply Z.ltb_lt in Q.
      repeat split; [exists []; reflexivity|left; auto].
    - apply Z.ltb_ge in Q; destruct (slot_of _ s) as [sl|] eqn:S.
      + destruct (slots _ _ ms) as [|w b] eqn:E; [discriminate|]; intros [= <- <-].
        apply IH in E as (before & x & rest & -> & -> & (ss & E) & F).
        exists (s :: before), x, rest; repeat split.
        * cbn [length]; f_equal; lia.
        * exists (sl :: ss); cbn [slots]; rewrite (proj2 (Z.ltb_ge _ _) Q), S, E; reflexivity.
        * exact F.
      + intros [= <- <-]; exists [], s, ms; cbn; rewrite Z.add_0_r.
        repeat split; [exists []; reflexivity|right; auto].
  Qed.
End Model.
