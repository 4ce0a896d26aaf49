(** * What the words of surfaces count

    Clauses: EB-COMPONENT-3 (how many symbols), EB-COUNT-1 (no CL, no CE), EB-COUNT-2 (#C),
    EB-COUNT-3 (#S - #E), EB-COUNT-4 (#Sh = 2g, #Sb = b - 1), CODE-COUNT-1 and CODE-COUNT-2 (the
    same in terms of triangles), CODE-IMPLIED-1 (a closed component begins with C), EB-REMAINDER-2
    (the number 1 - 2g - b, as far as it is a count). The sentence that first contact with a curve
    is an S is [Steps.first_contact].

    All is proved of the walk of [Walk] over any surface of [Surface], not of words that a grammar
    allows. The genus enters by its definition alone, χ = 2 - 2g - b (CPLX-COMPONENT-3).

    How: a C marks one vertex inside, so the C count them. A symbol leaves as many edges open as it
    has open sides, and every inner edge is opened once; this gives #S - #E. Every gate that an S
    leaves is gone on at, which an E does, or passed over, which makes a record; this gives the
    number of records. Those of the kind [boundary] each reach a curve, and one curve was reached
    at the beginning. *)

Require Import ZArith List Lia Arith Bool Permutation.
From Clers Require Import Letters Surface Edges Walk Gates Steps Tally Walks.
Import ListNotations.
Open Scope Z_scope.

(** The records of the kind [handle] and [boundary]: the S that are S_h and S_b (EB-HANDLE-2). *)
Definition handles (s : state) : Z := Z.of_nat (length (records s)) - Z.of_nat (truths (records s)).
Definition boundaries (s : state) : Z := Z.of_nat (truths (records s)).

Lemma count_rev : forall a w, count a (rev w) = count a w.
Proof. intros a; induction w; cbn [rev count]; rewrite ?count_app, ?IHw; cbn [count]; lia. Qed.
Lemma size_rev : forall w, size (rev w) = size w.
Proof. intros; unfold size; rewrite rev_length; auto. Qed.

Section Surface.
Variable M : table.
Hypothesis HM : surface M.
Notation v := (vertex M).
Notation opp := (opposite M).
Notation T := (triangles M).
Notation tally := (tally M).
Notation reached := (reached M).

(** ** The numbers of the surface *)

Lemma all_inner : forall mk, NoDup mk -> (forall a, In a mk <-> (a < vertices M)%nat) ->
  (length (filter (inner_vertex M) mk) + border_edges M = vertices M)%nat.
Proof.
  intros mk N A.
  assert (P : Permutation mk (seq 0 (vertices M))).
  { apply NoDup_Permutation; auto using seq_NoDup; intros a; rewrite A, in_seq; lia. }
  pose proof (Permutation_length (starts M HM)) as B; rewrite map_length in B.
  fold (border_edges M) in B; rewrite B, !sum_filter, (sum_perm _ _ _ _ P), <- sum_plus.
  rewrite (sum_ext _ _ (fun _ => 1%nat)), sum_const, seq_length by
    (intros a _; destruct (inner_vertex M a); reflexivity); lia.
Qed.

Lemma curve_number : forall mk rs, reached mk rs -> (forall a, In a mk <-> (a < vertices M)%nat) ->
  length rs = length (curves M).
Proof.
  intros mk rs [N R] A; apply Permutation_length, NoDup_Permutation; auto;
    [apply (curves_once M HM)|].
  intros k; rewrite R, (curves_all M HM); split; intros [a [I E]]; exists a; split; auto; apply A;
    auto.
Qed.

Section Numbers.
Variables (k : bool) (s : state).
Hypothesis HW : walk M k s.
(** The word of the walk, in the order in which it is written. *)
Let w := rev (word s).
Let B := Z.of_nat (border_edges M).
Let V := Z.of_nat (vertices M).
Let t := Z.of_nat T.
Let b := Z.of_nat (length (curves M)).

(** EB-COMPONENT-3: T symbols with boundary, T - 1 in a closed component. *)
Theorem symbols : size w = if k then t - 1 else t.
Proof.
  destruct (walk_ends M HM k s HW) as (_ & [N A] & _ & _ & TL & _).
  destruct (opened_all M (visited s) HM N A) as [_ L].
  pose proof (t_faces M _ _ TL) as F; unfold w; rewrite size_rev; rewrite L in F; fold t in F.
  destruct k; cbn [when] in F; lia.
Qed.

(** EB-COUNT-1. *)
Theorem no_cl_no_ce : tame sE w.
Proof. destruct (walk_ends M HM k s HW) as (_ & _ & _ & _ & TL & _); apply TL. Qed.

(** The last symbol is E. *)
Theorem ends_in_e : final sE w = sE.
Proof.
  destruct (walk_ends M HM k s HW) as (G & _ & _ & _ & TL & _);
    destruct (t_last M _ _ TL G) as [u E].
  unfold w; rewrite E; cbn [rev]; rewrite final_app; reflexivity.
Qed.

(** CODE-IMPLIED-1. *)
Theorem first_symbol : k = true -> exists u, w = sC :: u.
Proof.
  intros K; destruct (walk_ends M HM k s HW) as (G & _ & _ & _ & TL & _).
  destruct (t_first M _ _ TL K) as [[W _]|F]; auto.
  destruct (t_last M _ _ TL G) as [u E]; congruence.
Qed.

(** EB-COUNT-2: #C is V - 3 in a closed component, and the number of vertices inside, which is
    V - B, in one with boundary. *)
Theorem creations : count sC w = V - if k then 3 else B.
Proof.
  destruct (walk_ends M HM k s HW) as (_ & _ & [N A] & _ & TL & _ & NB & _).
  pose proof (all_inner _ N A) as I; pose proof (t_inner M _ _ TL) as C.
  unfold w; rewrite count_rev; unfold V, B.
  destruct k; cbn [when] in C; [|lia].
  assert (border_edges M = 0%nat); [|lia].
  unfold border_edges, border_corners; destruct (filter (border M) (all_corners M)) as [|c l]
    eqn:E; auto.
  assert (J : In c (filter (border M) (all_corners M))) by (rewrite E; left; auto).
  apply filter_In in J; destruct J as [J1 J2]; apply in_corners, in_seq in J1; unfold border in J2.
  destruct (opp c) eqn:O; [discriminate|destruct (NB eq_refl c); auto; lia].
Qed.

Lemma closed_has_no : k = true -> border_edges M = 0%nat /\ curves M = [].
Proof.
  intros K; destruct (walk_ends M HM k s HW) as (_ & _ & _ & _ & _ & NC & NB & _); split.
  - unfold border_edges, border_corners.
    destruct (filter (border M) (all_corners M)) as [|c l] eqn:E; auto.
    assert (J : In c (filter (border M) (all_corners M))) by (rewrite E; left; auto).
    apply filter_In in J; destruct J as [J1 J2]; apply in_corners, in_seq in J1;
      unfold border in J2.
    destruct (opp c) eqn:O; [discriminate|destruct (NB K c); auto; lia].
  - destruct (curves M) as [|j l] eqn:E; auto; exfalso.
    assert (J : In j (curves M)) by (rewrite E; left; auto).
    apply (curves_all M HM) in J; destruct J as [a [A1 A2]]; rewrite (NC K a A1) in A2;
      discriminate.
Qed.

(** #S - #E, before any genus: it is -χ, and one more in a closed component. *)
Theorem splits_and_ends : count sS w - count sE w = (if k then 1 else 0) - euler M.
Proof.
  destruct (walk_ends M HM k s HW) as (_ & [N A] & _ & _ & TL & _).
  destruct (opened_all M (visited s) HM N A) as [O _].
  pose proof (t_opened M _ _ TL) as P; pose proof symbols as S; pose proof creations as C.
  pose proof (twice_the_edges M HM) as E; pose proof (size_counts w) as Z.
  unfold w in *; rewrite size_rev in *; rewrite !count_rev in *; unfold euler, V, B, t in *.
  pose proof closed_has_no as N0; destruct k; cbn [when] in P; [|lia].
  destruct (N0 eq_refl) as [X _]; lia.
Qed.

(** #Sh + #Sb = #S - #E + 1: of the gates that S leave, all but those gone on at. *)
Theorem all_records : handles s + boundaries s = count sS w - count sE w + 1.
Proof.
  destruct (walk_ends M HM k s HW) as (G & _ & _ & ST & TL & _); pose proof (t_stack M _ _ TL) as S.
  rewrite G, ST in S; cbn [length] in S; unfold w; rewrite !count_rev; unfold handles, boundaries;
    lia.
Qed.

(** EB-COUNT-4, second part: #Sb is 0 in a closed component, and b - 1 in one with boundary. *)
Theorem boundary_records : boundaries s = if k then 0 else b - 1.
Proof.
  destruct (walk_ends M HM k s HW) as (_ & _ & [_ A] & ST & TL & _).
  destruct (t_curves M _ _ TL) as (rs & R & L); rewrite (curve_number _ _ R A), ST in L.
  pose proof closed_has_no as N; unfold boundaries, b in *.
  change (truths (map snd [])) with 0%nat in L; destruct k; cbn [negb when] in L; [|lia].
  destruct (N eq_refl) as [_ X]; rewrite X in L; cbn [length] in L; lia.
Qed.

Section Genus.
Variable g : Z.
Hypothesis HG : has_genus M g.

(** EB-COUNT-3: #S - #E is 2g - 1 in a closed component, and 2g + b - 2 in one with boundary. *)
Theorem splits_less_ends : count sS w - count sE w = if k then 2 * g - 1 else 2 * g + b - 2.
Proof.
  pose proof closed_has_no as N; rewrite splits_and_ends; unfold has_genus in HG; rewrite HG;
    fold b.
  destruct k; [|lia]; destruct (N eq_refl) as [_ X]; unfold b; rewrite X; cbn [length]; lia.
Qed.

(** EB-COUNT-4, first part: #Sh = 2g. So no genus is negative. *)
Theorem handle_records : handles s = 2 * g.
Proof.
  pose proof all_records; pose proof boundary_records; pose proof splits_less_ends.
  destruct k; lia.
Qed.

Theorem genus_not_negative : 0 <= g.
Proof.
  pose proof handle_records as H; unfold handles in H.
  assert (forall l, (truths l <= length l)%nat) as K.
  { clear; unfold truths; induction l as [|[] l IH]; cbn [sum one_if length]; lia. }
  specialize (K (records s)); lia.
Qed.

(** CODE-COUNT-1: the counts in terms of triangles, where T = 2m or T - B = 2m. *)
Theorem counts_in_triangles : exists m,
  (if k then t else t - B) = 2 * m
  /\ count sC w = if k then m - 1 - 2 * g else m + 2 - 2 * g - b.
Proof.
  pose proof (twice_the_edges M HM) as E; pose proof creations as C; unfold has_genus, euler in HG.
  pose proof closed_has_no as N; unfold t, B, V, b in *; destruct k.
  - destruct (N eq_refl) as [X Y]; rewrite Y in HG; cbn [length] in HG.
    exists (Z.of_nat (edges M) - Z.of_nat T); lia.
  - exists (2 * Z.of_nat T - Z.of_nat (edges M)); lia.
Qed.

(** EB-REMAINDER-2, the number: the walk crosses an edge for each triangle but one, and leaves
    E - (T - 1). Then V less these is 1 - 2g - b. (That what it crosses is a tree, and what is left
    is connected, is not proved here.) *)
Theorem remainder : V - (Z.of_nat (edges M) - (t - 1)) = 1 - 2 * g - b.
Proof. unfold has_genus, euler in HG; unfold V, t, b; lia. Qed.
End Genus.
End Numbers.
End Surface.
