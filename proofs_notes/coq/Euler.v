(** * The Euler and handle operators on sheets, and what they change

    Clauses: OPER-SHEET-1 (sheets: sides, each run once and in both directions), OPER-SHEET-3 (their
    numbers), OPER-EULER-1 to -5 and OPER-SURFACE-1 to -7 (the operators), OPER-EFFECT-2 (the table
    of effects), OPER-SHEET-5 (an operator makes a sheet of a sheet, but for the condition of
    OPER-SHEET-2 at each vertex).

    A sheet here is its vertices, its faces and its loops as lists of vertices, each run in its own
    direction. Vertices, edges, faces, loops and components are counted in it, not carried along:
    an edge is two sides, a component a class of joined vertices. Only the genus is arithmetic: it
    is the number with χ = 2c - 2g - b. *)

Require Import ZArith List Lia Arith Bool Permutation Relation_Operators.
From Clers Require Import Graph.
Import ListNotations.

(** ** Sides of cyclic lists *)

Fixpoint path (x : nat) (l : list nat) : list edge :=
  match l with [] => [] | y :: t => (x, y) :: path y t end.
Definition cycle (l : list nat) : list edge :=
  match l with [] => [] | x :: t => path x (t ++ [x]) end.
Definition sides (C : list (list nat)) : list edge := flat_map cycle C.
Definition swap (e : edge) : edge := (snd e, fst e).

Record sheet := Sheet { vertices : list nat; faces : list (list nat); loops : list (list nat) }.
Definition all_sides (s : sheet) : list edge := sides (faces s) ++ sides (loops s).

(** OPER-SHEET-1: no side is run twice, a side is run if its reverse is, and no edge has one end
    twice. The vertices are the ends of the sides. *)
Record good (s : sheet) : Prop := {
  vertices_once : NoDup (vertices s);
  vertices_used : forall x, In x (vertices s) -> exists y, In (x, y) (all_sides s);
  sides_within : within (vertices s) (all_sides s);
  sides_once : NoDup (all_sides s);
  sides_both : forall x y, In (x, y) (all_sides s) -> In (y, x) (all_sides s);
  sides_ends : forall x, ~ In (x, x) (all_sides s)
}.

(** ** The operators *)

(** The rows of the table. *)
Inductive row := zero_handle (p : nat) | make_ev | make_te | make_sg | make_ekl_one | make_ekl_two
  | gluing | join | lower | upper.

Notation run s x y := (In (x, y) (all_sides s)).
Notation joined s x y := (linked (all_sides s) x y).

(** Each operator, with the loop that it needs first in the list and begun where the clause begins
    it. M STV is the 0-handle with the polygon [r, q, p]: its face is the triangle (p, q, r). *)
Inductive makes : row -> sheet -> sheet -> Prop :=
| by_zero_handle : forall l V F L, NoDup l -> 3 <= length l -> (forall x, In x l -> ~ In x V) ->
    makes (zero_handle (length l)) (Sheet V F L) (Sheet (rev l ++ V) (rev l :: F) (l :: L))
| by_ev : forall a b X v V F L, ~ In v V ->
    makes make_ev (Sheet V F ((a :: b :: X) :: L)) (Sheet (v :: V) F ((a :: v :: a :: b :: X) :: L))
| by_te : forall a b c X V F L, let s := Sheet V F ((a :: b :: c :: X) :: L) in
    a <> c -> ~ run s a c ->
    makes make_te s (Sheet V ([a; b; c] :: F) ((a :: c :: X) :: L))
| by_sg : forall a b c V F L,
    makes make_sg (Sheet V F ([a; b; c] :: L)) (Sheet V ([a; b; c] :: F) L)
| by_ekl_one : forall a X c Y V F L, let s := Sheet V F ((a :: X) :: (c :: Y) :: L) in
    a <> c -> ~ run s a c -> joined s a c ->
    makes make_ekl_one s (Sheet V F ((a :: (c :: Y) ++ c :: a :: X) :: L))
| by_ekl_two : forall a X c Y V F L, let s := Sheet V F ((a :: X) :: (c :: Y) :: L) in
    a <> c -> ~ joined s a c -> X <> [] -> Y <> [] ->
    makes make_ekl_two s (Sheet V F ((a :: (c :: Y) ++ c :: a :: X) :: L))
| by_gluing : forall a b X v V F L, ~ In v V ->
    makes gluing (Sheet V F ((a :: b :: X) :: L)) (Sheet (v :: V) ([a; b; v] :: F) ((a :: v :: b :: X) :: L))
| by_join : forall a b X c Y V F L, let s := Sheet V F ((a :: b :: X) :: (c :: Y) :: L) in
    a <> c -> b <> c -> ~ joined s a c -> Y <> [] ->
    makes join s (Sheet V ([a; b; c] :: F) ((a :: (c :: Y) ++ c :: b :: X) :: L))
| by_lower : forall a b X c Y V F L, let s := Sheet V F ((a :: b :: X ++ c :: Y) :: L) in
    a <> c -> b <> c -> ~ run s a c -> ~ run s b c ->
    makes lower s (Sheet V ([a; b; c] :: F) ((c :: b :: X) :: (a :: c :: Y) :: L))
| by_upper : forall a b X c Y V F L, let s := Sheet V F ((a :: b :: X) :: (c :: Y) :: L) in
    a <> c -> b <> c -> ~ run s a c -> ~ run s b c -> joined s a c ->
    makes upper s (Sheet V ([a; b; c] :: F) ((a :: (c :: Y) ++ c :: b :: X) :: L)).

(** The sides that come with each, of which [x] and [y] are what the operator names. *)
Definition two_sides (x y : nat) : list edge := [(x, y); (y, x)].

Lemma path_app : forall l x y m, path x (l ++ y :: m) = path x (l ++ [y]) ++ path y m.
Proof. induction l as [|z l IH]; intros x y m; cbn; [reflexivity|rewrite IH; reflexivity]. Qed.

Lemma edge_dec : forall x y : edge, {x = y} + {x <> y}.
Proof. decide equality; apply Nat.eq_dec. Qed.

(** Equal up to order, decided by counting. *)
Lemma count_cons : forall (x y : edge) l,
  count_occ edge_dec (y :: l) x = (if edge_dec y x then 1 else 0) + count_occ edge_dec l x.
Proof. intros; cbn; destruct (edge_dec y x); auto. Qed.

Ltac reorder := unfold two_sides; cbn [app]; apply (Permutation_count_occ edge_dec); intros ?e;
  repeat rewrite ?count_occ_app, ?count_cons; cbn [count_occ]; lia.

Ltac unfold_sides := unfold all_sides, sides, two_sides;
  cbn [faces loops flat_map cycle path app]; rewrite <- ?app_assoc; cbn [path app].

Lemma makes_sides : forall r s s', makes r s s' -> exists N, Permutation (all_sides s') (N ++ all_sides s)
  /\ match r with
     | zero_handle p => exists l, length l = p /\ NoDup l /\ 3 <= p
         /\ (forall x, In x l -> ~ In x (vertices s))
         /\ vertices s' = rev l ++ vertices s /\ N = cycle (rev l) ++ cycle l
     | make_ev => exists a v, In a (map fst (all_sides s)) /\ ~ In v (vertices s)
         /\ vertices s' = v :: vertices s /\ N = two_sides a v
     | make_te | make_ekl_one => exists a c, a <> c /\ ~ run s a c /\ joined s a c
         /\ vertices s' = vertices s /\ N = two_sides a c
     | make_ekl_two => exists a c, ~ joined s a c /\ In a (map fst (all_sides s))
         /\ In c (map fst (all_sides s)) /\ vertices s' = vertices s /\ N = two_sides a c
     | make_sg => vertices s' = vertices s /\ N = []
     | gluing => exists a b v, run s a b /\ ~ In v (vertices s)
         /\ vertices s' = v :: vertices s /\ N = two_sides a v ++ two_sides b v
     | join => exists a b c, run s a b /\ ~ joined s a c /\ In c (map fst (all_sides s))
         /\ vertices s' = vertices s /\ N = two_sides a c ++ two_sides b c
     | lower | upper => exists a b c, run s a b /\ a <> c /\ b <> c /\ ~ run s a c /\ ~ run s b c
         /\ joined s a c /\ vertices s' = vertices s /\ N = two_sides a c ++ two_sides b c
     end.
Proof.
  intros r s s' M; destruct M; try subst s.
  - exists (cycle (rev l) ++ cycle l); split.
    + unfold all_sides, sides; cbn [faces loops flat_map]; reorder.
    + exists l; repeat split; auto.
  - exists (two_sides a v); split; [unfold_sides; reorder|].
    exists a, v; repeat split; auto; cbn [vertices]; unfold_sides.
    rewrite map_app, in_app_iff; right; left; reflexivity.
  - exists (two_sides a c); split; [unfold_sides; reorder|].
    exists a, c; repeat split; auto; apply linked_trans with b; apply linked_edge;
      unfold_sides; apply in_app_iff; right; cbn; auto.
  - exists []; split; [unfold_sides; reorder|split; reflexivity].
  - exists (two_sides a c); split.
    + unfold_sides; rewrite (path_app Y c c); cbn [path]; reorder.
    + exists a, c; repeat split; auto.
  - exists (two_sides a c); split.
    + unfold_sides; rewrite (path_app Y c c); cbn [path]; reorder.
    + exists a, c; repeat split; auto; unfold_sides; rewrite map_app, in_app_iff; right.
      * destruct X as [|x X]; [congruence|left; reflexivity].
      * rewrite map_app, in_app_iff; right; destruct Y as [|y Y]; [congruence|left; reflexivity].
  - exists (two_sides a v ++ two_sides b v); split; [unfold_sides; reorder|].
    exists a, b, v; repeat split; auto; unfold_sides; apply in_app_iff; right; left; reflexivity.
  - exists (two_sides a c ++ two_sides b c); split.
    + unfold_sides; rewrite (path_app Y c c); cbn [path]; reorder.
    + exists a, b, c; repeat split; auto; unfold_sides.
      * apply in_app_iff; right; left; reflexivity.
      * rewrite map_app, in_app_iff; right; cbn [map]; right; rewrite map_app, in_app_iff; right.
        destruct Y as [|y Y]; [congruence|left; reflexivity].
  - exists (two_sides a c ++ two_sides b c); split.
    + unfold_sides; rewrite (path_app X b c (Y ++ [a])); cbn [path]; reorder.
    + exists a, b, c; repeat split; auto; unfold_sides.
      * apply in_app_iff; right; left; reflexivity.
      * apply linked_trans with b; [apply linked_edge; apply in_app_iff; right; left; reflexivity|].
        rewrite (path_app X b c (Y ++ [a])).
        assert (K : forall X b E, incl (path b (X ++ [c])) E -> linked E b c).
        { clear; induction X as [|x X IH]; intros b E I; cbn in I.
          - apply linked_edge, I; left; auto.
          - apply linked_trans with x; [apply linked_edge, I; left; auto|].
            apply IH; intros e H; apply I; right; auto. }
        apply (K X); intros e He; apply in_app_iff; right; right.
        apply in_app_iff; left; apply in_app_iff; left; exact He.
  - exists (two_sides a c ++ two_sides b c); split.
    + unfold_sides; rewrite (path_app Y c c); cbn [path]; reorder.
    + exists a, b, c; repeat split; auto; unfold_sides.
      apply in_app_iff; right; left; reflexivity.
Qed.

(** ** Sheets of sheets *)

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
      rewrite (path_app u z x (w ++ [z])), (path_app w x z (u ++ [x])), Permutation_app_comm; apply Permutation_refl.
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
  - intros x y H; apply K in H; apply K; destruct H as [H|H]; [left; apply HN in H; tauto|right; auto].
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
    NoDup (two_sides a c ++ two_sides b c) /\ forall x y, In (x, y) (two_sides a c ++ two_sides b c) ->
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
      intros [x y] I; apply R in I; intros I'; destruct (cycle_one_way l y x NL L3 I) as [Z _]; auto.
    + intros x y I; apply in_app_iff in I; rewrite in_app_iff, !R.
      assert (I' : In (x, y) (cycle l) \/ In (y, x) (cycle l)) by (rewrite <- (R x y); tauto).
      split; [tauto|split].
      * destruct I' as [I'|I']; apply cycle_one_way in I'; auto; destruct I'; auto.
      * apply not_run_new; auto; destruct I' as [I'|I']; apply cycle_in in I'; cbn in I';
          apply D; tauto.
    + intros x y I; rewrite in_app_iff, <- in_rev; left; apply in_app_iff in I; rewrite R in I.
      destruct I as [I|I]; apply cycle_in in I; cbn in I; tauto.
    + intros x I; apply in_rev in I.
      rewrite <- cycle_fst in I; apply in_map_iff in I; destruct I as [[u w] [E I]]; cbn in E; subst u.
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

(** ** The numbers *)

Open Scope Z_scope.
(** OPER-SHEET-3. An edge is two sides. *)
Definition n0 (s : sheet) : Z := Z.of_nat (length (vertices s)).
Definition n1 (s : sheet) : Z := Z.of_nat (length (all_sides s)) / 2.
Definition n2 (s : sheet) : Z := Z.of_nat (length (faces s)).
Definition euler (s : sheet) : Z := n0 s - n1 s + n2 s.
Definition in_loops (s : sheet) : Z := Z.of_nat (length (loops s)).
Definition in_components (s : sheet) (c : Z) : Prop :=
  exists n, components (vertices s) (all_sides s) n /\ c = Z.of_nat n.
(** The genus, by its equation: the only number that is not counted. *)
Definition of_genus (s : sheet) (g : Z) : Prop :=
  exists c, in_components s c /\ euler s = 2 * c - 2 * g - in_loops s.

(** OPER-EFFECT-2, the table: vertices, edges, faces, χ, components, genus, loops. *)
Record effect := Effect { d0 : Z; d1 : Z; d2 : Z; dx : Z; dc : Z; dg : Z; db : Z }.
Definition effect_of (r : row) : effect :=
  match r with
  | zero_handle p => Effect (Z.of_nat p) (Z.of_nat p) 1 1 1 0 1
  | make_ev => Effect 1 1 0 0 0 0 0
  | make_te => Effect 0 1 1 0 0 0 0
  | make_sg => Effect 0 0 1 1 0 0 (-1)
  | make_ekl_one => Effect 0 1 0 (-1) 0 1 (-1)
  | make_ekl_two => Effect 0 1 0 (-1) (-1) 0 (-1)
  | gluing => Effect 1 2 1 0 0 0 0
  | join => Effect 0 2 1 (-1) (-1) 0 (-1)
  | lower => Effect 0 2 1 (-1) 0 0 1
  | upper => Effect 0 2 1 (-1) 0 1 (-1)
  end.

Lemma more_sides : forall s s' N k, Permutation (all_sides s') (N ++ all_sides s) ->
  Z.of_nat (length N) = 2 * k -> n1 s' = n1 s + k.
Proof.
  intros s s' N k P L; unfold n1; rewrite (Permutation_length P), app_length, Nat2Z.inj_add, L.
  rewrite Z.add_comm, Z.mul_comm, Z.div_add by lia; reflexivity.
Qed.

(** The vertices, edges, faces and loops. *)
Theorem effect_on_cells : forall r s s', makes r s s' ->
  n0 s' = n0 s + d0 (effect_of r) /\ n1 s' = n1 s + d1 (effect_of r)
  /\ n2 s' = n2 s + d2 (effect_of r) /\ in_loops s' = in_loops s + db (effect_of r).
Proof.
  intros r s s' M; split; [|split].
  - destruct (makes_sides r s s' M) as (N & _ & H); unfold n0.
    destruct r; cbn [effect_of d0].
    + destruct H as (l & L & _ & _ & _ & -> & _); rewrite app_length, rev_length; lia.
    + destruct H as (a & v & _ & _ & -> & _); cbn [length]; lia.
    + destruct H as (a & c & _ & _ & _ & -> & _); lia.
    + destruct H as [-> _]; lia.
    + destruct H as (a & c & _ & _ & _ & -> & _); lia.
    + destruct H as (a & c & _ & _ & _ & -> & _); lia.
    + destruct H as (a & b & v & _ & _ & -> & _); cbn [length]; lia.
    + destruct H as (a & b & c & _ & _ & _ & -> & _); lia.
    + destruct H as (a & b & c & _ & _ & _ & _ & _ & _ & -> & _); lia.
    + destruct H as (a & b & c & _ & _ & _ & _ & _ & _ & -> & _); lia.
  - destruct (makes_sides r s s' M) as (N & P & H); apply (more_sides s s' N _ P).
    destruct r; cbn [effect_of d1].
    + destruct H as (l & L & _ & _ & _ & _ & ->).
      rewrite app_length, !cycle_length, rev_length; lia.
    + destruct H as (a & v & _ & _ & _ & ->); reflexivity.
    + destruct H as (a & c & _ & _ & _ & _ & ->); reflexivity.
    + destruct H as [_ ->]; reflexivity.
    + destruct H as (a & c & _ & _ & _ & _ & ->); reflexivity.
    + destruct H as (a & c & _ & _ & _ & _ & ->); reflexivity.
    + destruct H as (a & b & v & _ & _ & _ & ->); reflexivity.
    + destruct H as (a & b & c & _ & _ & _ & _ & ->); reflexivity.
    + destruct H as (a & b & c & _ & _ & _ & _ & _ & _ & _ & ->); reflexivity.
    + destruct H as (a & b & c & _ & _ & _ & _ & _ & _ & _ & ->); reflexivity.
  - destruct M; try subst s; unfold n2, in_loops; cbn [faces loops length effect_of d2 db]; lia.
Qed.

(** χ. *)
Theorem effect_on_euler : forall r s s', makes r s s' -> euler s' = euler s + dx (effect_of r).
Proof.
  intros r s s' M; destruct (effect_on_cells r s s' M) as (A & B & C & _); unfold euler.
  rewrite A, B, C; destruct r; cbn [effect_of d0 d1 d2 dx]; lia.
Qed.

(** *** The components *)

Lemma add_known_list : forall N V E n, (forall x y, In (x, y) N -> linked E x y) ->
  components V E n -> components V (N ++ E) n.
Proof.
  induction N as [|[x y] N IH]; intros V E n H C; [exact C|]; cbn [app]; apply add_known.
  - apply linked_more with E; [intros e I; apply in_app_iff; auto|apply H; left; auto].
  - apply IH; auto; intros a b I; apply H; right; auto.
Qed.

Lemma add_leaf : forall V E n a v, within V E -> In a V -> ~ In v V -> components V E n ->
  components (v :: V) ((a, v) :: E) n.
Proof.
  intros V E n a v W A NV C.
  destruct (add_joining (v :: V) E (S n) a v) as (m & EM & CM).
  - right; auto.
  - left; auto.
  - intros L; destruct (linked_within V E _ _ W L) as [E'|[_ E']]; [subst|]; auto.
  - apply add_vertex; auto.
  - injection EM as <-; exact CM.
Qed.

Lemma add_path : forall t V E n x, within V E -> In x V -> NoDup t -> (forall y, In y t -> ~ In y V) ->
  components V E n -> components (rev t ++ V) (rev (path x t) ++ E) n.
Proof.
  induction t as [|y t IH]; intros V E n x W X N D C; [exact C|].
  cbn [rev path]; rewrite <- !app_assoc; cbn [app]; apply NoDup_cons_iff in N; destruct N as [NY N].
  apply IH; auto.
  - intros a b [H|H]; [injection H as <- <-; split; [right|left]; auto|].
    apply W in H; split; right; tauto.
  - left; auto.
  - intros z Z [<-|I]; [auto|apply (D z); [right|]; auto].
  - apply add_leaf; auto; apply D; left; auto.
Qed.

Lemma path_links : forall t E x y, incl (path x t) E -> In y (x :: t) -> linked E x y.
Proof.
  induction t as [|z t IH]; intros E x y I [<-|H]; try apply linked_refl; [destruct H|].
  apply linked_trans with z; [apply linked_edge, I; left; auto|].
  apply IH; auto; intros e X; apply I; right; auto.
Qed.

Theorem effect_on_components : forall r s s' c, good s -> makes r s s' -> in_components s c ->
  in_components s' (c + dc (effect_of r)).
Proof.
  intros r s s' c G M (n & C & ->); destruct (makes_sides r s s' M) as (N & P & H).
  pose proof (sides_within s G) as W.
  assert (DONE : forall W' m k, vertices s' = W' -> components W' (N ++ all_sides s) m ->
    Z.of_nat m = Z.of_nat n + k -> in_components s' (Z.of_nat n + k)).
  { intros W' m k HV K E; exists m; split; auto; rewrite HV.
    eapply components_perm; [apply Permutation_refl|apply Permutation_sym, P|exact K]. }
  assert (FST : forall a, In a (map fst (all_sides s)) -> In a (vertices s)).
  { intros a I; apply in_map_iff in I; destruct I as [[x y] [<- I]]; apply W in I; tauto. }
  destruct r; cbn [effect_of dc].
  - destruct H as (l & L & NL & L3 & D & HV & ->).
    eapply (DONE _ (S n) 1 HV); [|lia].
    destruct l as [|x t]; [cbn in L; subst; lia|].
    apply NoDup_cons_iff in NL; destruct NL as [NX NT].
    assert (K : components (rev t ++ x :: vertices s) (rev (path x t) ++ all_sides s) (S n)).
    { apply add_path; auto.
      - intros a b I; apply W in I; split; right; tauto.
      - left; auto.
      - intros y Y [<-|I]; [auto|apply (D y); [right|]; auto].
      - apply add_vertex; auto; apply D; left; auto. }
    assert (LK : forall a b, In (a, b) (cycle (rev (x :: t)) ++ cycle (x :: t)) ->
      linked (rev (path x t) ++ all_sides s) a b).
    { intros a b I.
      assert (J : In a (x :: t) /\ In b (x :: t)).
      { apply in_app_iff in I; destruct I as [I|I]; apply cycle_in in I; cbn [fst snd] in I; auto.
        rewrite <- !in_rev in I; auto. }
      assert (PI : incl (path x t) (rev (path x t) ++ all_sides s)).
      { intros e I'; apply in_app_iff; left; rewrite <- in_rev; auto. }
      apply linked_trans with x; [apply linked_sym|]; apply path_links with t; auto; apply J. }
    apply (add_known_list _ _ _ _ LK) in K.
    (* The path's sides were counted among those of the cycle: they add nothing. *)
    assert (SUB : forall A B V m, incl A B -> components V (B ++ A ++ all_sides s) m ->
      components V (B ++ all_sides s) m).
    { clear; intros A B V m I (R & (R1 & R2 & R3 & R4) & L); exists R; split; auto.
      assert (X : forall a b, linked (B ++ A ++ all_sides s) a b <-> linked (B ++ all_sides s) a b).
      { intros a b; split; apply linked_more; intros e H; rewrite !in_app_iff in *.
        - destruct H as [H|[H|H]]; auto.
        - tauto. }
      split; [auto|split; [auto|split]].
      - intros v V'; destruct (R3 v V') as (r & Q1 & Q2); exists r; split; auto; apply X; auto.
      - intros r r' A' B' Z; apply R4; auto; apply X; auto. }
    apply SUB in K.
    + cbn [rev app]; rewrite <- app_assoc; cbn [app]; exact K.
    + intros e I; rewrite <- in_rev in I; apply in_app_iff; right; unfold cycle.
      clear - I; revert x I; induction t as [|y t IH]; intros x I; [destruct I|].
      cbn [app path] in *; destruct I as [I|I]; [left; auto|right].
      clear IH; revert y I; induction t as [|z t IH]; intros y I; [destruct I|].
      cbn [app path] in *; destruct I as [I|I]; [left; auto|right; auto].
  - destruct H as (a & v & FA & NV & HV & ->); apply (DONE _ n 0 HV); [|lia].
    change (components (v :: vertices s) ([(a, v); (v, a)] ++ all_sides s) n).
    eapply components_perm; [apply Permutation_refl|apply perm_swap|].
    apply add_known; [apply linked_sym, linked_edge; left; auto|].
    apply add_leaf; auto.
  - destruct H as (a & b & NE & NR & J & HV & ->); apply (DONE _ n 0 HV); [|lia].
    apply add_known_list; auto; intros x y [E|[E|[]]]; injection E as <- <-; auto.
    apply linked_sym; auto.
  - destruct H as [HV ->]; apply (DONE _ n 0 HV); [exact C|lia].
  - destruct H as (a & b & NE & NR & J & HV & ->); apply (DONE _ n 0 HV); [|lia].
    apply add_known_list; auto; intros x y [E|[E|[]]]; injection E as <- <-; auto.
    apply linked_sym; auto.
  - destruct H as (a & b & NJ & FA & FB & HV & ->).
    destruct (add_joining _ _ n a b (FST a FA) (FST b FB) NJ C) as (m & -> & K).
    apply (DONE _ m (-1) HV); [|lia].
    change (components (vertices s) ([(a, b); (b, a)] ++ all_sides s) m).
    eapply components_perm; [apply Permutation_refl|apply perm_swap|].
    apply add_known; auto; apply linked_sym, linked_edge; left; auto.
  - destruct H as (a & b & v & R & NV & HV & ->); apply (DONE _ n 0 HV); [|lia].
    apply (components_perm (v :: vertices s) _ ([(v, a); (b, v); (v, b)] ++ (a, v) :: all_sides s));
      [apply Permutation_refl|reorder|].
    apply W in R as R'; apply add_known_list; [|apply add_leaf; tauto].
    assert (LV : linked ((a, v) :: all_sides s) a v) by (apply linked_edge; left; auto).
    assert (LB : linked ((a, v) :: all_sides s) a b) by (apply linked_edge; right; auto).
    intros x y [E|[E|[E|[]]]]; injection E as <- <-.
    + apply linked_sym; auto.
    + apply linked_trans with a; auto; apply linked_sym; auto.
    + apply linked_trans with a; auto; apply linked_sym; auto.
  - destruct H as (a & b & d & R & NJ & FC & HV & ->); apply W in R as R'.
    destruct (add_joining _ _ n a d (proj1 R') (FST d FC) NJ C) as (m & -> & K).
    apply (DONE _ m (-1) HV); [|lia].
    apply (components_perm (vertices s) _ ([(d, a); (b, d); (d, b)] ++ (a, d) :: all_sides s));
      [apply Permutation_refl|reorder|].
    apply add_known_list; auto.
    assert (LV : linked ((a, d) :: all_sides s) a d) by (apply linked_edge; left; auto).
    assert (LB : linked ((a, d) :: all_sides s) a b) by (apply linked_edge; right; auto).
    intros x y [E|[E|[E|[]]]]; injection E as <- <-.
    + apply linked_sym; auto.
    + apply linked_trans with a; auto; apply linked_sym; auto.
    + apply linked_trans with a; auto; apply linked_sym; auto.
  - destruct H as (a & b & d & R & N1 & N2 & N3 & N4 & J & HV & ->); apply (DONE _ n 0 HV); [|lia].
    apply linked_edge in R; apply add_known_list; auto.
    intros x y [E|[E|[E|[E|[]]]]]; injection E as <- <-; auto.
    + apply linked_sym; auto.
    + apply linked_trans with a; auto; apply linked_sym; auto.
    + apply linked_trans with a; auto; apply linked_sym; auto.
  - destruct H as (a & b & d & R & N1 & N2 & N3 & N4 & J & HV & ->); apply (DONE _ n 0 HV); [|lia].
    apply linked_edge in R; apply add_known_list; auto.
    intros x y [E|[E|[E|[E|[]]]]]; injection E as <- <-; auto.
    + apply linked_sym; auto.
    + apply linked_trans with a; auto; apply linked_sym; auto.
    + apply linked_trans with a; auto; apply linked_sym; auto.
Qed.

(** The genus. That is arithmetic: 2g = 2c - b - χ. *)
Theorem effect_on_genus : forall r s s' g, good s -> makes r s s' -> of_genus s g ->
  of_genus s' (g + dg (effect_of r)).
Proof.
  intros r s s' g G M (c & C & E); exists (c + dc (effect_of r)).
  split; [apply (effect_on_components r s s' c G M C)|].
  rewrite (effect_on_euler r s s' M).
  destruct (effect_on_cells r s s' M) as (_ & _ & _ & ->); rewrite E.
  destruct r; cbn [effect_of dx dc dg db]; lia.
Qed.

(** ** Scripts *)

(** OPER-SHEET-1: lists are cyclic and in no order. *)
Definition turned (l m : list nat) : Prop := exists u w, l = u ++ w /\ m = w ++ u.
Inductive alike : list (list nat) -> list (list nat) -> Prop :=
| alike_order : forall L M, Permutation L M -> alike L M
| alike_turn : forall l m L, turned l m -> alike (l :: L) (m :: L)
| alike_more : forall L M N, alike L M -> alike M N -> alike L N.

Lemma turned_cycle : forall l m, turned l m -> Permutation (cycle l) (cycle m).
Proof.
  intros l m (u & w & -> & ->); destruct u as [|x u], w as [|y w]; rewrite ?app_nil_r;
    try apply Permutation_refl.
  unfold cycle; cbn [app]; rewrite <- !app_assoc; cbn [app].
  rewrite (path_app u x y (w ++ [x])), (path_app w y x (u ++ [y])), Permutation_app_comm; apply Permutation_refl.
Qed.

Lemma alike_sides : forall L M, alike L M -> Permutation (sides L) (sides M) /\ length L = length M.
Proof.
  induction 1 as [L M P|l m L T|L M N _ [A B] _ [C D]].
  - split; [apply Permutation_flat_map; auto|apply Permutation_length; auto].
  - split; [|reflexivity]; unfold sides; cbn [flat_map]; apply Permutation_app_tail, turned_cycle; auto.
  - split; [transitivity (sides M); auto|congruence].
Qed.

(** A script of operators that make, each on the loops as they lie. *)
Inductive script : list row -> sheet -> sheet -> Prop :=
| script_nil : forall s, script [] s s
| script_turn : forall R s V F F' L L', script R s (Sheet V F L) -> alike L L' -> alike F F' ->
    script R s (Sheet V F' L')
| script_make : forall R s t t' r, script R s t -> makes r t t' -> script (r :: R) s t'.

Definition sum_of (f : effect -> Z) (R : list row) : Z :=
  fold_right (fun r t => f (effect_of r) + t) 0 R.

(** EB-FOLD-4, OPER-BUILD-3: the numbers after a script are the sums of the effects. *)
Theorem script_effects : forall R s t c g, good s -> in_components s c -> of_genus s g -> script R s t ->
  good t /\ euler t = euler s + sum_of dx R /\ in_loops t = in_loops s + sum_of db R
  /\ in_components t (c + sum_of dc R) /\ of_genus t (g + sum_of dg R).
Proof.
  intros R s t c g G C H S; induction S as [s|R s V F F' L L' S IH A A'|R s t t' r S IH M].
  - cbn; rewrite !Z.add_0_r; auto.
  - destruct (IH G C H) as (G1 & E1 & L1 & C1 & H1).
    destruct (alike_sides L L' A) as [PL LL], (alike_sides F F' A') as [PF LF].
    set (t := Sheet V F L) in *; set (t' := Sheet V F' L').
    assert (P : Permutation (all_sides t) (all_sides t')).
    { unfold all_sides; cbn [faces loops t t']; apply Permutation_app; auto. }
    assert (I : forall e, In e (all_sides t') <-> In e (all_sides t)).
    { intros e; split; apply Permutation_in; auto; apply Permutation_sym; auto. }
    assert (E : euler t' = euler t).
    { unfold euler, n0, n1, n2; cbn [vertices faces t t']; rewrite (Permutation_length P), LF; auto. }
    assert (B : in_loops t' = in_loops t) by (unfold in_loops; cbn [loops t t']; rewrite LL; auto).
    assert (K : forall n, in_components t n -> in_components t' n).
    { intros n (m & X & Y); exists m; split; auto; eapply components_perm; eauto. }
    split; [|split; [congruence|split; [congruence|split; [auto|]]]].
    + destruct G1 as [P1 P2 P3 P4 P5 P6]; constructor; cbn [vertices t t'] in *.
      * exact P1.
      * intros x X; destruct (P2 x X) as [y Y]; exists y; apply I; auto.
      * intros x y X; apply I in X; apply P3; auto.
      * apply (Permutation_NoDup P); auto.
      * intros x y X; apply I; apply I in X; auto.
      * intros x X; apply I in X; apply (P6 x X).
    + destruct H1 as (n & X & Y); exists n; split; auto; rewrite E, B; auto.
  - destruct (IH G C H) as (G1 & E1 & L1 & C1 & H1).
    pose proof (effect_on_cells r t t' M) as (_ & _ & _ & B).
    cbn [sum_of fold_right]; fold (sum_of dx R) (sum_of db R) (sum_of dc R) (sum_of dg R).
    split; [eapply makes_good; eauto|split; [|split; [|split]]].
    + rewrite (effect_on_euler r t t' M); lia.
    + lia.
    + replace (c + (dc (effect_of r) + sum_of dc R)) with (c + sum_of dc R + dc (effect_of r)) by lia.
      eapply effect_on_components; eauto.
    + replace (g + (dg (effect_of r) + sum_of dg R)) with (g + sum_of dg R + dg (effect_of r)) by lia.
      eapply effect_on_genus; eauto.
Qed.

(** OPER-EULER-6, OPER-SHEET-3: from the empty sheet, the Euler-Poincaré formula, and no genus but
    by upper 1-handles and by M EKL in one component. *)
Definition empty : sheet := Sheet [] [] [].

Theorem from_nothing : forall R t, script R empty t ->
  exists c, in_components t c /\ of_genus t (sum_of dg R) /\ 0 <= sum_of dg R
  /\ euler t = 2 * c - 2 * sum_of dg R - in_loops t.
Proof.
  intros R t S.
  assert (G : good empty) by (constructor; cbn; first [apply NoDup_nil|solve [intros x []]|solve [intros x y []]]).
  assert (C : in_components empty 0) by (exists 0%nat; split; [apply no_component|auto]).
  assert (H : of_genus empty 0) by (exists 0; split; [exact C|reflexivity]).
  destruct (script_effects R empty t 0 0 G C H S) as (_ & E & L & C' & H'); cbn [Z.add] in *.
  exists (sum_of dc R); split; [exact C'|split; [exact H'|split]].
  - clear; induction R as [|r R IH]; [cbn; lia|].
    cbn [sum_of fold_right]; fold (sum_of dg R); destruct r; cbn [effect_of dg]; lia.
  - rewrite E, L; change (euler empty) with 0; change (in_loops empty) with 0; rewrite !Z.add_0_l.
    clear; induction R as [|r R IH]; [reflexivity|].
    cbn [sum_of fold_right]; fold (sum_of dx R) (sum_of db R) (sum_of dc R) (sum_of dg R).
    destruct r; cbn [effect_of dx dc dg db]; lia.
Qed.
