(** Two decoders agree: the fold and Spirale Reversi give the same faces.

    EB-DECODE-3, for these two decoders and one closed component of genus 0: on every word that the
    fold accepts ([Decoder.decode]), Spirale Reversi ([Rebuild.decode_stream]) gives the same list of
    faces, vertex by vertex. *)
Require Import List Arith Lia Permutation.
Require Import Clers.Letters Clers.Words Clers.Meshes Clers.Discs Clers.Decoder Clers.Traversal
  Clers.Visited Clers.Records Clers.Replay Clers.Reversi Clers.Sides Clers.Round_trip
  Clers.Numbering Clers.Stream Clers.Rebuild.
Import ListNotations.
Open Scope nat_scope.

Lemma created_of_disc : forall t a b X ns F, disc t a b X ns F -> created (combine (flat t) F) = ns.
Proof.
  induction 1 as [a b v|t a b X v ns F NE D IH|t a b v X ns F D IH|t a b v X ns F D IH
    |u w a b v X1 X2 n1 n2 F1 F2 D1 IH1 D2 IH2]; cbn [flat combine].
  - reflexivity.
  - change (created ((sC, (v, a, b)) :: combine (flat t) F)) with (v :: created (combine (flat t) F)).
    rewrite IH; reflexivity.
  - exact IH.
  - exact IH.
  - change (created ((sS, (v, a, b)) :: combine (flat u ++ flat w) (F1 ++ F2)))
      with (created (combine (flat u ++ flat w) (F1 ++ F2))).
    destruct (disc_sizes _ _ _ _ _ _ D1) as (_ & _ & S1 & _).
    assert (A : forall l1 l2 G1 G2, length l1 = length G1 ->
      created (combine (l1 ++ l2) (G1 ++ G2)) = created (combine l1 G1) ++ created (combine l2 G2)).
    { clear; induction l1 as [|s l1 IH]; intros l2 [|f G1] G2 E; try discriminate; [reflexivity|].
      cbn [app combine]; unfold created in *; cbn [flat_map]; rewrite IH by (cbn in E; lia).
      apply app_assoc. }
    rewrite A, IH1, IH2 by exact S1; reflexivity.
Qed.

(** Without gates passed over there are no records. *)
Lemma no_records : forall M tr, surface M -> connected M -> encode M = Some (tr, []) ->
  records_of tr = [].
Proof.
  intros M tr SM CM H; assert (R := record_iff_passed M tr [] SM CM H).
  assert (None_all : forall x, In x (items tr) -> snd x = None).
  { assert (A : forall t2 t1, tr = t1 ++ t2 -> forall x, In x (items t2) -> snd x = None).
    { induction t2 as [|[s [[v a] b]] t2 IH]; intros t1 E0 x I; [destruct I|].
      assert (IH' := IH (t1 ++ [(s, (v, a, b))]) ltac:(rewrite <- app_assoc; exact E0)).
      destruct s; cbn [items] in I; destruct I as [<-|I]; try exact (IH' x I); try reflexivity.
      cbn [snd]; destruct (closing (a, v) t2) eqn:Cl; [exfalso|reflexivity].
      apply (proj1 (R t1 v a b t2 E0)); rewrite Cl; discriminate. }
    exact (A tr [] eq_refl). }
  unfold records_of; generalize 0 as s; revert None_all; generalize (items tr) as l.
  induction l as [|[x c] l IH]; intros N s; [reflexivity|].
  assert (N0 := N (x, c) (or_introl eq_refl)); cbn in N0; subst c.
  destruct x; cbn [entries]; apply IH; intros y I; apply N; right; exact I.
Qed.

Theorem fold_and_reversi_agree : forall w F, decode w = Some F -> decode_stream w [] = Some F.
Proof.
  intros w F H; destruct (decoded_is_sphere w F H) as (SF & CF & _).
  assert (Inv := decode_inv w F H); destruct Inv as (t & G & O & Ew & EF & D & _).
  destruct (encode_decode w F H) as (tr & En & Wd & Fs).
  destruct (decode_stream_encode F tr [] SF CF En) as (F2 & D2 & _ & Fs2 & Bd).
  rewrite (no_records F tr SF CF En) in D2.
  change (word_of tr) with (map fst tr) in D2; rewrite Wd in D2; rewrite D2; f_equal.
  assert (Ftr : map snd tr = G) by (rewrite EF in Fs; injection Fs; auto).
  assert (Tr : tr = combine (flat t) G).
  { rewrite <- Ew, <- Wd, <- Ftr; clear; induction tr as [|[x f] tr IH]; [reflexivity|].
    cbn; rewrite <- IH; reflexivity. }
  assert (Ord : order F tr = seq 0 (3 + creations t)).
  { rewrite EF, Tr; cbn [order]; rewrite (created_of_disc _ _ _ _ _ _ D); reflexivity. }
  assert (Id : forall x, In x (vertices F2) -> nth x (order F tr) 0 = x).
  { intros x I; specialize (Bd x I); rewrite Ord in *; rewrite seq_length in Bd; apply seq_nth, Bd. }
  assert (Same : map (renamed (fun i => nth i (order F tr) 0)) F2 = F2).
  { rewrite <- (map_id F2) at 2; apply map_ext_in; intros [[x y] z] I; cbn [renamed].
    assert (V : forall u, In u [x; y; z] -> nth u (order F tr) 0 = u).
    { intros u J; apply Id, in_flat_map; exists (x, y, z); auto. }
    rewrite !V by (cbn; auto); reflexivity. }
  rewrite Same in Fs2; rewrite Fs2, EF; cbn [firstn app]; rewrite <- Ftr; reflexivity.
Qed.
