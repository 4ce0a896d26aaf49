(** * An operator makes a sheet of a sheet

    Clauses: OPER-SHEET-5, its first sentence, but for the condition of OPER-SHEET-2 at each vertex
    and for two triangles on three vertices. *)

Require Import ZArith List Lia Arith Bool Permutation Relation_Operators.
From Clers Require Import Graph Sheets.
Import ListNotations.

Lemma path_fst : forall l x, map fst (path x l) = removelast (x :: l).
Proof.
  induction l as [|y l IH]; intros x; [reflexivity|].
  cbn [path map]; rewrite IH; reflexivity.
Qed.
Lemma cycle_fst : forall l, map fst (cycle l) = l.
Proof.
  destruct l as [|x l]; [reflexivity|]; unfold cycle; rewrite path_fst.
  change (x :: l ++ [x]) with ((x :: l) ++ [x]); apply removelast_last.
Qed.
Lemma cycle_length : forall l, length (cycle l) = length l.
Proof.
  intros l; transitivity (length (map fst (cycle l))); [symmetry; apply map_length|].
  rewrite cycle_fst; reflexivity.
Qed.

Lemma path_in : forall l x e, In e (path x l) -> In (fst e) (x :: l) /\ In (snd e) l.
Proof.
  induction l as [|y l IH]; intros x e H; [destruct H|]; destruct H as [<-|H].
  - cbn; auto.
  - apply IH in H; cbn in *; tauto.
Qed.
Lemma cycle_in : forall l e, In e (cycle l) -> In (fst e) l /\ In (snd e) l.
Proof.
  destruct l as [|x l]; intros e H; [destruct H|]; unfold cycle in H; apply path_in in H.
  destruct H as [A B]; cbn [In] in *; rewrite in_app_iff in *; cbn [In] in *; tauto.
Qed.

Lemma path_snoc : forall l x y z, path x (l ++ [y; z]) = path x (l ++ [y]) ++ [(y, z)].
Proof. intros l x y z; rewrite (path_app l x y [z]); reflexivity. Qed.

(** The sides of a list run backwards. *)
Lemma path_rev : forall l x y, Permutation (path y (rev l ++ [x])) (map swap (path x (l ++ [y]))).
Proof.
  induction l as [|z l IH]; intros x y; [cbn; apply Permutation_refl|].
  cbn [rev app path map]; rewrite <- app_assoc; cbn [app].
  rewrite path_snoc, Permutation_app_comm; cbn [app]; constructor; apply IH.
Qed.
Lemma cycle_rev : forall l, Permutation (cycle (rev l)) (map swap (cycle l)).
Proof.
  destruct l as [|x l]; [apply Permutation_refl|].
  transitivity (path x (rev l ++ [x])); [|apply path_rev].
  cbn [rev]; destruct (rev l) as [|y r]; [apply Permutation_refl|].
  unfold cycle; cbn [app path]; rewrite <- app_assoc; cbn [app].
  rewrite path_snoc, Permutation_app_comm; apply Permutation_refl.
Qed.

(** In a cycle of three different vertices at least, no side is the reverse of a side. *)
Lemma cycle_one_way : forall l x y, NoDup l -> 3 <= length l -> In (x, y) (cycle l) ->
  ~ In (y, x) (cycle l) /\ x <> y.
Proof.
  assert (S : forall l x y, NoDup l -> In (x, y) (cycle l) ->
    exists m, Permutation (cycle l) (cycle (x :: m)) /\ Permutation l (x :: m)).
  { intros l x y N I; apply cycle_in in I; destruct I as [I _]; cbn in I; apply in_split in I.
    destruct I as (u & w & ->); exists (w ++ u); split.
    - destruct u as [|z u]; [rewrite app_nil_r; apply Permutation_refl|].
      unfold cycle; cbn [app]; rewrite <- !app_assoc; cbn [app].
      rewrite (path_app u z x (w ++ [z])), (path_app w x z (u ++ [x])), Permutation_app_comm;
        apply Permutation_refl.
    - rewrite Permutation_app_comm; apply Permutation_refl. }
  intros l x y N L I; destruct (S l x y N I) as (m & P & Q).
  assert (NM : NoDup (x :: m)) by (eapply Permutation_NoDup; eauto).
  assert (LM : 3 <= length (x :: m)) by (rewrite <- (Permutation_length Q); auto).
  apply (Permutation_in _ P) in I.
  enough (~ In (y, x) (cycle (x :: m)) /\ x <> y) as [A B].
  { split; auto; intros H; apply A, (Permutation_in _ P); auto. }
  assert (U : forall a b b', In (a, b) (cycle (x :: m)) -> In (a, b') (cycle (x :: m)) -> b = b').
  { rewrite <- cycle_fst in NM; revert NM; generalize (cycle (x :: m)); clear.
    induction l as [|[p q] l IH]; intros N a b b' H H'; [destruct H|].
    cbn [map fst] in N; apply NoDup_cons_iff in N; destruct N as [N1 N2].
    destruct H as [H|H], H' as [H'|H']; try congruence; [| |eapply IH; eauto];
      exfalso; apply N1, in_map_iff; [exists (a, b')|exists (a, b)]; split; auto; cbn; congruence. }
  destruct m as [|z [|w m]]; cbn [length] in LM; try lia.
  assert (y = z) as -> by (eapply U; [exact I|left; reflexivity]).
  apply NoDup_cons_iff in NM; destruct NM as [NX NM]; split.
  - intros H; assert (x = w) as -> by (eapply U; [exact H|right; left; reflexivity]).
    apply NX; right; left; reflexivity.
  - intros ->; apply NX; left; reflexivity.
Qed.

Lemma nodup_app : forall A (p q : list A), NoDup p -> NoDup q -> (forall a, In a p -> ~ In a q) ->
  NoDup (p ++ q).
Proof.
  induction p as [|a p IH]; intros q P Q D; cbn; auto.
  apply NoDup_cons_iff in P; destruct P as [P1 P2]; constructor.
  - rewrite in_app_iff; intros [Y|Y]; auto; apply (D a); cbn; auto.
  - apply IH; auto; intros b Y; apply D; cbn; auto.
Qed.

(** A sheet with new sides, both ways, and new vertices. *)
Lemma good_more : forall s s' W N, good s -> Permutation (all_sides s') (N ++ all_sides s) ->
  vertices s' = W ++ vertices s -> NoDup W -> (forall x, In x W -> ~ In x (vertices s)) ->
  NoDup N -> (forall x y, In (x, y) N -> In (y, x) N /\ x <> y /\ ~ run s x y) ->
  (forall x y, In (x, y) N -> In x (W ++ vertices s)) ->
  (forall x, In x W -> exists y, In (x, y) N) -> good s'.
Proof.
  intros s s' W N [A B C D E G] P HV NW DW NN HN IN UW.
  assert (K : forall e, In e (all_sides s') <-> In e N \/ In e (all_sides s)).
  { intros e; split; intros H.
    - apply (Permutation_in _ P), in_app_iff in H; exact H.
    - apply (Permutation_in _ (Permutation_sym P)), in_app_iff; exact H. }
  constructor; rewrite ?HV.
  - apply nodup_app; auto.
  - intros x H; apply in_app_iff in H; destruct H as [H|H].
    + destruct (UW x H) as [y Y]; exists y; apply K; auto.
    + destruct (B x H) as [y Y]; exists y; apply K; auto.
  - intros x y H; apply K in H; destruct H as [H|H].
    + split; [eapply IN; eauto|apply HN in H; destruct H as [H _]; eapply IN; eauto].
    + apply C in H; rewrite !in_app_iff; tauto.
  - apply (Permutation_NoDup (Permutation_sym P)), nodup_app; auto.
    intros [x y] H; apply HN in H; tauto.
  - intros x y H; apply K in H; apply K; destruct H as [H|H]; [left; apply HN in H; tauto|right;
      auto].
  - intros x H; apply K in H; destruct H as [H|H]; [apply HN in H; tauto|apply (G x H)].
Qed.

Lemma not_run_new : forall s x y, good s -> ~ In x (vertices s) -> ~ run s x y.
Proof. intros s x y G N H; apply (sides_within s G) in H; tauto. Qed.

(** OPER-SHEET-5: an operator makes a sheet of a sheet. *)
Theorem makes_good : forall r s s', good s -> makes r s s' -> good s'.
Proof.
  intros r s s' G M; destruct (makes_sides r s s' M) as (N & P & H).
  pose proof (sides_both s G) as SB; pose proof (sides_within s G) as SW.
  assert (FST : forall a, In a (map fst (all_sides s)) -> In a (vertices s)).
  { intros a I; apply in_map_iff in I; destruct I as [[x y] [<- I]]; apply SW in I; tauto. }
  assert (NR : forall a b, run s a b -> a <> b) by (intros a b I ->; apply (sides_ends s G _ I)).
  assert (TWO : forall a c, a <> c -> ~ run s a c ->
    NoDup (two_sides a c) /\ forall x y, In (x, y) (two_sides a c) ->
      In (y, x) (two_sides a c) /\ x <> y /\ ~ run s x y).
  { intros a c NE NRUN; split.
    - repeat constructor; cbn; intuition congruence.
    - intros x y [E|[E|[]]]; injection E as <- <-; cbn; intuition. }
  assert (FOUR : forall a b c, a <> b -> a <> c -> b <> c -> ~ run s a c -> ~ run s b c ->
    NoDup (two_sides a c ++ two_sides b c) /\ forall x y, In (x, y) (two_sides a c ++ two_sides b
      c) ->
      In (y, x) (two_sides a c ++ two_sides b c) /\ x <> y /\ ~ run s x y).
  { intros a b c N0 N1 N2 N3 N4; split.
    - repeat constructor; cbn; intuition congruence.
    - intros x y [E|[E|[E|[E|[]]]]]; injection E as <- <-; cbn; intuition. }
  assert (OLD : forall x, In x (@nil nat) -> exists y, In (x, y) N) by (intros x []).
  assert (OLD' : forall x, In x (@nil nat) -> ~ In x (vertices s)) by (intros x []).
  destruct r as [p| | | | | | | | |].
  - destruct H as (l & L & NL & L3 & D & HV & ->); subst p.
    assert (R : forall x y, In (x, y) (cycle (rev l)) <-> In (y, x) (cycle l)).
    { intros x y; split; intros I.
      - apply (Permutation_in _ (cycle_rev l)), in_map_iff in I; destruct I as [[u w] [E I]].
        cbn in E; injection E as <- <-; exact I.
      - apply (Permutation_in _ (Permutation_sym (cycle_rev l))), in_map_iff.
        exists (y, x); auto. }
    assert (NC : forall m, NoDup m -> NoDup (cycle m)).
    { intros m K; apply (NoDup_map_inv fst); rewrite cycle_fst; auto. }
    eapply (good_more s s' (rev l)); eauto.
    + apply NoDup_rev; auto.
    + intros x I; apply D, in_rev; auto.
    + apply nodup_app; [apply NC, NoDup_rev; auto|auto|].
      intros [x y] I; apply R in I; intros I'; destruct (cycle_one_way l y x NL L3 I) as [Z _];
        auto.
    + intros x y I; apply in_app_iff in I; rewrite in_app_iff, !R.
      assert (I' : In (x, y) (cycle l) \/ In (y, x) (cycle l)) by (rewrite <- (R x y); tauto).
      split; [tauto|split].
      * destruct I' as [I'|I']; apply cycle_one_way in I'; auto; destruct I'; auto.
      * apply not_run_new; auto; destruct I' as [I'|I']; apply cycle_in in I'; cbn in I';
          apply D; tauto.
    + intros x y I; rewrite in_app_iff, <- in_rev; left; apply in_app_iff in I; rewrite R in I.
      destruct I as [I|I]; apply cycle_in in I; cbn in I; tauto.
    + intros x I; apply in_rev in I.
      rewrite <- cycle_fst in I; apply in_map_iff in I; destruct I as [[u w] [E I]]; cbn in E;
        subst u.
      exists w; apply in_app_iff; auto.
  - destruct H as (a & v & FA & NV & HV & ->).
    assert (a <> v) by (intros ->; apply NV, FST, FA).
    destruct (TWO a v) as [T1 T2]; auto.
    { intros R; apply SW in R; tauto. }
    eapply (good_more s s' [v]); eauto.
    + repeat constructor; intros [].
    + intros x [<-|[]]; auto.
    + intros x y [E|[E|[]]]; injection E as <- <-; apply in_app_iff; cbn; auto.
    + intros x [<-|[]]; exists a; cbn; auto.
  - destruct H as (a & c & NE & NRUN & J & HV & ->); destruct (TWO a c) as [T1 T2]; auto.
    destruct (linked_within _ _ _ _ SW J) as [E|[IA IC]]; [congruence|].
    eapply (good_more s s' []); eauto; try apply NoDup_nil.
    intros x y [E|[E|[]]]; injection E as <- <-; auto.
  - destruct H as [HV ->]; eapply (good_more s s' []); eauto; try apply NoDup_nil; intros x y [].
  - destruct H as (a & c & NE & NRUN & J & HV & ->); destruct (TWO a c) as [T1 T2]; auto.
    destruct (linked_within _ _ _ _ SW J) as [E|[IA IC]]; [congruence|].
    eapply (good_more s s' []); eauto; try apply NoDup_nil.
    intros x y [E|[E|[]]]; injection E as <- <-; auto.
  - destruct H as (a & c & NJ & FA & FC & HV & ->).
    assert (a <> c) by (intros ->; apply NJ, linked_refl).
    destruct (TWO a c) as [T1 T2]; auto; [intros R; apply NJ, linked_edge, R|].
    eapply (good_more s s' []); eauto; try apply NoDup_nil.
    intros x y [E|[E|[]]]; injection E as <- <-; apply FST; auto.
  - destruct H as (a & b & v & R & NV & HV & ->).
    assert (In a (vertices s) /\ In b (vertices s)) as [IA IB] by (apply SW in R; auto).
    destruct (FOUR a b v) as [T1 T2]; eauto; try congruence.
    { intros R'; apply SW in R'; tauto. }
    { intros R'; apply SW in R'; tauto. }
    eapply (good_more s s' [v]); eauto.
    + repeat constructor; intros [].
    + intros x [<-|[]]; auto.
    + intros x y [E|[E|[E|[E|[]]]]]; injection E as <- <-; apply in_app_iff; cbn; auto.
    + intros x [<-|[]]; exists a; cbn; auto.
  - destruct H as (a & b & c & R & NJ & FC & HV & ->).
    assert (In a (vertices s) /\ In b (vertices s)) as [IA IB] by (apply SW in R; auto).
    assert (a <> c) by (intros ->; apply NJ, linked_refl).
    assert (b <> c) by (intros ->; apply NJ, linked_edge, R).
    destruct (FOUR a b c) as [T1 T2]; eauto.
    { intros R'; apply NJ, linked_edge, R'. }
    { intros R'; apply NJ; apply linked_trans with b; apply linked_edge; auto. }
    eapply (good_more s s' []); eauto; try apply NoDup_nil.
    intros x y [E|[E|[E|[E|[]]]]]; injection E as <- <-; auto.
  - destruct H as (a & b & c & R & N1 & N2 & N3 & N4 & J & HV & ->).
    assert (In a (vertices s) /\ In b (vertices s)) as [IA IB] by (apply SW in R; auto).
    destruct (linked_within _ _ _ _ SW J) as [E|[_ IC]]; [congruence|].
    destruct (FOUR a b c) as [T1 T2]; eauto.
    eapply (good_more s s' []); eauto; try apply NoDup_nil.
    intros x y [E|[E|[E|[E|[]]]]]; injection E as <- <-; auto.
  - destruct H as (a & b & c & R & N1 & N2 & N3 & N4 & J & HV & ->).
    assert (In a (vertices s) /\ In b (vertices s)) as [IA IB] by (apply SW in R; auto).
    destruct (linked_within _ _ _ _ SW J) as [E|[_ IC]]; [congruence|].
    destruct (FOUR a b c) as [T1 T2]; eauto.
    eapply (good_more s s' []); eauto; try apply NoDup_nil.
    intros x y [E|[E|[E|[E|[]]]]]; injection E as <- <-; auto.
Qed.
