(** The 32-bit arithmetic coder, encoder and decoder: spec/02-arithmetic.md, section 2.4.

    For every model whose tables are proper, adaptive or not. Proved here:
    - the value always lies in the state, whatever the bits           (ARITH-DECODE-2)
    - a message is found in its bits, whatever follows them           (ARITH-END-2)
    - and the reader knows where they end                             (ARITH-DECODE-4)
    - a strict reader accepts the code of a message and nothing else  (ARITH-STRICT-1)
    - a reading is rejected only because of a table                   (ARITH-DECODE-3)
    - no code is the beginning of another                             (ARITH-END-2) *)
Require Import ZArith List Lia Bool.
From Clers Require Import Bits Model Interval Integer_encoder Integer_decoder.
Import ListNotations.
Open Scope Z_scope.

Section Coder.
  Variable Model : Type.
  Variable now : Model -> table.
  Variable after : Model -> Z -> Model.
  Variable good : Model -> Prop.
  Hypothesis good_now : forall m, good m -> proper (now m).
  Hypothesis good_after : forall m s sl, good m -> total (now m) <= quarter ->
    slot_of (now m) s = Some sl -> good (after m s).

  Let slots := slots Model now after.
  Let is_whole := is_whole Model now after.

  (** ARITH-ENCODE-1. *)
  Definition encode (m : Model) (ms : list Z) : result (list bool) :=
    match slots 0 m ms with
    | accepted ss => accepted (code ss)
    | rejected why blamed => rejected why blamed
    end.

  (** Up to n symbols, and the decoder after them; no code of more than [limit] bits.
      ARITH-DECODE-2, ARITH-DECODE-3, ARITH-STRICT-2. *)
  Fixpoint read (limit index : Z) (n : nat) (m : Model) (x : receiver) : result (list Z * receiver)
    :=
    match n with
    | O => accepted ([], x)
    | S k =>
        let t := now m in
        if quarter <? total t then rejected bad_table (Some index)
        else if total t =? 0 then accepted ([], x)
        else
          let s := find t (target (total t) (rlow x) (rhigh x) (seen_value x)) in
          let y := receive x (Slot (cumulative t s) (cumulative t (s + 1)) (total t)) in
          if limit <? taken y + 2 then rejected truncated_bits (Some index)
          else match read limit (index + 1) k (after m s) y with
               | accepted (ms, z) => accepted (s :: ms, z)
               | rejected why blamed => rejected why blamed
               end
    end.

  (** ARITH-STRICT-1, the end of it: the last quarter. *)
  Definition ends_well (x : receiver) : bool :=
    seen_value x / quarter =? (if rlow x <? quarter then 1 else 2).

  (** A strict reader. ARITH-STRICT-1 to ARITH-STRICT-4. *)
  Definition decode (m : Model) (l : list bool) (n : nat) : result (list Z) :=
    let limit := Z.of_nat (length l) in
    if limit <? 2 then rejected truncated_bits (Some 0)
    else match read limit 0 n m (receiver0 l) with
         | accepted (ms, x) =>
             if taken x + 2 <? limit then rejected trailing_bits None
             else if ends_well x then accepted ms else rejected not_canonical None
         | rejected why blamed => rejected why blamed
         end.

  (** The part of a table that the search found at a place. *)
  Lemma found_slot : forall l m x p, good m -> at_rest p -> holds l p -> follows l x p ->
    total (now m) <= quarter -> total (now m) <> 0 ->
    let t := now m in
    let s := find t (target (total t) (rlow x) (rhigh x) (seen_value x)) in
    let sl := Slot (cumulative t s) (cumulative t (s + 1)) (total t) in
    slot_of t s = Some sl /\ valid sl /\ holds l (step p sl).
  Proof.
    intros l m x p G R H (-> & -> & -> & _) Q N t s sl; pose proof (good_now m G) as P.
    assert (T : 1 <= total t).
    { pose proof (rises t 0 (size t) P); pose proof (has_size t P); pose proof (from_zero t P).
      unfold t, total in *; lia. }
    assert (X : 0 <= target (total t) (low p) (high p) (seen l p) < total t)
      by (apply target_in_table; [exact H|exact T]).
    assert (S : slot_of t s = Some sl) by (apply slot_of_found; assumption).
    pose proof (slot_valid t s sl P Q S) as V; repeat split; try apply V; try exact S.
    all: apply (step_holds l p sl H V); apply (found t P _ X).
  Qed.

  (** What a reading finds is the message whose last place holds what is seen, and whose length is
      known. *)
  Lemma read_sound : forall l limit n i m x p ms z, good m -> at_rest p -> holds l p ->
    follows l x p -> read limit i n m x = accepted (ms, z) ->
    exists ss, slots i m ms = accepted ss /\ is_whole m n ms /\
      at_rest (run ss p) /\ holds l (run ss p) /\ follows l z (run ss p).
  Proof.
    unfold is_whole, Model.is_whole, slots.
    intros l limit; induction n as [|n IH]; intros i m x p ms z G R H F; cbn [read].
    - intros [= <- <-]; exists []; cbn; auto.
    - destruct (quarter <? total (now m)) eqn:Q; [discriminate|]; apply Z.ltb_ge in Q.
      destruct (total (now m) =? 0) eqn:N; [apply Z.eqb_eq in N|apply Z.eqb_neq in N].
      + intros [= <- <-]; exists []; split; [reflexivity|].
        split; [right; split; [cbn; lia|exact N]|auto].
      + destruct (found_slot l m x p G R H F Q N) as (S & V & K).
        set (s := find _ _) in *; set (sl := Slot _ _ _) in *.
        destruct (limit <? _); [discriminate|].
        destruct (read _ _ n _ _) as [[ms' z']|] eqn:E; [|discriminate]; intros [= <- <-].
        apply (IH _ _ _ (step p sl)) in E; auto using step_settles, receive_follows;
          [|exact (good_after m s sl G Q S)].
        destruct E as (ss & E & W & R' & H' & F'); exists (sl :: ss).
        rewrite fold_left_cons; split; [|split; [|auto]].
        * cbn [Model.slots]; rewrite (proj2 (Z.ltb_ge _ _) Q), S, E; reflexivity.
        * unfold then_; cbn [fold_left length]; destruct W as [W|[W W']]; [left; lia|right].
          split; [lia|exact W'].
  Qed.

  (** And each message whose last place holds what is seen is found, if the limit allows. *)
  Lemma read_complete : forall l limit n i m x p ms ss, good m -> at_rest p -> holds l p ->
    follows l x p -> slots i m ms = accepted ss -> is_whole m n ms -> holds l (run ss p) ->
    Z.of_nat (shifts (run ss p)) + 2 <= limit ->
    exists z, read limit i n m x = accepted (ms, z) /\ follows l z (run ss p).
  Proof.
    unfold is_whole, Model.is_whole, slots.
    intros l limit; induction n as [|n IH]; intros i m x p ms ss G R H F E W K M; cbn [read].
    - destruct ms; [|cbn in W; lia]; injection E as <-; exists x; auto.
    - destruct ms as [|s ms].
      + destruct W as [W|[_ W]]; [discriminate|]; unfold then_ in W; cbn [fold_left] in W.
        injection E as <-; exists x; rewrite W, Z.eqb_refl; split; [|exact F].
        rewrite (proj2 (Z.ltb_ge quarter 0)) by (pose proof quarter_pos; lia); reflexivity.
      + apply slots_cons in E as (sl & rs & Q & S & E & ->).
        pose proof (good_now m G) as P; pose proof (slot_valid _ _ _ P Q S) as V.
        pose proof (slot_of_some _ _ _ S) as (B & C & SL).
        rewrite fold_left_cons in K, M.
        assert (G' : good (after m s)) by exact (good_after m s sl G Q S).
        pose proof (slots_valid _ _ _ _ good_now good_after _ _ _ _ G' E) as VS.
        pose proof (step_settles p sl R V) as R'.
        pose proof (run_holds_back l rs _ R' VS K) as H'.
        pose proof (proj1 (step_holds l p sl H V) H') as T.
        pose proof F as (L & HI & SV & _).
        assert (FIND : find (now m) (target (total (now m)) (rlow x) (rhigh x) (seen_value x)) = s).
        { apply found_is_the_one; [exact P|exact B|]; rewrite L, HI, SV; rewrite SL in T; exact T. }
        rewrite (proj2 (Z.ltb_ge _ _) Q), FIND, <- SL.
        rewrite (proj2 (Z.eqb_neq (total (now m)) 0))
          by (rewrite SL in V; unfold valid in V; cbn [below upto whole] in V; lia).
        pose proof (receive_follows l x p sl F) as F'.
        destruct F' as (F1 & F2 & F3 & F4 & F5).
        pose proof (run_shifts rs (step p sl)) as SH.
        rewrite (proj2 (Z.ltb_ge _ _)) by (rewrite F5; lia).
        destruct (IH (i + 1) (after m s) (receive x sl) (step p sl) ms rs) as (z & -> & Fz); auto.
        * unfold follows; auto.
        * destruct W as [W|[W W']]; cbn [length] in W; [left; lia|right; split; [lia|exact W']].
        * exists z; rewrite fold_left_cons; auto.
  Qed.

  Lemma read_limit : forall limit n i m x ms z, taken x + 2 <= limit ->
    read limit i n m x = accepted (ms, z) -> taken z + 2 <= limit.
  Proof.
    intros limit; induction n as [|n IH]; intros i m x ms z T; cbn [read]; [congruence|].
    destruct (quarter <? _); [discriminate|]; destruct (_ =? 0); [congruence|].
    destruct (limit <? _) eqn:L; [discriminate|]; apply Z.ltb_ge in L.
    destruct (read _ _ n _ _) as [[ms' z']|] eqn:E; [|discriminate]; intros [= <- <-]; eauto.
  Qed.

  Lemma ends_well_is : forall l x p, follows l x p ->
    ends_well x = true <-> seen l p / quarter = ending p / quarter.
  Proof.
    intros l x p (L & _ & V & _); unfold ends_well, ending; rewrite L, V, Z.eqb_eq.
    pose proof quarter_pos; destruct (low p <? quarter); [rewrite Z.div_same|rewrite Z.div_mul];
      lia.
  Qed.

  Lemma encode_slots : forall m ms l, encode m ms = accepted l ->
    exists ss, slots 0 m ms = accepted ss /\ l = code ss.
  Proof.
    unfold encode; intros m ms l; destruct (slots 0 m ms) as [ss|]; [|discriminate].
    intros [= <-]; eauto.
  Qed.

  (** ARITH-ENCODE-1: an encoder rejects a message for these two reasons and no other;
      [Model.faults] says when. *)
  Theorem encode_rejects : forall m ms why blamed, encode m ms = rejected why blamed ->
    slots 0 m ms = rejected why blamed /\ (why = bad_table \/ why = not_in_alphabet).
  Proof.
    unfold encode, slots; intros m ms why blamed; destruct (Model.slots _ _ _ 0 m ms) eqn:E;
      [discriminate|].
    intros [= <- <-]; split; [reflexivity|].
    apply faults in E as (? & ? & ? & _ & _ & _ & [[-> _]|[-> _]]); auto.
  Qed.

  (** ARITH-DECODE-2: whatever the bits, the value lies in the state. *)
  Theorem value_stays_inside : forall l limit n m ms x, good m ->
    read limit 0 n m (receiver0 l) = accepted (ms, x) -> rlow x <= seen_value x <= rhigh x.
  Proof.
    intros l limit n m ms x G E.
    destruct (read_sound l limit n 0 m _ start ms x G start_at_rest (start_holds l)
      (receiver0_follows l) E)
      as (ss & _ & _ & _ & H & (-> & -> & -> & _)); exact H.
  Qed.

  (** ARITH-DECODE-3: a reader that is not strict (one whose limit is never met) rejects bits only
      for a table that is too large. *)
  Theorem reading_rejects_tables_only : forall l limit n i m x p why blamed, follows l x p ->
    taken x + 32 * Z.of_nat n + 2 <= limit ->
    read limit i n m x = rejected why blamed -> why = bad_table.
  Proof.
    intros l limit; induction n as [|n IH]; intros i m x p why blamed F L; cbn [read];
      [discriminate|].
    destruct (quarter <? _); [congruence|]; destruct (_ =? 0); [discriminate|].
    set (s := find _ _); set (sl := Slot _ _ _).
    pose proof (receive_follows l x p sl F) as F'; pose proof (step_shifts p sl).
    destruct F as (_ & _ & _ & _ & T), F' as (A & B & C & D & T').
    rewrite (proj2 (Z.ltb_ge _ _)) by lia.
    destruct (read _ _ n _ _) as [[? ?]|w b] eqn:E; [discriminate|]; intros [= <- <-].
    apply (IH _ _ _ (step p sl)) in E; [exact E|unfold follows; auto|lia].
  Qed.

  (** ARITH-END-2, ARITH-DECODE-4: a message is found in its bits whatever follows them, and the
      reader knows where they end. *)
  Theorem found_whatever_follows : forall m ms n l more limit, good m ->
    encode m ms = accepted l -> is_whole m n ms -> Z.of_nat (length l) <= limit ->
    exists x, read limit 0 n m (receiver0 (l ++ more)) = accepted (ms, x) /\
      taken x + 2 = Z.of_nat (length l) /\ ends_well x = true.
  Proof.
    intros m ms n l more limit G E W L; apply encode_slots in E as (ss & E & ->).
    pose proof (slots_valid _ _ _ _ good_now good_after _ _ _ _ G E) as V.
    rewrite code_length in L by exact V.
    destruct (read_complete (code ss ++ more) limit n 0 m _ start ms ss G start_at_rest
      (start_holds _)
                (receiver0_follows _) E W (code_points_inside ss more _ V eq_refl)) as (x & R & F);
                  [lia|].
    exists x; split; [exact R|]; split.
    - destruct F as (_ & _ & _ & _ & ->); rewrite code_length by exact V; lia.
    - apply (ends_well_is _ _ _ F); pose proof quarter_pos.
      pose proof (seen_of_code ss more _ V eq_refl) as S;
        pose proof (quarters_of_ending (run ss start)).
      symmetry; apply (Z.div_unique _ _ _ (seen (code ss ++ more) (run ss start) - ending (run ss
        start))); lia.
  Qed.

  (** ARITH-STRICT-1: a strict reader of n symbols accepts the code of a message of n symbols (or
      one that ends before), finds this message, and accepts no other bits. *)
  Theorem strict_reader : forall m l n ms, good m ->
    decode m l n = accepted ms <-> encode m ms = accepted l /\ is_whole m n ms.
  Proof.
    intros m l n ms G; split.
    - unfold decode; destruct (_ <? 2) eqn:T; [discriminate|]; apply Z.ltb_ge in T.
      destruct (read _ 0 n m (receiver0 l)) as [[ms' x]|] eqn:R; [|discriminate].
      destruct (_ <? _) eqn:N; [discriminate|]; apply Z.ltb_ge in N.
      destruct (ends_well x) eqn:Z; [|discriminate]; intros [= <-].
      pose proof (receiver0_follows l) as F0.
      assert (M : taken x + 2 <= Z.of_nat (length l)).
      { apply (read_limit _ _ _ _ _ _ _) in R; [exact R|].
        destruct F0 as (_ & _ & _ & _ & ->); cbn [start shifts]; lia. }
      destruct (read_sound l _ n 0 m _ start ms' x G start_at_rest (start_holds l) F0 R)
        as (ss & E & W & _ & _ & F); split; [|exact W].
      unfold encode; rewrite E; f_equal; symmetry.
      apply (code_by_last_quarter ss l _ (slots_valid _ _ _ _ good_now good_after _ _ _ _ G E)
        eq_refl).
      split; [destruct F as (_ & _ & _ & _ & T'); lia|apply (ends_well_is _ _ _ F), Z].
    - intros [E W].
      destruct (found_whatever_follows m ms n l [] (Z.of_nat (length l)) G E W) as (x & R & T & Z);
        [lia|].
      rewrite app_nil_r in R; unfold decode; rewrite R, Z.
      apply encode_slots in E as (ss & E & ->).
      pose proof (slots_valid _ _ _ _ good_now good_after _ _ _ _ G E) as V.
      rewrite (proj2 (Z.ltb_ge _ 2)) by (rewrite code_length by exact V; lia).
      rewrite (proj2 (Z.ltb_ge _ _)) by lia; reflexivity.
  Qed.

  (** ARITH-END-2: no code of a message of n symbols is the beginning of another's. *)
  Theorem no_code_begins_another : forall m n ms ks l more, good m ->
    is_whole m n ms -> is_whole m n ks ->
    encode m ms = accepted l -> encode m ks = accepted (l ++ more) -> ms = ks /\ more = [].
  Proof.
    intros m n ms ks l more G W K E F; set (limit := Z.of_nat (length (l ++ more))).
    destruct (found_whatever_follows m ms n l more limit G E W) as (x & R & T & _);
      [unfold limit; rewrite app_length; lia|].
    destruct (found_whatever_follows m ks n (l ++ more) [] limit G F K) as (y & S & U & _); [lia|].
    rewrite app_nil_r, R in S; injection S as -> ->; split; [reflexivity|].
    rewrite app_length in U; destruct more; [reflexivity|cbn [length] in U; lia].
  Qed.
End Coder.
