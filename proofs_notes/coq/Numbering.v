(** The numbers of handle data, and back.

    EB-HANDLE-3, EB-HANDLE-5: a record tells the S by the number of S before it, and the closing
    symbol by the number of R, L and E before it. [entries] numbers, [told] finds again, and they
    fit ([told_entries]). *)
Require Import List Arith Lia.
Require Import Clers.Letters Clers.Reversi.
Import ListNotations.
Open Scope nat_scope.

(** s, at, side: EB-HANDLE-3, EB-HANDLE-4. All are of the kind [handle], there being no curves. *)
Notation entry := (nat * nat * place)%type (only parsing).

Definition closes (x : symbol) : bool := match x with sR | sL | sE => true | _ => false end.
Definition closers (w : list symbol) : nat := length (filter closes w).

(** The records of a list of items, by increasing s; w is the whole word. *)
Fixpoint entries (w : list symbol) (s : nat) (l : list (symbol * option side)) : list entry :=
  match l with
  | [] => []
  | (sS, Some (j, q)) :: l => (s, closers (firstn (length w - 1 - j) w), q) :: entries w (s + 1) l
  | (sS, None) :: l => entries w (s + 1) l
  | _ :: l => entries w s l
  end.

(** The place in the word of the symbol R, L or E before which there are so many. *)
Fixpoint nth_closer (w : list symbol) (k : nat) : nat :=
  match w with
  | [] => 0
  | x :: w =>
      if closes x then match k with 0 => 0 | S k => S (nth_closer w k) end else S (nth_closer w k)
  end.

(** What a decoder makes of a stream before it undoes the word. *)
Fixpoint told (w : list symbol) (s : nat) (l : list symbol) (rs : list entry)
  : list (symbol * option side) :=
  match l with
  | [] => []
  | sS :: l =>
      match rs with
      | (s', k, q) :: rest =>
          if s' =? s then (sS, Some (length w - 1 - nth_closer w k, q)) :: told w (s + 1) l rest
          else (sS, None) :: told w (s + 1) l rs
      | [] => (sS, None) :: told w (s + 1) l []
      end
  | x :: l => (x, None) :: told w s l rs
  end.

Lemma nth_closer_found : forall w1 x w2, closes x = true ->
  nth_closer (w1 ++ x :: w2) (closers w1) = length w1.
Proof.
  induction w1 as [|y w1 IH]; intros x w2 H; cbn [app nth_closer length].
  - rewrite H; reflexivity.
  - unfold closers in *; cbn [filter]; destruct (closes y); cbn [length]; rewrite IH by exact H; reflexivity.
Qed.

Lemma entries_later : forall w l s e, In e (entries w s l) -> s <= fst (fst e).
Proof.
  induction l as [|[x c] l IH]; intros s e I; [destruct I|].
  destruct x; cbn [entries] in I; try (apply IH in I; lia).
  destruct c as [[j q]|]; [destruct I as [<-|I]; [cbn; lia|]|]; apply IH in I; lia.
Qed.

(** A side that can be told by numbers. *)
Definition tellable (w : list symbol) (x : symbol * option side) : Prop :=
  match x with
  | (sS, Some (j, _)) => exists w1 y w2, w = w1 ++ y :: w2 /\ length w2 = j /\ closes y = true
  | (sS, None) => True
  | (_, c) => c = None
  end.

Lemma told_entries : forall w l s, (forall x, In x l -> tellable w x) ->
  told w s (map fst l) (entries w s l) = l.
Proof.
  induction l as [|[x c] l IH]; intros s H; [reflexivity|].
  assert (H0 := H (x, c) (or_introl eq_refl)); assert (Hl := fun y I => H y (or_intror I)).
  destruct x; cbn [map fst told entries]; cbn [tellable] in H0; try (subst c; rewrite IH by exact Hl; reflexivity).
  destruct c as [[j q]|].
  - destruct H0 as (w1 & y & w2 & E & L & Cy); rewrite Nat.eqb_refl, IH by exact Hl.
    assert (Lw : length w - 1 - j = length w1) by (rewrite E, app_length; cbn [length]; lia).
    assert (Fi : firstn (length w1) w = w1).
    { rewrite E, firstn_app, Nat.sub_diag, firstn_all; cbn [firstn]; apply app_nil_r. }
    assert (Nc : nth_closer w (closers w1) = length w1) by (rewrite E; apply nth_closer_found, Cy).
    assert (Lj : length w - 1 - length w1 = j) by (rewrite E, app_length; cbn [length]; lia).
    rewrite Lw, Fi, Nc, Lj; reflexivity.
  - assert (IHl := IH (s + 1) Hl); assert (Later := entries_later w l (s + 1)).
    destruct (entries w (s + 1) l) as [|[[s' k] q] rest]; [rewrite IHl; reflexivity|].
    assert (Le := Later (s', k, q) (or_introl eq_refl)); cbn in Le.
    destruct (s' =? s) eqn:Eq; [apply Nat.eqb_eq in Eq; lia|rewrite IHl; reflexivity].
Qed.
