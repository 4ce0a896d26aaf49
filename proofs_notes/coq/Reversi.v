(** Spirale Reversi with handle data: a machine on sides of triangles, which reads a word backwards.

    EB-REVERSI-1, EB-REVERSI-2, EB-REVERSI-3 for one closed component of any genus. A side is a step,
    told by the number of symbols after its own, and one of three places. An S with a record comes
    with the side that waits for it: EB-HANDLE-3 and -4 tell that side by [at] and [side]. The machine
    here has not all the checks of EB-GRAMMAR-5 and -6; [undo] and [glue] answer None where there is
    nothing to glue. *)
Require Import List Arith Lia.
Require Import Clers.Letters.
Import ListNotations.
Open Scope nat_scope.

Inductive place := at_gate | at_right | at_left.
Notation side := (nat * place)%type (only parsing).

Definition side_eq_dec (s r : side) : {s = r} + {s <> r}.
Proof. repeat decide equality. Defined.

(** The loops of the gates, the loops beside them, and the sides glued. *)
Record state := State {
  stack : list (list side);
  beside : list (list side);
  glued : list (side * side) }.

(** What is before s and what is after it. *)
Fixpoint cut (s : side) (l : list side) : option (list side * list side) :=
  match l with
  | [] => None
  | r :: l =>
      if side_eq_dec r s then Some ([], l)
      else match cut s l with Some (x, y) => Some (r :: x, y) | None => None end
  end.

(** The loop with s among several, opened at s, and the others. *)
Fixpoint take (s : side) (loops : list (list side)) : option (list side * list (list side)) :=
  match loops with
  | [] => None
  | l :: loops =>
      match cut s l with
      | Some (x, y) => Some (y ++ x, loops)
      | None => match take s loops with Some (y, rest) => Some (y, l :: rest) | None => None end
      end
  end.

(** A symbol; with an S that has a record, the side that waits for its left edge. *)
Notation item := (symbol * option side)%type (only parsing).

(** EB-REVERSI-2, row by row; n is the number of symbols after this one. *)
Definition undo1 (n : nat) (x : item) (m : state) : option state :=
  let g := (n, at_gate) in let r := (n, at_right) in let l := (n, at_left) in
  match x, stack m with
  | (sE, _), loops => Some (State ([g; r; l] :: loops) (beside m) (glued m))
  | (sR, _), (e :: X) :: loops => Some (State ((g :: r :: X) :: loops) (beside m) ((l, e) :: glued m))
  | (sL, _), (e :: X) :: loops =>
      Some (State ((g :: X ++ [l]) :: loops) (beside m) ((r, e) :: glued m))
  | (sC, _), (e :: X) :: loops =>
      match rev X with
      | f :: X' => Some (State ((g :: rev X') :: loops) (beside m) ((r, e) :: (l, f) :: glued m))
      | [] => None
      end
  | (sS, None), (e :: X) :: (e' :: Y) :: loops =>
      Some (State ((g :: X ++ Y) :: loops) (beside m) ((r, e) :: (l, e') :: glued m))
  | (sS, Some e'), (e :: X) :: loops =>
      match cut e' X with
      | Some (X, Y) =>
          Some (State ((g :: X) :: loops) (Y :: beside m) ((r, e) :: (l, e') :: glued m))
      | None =>
          match take e' (beside m) with
          | Some (Y, others) =>
              Some (State ((g :: X ++ Y) :: loops) others ((r, e) :: (l, e') :: glued m))
          | None => None
          end
      end
  | _, _ => None
  end.

Fixpoint undo (w : list item) : option state :=
  match w with
  | [] => Some (State [] [] [])
  | x :: w => match undo w with Some m => undo1 (length w) x m | None => None end
  end.

(** EB-REVERSI-3: the last loop is glued to P, whose number is that of all symbols. Its edges
    opposite to the first, third and second corner are those at the gate, left and right. *)
Definition glue (w : list item) : option (list (side * side)) :=
  match undo w with
  | Some (State [[e; e1; e2]] others pairs) =>
      match concat others with
      | [] =>
          let n := length w in
          Some ((e, (n, at_gate)) :: (e1, (n, at_left)) :: (e2, (n, at_right)) :: pairs)
      | _ => None
      end
  | _ => None
  end.

Lemma cut_in : forall s l, In s l -> exists x y, cut s l = Some (x, y) /\ l = x ++ s :: y.
Proof.
  induction l as [|r l IH]; intros I; [destruct I|]; cbn [cut].
  destruct (side_eq_dec r s) as [->|D]; [exists [], l; auto|].
  destruct I as [I|I]; [contradiction|]; destruct (IH I) as (x & y & -> & ->); exists (r :: x), y; auto.
Qed.

Lemma cut_out : forall s l, ~ In s l -> cut s l = None.
Proof.
  induction l as [|r l IH]; intros I; [reflexivity|]; cbn [cut].
  destruct (side_eq_dec r s) as [->|D]; [destruct I; left; reflexivity|].
  rewrite IH; [reflexivity|intros J; apply I; right; exact J].
Qed.

Lemma take_in : forall s Z W, In s (concat Z) -> exists U z V x y,
  Z = U ++ z :: V /\ z = x ++ s :: y /\ take s (Z ++ W) = Some (y ++ x, U ++ V ++ W).
Proof.
  induction Z as [|z Z IH]; intros W I; [destruct I|]; cbn [app take].
  destruct (in_dec side_eq_dec s z) as [J|J].
  - destruct (cut_in _ _ J) as (x & y & -> & ->).
    exists [], (x ++ s :: y), Z, x, y; auto.
  - rewrite cut_out by exact J; cbn [concat] in I; apply in_app_or in I; destruct I as [I|I]; [contradiction|].
    destruct (IH W I) as (U & z' & V & x & y & -> & E & ->).
    exists (z :: U), z', V, x, y; auto.
Qed.
