(** The round trip of Edgebreaker on spheres, both ways.

    EB-DECODE-1, EB-DECODE-2 for one closed component of genus 0. [Replay.encode_decode] is one way.
    [decode_encode]: the word of a sphere is accepted, and decoded to the same sphere: renaming its
      vertices by the order of creation gives the faces of the sphere in the order of the visit.
    [accepted_words]: the words that the decoder accepts are exactly the words of spheres.
    [same_word_same_sphere]: spheres with one word are isomorphic, the first faces corner by corner. *)
Require Import List Arith Lia Permutation.
Require Import Clers.Letters Clers.Words Clers.Meshes Clers.Discs Clers.Fans Clers.Decoder
  Clers.Traversal Clers.Visited Clers.Records
  Clers.Replay Clers.Undoing.
Import ListNotations.
Open Scope nat_scope.

(** CPLX-ISO-1: a renaming, one-to-one on the vertices, that carries the faces onto the faces. *)
Definition isomorphism (r : nat -> nat) (F M : list face) : Prop :=
  (forall x y, In x (vertices F) -> In y (vertices F) -> r x = r y -> x = y) /\
  forall x y z, has M x y z <-> has (map (renamed r) F) x y z.

Lemma names : forall l pre, map (fun i => nth i (pre ++ l) 0) (seq (length pre) (length l)) = l.
Proof.
  induction l as [|x l IH]; intros pre; [reflexivity|]; cbn [length seq map].
  rewrite nth_middle; f_equal; specialize (IH (pre ++ [x])).
  rewrite app_length, <- app_assoc in IH; cbn [length app] in IH.
  replace (S (length pre)) with (length pre + 1) by lia; exact IH.
Qed.

Lemma edges_renamed : forall r F,
  edges (map (renamed r) F) = map (fun e => (r (fst e), r (snd e))) (edges F).
Proof.
  induction F as [|[[x y] z] F IH]; [reflexivity|].
  unfold edges in *; cbn [map renamed flat_map runs app fst snd]; rewrite IH; reflexivity.
Qed.

Lemma has_renamed : forall r F x y z, has F x y z -> has (map (renamed r) F) (r x) (r y) (r z).
Proof.
  unfold has; intros r F x y z [H|[H|H]]; apply (in_map (renamed r)) in H; cbn in H; auto.
Qed.

(** The order of creation: EB-ORDER-1. *)
Definition order (M : list face) (tr : list step) : list nat :=
  match M with [] => [] | (x, y, z) :: _ => x :: y :: z :: created tr end.

Theorem decode_encode : forall M, sphere M -> exists tr F,
  encode M = Some (tr, []) /\ decode (map fst tr) = Some F /\
  let r := fun i => nth i (order M tr) 0 in
  isomorphism r F M /\ map (renamed r) F = firstn 1 M ++ map snd tr.
Proof.
  intros M Sp; destruct (sphere_without_records M Sp) as [tr Enc]; destruct Sp as (SM & CM & _).
  destruct (encode_total M SM CM) as (tr' & p & x0 & x1 & x2 & rest & E0 & E1 & W).
  rewrite Enc in E1; injection E1 as <- <-.
  assert (G := good_start M SM x0 x1 x2 rest E0).
  destruct (walk_is_disc M SM x0 x1 x2 rest tr E0 W) as (t & D & Fl).
  destruct (visited M SM _ _ _ _ _ _ _ W G) as (_ & N & Nc & New & _).
  destruct (disc_sizes _ _ _ _ _ _ D) as (S1 & S2 & _ & O & _).
  set (F0 := draw t 2 1 [0] (seq 3 (creations t))).
  assert (D0 : disc t 2 1 [0] (seq 3 (creations t)) F0).
  { apply draw_is_disc; [exact O|exact S1|rewrite seq_length; reflexivity]. }
  assert (Ord : order M tr = [x0; x1; x2] ++ created tr) by (rewrite E0; reflexivity).
  set (r := fun i => nth i (order M tr) 0).
  assert (Nm : map r (seq 3 (creations t)) = created tr).
  { unfold r; rewrite Ord, S2; apply (names (created tr) [x0; x1; x2]). }
  assert (R0 : r 0 = x0) by (unfold r; rewrite Ord; reflexivity).
  assert (R1 : r 1 = x1) by (unfold r; rewrite Ord; reflexivity).
  assert (R2 : r 2 = x2) by (unfold r; rewrite Ord; reflexivity).
  assert (RF : map (renamed r) F0 = map snd tr).
  { assert (D1 := disc_renamed r _ _ _ _ _ _ D0); rewrite Nm in D1; cbn [map] in D1.
    rewrite R0, R1, R2 in D1; apply disc_is_drawn in D1; rewrite <- D1; apply disc_is_drawn, D. }
  set (F := (0, 1, 2) :: F0).
  assert (RM : map (renamed r) F = (x0, x1, x2) :: map snd tr).
  { unfold F; cbn [map renamed]; rewrite R0, R1, R2, RF; reflexivity. }
  assert (Has : forall x y z, has M x y z <-> has (map (renamed r) F) x y z).
  { intros x y z; rewrite (all_visited M SM x0 x1 x2 rest E0 tr [] W CM x y z), RM.
    unfold after, has; rewrite !in_app_iff, <- !in_rev; cbn [In]; tauto. }
  exists tr, F; split; [exact Enc|split; [|split; [split|]]].
  - rewrite Fl; apply decode_intro; auto.
    + fold F; apply (NoDup_map_inv (fun e => (r (fst e), r (snd e)))); rewrite <- edges_renamed, RM.
      apply (Permutation_NoDup (edges_after tr _)) in N.
      eapply Permutation_NoDup; [|exact N]; rewrite Permutation_app_comm; reflexivity.
    + fold F; intros x y z A B; apply (has_renamed r) in A; apply (has_renamed r) in B.
      apply Has in A; apply Has in B; exact (distinct M SM _ _ _ A B).
  - assert (No : NoDup (order M tr)).
    { rewrite Ord; destruct (face_distinct M SM x0 x1 x2) as (D1 & D2 & D3).
      { rewrite E0; left; left; reflexivity. }
      apply NoDup_app_join; auto; [repeat constructor; cbn; intuition congruence|].
      intros x I J; exact (New x J I). }
    assert (Lo : length (order M tr) = 3 + creations t) by (rewrite Ord, app_length, S2; reflexivity).
    assert (Bd : forall x, In x (vertices F) -> x < length (order M tr)).
    { intros x I; change (vertices F) with ([0; 1; 2] ++ vertices F0) in I.
      rewrite in_app_iff, (disc_vertices _ _ _ _ _ _ D0) in I; cbn [In app] in I; rewrite in_seq in I; lia. }
    intros x y I J; apply (proj1 (NoDup_nth (order M tr) 0) No x y); auto.
  - exact Has.
  - change (map (renamed r) F = firstn 1 M ++ map snd tr); rewrite RM, E0; reflexivity.
Qed.

(** The decoder accepts exactly the words of spheres: EB-DECODE-2. *)
Corollary accepted_words : forall w, (exists F, decode w = Some F) <->
  exists M tr, sphere M /\ encode M = Some (tr, []) /\ map fst tr = w.
Proof.
  intros w; split.
  - intros [F H]; destruct (encode_decode w F H) as (tr & E0 & E1 & _).
    exists F, tr; repeat split; try apply (decoded_is_sphere w F H); auto.
  - intros (M & tr & Sp & E0 & <-); destruct (decode_encode M Sp) as (tr' & F & E1 & H & _).
    rewrite E0 in E1; injection E1 as <-; eauto.
Qed.

(** Two spheres with one word are both the decoded one under other names. *)
Corollary same_word_same_sphere : forall M N trM trN, sphere M -> sphere N ->
  encode M = Some (trM, []) -> encode N = Some (trN, []) -> map fst trM = map fst trN ->
  exists F r s, isomorphism r F M /\ isomorphism s F N /\
    map (renamed r) F = firstn 1 M ++ map snd trM /\ map (renamed s) F = firstn 1 N ++ map snd trN.
Proof.
  intros M N trM trN SM SN EM EN H.
  destruct (decode_encode M SM) as (tr & F & E1 & D1 & I1 & J1).
  destruct (decode_encode N SN) as (tr' & F' & E2 & D2 & I2 & J2).
  rewrite EM in E1; injection E1 as <-; rewrite EN in E2; injection E2 as <-.
  rewrite H, D2 in D1; injection D1 as ->; eauto 8.
Qed.
