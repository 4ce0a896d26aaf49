(** The decoder of one connected closed surface of any genus, from its stream to a face list.

    EB-DECODE-1, EB-REVERSI-3, EB-ORDER-1, EB-ORDER-3: the word and the records are undone and glued
    ([Reversi.glue]); then each corner turns around its vertex to the corner that created it, P's or
    a C's, whose number in the order of creation it takes. [decode_stream_encode]: the stream of a
    connected closed surface is decoded to that surface under other names, vertices and faces in the
    order of creation. *)
Require Import List Arith Lia Permutation Relation_Operators.
Require Import Clers.Letters Clers.Words Clers.Meshes Clers.Discs Clers.Traversal Clers.Visited
  Clers.Records Clers.Undoing Clers.Reversi Clers.Sides Clers.Handles Clers.Round_trip
  Clers.Handles_round_trip Clers.Numbering Clers.Stream.
Import ListNotations.
Open Scope nat_scope.

Fixpoint mate (pairs : list (side * side)) (s : side) : option side :=
  match pairs with
  | [] => None
  | (x, y) :: pairs =>
      if side_eq_dec x s then Some y else if side_eq_dec y s then Some x else mate pairs s
  end.

(** The next corner around the vertex where a side begins: CPLX-CORNER-4. *)
Definition turn (pairs : list (side * side)) (s : side) : side :=
  match mate pairs (before_side s) with Some r => r | None => s end.

(** The sides that begin at the vertices of P, and at the vertex of each C in turn. *)
Fixpoint creating (w : list symbol) : list side :=
  match w with
  | [] => []
  | sC :: w => (length w, at_left) :: creating w
  | _ :: w => creating w
  end.
Definition creators (w : list symbol) : list side :=
  (length w, at_left) :: (length w, at_gate) :: (length w, at_right) :: creating w.

Fixpoint index (s : side) (l : list side) : option nat :=
  match l with
  | [] => None
  | r :: l => if side_eq_dec r s then Some 0 else option_map S (index s l)
  end.

Fixpoint number (n : nat) (pairs : list (side * side)) (c : list side) (s : side) : nat :=
  match index s c, n with
  | Some i, _ => i
  | None, 0 => 0
  | None, S n => number n pairs c (turn pairs s)
  end.

Definition decode_stream (w : list symbol) (rs : list entry) : option (list face) :=
  match glue (told w 0 w rs) with
  | None => None
  | Some pairs =>
      let v := number (3 * length w + 3) pairs (creators w) in
      Some (map (fun i => (v (i, at_left), v (i, at_gate), v (i, at_right)))
                (rev (seq 0 (length w + 1))))
  end.

Lemma mate_found : forall pairs s r, NoDup (both pairs) ->
  In (s, r) pairs \/ In (r, s) pairs -> mate pairs s = Some r.
Proof.
  induction pairs as [|[x y] pairs IH]; intros s r N I; [destruct I as [[]|[]]|].
  cbn [both flat_map app fst snd] in N; apply NoDup_cons_iff in N; destruct N as [N1 N].
  apply NoDup_cons_iff in N; destruct N as [N2 N]; cbn [mate].
  assert (B : forall p q, In (p, q) pairs -> In p (both pairs) /\ In q (both pairs)).
  { intros p q J; split; apply in_flat_map; exists (p, q); cbn; auto. }
  destruct I as [[I|I]|[I|I]].
  - injection I as -> ->; destruct (side_eq_dec s s); congruence.
  - destruct (B _ _ I) as [B1 B2].
    destruct (side_eq_dec x s) as [->|]; [destruct N1; right; exact B1|].
    destruct (side_eq_dec y s) as [->|]; [destruct N2; exact B1|auto].
  - injection I as -> ->; destruct (side_eq_dec r s) as [->|]; [reflexivity|].
    destruct (side_eq_dec s s); congruence.
  - destruct (B _ _ I) as [B1 B2].
    destruct (side_eq_dec x s) as [->|]; [destruct N1; right; exact B2|].
    destruct (side_eq_dec y s) as [->|]; [destruct N2; exact B2|auto].
Qed.

Lemma index_nth : forall l s i d, index s l = Some i -> nth i l d = s /\ i < length l.
Proof.
  induction l as [|r l IH]; intros s i d H; [discriminate|]; cbn [index] in H.
  destruct (side_eq_dec r s) as [->|D]; [injection H as <-; cbn; auto with arith|].
  destruct (index s l) as [j|] eqn:E; [|discriminate]; injection H as <-.
  destruct (IH s j d E); cbn; split; [assumption|lia].
Qed.

Lemma index_in : forall l s, In s l -> index s l <> None.
Proof.
  induction l as [|r l IH]; intros s I; [destruct I|]; cbn [index].
  destruct (side_eq_dec r s); [discriminate|]; destruct I as [I|I]; [contradiction|].
  specialize (IH s I); destruct (index s l); cbn; congruence.
Qed.

(** A deterministic walk in a finite set reaches what it reaches in few steps. *)
Fixpoint iterate (f : side -> side) (k : nat) (s : side) : side :=
  match k with 0 => s | S k => iterate f k (f s) end.

Lemma iterate_add : forall f i j s, iterate f (i + j) s = iterate f j (iterate f i s).
Proof. induction i; intros; cbn [Nat.add iterate]; auto. Qed.

Lemma least : forall f s c k, iterate f k s = c ->
  exists m, m <= k /\ iterate f m s = c /\ forall j, j < m -> iterate f j s <> c.
Proof.
  intros f s c; assert (A : forall k, (exists m, m <= k /\ iterate f m s = c /\
    forall j, j < m -> iterate f j s <> c) \/ forall j, j <= k -> iterate f j s <> c).
  { induction k as [|k [(m & L & E & M)|IH]].
    - destruct (side_eq_dec (iterate f 0 s) c) as [E|D].
      + left; exists 0; repeat split; auto; intros j J; lia.
      + right; intros j J; replace j with 0 by lia; exact D.
    - left; exists m; repeat split; auto.
    - destruct (side_eq_dec (iterate f (S k) s) c) as [E|D].
      + left; exists (S k); repeat split; auto; intros j J; apply IH; lia.
      + right; intros j J; destruct (Nat.eq_dec j (S k)) as [->|N]; [exact D|apply IH; lia]. }
  intros k E; destruct (A k) as [B|B]; [exact B|destruct (B k (le_n k) E)].
Qed.

Lemma NoDup_map_on : forall (A B : Type) (f : A -> B) l, NoDup l ->
  (forall x y, In x l -> In y l -> f x = f y -> x = y) -> NoDup (map f l).
Proof.
  induction l as [|x l IH]; intros N H; cbn [map]; [constructor|].
  apply NoDup_cons_iff in N; destruct N as [N1 N2]; constructor.
  - intros I; apply in_map_iff in I; destruct I as (y & E & I).
    apply N1; rewrite (H x y); auto; [left; reflexivity|right; exact I].
  - apply IH; auto; intros y z I J; apply H; right; assumption.
Qed.

Lemma few_steps : forall f l s c k, (forall j, In (iterate f j s) l) -> iterate f k s = c ->
  exists m, m < length l /\ iterate f m s = c.
Proof.
  intros f l s c k Cl E; destruct (least f s c k E) as (m & _ & Em & Mi).
  exists m; split; [|exact Em].
  assert (N : NoDup (map (fun i => iterate f i s) (seq 0 (m + 1)))).
  { apply NoDup_map_on; [apply seq_NoDup|].
    assert (W : forall i j, i < j -> j <= m -> iterate f i s <> iterate f j s).
    { intros i j L1 L2 X; apply (Mi (i + (m - j))); [lia|].
      rewrite iterate_add, X, <- iterate_add; replace (j + (m - j)) with m by lia; exact Em. }
    intros i j I J X; apply in_seq in I; apply in_seq in J.
    destruct (Nat.lt_trichotomy i j) as [L|[L|L]]; [|exact L|].
    - destruct (W i j L ltac:(lia) X).
    - destruct (W j i L ltac:(lia) (eq_sym X)). }
  assert (Ic : incl (map (fun i => iterate f i s) (seq 0 (m + 1))) l).
  { intros x I; apply in_map_iff in I; destruct I as (i & <- & _); apply Cl. }
  apply (NoDup_incl_length N) in Ic; rewrite map_length, seq_length in Ic; lia.
Qed.

Lemma number_found : forall n pairs c s k, k <= n -> In (iterate (turn pairs) k s) c ->
  exists j, In (iterate (turn pairs) j s) c /\
    index (iterate (turn pairs) j s) c = Some (number n pairs c s).
Proof.
  induction n as [|n IH]; intros pairs c s k L I.
  - replace k with 0 in I by lia; cbn [iterate] in I; exists 0; cbn [iterate number].
    destruct (index s c) eqn:E; [auto|destruct (index_in _ _ I E)].
  - cbn [number]; destruct (index s c) as [i|] eqn:E.
    + exists 0; cbn [iterate]; split; [|exact E].
      destruct (in_dec side_eq_dec s c) as [J|J]; [exact J|exfalso; clear - E J].
      destruct (index_nth _ _ _ s E) as [A B]; apply J; rewrite <- A; apply nth_In, B.
    + destruct k as [|k]; [destruct (index_in _ _ I E)|]; cbn [iterate] in I.
      destruct (IH pairs c (turn pairs s) k ltac:(lia) I) as (j & A & B); exists (S j); auto.
Qed.

Section Surface.
  Variables (M : list face) (tr : list step) (p : list edge).
  Hypothesis SM : surface M.
  Hypothesis CM : connected M.
  Hypothesis walked : encode M = Some (tr, p).
  Let T := whole M tr.
  Let phi := edge_at T.
  Let w := word_of tr.

  Lemma order_once : NoDup (order M tr) /\ forall x, In x (vertices M) -> In x (order M tr).
  Proof.
    destruct (encode_total M SM CM) as (tr' & p' & x0 & x1 & x2 & rest & E0 & E1 & W).
    rewrite walked in E1; injection E1 as <- <-.
    assert (G := good_start M SM x0 x1 x2 rest E0).
    destruct (visited M SM _ _ _ _ _ _ _ W G) as (_ & _ & Nc & New & V).
    assert (Ord : order M tr = [x0; x1; x2] ++ created tr) by (rewrite E0; reflexivity).
    destruct (face_distinct M SM x0 x1 x2) as (D1 & D2 & D3); [rewrite E0; left; left; reflexivity|].
    rewrite Ord; split.
    - apply NoDup_app_join; auto; [repeat constructor; cbn; intuition congruence|].
      intros x I J; exact (New x J I).
    - intros x I; apply in_app_iff, V; apply vertex_has in I; destruct I as (y & z & I).
      apply (all_visited M SM x0 x1 x2 rest E0 tr p W CM) in I; apply has_vertex with y z, I.
  Qed.

  Lemma creators_begin : map (fun s => fst (phi s)) (creators w) = order M tr /\
    incl (creators w) (sides 0 T).
  Proof.
    assert (TE : exists x0 x1 x2 rest, M = (x0, x1, x2) :: rest).
    { assert (NE := not_empty M SM); destruct M as [|[[x y] z] rest]; [congruence|eauto]. }
    destruct TE as (x0 & x1 & x2 & rest & E0).
    assert (ET : T = [] ++ (sC, (x0, x1, x2)) :: tr) by (unfold T; rewrite E0; reflexivity).
    assert (Lw : length w = length tr) by (unfold w, word_of; apply map_length).
    assert (Here := fun q => edge_at_here [] sC (x0, x1, x2) tr q); cbn [app] in Here.
    assert (A : forall t pre, T = pre ++ t -> map (fun s => fst (phi s)) (creating (map fst t)) = created t
      /\ incl (creating (map fst t)) (sides 0 t)).
    { induction t as [|[x [[v a] b]] t IH]; intros pre E1; [split; [reflexivity|intros s []]|].
      destruct (IH (pre ++ [(x, (v, a, b))]) ltac:(rewrite <- app_assoc; exact E1)) as [A B].
      assert (B' : incl (creating (map fst t)) (sides 0 ((x, (v, a, b)) :: t))).
      { intros s I; cbn [sides]; apply in_app_iff; auto. }
      destruct x; cbn [map fst creating]; try (split; [exact A|exact B']).
      split.
      - cbn [map]; rewrite map_length; unfold phi at 1; rewrite E1, edge_at_here; cbn [edge_of fst].
        change (created ((sC, (v, a, b)) :: t)) with (v :: created t); f_equal; exact A.
      - intros s [<-|I]; [|exact (B' s I)]; rewrite map_length; cbn; auto. }
    destruct (A tr [(sC, (x0, x1, x2))] ET) as [A1 A2]; unfold creators; split.
    - cbn [map]; unfold phi at 1 2 3; rewrite ET; cbn [app]; rewrite Lw, !Here; cbn [edge_of fst].
      rewrite E0; cbn [order]; do 3 f_equal; exact A1.
    - rewrite ET; cbn [app sides]; rewrite Lw; intros s [<-|[<-|[<-|I]]]; try (cbn; tauto).
      apply in_app_iff; right; exact (A2 s I).
  Qed.

  Variable pairs : list (side * side).
  Hypothesis glued_all : Permutation (both pairs) (sides 0 T).
  Hypothesis glued_right : forall s r, In (s, r) pairs -> phi r = flip (phi s).

  Lemma turn_swings : forall s r, swing M tr pairs s r -> turn pairs s = r.
  Proof.
    intros s r [I Ma]; unfold turn; rewrite (mate_found pairs _ r); [reflexivity| |exact Ma].
    destruct (whole_is_M M tr p SM CM walked) as [NT _].
    exact (Permutation_NoDup (Permutation_sym glued_all) (sides_once T NT)).
  Qed.

  Lemma turn_stays : forall s, In s (sides 0 T) -> In (turn pairs s) (sides 0 T) /\
    fst (phi (turn pairs s)) = fst (phi s).
  Proof.
    intros s I; destruct (before_here M tr p SM CM walked s I) as (x & y & z & _ & _ & _ & B).
    destruct (mate_exists M tr pairs glued_all _ B) as (r & Ma & Ir).
    assert (Sw : swing M tr pairs s r) by (split; assumption).
    rewrite (turn_swings s r Sw); split; [exact Ir|].
    exact (swing_stays M tr p SM CM walked pairs glued_right s r Sw).
  Qed.

  Lemma turns_stay : forall k s, In s (sides 0 T) -> In (iterate (turn pairs) k s) (sides 0 T) /\
    fst (phi (iterate (turn pairs) k s)) = fst (phi s).
  Proof.
    induction k as [|k IH]; intros s I; cbn [iterate]; [auto|].
    destruct (turn_stays s I) as [A B]; destruct (IH _ A) as [D E]; split; [exact D|congruence].
  Qed.

  Lemma turns_reach : forall s r, clos_refl_trans side (swing M tr pairs) s r ->
    exists k, iterate (turn pairs) k s = r.
  Proof.
    induction 1 as [s r Sw|s|s q r _ [i A] _ [j B]].
    - exists 1; exact (turn_swings s r Sw).
    - exists 0; reflexivity.
    - exists (i + j); rewrite iterate_add, A; exact B.
  Qed.

  Lemma sides_length : forall k t, length (sides k t) = 3 * length t.
  Proof. induction t as [|x t IH]; [reflexivity|]; cbn [sides]; rewrite app_length, IH; cbn; lia. Qed.

  (** The number of a corner is that of its vertex in the order of creation. *)
  Lemma number_right : forall s, In s (sides 0 T) ->
    let i := number (3 * length w + 3) pairs (creators w) s in
    i < length (order M tr) /\ nth i (order M tr) 0 = fst (phi s).
  Proof.
    intros s I i; destruct creators_begin as [Cb Ci].
    assert (Iv : In (fst (phi s)) (order M tr)).
    { destruct (before_here M tr p SM CM walked s I) as (x & y & z & H & P1 & _).
      fold T phi in P1; rewrite P1; apply order_once, has_vertex with y z, H. }
    rewrite <- Cb in Iv; apply in_map_iff in Iv; destruct Iv as (c & Pc & Ic).
    assert (R := swings_reach M tr p SM CM walked pairs glued_all glued_right s c I (Ci c Ic) (eq_sym Pc)).
    destruct (turns_reach s c R) as [k Ek].
    destruct (few_steps (turn pairs) (sides 0 T) s c k (fun j => proj1 (turns_stay j s I)) Ek) as (m & Lm & Em).
    assert (Lt : length T = length w + 1).
    { unfold T; rewrite whole_length by apply (not_empty M SM); unfold w, word_of; rewrite map_length; lia. }
    rewrite sides_length, Lt in Lm.
    destruct (number_found (3 * length w + 3) pairs (creators w) s m ltac:(lia)) as (j & Jc & Ji).
    { rewrite Em; exact Ic. }
    fold i in Ji; destruct (index_nth _ _ _ (0, at_gate) Ji) as [Nx Li].
    rewrite <- Cb, map_length; split; [exact Li|].
    rewrite (nth_indep _ 0 (fst (phi (0, at_gate)))) by (rewrite map_length; exact Li).
    rewrite (map_nth (fun s => fst (phi s))), Nx; apply (turns_stay j s I).
  Qed.
End Surface.

(** EB-DECODE-1: decoding the stream of a surface gives the surface, in the order of creation. *)
Theorem decode_stream_encode : forall M tr p, surface M -> connected M -> encode M = Some (tr, p) ->
  exists F, decode_stream (word_of tr) (records_of tr) = Some F /\
  let r := fun i => nth i (order M tr) 0 in
  isomorphism r F M /\ map (renamed r) F = firstn 1 M ++ map snd tr /\
  forall x, In x (vertices F) -> x < length (order M tr).
Proof.
  intros M tr p SM CM H.
  destruct (decoded_from_stream M tr p SM CM H) as (pairs & Gl & All & Right).
  set (T := whole M tr) in *; set (w := word_of tr) in *.
  assert (Num := number_right M tr p SM CM H pairs All Right); cbv zeta in Num; fold T w in Num.
  set (v := number (3 * length w + 3) pairs (creators w)) in *.
  set (f := fun i => (v (i, at_left), v (i, at_gate), v (i, at_right))).
  set (r := fun i => nth i (order M tr) 0).
  exists (map f (rev (seq 0 (length w + 1)))); unfold decode_stream; rewrite Gl; split; [reflexivity|].
  assert (NE := not_empty M SM).
  assert (Lt : length T = length w + 1).
  { unfold T; rewrite whole_length by exact NE; unfold w, word_of; rewrite map_length; lia. }
  assert (Faces : map (renamed r) (map f (rev (seq 0 (length w + 1)))) = map snd T).
  { rewrite <- Lt; assert (A : forall t pre, T = pre ++ t ->
      map (renamed r) (map f (rev (seq 0 (length t)))) = map snd t).
    { induction t as [|[x [[u a] b]] t IH]; intros pre E0; [reflexivity|].
      cbn [length]; rewrite seq_S, rev_app_distr; cbn [rev app map snd Nat.add].
      rewrite (IH (pre ++ [(x, (u, a, b))])) by (rewrite <- app_assoc; exact E0); f_equal.
      assert (Q : forall q, r (v (length t, q)) = fst (edge_of (u, a, b) q)).
      { intros q; unfold r; rewrite (proj2 (Num (length t, q) ltac:(rewrite E0, sides_app;
          apply in_app_iff; right; cbn [sides]; apply in_app_iff; left; destruct q; cbn; auto))).
        rewrite E0 at 1; rewrite edge_at_here; reflexivity. }
      unfold f; cbn [renamed]; rewrite !Q; reflexivity. }
    exact (A T [] eq_refl). }
  assert (HM := proj2 (whole_is_M M tr p SM CM H)); fold T in HM.
  assert (Bd : forall x, In x (vertices (map f (rev (seq 0 (length w + 1))))) -> x < length (order M tr)).
    { intros x I; apply in_flat_map in I; destruct I as (g & I & J).
      apply in_map_iff in I; destruct I as (i & <- & I); apply in_rev, in_seq in I.
      assert (Sd : forall q, In (i, q) (sides 0 T)).
      { intros q; assert (A : forall t, i < length t -> In (i, q) (sides 0 t)).
        { induction t as [|y t IH]; intros L; cbn [length] in L; [lia|]; cbn [sides]; apply in_app_iff.
          destruct (Nat.eq_dec i (length t)) as [->|D]; [left; destruct q; cbn; auto|right; apply IH; lia]. }
        apply A; lia. }
      destruct J as [<-|[<-|[<-|[]]]]; apply Num, Sd. }
  split; [split|split; [|exact Bd]].
  - destruct (order_once M tr p SM CM H) as [No _].
    intros x y Ix Iy E0; apply (proj1 (NoDup_nth (order M tr) 0) No x y); auto.
  - intros x y z; rewrite HM, Faces; reflexivity.
  - rewrite Faces; unfold T; destruct M; [congruence|reflexivity].
Qed.

(** The torus of section 5.7: its word, its two records, and its faces in the order of creation. *)
Definition torus : list face :=
  [(0, 3, 4); (0, 4, 1); (1, 4, 5); (1, 5, 2); (2, 5, 3); (2, 3, 0);
   (3, 6, 7); (3, 7, 4); (4, 7, 8); (4, 8, 5); (5, 8, 6); (5, 6, 3);
   (6, 0, 1); (6, 1, 7); (7, 1, 2); (7, 2, 8); (8, 2, 0); (8, 0, 6)].

Example torus_stream : option_map (fun x => (word_of (fst x), records_of (fst x))) (encode torus)
  = Some ([sC; sC; sC; sC; sR; sC; sS; sC; sR; sS; sS; sR; sL; sS; sE; sE; sE],
          [(0, 6, at_right); (1, 5, at_right)]).
Proof. vm_compute; reflexivity. Qed.
