(** * What the Euler and handle operators change

    Clauses: OPER-SHEET-3 (the numbers of a sheet), OPER-EFFECT-2 (the table of effects), EB-FOLD-4
    and OPER-BUILD-3 (the numbers after a script are the sums of the effects).

    Vertices, edges, faces, loops and components are counted in the sheet, not carried along: an
    edge is two sides, a component a class of joined vertices. Only the genus is arithmetic: it is
    the number with χ = 2c - 2g - b. *)

Require Import ZArith List Lia Arith Bool Permutation Relation_Operators.
From Clers Require Import Graph Sheets Sheets_of_sheets.
Import ListNotations.

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

Lemma add_path : forall t V E n x, within V E -> In x V -> NoDup t -> (forall y, In y t ->
  ~ In y V) ->
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
  rewrite (path_app u x y (w ++ [x])), (path_app w y x (u ++ [y])), Permutation_app_comm;
    apply Permutation_refl.
Qed.

Lemma alike_sides : forall L M, alike L M -> Permutation (sides L) (sides M) /\ length L = length M.
Proof.
  induction 1 as [L M P|l m L T|L M N _ [A B] _ [C D]].
  - split; [apply Permutation_flat_map; auto|apply Permutation_length; auto].
  - split; [|reflexivity]; unfold sides; cbn [flat_map]; apply Permutation_app_tail, turned_cycle;
      auto.
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
Theorem script_effects : forall R s t c g, good s -> in_components s c -> of_genus s g ->
  script R s t ->
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
    { unfold euler, n0, n1, n2; cbn [vertices faces t t']; rewrite (Permutation_length P), LF;
        auto. }
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
    + replace (c + (dc (effect_of r) + sum_of dc R)) with (c + sum_of dc R + dc (effect_of r)) by
        lia.
      eapply effect_on_components; eauto.
    + replace (g + (dg (effect_of r) + sum_of dg R)) with (g + sum_of dg R + dg (effect_of r)) by
        lia.
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
  assert (G : good empty) by (constructor; cbn; first [apply NoDup_nil|solve [intros x []]|solve
    [intros x y []]]).
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

(** ** A worked script *)

(** The tetrahedron of the specification's example, `zero-handle 0 1 2; glue 1 0 3; complete 2 1 3;
    two-handle 0 2 3`: 4 vertices, 6 edges, 4 faces, no loop, one component, genus 0. *)
Theorem tetrahedron : exists t,
  script [make_sg; make_te; gluing; zero_handle 3] empty t
  /\ n0 t = 4 /\ n1 t = 6 /\ n2 t = 4 /\ euler t = 2 /\ in_loops t = 0
  /\ in_components t 1 /\ of_genus t 0.
Proof.
  set (t1 := (Sheet [0; 1; 2] [[0; 1; 2]] [[2; 1; 0]])%nat).
  set (t2 := (Sheet [3; 0; 1; 2] [[1; 0; 3]; [0; 1; 2]] [[1; 3; 0; 2]])%nat).
  set (t3 := (Sheet [3; 0; 1; 2] [[2; 1; 3]; [1; 0; 3]; [0; 1; 2]] [[2; 3; 0]])%nat).
  set (t4 := (Sheet [3; 0; 1; 2] [[0; 2; 3]; [2; 1; 3]; [1; 0; 3]; [0; 1; 2]] [])%nat).
  assert (M1 : makes (zero_handle 3) empty t1).
  { apply (by_zero_handle [2; 1; 0]%nat [] [] []); [|cbn; lia|intros x _ []].
    repeat constructor; cbn; intuition lia. }
  assert (M2 : makes gluing (Sheet [0; 1; 2] [[0; 1; 2]] [[1; 0; 2]])%nat t2).
  { apply by_gluing; cbn; intuition lia. }
  assert (M3 : makes make_te (Sheet [3; 0; 1; 2] [[1; 0; 3]; [0; 1; 2]] [[2; 1; 3; 0]])%nat t3).
  { apply by_te; [lia|]; unfold all_sides; cbn; intuition congruence. }
  assert (M4 : makes make_sg
    (Sheet [3; 0; 1; 2] [[2; 1; 3]; [1; 0; 3]; [0; 1; 2]] [[0; 2; 3]])%nat t4).
  { apply by_sg. }
  assert (S : script [make_sg; make_te; gluing; zero_handle 3] empty t4).
  { eapply script_make; [|exact M4]; eapply script_turn;
      [eapply script_make; [|exact M3]| |apply alike_order, Permutation_refl].
    - eapply script_turn; [eapply script_make; [|exact M2]| |apply alike_order, Permutation_refl].
      + eapply script_turn; [eapply script_make; [apply script_nil|exact M1]| |
          apply alike_order, Permutation_refl].
        apply alike_turn; exists [2]%nat, [1; 0]%nat; split; reflexivity.
      + apply alike_turn; exists [1; 3; 0]%nat, [2]%nat; split; reflexivity.
    - apply alike_turn; exists [2; 3]%nat, [0]%nat; split; reflexivity. }
  exists t4; split; [exact S|].
  assert (G : good empty) by
    (constructor; cbn; first [apply NoDup_nil|solve [intros x []]|solve [intros x y []]]).
  assert (C : in_components empty 0) by (exists 0%nat; split; [apply no_component|auto]).
  assert (H : of_genus empty 0) by (exists 0; split; [exact C|reflexivity]).
  destruct (script_effects _ empty t4 0 0 G C H S) as (_ & _ & _ & C' & H').
  repeat split; try reflexivity; [exact C'|exact H'].
Qed.
