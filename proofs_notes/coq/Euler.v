(** * What the Euler and handle operators change

    Clauses: OPER-SHEET-3 (the numbers of a sheet), OPER-EFFECT-2 (the table of effects).

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
