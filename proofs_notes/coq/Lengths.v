(** * The lengths of the words of surfaces, in king-rossignac and golden

    Clauses: CODE-KR-4, CODE-KR-5, CODE-KR-6, CODE-GOLDEN-4, CODE-GOLDEN-5. What [Bound] and
    [Golden] say of words with certain counts, here of the word of every walk over a connected
    surface of genus g: [Counting] gives the counts. *)

Require Import ZArith List Lia.
From Clers Require Import Letters Surface Edges Walk Walks Counting Bound Golden.
Import ListNotations.
Open Scope Z_scope.

Section Lengths.
Variable M : table.
Hypothesis HM : surface M.
Variable g : Z.
Hypothesis HG : has_genus M g.
Variable s : state.
Let w := rev (word s).
Let T := Z.of_nat (triangles M).
Let B := Z.of_nat (border_edges M).
Let b := Z.of_nat (length (curves M)).
Let n := size w.
Let sum3 := total code1 sE w + total code2 sE w + total code3 sE w.

Lemma not_c : forall k, walk M k s -> final sE w <> sC.
Proof. intros k W; unfold w; rewrite (ends_in_e M HM k s W); discriminate. Qed.

(** CODE-KR-4 and CODE-GOLDEN-4, for every surface. *)
Theorem kr_word : forall k, walk M k s ->
  sum3 = 8 * n - 5 * count sC w + count sS w - count sE w - pairs sC sS sE w.
Proof. intros k W; apply sum_of_word; [apply (no_cl_no_ce M HM k s W)|apply (not_c k W)]. Qed.

Theorem golden_word : forall k, walk M k s ->
  length_of sE w = 4 * n - 3 * count sC w + count sS w - count sE w.
Proof. intros k W; apply length_of_word; [apply (no_cl_no_ce M HM k s W)|apply (not_c k W)]. Qed.

(** CODE-KR-5: 11T/2 - 4 + 12g - #CS, and 11T/2 + 5B/2 - 12 + 12g + 6b - #CS. *)
Theorem kr_closed : walk M true s -> 2 * sum3 = 11 * T - 8 + 24 * g - 2 * pairs sC sS sE w.
Proof.
  intros W; destruct (counts_in_triangles M HM true s W g HG) as (m & E & C).
  apply (sum_closed w T m g); auto; [apply (no_cl_no_ce M HM true s W)|apply (not_c true W)| |].
  - apply (symbols M HM true s W).
  - apply (splits_less_ends M HM true s W g HG).
Qed.

Theorem kr_with_boundary : walk M false s ->
  2 * sum3 = 11 * T + 5 * B - 24 + 24 * g + 12 * b - 2 * pairs sC sS sE w.
Proof.
  intros W; destruct (counts_in_triangles M HM false s W g HG) as (m & E & C).
  apply (sum_with_boundary w T B m g b); auto;
    [apply (no_cl_no_ce M HM false s W)|apply (not_c false W)| |].
  - apply (symbols M HM false s W).
  - apply (splits_less_ends M HM false s W g HG).
Qed.

(** CODE-KR-6, its three cases: the bits of a closed component, whose first C is implied, are at
    most floor(11T/6 - 1 + 4g - #CS/3); of a sphere floor(11T/6 - 1 - #CS/3); with boundary at most
    floor(11T/6 + 5B/6 - 2 + 4g + 2b - #CS/3). *)
Theorem kr_bound_closed : walk M true s -> exists u, w = sC :: u
  /\ king_rossignac sC u <= (11 * T - 6 + 24 * g - 2 * pairs sC sS sC u) / 6.
Proof.
  intros W; destruct (counts_in_triangles M HM true s W g HG) as (m & E & C).
  pose proof (symbols M HM true s W) as N; pose proof (splits_less_ends M HM true s W g HG) as D.
  pose proof (no_cl_no_ce M HM true s W) as TM; pose proof (not_c true W) as F.
  destruct (first_symbol M HM true s W eq_refl) as [u U]; exists u; split; [exact U|].
  unfold w in F; rewrite U in *; apply (bound_closed u T m g); auto.
Qed.

Corollary kr_bound_sphere : g = 0 -> walk M true s -> exists u, w = sC :: u
  /\ king_rossignac sC u <= (11 * T - 6 - 2 * pairs sC sS sC u) / 6.
Proof.
  intros G W; destruct (kr_bound_closed W) as (u & U & H); exists u; split; [exact U|].
  rewrite G in H; replace (11 * T - 6 + 24 * 0) with (11 * T - 6) in H by lia; exact H.
Qed.

Theorem kr_bound_with_boundary : walk M false s ->
  king_rossignac sE w <= (11 * T + 5 * B - 12 + 24 * g + 12 * b - 2 * pairs sC sS sE w) / 6.
Proof.
  intros W; destruct (counts_in_triangles M HM false s W g HG) as (m & E & C).
  apply (bound_with_boundary w T B m g b); auto;
    [apply (no_cl_no_ce M HM false s W)|apply (not_c false W)| |].
  - apply (symbols M HM false s W).
  - apply (splits_less_ends M HM false s W g HG).
Qed.

(** CODE-GOLDEN-5: 5T/2 - 2 + 8g units, and 5T/2 + 3B/2 - 8 + 8g + 4b. *)
Theorem golden_closed : walk M true s -> 2 * length_of sE w = 5 * T - 4 + 16 * g.
Proof.
  intros W; destruct (counts_in_triangles M HM true s W g HG) as (m & E & C).
  apply (length_closed w T m g); auto; [apply (no_cl_no_ce M HM true s W)|apply (not_c true W)| |].
  - apply (symbols M HM true s W).
  - apply (splits_less_ends M HM true s W g HG).
Qed.

Theorem golden_with_boundary : walk M false s ->
  2 * length_of sE w = 5 * T + 3 * B - 16 + 16 * g + 8 * b.
Proof.
  intros W; destruct (counts_in_triangles M HM false s W g HG) as (m & E & C).
  apply (length_with_boundary w T B m g b); auto;
    [apply (no_cl_no_ce M HM false s W)|apply (not_c false W)| |].
  - apply (symbols M HM false s W).
  - apply (splits_less_ends M HM false s W g HG).
Qed.

(** Every sphere of T triangles has the same probability, 1/φ to the power 5T/2 - 2. *)
Theorem golden_sphere : g = 0 -> walk M true s -> exists m, T = 2 * m
  /\ product sE w = power inverse (Z.to_nat (5 * m - 2)).
Proof.
  intros G W; destruct (counts_in_triangles M HM true s W g HG) as (m & E & C); exists m.
  split; [exact E|]; refine (proj2 (sphere_probability w T m _ _ E _ _ _)).
  - apply (no_cl_no_ce M HM true s W).
  - apply (not_c true W).
  - apply (symbols M HM true s W).
  - unfold w; rewrite C; lia.
  - unfold w; rewrite (splits_less_ends M HM true s W g HG); lia.
Qed.
End Lengths.
