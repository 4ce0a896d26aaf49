(** Handle data as the stream has it: one record for each gate passed over, with its numbers.

    EB-HANDLE-1, EB-HANDLE-3, EB-HANDLE-4, EB-HANDLE-5 for one connected closed surface: an S has a
    record exactly if its left gate was passed over ([record_iff_passed]); the closing triangle is R
    or E on the right, L or E on the left ([closed_by]); from the word and the numbers s, at, side of
    the records the side that closes each S is found again ([told_is_items]). So the stream, the word
    and its records, determines the surface ([same_stream_same_surface]), and from the stream alone
    Spirale Reversi glues it ([decoded_from_stream]). *)
Require Import List Arith Lia Permutation.
Require Import Clers.Letters Clers.Words Clers.Meshes Clers.Discs Clers.Traversal Clers.Visited
  Clers.Records Clers.Undoing Clers.Reversi Clers.Sides Clers.Handles Clers.Round_trip
  Clers.Handles_round_trip Clers.Numbering.
Import ListNotations.
Open Scope nat_scope.

(** The stream of a trace: its word and its records. *)
Definition word_of (tr : list step) : list symbol := map fst tr.
Definition records_of (tr : list step) : list entry := entries (word_of tr) 0 (items tr).

Section Surface.
  Variable M : list face.
  Hypothesis SM : surface M.

  (** EB-HANDLE-4, of all closed sides: the letters whose right, whose left edge is closed. *)
  Lemma closed_sides : forall K m a b st tr p, Walk M K m a b st tr p -> good M K m a b st ->
    forall x v c d, In (x, (v, c, d)) tr ->
    (In (v, d) (edges K) -> x = sR \/ x = sE) /\ (In (c, v) (edges K) -> x = sL \/ x = sE).
  Proof.
    assert (Up : forall f K e, In e (edges K) -> In e (edges (f :: K)))
      by (intros f K e I; apply (in_or_app (runs f)); auto).
    apply (walk_induction M SM (fun K m a b st tr p => forall x v c d, In (x, (v, c, d)) tr ->
      (In (v, d) (edges K) -> x = sR \/ x = sE) /\ (In (c, v) (edges K) -> x = sL \/ x = sE))).
    - intros K m a b v st tr p G H V G' IH x w c d [I|I].
      + injection I as <- <- <- <-; destruct (advance M SM _ _ _ _ _ _ G H) as (_ & _ & _ & _ & A & B).
        split; intros J; exfalso; auto.
      + destruct (IH x w c d I); auto.
    - intros K m a b v st tr p G H V X Y G' IH x w c d [I|I].
      + injection I as <- <- <- <-; split; [auto|contradiction].
      + destruct (IH x w c d I); auto.
    - intros K m a b v st tr p G H V X Y G' IH x w c d [I|I].
      + injection I as <- <- <- <-; split; [contradiction|auto].
      + destruct (IH x w c d I); auto.
    - intros K m a b v st tr p G H V X Y G' IH x w c d [I|I].
      + injection I as <- <- <- <-; split; contradiction.
      + destruct (IH x w c d I); auto.
    - intros K m a b v st G H V X Y Q x w c d [I|[]]; injection I as <- <- <- <-; auto.
    - intros K m a b v passed a' b' rest tr p G H V X Y Q O G' IH x w c d [I|I].
      + injection I as <- <- <- <-; auto.
      + destruct (IH x w c d I); auto.
  Qed.

  Lemma closing_where : forall tr e j q, closing e tr = Some (j, q) ->
    exists t1 x v a b t2, tr = t1 ++ (x, (v, a, b)) :: t2 /\ j = length t2 /\
      (q = at_right /\ e = (b, v) \/ q = at_left /\ e = (v, a)).
  Proof.
    induction tr as [|[x [[v a] b]] tr IH]; intros e j q H; [discriminate|]; cbn [closing] in H.
    destruct (edge_eq_dec e (b, v)) as [->|D1]; [|destruct (edge_eq_dec e (v, a)) as [->|D2]].
    - injection H as <- <-; exists [], x, v, a, b, tr; auto 6.
    - injection H as <- <-; exists [], x, v, a, b, tr; auto 6.
    - destruct (IH e j q H) as (t1 & y & w & c & d & t2 & -> & A).
      exists ((x, (v, a, b)) :: t1), y, w, c, d, t2; auto.
  Qed.

  (** A walk stopped before one of its steps. *)
  Lemma from_step : forall K m a b st tr p, Walk M K m a b st tr p -> good M K m a b st ->
    forall t1 x v c d t2, tr = t1 ++ (x, (v, c, d)) :: t2 -> exists K' m' st' p',
      Walk M K' m' c d st' ((x, (v, c, d)) :: t2) p' /\ good M K' m' c d st' /\ K' = after t1 K.
  Proof.
    intros K m a b st tr p W.
    induction W as [K m a b v st tr p H V W IH|K m a b v st tr p H V X Y W IH
      |K m a b v st tr p H V X Y W IH|K m a b v st tr p H V X Y W IH|K m a b v st H V X Y Q
      |K m a b v passed a' b' rest tr p H V X Y Q O W IH]; intros G [|[y f] t1] x w c d t2 E0;
      injection E0; intros; subst; try (rewrite after_cons).
    - do 4 eexists; split; [apply Walk_C; eassumption|split; [eassumption|reflexivity]].
    - eapply IH; [|reflexivity]; destruct (advance M SM _ _ _ _ _ _ G H) as (_ & _ & _ & _ & A & _).
      apply good_right with m st; auto; cbn; intuition auto.
    - do 4 eexists; split; [apply Walk_R; eassumption|split; [eassumption|reflexivity]].
    - eapply IH; [|reflexivity]; exact (good_left M SM _ _ _ _ _ _ G H Y V).
    - do 4 eexists; split; [apply Walk_L; eassumption|split; [eassumption|reflexivity]].
    - eapply IH; [|reflexivity]; apply good_right with m st; auto; intros z; intuition (subst; auto).
    - do 4 eexists; split; [apply Walk_S; eassumption|split; [eassumption|reflexivity]].
    - eapply IH; [|reflexivity].
      apply good_right with m st; auto; [intros z; intuition (subst; auto)|intros z z' [J|J]; auto].
    - do 4 eexists; split; [apply Walk_end; eassumption|split; [eassumption|reflexivity]].
    - destruct t1; discriminate.
    - do 4 eexists; split; [apply Walk_E; eassumption|split; [eassumption|reflexivity]].
    - eapply IH; [|reflexivity]; exact (good_popped M SM _ _ _ _ _ _ _ _ _ G H O V).
  Qed.

  (** EB-HANDLE-4: the closing triangle is R or E on the right side, L or E on the left. *)
  Theorem closed_by : forall K m a b st tr p, Walk M K m a b st tr p -> good M K m a b st ->
    forall t1 v c d t2 j q, tr = t1 ++ (sS, (v, c, d)) :: t2 -> closing (c, v) t2 = Some (j, q) ->
    exists s1 x f s2, t2 = s1 ++ (x, f) :: s2 /\ j = length s2 /\
      (q = at_right /\ (x = sR \/ x = sE) \/ q = at_left /\ (x = sL \/ x = sE)).
  Proof.
    intros K m a b st tr p W G t1 v c d t2 j q E0 Cl.
    destruct (from_step _ _ _ _ _ _ _ W G _ _ _ _ _ _ E0) as (K' & m' & st' & p' & W' & G' & _).
    destruct (closing_where _ _ _ _ Cl) as (s1 & x & w & e & f & s2 & -> & -> & D).
    exists s1, x, (w, e, f), s2; split; [reflexivity|split; [reflexivity|]].
    inversion W' as [| | |K0 m0 a0 b0 v0 st0 tr0 p0 H V X Y W2| |]; subst.
    assert (G2 : good M ((v, c, d) :: K') m' v d ((c, v) :: st')).
    { apply good_right with m' st'; auto; [intros z; intuition (subst; auto)|intros z z' [J|J]; auto]. }
    assert (I : In (x, (w, e, f)) (s1 ++ (x, (w, e, f)) :: s2)) by (apply in_app_iff; right; left; reflexivity).
    destruct (closed_sides _ _ _ _ _ _ _ W2 G2 x w e f I) as [A B].
    destruct D as [[-> D]|[-> D]]; injection D as -> ->; [left|right]; (split; [reflexivity|]).
    - apply A; left; reflexivity.
    - apply B; left; reflexivity.
  Qed.

  (** A gate that was passed over is no gate of a later step. *)
  Lemma passed_no_gate : forall K m a b st tr p, Walk M K m a b st tr p -> good M K m a b st ->
    NoDup (edges (map snd tr) ++ edges K) -> NoDup ((a, b) :: st) -> forall g, In g p ->
    (In g st \/ In (flip g) (edges (map snd tr))) /\ In g (edges (after tr K)) /\
    forall x v, ~ In (x, (v, fst g, snd g)) tr.
  Proof.
    assert (Head : forall K m a b st v (tr : list step) g, good M K m a b st ->
      NoDup (edges ((v, a, b) :: map snd tr) ++ edges K) -> ~ In (a, b) st ->
      (In g st \/ In (flip g) (edges ((v, a, b) :: map snd tr))) -> (a, b) <> g).
    { intros K m a b st v tr g G N Ns D <-; destruct D as [D|D]; [contradiction|].
      apply NoDup_app_split in N; destruct N as (_ & _ & N); exact (N _ D (behind _ _ _ _ _ _ G)). }
    assert (Shift : forall f (tr : list step) K, NoDup (edges (f :: map snd tr) ++ edges K) ->
      NoDup (edges (map snd tr) ++ edges (f :: K))).
    { intros f tr K N; change (edges (f :: map snd tr)) with (runs f ++ edges (map snd tr)) in N.
      change (edges (f :: K)) with (runs f ++ edges K).
      eapply Permutation_NoDup; [|exact N]; clear; permute. }
    assert (Fresh : forall K m a b st v e, good M K m a b st -> has M a b v ->
      In (flip e) (runs (v, a, b)) -> ~ In e st).
    { intros K m a b st v [x y] G H I J; destruct (advance M SM _ _ _ _ _ _ G H) as (_ & _ & A & _).
      exact (A _ I (waiting _ _ _ _ _ _ G x y J)). }
    assert (Step : forall s K m a b v st st' (tr : list step) g, good M K m a b st ->
      NoDup (edges ((v, a, b) :: map snd tr) ++ edges K) -> ~ In (a, b) st ->
      (forall e, In e st' -> In e st \/ In (flip e) (runs (v, a, b))) ->
      (In g st' \/ In (flip g) (edges (map snd tr))) /\ In g (edges (after tr ((v, a, b) :: K))) /\
        (forall x w, ~ In (x, (w, fst g, snd g)) tr) ->
      (In g st \/ In (flip g) (edges ((v, a, b) :: map snd tr))) /\
        In g (edges (after ((s, (v, a, b)) :: tr) K)) /\
        (forall x w, ~ In (x, (w, fst g, snd g)) ((s, (v, a, b)) :: tr))).
    { intros s K m a b v st st' tr g G N Ns Sub (A & B & D).
      assert (A' : In g st \/ In (flip g) (edges ((v, a, b) :: map snd tr))).
      { destruct A as [A|A]; [destruct (Sub g A) as [I|I]; [auto|right; apply (in_or_app (runs (v, a, b))); auto]|].
        right; apply (in_or_app (runs (v, a, b))); auto. }
      split; [exact A'|split; [rewrite after_cons; exact B|]]; intros x w [I|I]; [|exact (D x w I)].
      injection I as _ _ E1 E2; apply (Head K m a b st v tr g G N Ns A'); destruct g; cbn in *; congruence. }
    intros K m a b st tr p W G.
    revert W G; apply (walk_induction M SM (fun K m a b st tr p =>
      NoDup (edges (map snd tr) ++ edges K) -> NoDup ((a, b) :: st) -> forall g, In g p ->
      (In g st \/ In (flip g) (edges (map snd tr))) /\ In g (edges (after tr K)) /\
      forall x v, ~ In (x, (v, fst g, snd g)) tr)).
    - intros K' m' a' b' v st' tr' p' G H V G' IH N Ns g I; cbn [map snd] in N.
      apply NoDup_cons_iff in Ns; destruct Ns as [Ns1 Ns2].
      apply (Step sC K' m' a' b' v st' st' tr' g G N Ns1); [auto|]; apply IH; auto.
      constructor; [|exact Ns2]; apply (Fresh _ _ _ _ _ _ _ G H); right; right; left; reflexivity.
    - intros K' m' a' b' v st' tr' p' G H V X Y G' IH N Ns g I; cbn [map snd] in N.
      apply NoDup_cons_iff in Ns; destruct Ns as [Ns1 Ns2].
      apply (Step sR K' m' a' b' v st' st' tr' g G N Ns1); [auto|]; apply IH; auto.
      constructor; [|exact Ns2]; apply (Fresh _ _ _ _ _ _ _ G H); left; reflexivity.
    - intros K' m' a' b' v st' tr' p' G H V X Y G' IH N Ns g I; cbn [map snd] in N.
      apply NoDup_cons_iff in Ns; destruct Ns as [Ns1 Ns2].
      apply (Step sL K' m' a' b' v st' st' tr' g G N Ns1); [auto|]; apply IH; auto.
      constructor; [|exact Ns2]; apply (Fresh _ _ _ _ _ _ _ G H); right; right; left; reflexivity.
    - intros K' m' a' b' v st' tr' p' G H V X Y G' IH N Ns g I; cbn [map snd] in N.
      apply NoDup_cons_iff in Ns; destruct Ns as [Ns1 Ns2].
      destruct (face_distinct M SM _ _ _ H) as (VA & VB & AB).
      assert (F1 : ~ In (v, b') st') by (apply (Fresh _ _ _ _ _ _ _ G H); right; right; left; reflexivity).
      assert (F2 : ~ In (a', v) st') by (apply (Fresh _ _ _ _ _ _ _ G H); left; reflexivity).
      apply (Step sS K' m' a' b' v st' ((a', v) :: st') tr' g G N Ns1).
      + intros e [<-|J]; [right; left; reflexivity|auto].
      + apply IH; auto; constructor; [|constructor; assumption].
        intros [J|J]; [congruence|contradiction].
    - intros K' m' a' b' v st' G H V X Y Q N Ns g I; cbn [map snd] in N.
      apply NoDup_cons_iff in Ns; destruct Ns as [Ns1 Ns2].
      split; [auto|split; [exact (Q g I)|]]; intros x w [J|[]]; injection J as _ _ E1 E2.
      apply Ns1; destruct g; cbn in *; congruence.
    - intros K' m' a0 b0 v passed a' b' rest tr' p' G H V X Y Q O G' IH N Ns g I; cbn [map snd] in N.
      apply NoDup_cons_iff in Ns; destruct Ns as [Ns1 Ns2]; apply in_app_iff in I; destruct I as [I|I].
      + split; [left; apply in_app_iff; auto|split; [rewrite after_cons; apply after_keeps, Q, I|]].
        intros x w [J|J].
        * injection J as _ _ E1 E2; apply Ns1; apply in_app_iff; left; destruct g; cbn in *; congruence.
        * apply Shift, NoDup_app_split in N; destruct N as (_ & _ & N); apply (N g); [|exact (Q g I)].
          apply in_flat_map; exists (w, fst g, snd g); split; [|destruct g; cbn; auto].
          apply in_map_iff; exists (x, (w, fst g, snd g)); auto.
      + apply (Step sE K' m' a0 b0 v (passed ++ (a', b') :: rest) rest tr' g G N Ns1).
        * intros e J; left; apply in_app_iff; right; right; exact J.
        * apply IH; auto; clear - Ns2; apply NoDup_app_split in Ns2; tauto.
  Qed.

  (** A left gate on the stack is passed over or gone on at. *)
  Lemma gate_or_passed : forall K m a b st tr p, Walk M K m a b st tr p ->
    (forall g, In g st -> In g p \/ exists x v, In (x, (v, fst g, snd g)) tr) /\
    forall t1 v c d t2, tr = t1 ++ (sS, (v, c, d)) :: t2 ->
      In (c, v) p \/ exists x w, In (x, (w, c, v)) t2.
  Proof.
    assert (Skip : forall (s : symbol) (f : face) tr (t1 : list step) v c d t2,
      (s, f) :: tr = t1 ++ (sS, (v, c, d)) :: t2 ->
      (s = sS /\ f = (v, c, d) /\ tr = t2) \/ exists t1', tr = t1' ++ (sS, (v, c, d)) :: t2).
    { intros s f tr [|y t1] v c d t2 E0; injection E0; intros; subst; eauto. }
    assert (Tail : forall (s : symbol) (f : face) (tr : list step) (p : list edge), (forall t1 v c d t2, tr = t1 ++ (sS, (v, c, d)) :: t2 ->
        In (c, v) p \/ exists x w, In (x, (w, c, v)) t2) -> s <> sS ->
      forall t1 v c d t2, (s, f) :: tr = t1 ++ (sS, (v, c, d)) :: t2 ->
        In (c, v) p \/ exists x w, In (x, (w, c, v)) t2).
    { intros s f tr p H D t1 v c d t2 E0; destruct (Skip _ _ _ _ _ _ _ _ E0) as [[A _]|[t1' A]];
        [contradiction|exact (H _ _ _ _ _ A)]. }
    induction 1 as [K m a b v st tr p H V W IH|K m a b v st tr p H V X Y W IH
      |K m a b v st tr p H V X Y W IH|K m a b v st tr p H V X Y W IH|K m a b v st H V X Y Q
      |K m a b v passed a' b' rest tr p H V X Y Q O W IH]; try destruct IH as [IH1 IH2].
    - split; [|apply Tail; [exact IH2|discriminate]].
      intros g I; destruct (IH1 g I) as [A|(x & w & A)]; [auto|right; exists x, w; right; exact A].
    - split; [|apply Tail; [exact IH2|discriminate]].
      intros g I; destruct (IH1 g I) as [A|(x & w & A)]; [auto|right; exists x, w; right; exact A].
    - split; [|apply Tail; [exact IH2|discriminate]].
      intros g I; destruct (IH1 g I) as [A|(x & w & A)]; [auto|right; exists x, w; right; exact A].
    - split.
      + intros g I; destruct (IH1 g (or_intror I)) as [A|(x & w & A)]; [auto|right; exists x, w; right; exact A].
      + intros t1 w c d t2 E0; destruct (Skip _ _ _ _ _ _ _ _ E0) as [(_ & A & ->)|[t1' A]].
        * injection A as -> -> ->; exact (IH1 (c, w) (or_introl eq_refl)).
        * exact (IH2 _ _ _ _ _ A).
    - split; [auto|]; intros [|y t1] w c d t2 E0; [discriminate|].
      injection E0; intros A _; destruct t1; discriminate.
    - split.
      + intros g I; apply in_app_iff in I; destruct I as [I|[<-|I]].
        * left; apply in_app_iff; auto.
        * right; inversion W; subst; do 2 eexists; right; left; reflexivity.
        * destruct (IH1 g I) as [A|(x & w & A)]; [left; apply in_app_iff; auto|right; exists x, w; right; exact A].
      + intros t1 w c d t2 E0; destruct (Skip _ _ _ _ _ _ _ _ E0) as [[A _]|[t1' A]]; [discriminate|].
        destruct (IH2 _ _ _ _ _ A) as [B|B]; [left; apply in_app_iff; auto|auto].
  Qed.
End Surface.

(** EB-HANDLE-1: an S has a record exactly if its left gate was passed over. *)
Theorem record_iff_passed : forall M tr p, surface M -> connected M -> encode M = Some (tr, p) ->
  forall t1 v a b t2, tr = t1 ++ (sS, (v, a, b)) :: t2 ->
  (closing (a, v) t2 <> None <-> In (a, v) p).
Proof.
  intros M tr p SM CM H t1 v a b t2 E0.
  destruct (encode_total M SM CM) as (tr' & p' & x0 & x1 & x2 & rest & E1 & E2 & W).
  rewrite H in E2; injection E2 as <- <-.
  assert (G := good_start M SM x0 x1 x2 rest E1).
  destruct (visited M SM _ _ _ _ _ _ _ W G) as (_ & N & _).
  apply (Permutation_NoDup (edges_after tr _)) in N.
  destruct (gate_or_passed M _ _ _ _ _ _ _ W) as [_ GP].
  assert (PN := passed_no_gate M SM _ _ _ _ _ _ _ W G N ltac:(constructor; [intros []|constructor])).
  destruct (from_step M SM _ _ _ _ _ _ _ W G _ _ _ _ _ _ E0) as (K' & m' & st' & p' & W' & G' & EK).
  clear E1 H; inversion W' as [| | |K0 m0 a0 b0 v0 st0 tr0 p0 Hf V X Y W2| |]; subst.
  destruct (face_distinct M SM _ _ _ Hf) as (VA & VB & AB).
  assert (N2 : NoDup (edges (map snd t2))).
  { apply NoDup_app_split in N; destruct N as (N & _); rewrite map_app, edges_app in N.
    apply NoDup_app_split in N; destruct N as (_ & N & _).
    change (edges (map snd ((sS, (v, a, b)) :: t2))) with (runs (v, a, b) ++ edges (map snd t2)) in N.
    apply NoDup_app_split in N; tauto. }
  split.
  - intros Cl; destruct (closing (a, v) t2) as [[j q]|] eqn:Ec; [clear Cl|congruence].
    destruct (GP _ _ _ _ _ eq_refl) as [A|(x & w & A)]; [exact A|exfalso].
    destruct (closing_where _ _ _ _ Ec) as (s1 & y & u & c & d & s2 & E3 & _ & D); subst t2.
    assert (N3 := N2); rewrite map_app, edges_app in N2; cbn [map snd] in N2.
    change (edges ((u, c, d) :: map snd s2)) with ((u, c) :: (c, d) :: (d, u) :: edges (map snd s2)) in N2.
    apply NoDup_app_split in N2; destruct N2 as (_ & N2 & N4).
    assert (Av : forall s, In (x, (w, a, v)) s -> In (a, v) (edges (map snd s))).
    { intros s I; apply in_flat_map; exists (w, a, v); split; [|cbn; auto].
      apply in_map_iff; exists (x, (w, a, v)); auto. }
    apply in_app_iff in A; destruct A as [A|[A|A]].
    + apply (N4 _ (Av _ A)); destruct D as [[_ ->]|[_ ->]]; cbn; auto.
    + injection A as _ _ -> ->.
      apply NoDup_cons_iff in N2; destruct N2 as [N2 N5]; apply NoDup_cons_iff in N5; destruct N5 as [N5 _].
      destruct D as [[_ D]|[_ D]]; rewrite D in *; [apply N5; left; reflexivity|apply N2; left; reflexivity].
    + apply NoDup_cons_iff in N2; destruct N2 as [N2 N5]; apply NoDup_cons_iff in N5; destruct N5 as [_ N5].
      apply NoDup_cons_iff in N5; destruct N5 as [N5 _].
      destruct D as [[_ D]|[_ D]]; rewrite <- D in *; [exact (N5 (Av _ A))|].
      apply N2; right; right; exact (Av _ A).
  - intros Ip Cl; destruct (PN _ Ip) as (_ & A & B); cbn [fst snd] in B.
    rewrite after_app, after_cons in A.
    apply (Permutation_in _ (edges_after t2 _)), in_app_iff in A; destruct A as [A|A].
    + destruct (edge_in_trace _ _ A) as (x & w & c & d & I & D).
      destruct (closing_none t2 (a, v) Cl x w c d I) as [D1 D2].
      destruct D as [D|[D|D]]; [congruence| |congruence].
      injection D as -> ->; apply (B x w); apply in_app_iff; right; right; exact I.
    + destruct A as [A|[A|[A|A]]]; congruence || contradiction.
Qed.

(** The decoder finds, from word and records, the side that closes each S. *)
Theorem told_is_items : forall M tr p, surface M -> connected M -> encode M = Some (tr, p) ->
  told (word_of tr) 0 (word_of tr) (records_of tr) = items tr.
Proof.
  intros M tr p SM CM H.
  destruct (encode_total M SM CM) as (tr' & p' & x0 & x1 & x2 & rest & E1 & E2 & W).
  rewrite H in E2; injection E2 as <- <-.
  assert (G := good_start M SM x0 x1 x2 rest E1).
  assert (Fst : forall t : list step, map fst (items t) = map fst t).
  { induction t as [|[[] [[v a] b]] t IH]; cbn [items map fst]; congruence. }
  transitivity (told (word_of tr) 0 (map fst (items tr)) (entries (word_of tr) 0 (items tr)));
    [rewrite Fst; reflexivity|apply told_entries].
  assert (A : forall t2 t1, tr = t1 ++ t2 -> forall x, In x (items t2) -> tellable (word_of tr) x).
  { induction t2 as [|[s [[v a] b]] t2 IH]; intros t1 E0 x I; [destruct I|].
    assert (IH' := IH (t1 ++ [(s, (v, a, b))]) ltac:(rewrite <- app_assoc; exact E0)).
    destruct s; cbn [items] in I; destruct I as [<-|I]; try exact (IH' x I); try reflexivity.
    cbn [tellable]; destruct (closing (a, v) t2) as [[j q]|] eqn:Cl; [|exact Logic.I].
    destruct (closed_by M SM _ _ _ _ _ _ _ W G _ _ _ _ _ _ _ E0 Cl) as (s1 & y & f & s2 & E3 & E4 & D).
    exists (map fst (t1 ++ [(sS, (v, a, b))] ++ s1)), y, (map fst s2); split; [|split].
    - unfold word_of; rewrite E0, E3, !map_app; cbn [map fst app]; rewrite map_app, <- app_assoc; reflexivity.
    - rewrite map_length; congruence.
    - destruct D as [[_ [-> | ->]]|[_ [-> | ->]]]; reflexivity. }
  exact (A tr [] eq_refl).
Qed.

(** From its stream alone the surface is glued. *)
Corollary decoded_from_stream : forall M tr p, surface M -> connected M -> encode M = Some (tr, p) ->
  exists pairs, glue (told (word_of tr) 0 (word_of tr) (records_of tr)) = Some pairs /\
    Permutation (both pairs) (sides 0 (whole M tr)) /\
    forall s r, In (s, r) pairs -> edge_at (whole M tr) r = flip (edge_at (whole M tr) s).
Proof.
  intros M tr p SM CM H; rewrite (told_is_items M tr p SM CM H).
  exact (handles_round_trip M tr p SM CM H).
Qed.

(** A stream is the stream of one surface, up to names. *)
Corollary same_stream_same_surface : forall M N trM trN pM pN,
  surface M -> connected M -> surface N -> connected N ->
  encode M = Some (trM, pM) -> encode N = Some (trN, pN) ->
  word_of trM = word_of trN -> records_of trM = records_of trN ->
  exists r, isomorphism r M N /\
    map (renamed r) (firstn 1 M ++ map snd trM) = firstn 1 N ++ map snd trN.
Proof.
  intros M N trM trN pM pN SM CM SN CN EM EN Wd Rc.
  apply (same_items_same_surface M N trM trN pM pN SM CM SN CN EM EN).
  rewrite <- (told_is_items M trM pM SM CM EM), <- (told_is_items N trN pN SN CN EN), Wd, Rc; reflexivity.
Qed.
