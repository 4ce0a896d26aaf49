(** * Sheets, and the operators on them

    Clauses: OPER-SHEET-1 (sheets: sides, each run once and in both directions), OPER-EULER-1 to -5
    and OPER-SURFACE-1 to -7 (the operators). A strip (OPER-SURFACE-9) is two of them.

    A sheet here is its vertices, its faces and its loops as lists of vertices, each run in its own
    direction. What an operator does to the sides is proved once, in [makes_sides]: all that it
    changes can be read off this. *)

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
    makes gluing (Sheet V F ((a :: b :: X) :: L))
      (Sheet (v :: V) ([a; b; v] :: F) ((a :: v :: b :: X) :: L))
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

Lemma makes_sides : forall r s s', makes r s s' ->
  exists N, Permutation (all_sides s') (N ++ all_sides s)
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
