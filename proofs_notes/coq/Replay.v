(** Encoding what was decoded: the traversal of a disc spells its tree.

    EB-DECODE-1, second sentence, for one closed component of genus 0. [replay]: where the traversal
    enters a disc through its gate, it writes the word of its tree, visits its faces in their order,
    and goes on at the next gate of the stack. [encode_decode]: the traversal of a decoded word
    writes the word again, without records. *)
Require Import List Arith Lia Permutation.
Require Import Clers.Letters Clers.Words Clers.Meshes Clers.Discs Clers.Fans Clers.Decoder
  Clers.Traversal Clers.Visited Clers.Records.
Import ListNotations.
Open Scope nat_scope.

(** Go on at the gate on top of the stack, which has not been visited. *)
Definition resume (M K : list face) (m : list nat) (st : list edge) (tr : list step) : Prop :=
  match st with
  | [] => tr = []
  | (a, b) :: st => ~ In (a, b) (edges K) /\ Walk M K m a b st tr []
  end.

Lemma Walk_pop : forall M K m a b v st tr, has M a b v -> In v m ->
  In (v, b) (edges K) -> In (a, v) (edges K) -> resume M ((v, a, b) :: K) m st tr ->
  Walk M K m a b st ((sE, (v, a, b)) :: tr) [].
Proof.
  intros M K m a b v [|[a' b'] st] tr H V X Y Re; cbn [resume] in Re.
  - subst tr; apply Walk_end; auto; intros g [].
  - destruct Re as [O W]; exact (Walk_E M K m a b v [] a' b' st tr [] H V X Y (fun g (i : In g []) => match i with end) O W).
Qed.

Lemma replay : forall M t a b X ns F, disc t a b X ns F -> forall K m st tr,
  (forall x y z, has F x y z -> has M x y z) -> NoDup (edges F ++ edges K) ->
  (forall x y, In (x, y) ((a, b) :: path b X a) -> In (y, x) (edges K)) ->
  (forall x, In x (a :: b :: X) -> In x m) -> (forall x, In x ns -> ~ In x m) -> NoDup ns ->
  resume M (rev F ++ K) (rev ns ++ m) st tr ->
  Walk M K m a b st (combine (flat t) F ++ tr) [].
Proof.
  intros M t a b X ns F D; induction D as [a b v|t a b X v ns F NE D IH|t a b v X ns F D IH
    |t a b v X ns F D IH|u w a b v X1 X2 n1 n2 F1 F2 D1 IH1 D2 IH2];
    intros K m st tr In_M N Cl Mk New Nn Re;
    (assert (H : has M a b v) by (apply In_M; right; right; left; reflexivity)).
  - cbn [flat combine app]; apply Walk_pop; auto.
    + apply Mk; cbn; auto.
    + apply Cl; cbn; auto.
    + apply Cl; cbn; auto.
  - cbn [flat combine app].
    change (edges ((v, a, b) :: F)) with ((v, a) :: (a, b) :: (b, v) :: edges F) in N.
    apply Walk_C; [exact H|apply New; left; reflexivity|]; apply IH.
    + intros x y z J; apply In_M, has_cons; auto.
    + change (edges ((v, a, b) :: K)) with ((v, a) :: (a, b) :: (b, v) :: edges K).
      eapply Permutation_NoDup; [|exact N]; clear; permute.
    + intros x y [J|J]; [injection J as <- <-; right; right; left; reflexivity|].
      rewrite path_app in J; apply in_app_iff in J; destruct J as [J|[J|[]]].
      * right; right; right; apply Cl; right; exact J.
      * injection J as <- <-; left; reflexivity.
    + intros x J; cbn [In] in J; rewrite in_app_iff in J; cbn [In] in *.
      destruct J as [J|[J|[J|[J|[]]]]]; auto.
    + apply NoDup_cons_iff in Nn; destruct Nn as [Nv Nn].
      intros x J [<-|J']; [contradiction|exact (New x (or_intror J) J')].
    + apply NoDup_cons_iff in Nn; tauto.
    + cbn [rev] in Re; rewrite <- !app_assoc in Re; exact Re.
  - cbn [flat combine app].
    change (edges ((v, a, b) :: F)) with ((v, a) :: (a, b) :: (b, v) :: edges F) in N.
    destruct (disc_edges _ _ _ _ _ _ D) as [I P].
    apply Walk_R; [exact H|apply Mk; cbn; auto|apply Cl; cbn; auto| |apply IH]; auto.
    + apply NoDup_app_split in N; destruct N as (_ & _ & N); intros J; apply (N (a, v)); [|exact J].
      do 3 right; apply (Permutation_in _ (Permutation_sym P)); left; reflexivity.
    + intros x y z J; apply In_M, has_cons; auto.
    + change (edges ((v, a, b) :: K)) with ((v, a) :: (a, b) :: (b, v) :: edges K).
      eapply Permutation_NoDup; [|exact N]; clear; permute.
    + intros x y [J|J]; [injection J as <- <-; left; reflexivity|].
      do 3 right; apply Cl; right; right; exact J.
    + intros x J; apply Mk; cbn [In] in *; tauto.
    + cbn [rev] in Re; rewrite <- !app_assoc in Re; exact Re.
  - cbn [flat combine app].
    change (edges ((v, a, b) :: F)) with ((v, a) :: (a, b) :: (b, v) :: edges F) in N.
    destruct (disc_edges _ _ _ _ _ _ D) as [I P]; rewrite path_app in Cl; cbn [path] in Cl.
    apply Walk_L; [exact H|apply Mk; cbn; rewrite in_app_iff; cbn; auto| | |apply IH]; auto.
    + apply NoDup_app_split in N; destruct N as (_ & _ & N); intros J; apply (N (v, b)); [|exact J].
      do 3 right; apply (Permutation_in _ (Permutation_sym P)); left; reflexivity.
    + apply Cl; right; apply in_app_iff; cbn; auto.
    + intros x y z J; apply In_M, has_cons; auto.
    + change (edges ((v, a, b) :: K)) with ((v, a) :: (a, b) :: (b, v) :: edges K).
      eapply Permutation_NoDup; [|exact N]; clear; permute.
    + intros x y [J|J]; [injection J as <- <-; right; right; left; reflexivity|].
      do 3 right; apply Cl; right; apply in_app_iff; auto.
    + intros x J; apply Mk; cbn [In] in *; rewrite in_app_iff; cbn [In]; tauto.
    + cbn [rev] in Re; rewrite <- !app_assoc in Re; exact Re.
  - cbn [flat combine app].
    change (edges ((v, a, b) :: F1 ++ F2)) with ((v, a) :: (a, b) :: (b, v) :: edges (F1 ++ F2)) in N.
    rewrite edges_app in N; rewrite path_app in Cl.
    destruct (disc_edges _ _ _ _ _ _ D1) as [I1 P1], (disc_edges _ _ _ _ _ _ D2) as [I2 P2].
    destruct (disc_sizes _ _ _ _ _ _ D1) as (_ & _ & S1 & _).
    assert (G1 : In (v, b) (edges F1)) by (apply (Permutation_in _ (Permutation_sym P1)); left; reflexivity).
    assert (G2 : In (a, v) (edges F2)) by (apply (Permutation_in _ (Permutation_sym P2)); left; reflexivity).
    assert (N0 := N); apply NoDup_app_split in N0; destruct N0 as (_ & _ & N0).
    assert (V : In v m) by (apply Mk; cbn; rewrite in_app_iff; cbn; auto).
    apply NoDup_app_split in Nn; destruct Nn as (Nn1 & Nn2 & Nn).
    assert (Cb : forall l1 l2 : list symbol, length l1 = length F1 ->
      combine (l1 ++ l2) (F1 ++ F2) = combine l1 F1 ++ combine l2 F2).
    { clear; induction F1 as [|f F1 IH]; intros [|s l1] l2 sE; try discriminate; [reflexivity|].
      cbn [app combine]; f_equal; apply IH; cbn in sE; lia. }
    rewrite Cb by exact S1; rewrite <- app_assoc.
    apply Walk_S; auto.
    + intros J; apply (N0 (v, b)); [|exact J]; do 3 right; apply in_app_iff; auto.
    + intros J; apply (N0 (a, v)); [|exact J]; do 3 right; apply in_app_iff; auto.
    + apply IH1; auto.
      * intros x y z J; apply In_M, has_cons; right; apply has_app; auto.
      * change (edges ((v, a, b) :: K)) with ((v, a) :: (a, b) :: (b, v) :: edges K).
        assert (Q : NoDup (edges F2 ++ (edges F1 ++ (v, a) :: (a, b) :: (b, v) :: edges K))).
        { eapply Permutation_NoDup; [|exact N]; clear; permute. }
        apply NoDup_app_split in Q; tauto.
      * intros x y [J|J]; [injection J as <- <-; right; right; left; reflexivity|].
        do 3 right; apply Cl; right; apply in_app_iff; auto.
      * intros x J; apply Mk; cbn [In] in *; rewrite in_app_iff; cbn [In]; tauto.
      * intros x J; apply New, in_app_iff; auto.
      * assert (Q : NoDup (edges F2 ++ edges (rev F1 ++ (v, a, b) :: K))).
        { rewrite edges_app.
          assert (Rv : Permutation (edges (rev F1)) (edges F1)).
          { apply edges_perm; symmetry; apply Permutation_rev. }
          change (edges ((v, a, b) :: K)) with ((v, a) :: (a, b) :: (b, v) :: edges K).
          eapply Permutation_NoDup; [|exact N]; clear - Rv; permute. }
        split.
        -- apply NoDup_app_split in Q; destruct Q as (_ & _ & Q); exact (Q _ G2).
        -- apply IH2; auto.
           ++ intros x y z J; apply In_M, has_cons; right; apply has_app; auto.
           ++ intros x y J; rewrite edges_app; apply in_app_iff; right.
              destruct J as [J|J]; [injection J as <- <-; left; reflexivity|].
              do 3 right; apply Cl; right; apply in_app_iff; auto.
           ++ intros x J; apply in_app_iff; right; apply Mk; cbn [In] in *; rewrite in_app_iff; cbn [In]; tauto.
           ++ intros x J J'; apply in_app_iff in J'; destruct J' as [J'|J'].
              ** apply in_rev in J'; exact (Nn x J' J).
              ** apply (New x); [apply in_app_iff; auto|exact J'].
           ++ cbn [rev] in Re; rewrite !rev_app_distr, <- !app_assoc in Re; exact Re.
Qed.

Lemma combine_fst : forall (A B : Type) (l : list A) (m : list B), length l = length m ->
  map fst (combine l m) = l.
Proof.
  induction l as [|x l IH]; intros [|y m] sE; try discriminate; [reflexivity|].
  cbn; f_equal; apply IH; cbn in sE; lia.
Qed.

Lemma combine_snd : forall (A B : Type) (l : list A) (m : list B), length l = length m ->
  map snd (combine l m) = m.
Proof.
  induction l as [|x l IH]; intros [|y m] sE; try discriminate; [reflexivity|].
  cbn; f_equal; apply IH; cbn in sE; lia.
Qed.

Theorem encode_decode : forall w F, decode w = Some F ->
  exists tr, encode F = Some (tr, []) /\ map fst tr = w /\ F = (0, 1, 2) :: map snd tr.
Proof.
  intros w F H; assert (Sp := decoded_is_sphere _ _ H); destruct (decoded_counts _ _ H) as [Le _].
  apply decode_inv in H; destruct H as (t & G & O & -> & -> & D & N & Di).
  destruct (disc_sizes _ _ _ _ _ _ D) as (_ & _ & S3 & _).
  exists (combine (flat t) G); rewrite combine_fst, combine_snd by exact S3; repeat split; auto.
  unfold encode; rewrite <- (app_nil_r (combine (flat t) G)).
  assert (Fr := fresh_names (creations t)).
  apply Walk_is_walk; auto; [|rewrite app_nil_r, combine_length; lia].
  apply (replay _ t 2 1 [0] (seq 3 (creations t)) G D).
  - intros x y z J; apply has_cons; auto.
  - change (edges ((0, 1, 2) :: G)) with (edges [(0, 1, 2)] ++ edges G) in N.
    eapply Permutation_NoDup; [apply Permutation_app_comm|exact N].
  - intros x y J; cbn in J; cbn; intuition (try congruence);
      match goal with E0 : (_, _) = (_, _) |- _ => injection E0 as <- <-; auto end.
  - intros x J; cbn in *; tauto.
  - intros x J J'; apply in_seq in J; cbn in J'; lia.
  - apply seq_NoDup.
  - reflexivity.
Qed.
