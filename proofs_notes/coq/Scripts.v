(** * The numbers after a script of operators

    Clauses: EB-FOLD-4 and OPER-BUILD-3 (they are the sums of the effects), OPER-SHEET-3 and the
    Euler-Poincaré formula from the empty sheet on, OPER-SHEET-1 (lists are cyclic and in no
    order). At the end a script is run: that of a tetrahedron. *)

Require Import ZArith List Lia Arith Bool Permutation Relation_Operators.
From Clers Require Import Graph Sheets Sheets_of_sheets Euler.
Import ListNotations.
Open Scope Z_scope.

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
