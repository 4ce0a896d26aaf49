(** * The traversal of a connected surface

    Clauses: EB-GATE-1, EB-GATE-2 (gates; closed and open edges), EB-COMPONENT-1 and -2 (how a
    component is begun), EB-TRAVERSE-1 to -7 (the walk), EB-HANDLE-1 and -2 (which S gets a record,
    of which kind). That it visits everything is
    proved in [Gates] and [Steps], what it counts in [Tally] and [Counting]. *)

Require Import ZArith List Lia Arith Bool Permutation.
From Clers Require Import Letters Surface Edges.
Import ListNotations.
Open Scope nat_scope.

(** ** The walk, as section 5.4 has it *)

(** The stack has the left gates of S, each with whether its S reached a curve. The word is kept
    with the last symbol first, the visited faces as well. A record is told by its kind alone: true
    is boundary. Where the gate is None the component is finished. *)
Record state := State {
  gate : option corner;
  stack : list (corner * bool);
  visited : list nat;
  marked : list nat;
  word : list symbol;
  records : list bool
}.

(** The gate behind an edge, if the edge is open (EB-GATE-2). *)
Definition behind (M : table) (vis : list nat) (x : corner) : option corner :=
  match opposite M x with
  | Some d => if mem (face d) vis then None else Some d
  | None => None
  end.

(** EB-TRAVERSE-5: gates are popped until one is found whose triangle is not visited. By
    EB-HANDLE-1 each that is passed over makes a record. *)
Fixpoint pop (vis : list nat) (st : list (corner * bool)) (rec : list bool)
  : option corner * list (corner * bool) * list bool :=
  match st with
  | [] => (None, [], rec)
  | (d, b) :: r => if mem (face d) vis then pop vis r (b :: rec) else (Some d, r, rec)
  end.

(** The vertices that are reached together: those of one curve; a vertex inside is reached alone. *)
Definition ring (M : table) (v w : nat) : bool :=
  match curve M v, curve M w with
  | Some j, Some k => j =? k
  | None, None => v =? w
  | _, _ => false
  end.
Definition whole (M : table) (v : nat) : list nat := filter (ring M v) (seq 0 (vertices M)).

Definition step (M : table) (s : state) : option state :=
  match gate s with
  | None => None
  | Some c =>
      let vis := face c :: visited s in
      let v := vertex M c in
      let known := mem v (marked s) in
      Some
        (if negb known && inner_vertex M v
         then State (behind M vis (next c)) (stack s) vis (v :: marked s) (sC :: word s) (records s)
         else
           match behind M vis (prev c), behind M vis (next c) with
           | Some l, None => State (Some l) (stack s) vis (marked s) (sR :: word s) (records s)
           | None, Some r => State (Some r) (stack s) vis (marked s) (sL :: word s) (records s)
           | None, None =>
               let '(g, st, rec) := pop vis (stack s) (records s) in
               State g st vis (marked s) (sE :: word s) rec
           | Some l, Some r =>
               State (Some r) ((l, negb known) :: stack s) vis
                 (if known then marked s else whole M v ++ marked s) (sS :: word s) (records s)
           end)
  end.

Fixpoint run (M : table) (n : nat) (s : state) : state :=
  match n with
  | 0 => s
  | S k => match step M s with None => s | Some s' => run M k s' end
  end.

(** EB-COMPONENT-2: a closed component begins at a triangle P, any. *)
Definition begin_closed (M : table) (t : nat) : state :=
  State (opposite M (t, p0)) [] [t] (map (vertex M) (at_face t)) [] [].
(** EB-COMPONENT-1: one with boundary at an edge of a curve, any; that curve is reached. *)
Definition begin_border (M : table) (c : corner) : state :=
  State (Some c) [] [] (whole M (vertex M (next c))) [] [].
