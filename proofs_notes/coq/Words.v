(** Words of one closed component without records, and the trees they spell.

    EB-WORD-1, EB-GRAMMAR-3, EB-GRAMMAR-5, EB-REVERSI-1: a word read from its end builds a stack of
    trees, one for each gate; [word k w] says that w closes a loop of k edges. Proved here: the
    machine accepts exactly the words of the grammar ([machine_is_grammar]), a word has one tree
    ([one_tree]), no word of the grammar continues another ([no_word_continues_another]), the
    length of every loop, and so the offset of every S, is read off the word ([loop_length]), it
    is never below three ([loops_are_long]), and #E = #S + 1 ([ends]; EB-COUNT-3 for spheres). *)
Require Import ZArith List Arith Lia.
Require Import Clers.Letters.
Import ListNotations.
Open Scope nat_scope.

(** What is behind one gate: the rest of the word up to the E that uses the gate up. *)
Inductive tree :=
| TC (t : tree) | TL (t : tree) | TE | TR (t : tree) | TS (right left : tree).

Fixpoint flat (t : tree) : list symbol :=
  match t with
  | TC t => sC :: flat t | TL t => sL :: flat t | TE => [sE] | TR t => sR :: flat t
  | TS u w => sS :: flat u ++ flat w
  end.

(** The length of the loop that a tree closes: EB-REVERSI-2, where each loop is a list. *)
Fixpoint len (t : tree) : nat :=
  match t with
  | TC t => len t - 1 | TL t => len t + 1 | TE => 3 | TR t => len t + 1
  | TS u w => len u + len w - 1
  end.

(** EB-GRAMMAR-5: a loop of at least four edges follows a C. *)
Fixpoint ok (t : tree) : Prop :=
  match t with
  | TC t => 4 <= len t /\ ok t | TL t => ok t | TE => True | TR t => ok t
  | TS u w => ok u /\ ok w
  end.

Fixpoint creations (t : tree) : nat :=
  match t with
  | TC t => 1 + creations t | TL t => creations t | TE => 0 | TR t => creations t
  | TS u w => creations u + creations w
  end.

(** The machine: a stack of trees, the current one on top. *)
Definition undo (s : symbol) (stack : list tree) : option (list tree) :=
  match s, stack with
  | sE, _ => Some (TE :: stack)
  | sC, t :: rest => if 4 <=? len t then Some (TC t :: rest) else None
  | sL, t :: rest => Some (TL t :: rest)
  | sR, t :: rest => Some (TR t :: rest)
  | sS, u :: w :: rest => Some (TS u w :: rest)
  | _, _ => None
  end.

Fixpoint undone (w : list symbol) : option (list tree) :=
  match w with
  | [] => Some []
  | s :: w => match undone w with Some stack => undo s stack | None => None end
  end.

Definition parse (w : list symbol) : option tree :=
  match undone w with Some [t] => Some t | _ => None end.

(** The grammar: [word k w] if w closes a loop of k edges. *)
Inductive word : nat -> list symbol -> Prop :=
| word_E : word 3 [sE]
| word_C : forall k w, 3 <= k -> word (k + 1) w -> word k (sC :: w)
| word_L : forall k w, word k w -> word (k + 1) (sL :: w)
| word_R : forall k w, word k w -> word (k + 1) (sR :: w)
| word_S : forall i j u w, word i u -> word j w -> word (i + j - 1) (sS :: u ++ w).

Lemma loops_are_long_tree : forall t, ok t -> 3 <= len t.
Proof.
  induction t; cbn [ok len]; intros; auto with arith; try (specialize (IHt H); lia).
  - destruct H; lia.
  - destruct H as [A B]; specialize (IHt1 A); specialize (IHt2 B); lia.
Qed.

Lemma loops_are_long : forall k w, word k w -> 3 <= k.
Proof. induction 1; lia. Qed.

Lemma word_of_tree : forall t, ok t -> word (len t) (flat t).
Proof.
  induction t; cbn [ok len flat]; intros H; auto using word_L, word_R, word_E.
  - destruct H as [A B]; constructor; [lia|].
    replace (len t - 1 + 1) with (len t) by lia; auto.
  - destruct H; constructor; auto.
Qed.

Lemma tree_of_word : forall k w, word k w -> exists t, ok t /\ len t = k /\ flat t = w.
Proof.
  induction 1 as [|k w K _ (t & O & N & <-)|k w _ (t & O & <- & <-)|k w _ (t & O & <- & <-)
    |i j u w _ (t & O & <- & <-) _ (t' & O' & <- & <-)].
  - exists TE; cbn; auto.
  - exists (TC t); cbn [ok len flat]; repeat split; auto; lia.
  - exists (TL t); cbn; auto.
  - exists (TR t); cbn; auto.
  - exists (TS t t'); cbn; auto.
Qed.

Lemma undone_flat : forall t w, ok t ->
  undone (flat t ++ w) = match undone w with Some stack => Some (t :: stack) | None => None end.
Proof.
  induction t; intros w O; cbn [flat app undone ok] in *.
  - destruct O as [A B]; rewrite IHt by exact B; destruct (undone w); [|reflexivity].
    cbn [undo]; apply Nat.leb_le in A; rewrite A; reflexivity.
  - rewrite IHt by exact O; destruct (undone w); reflexivity.
  - destruct (undone w); reflexivity.
  - rewrite IHt by exact O; destruct (undone w); reflexivity.
  - destruct O as [A B]; rewrite <- app_assoc, IHt1, IHt2 by assumption.
    destruct (undone w); reflexivity.
Qed.

Lemma undone_sound : forall w stack, undone w = Some stack ->
  w = flat_map flat stack /\ Forall ok stack.
Proof.
  induction w as [|s w IH]; cbn [undone]; intros stack H.
  - injection H as <-; auto.
  - destruct (undone w) as [st|]; [|discriminate].
    destruct (IH st eq_refl) as [-> O]; clear IH.
    destruct s; cbn [undo] in H.
    + destruct st as [|t st]; [discriminate|]; destruct (4 <=? len t) eqn:N; [|discriminate].
      apply Nat.leb_le in N; injection H as <-; inversion O; subst; split; [reflexivity|constructor; cbn; auto].
    + destruct st as [|t st]; [discriminate|]; injection H as <-; inversion O; subst; split; [reflexivity|constructor; cbn; auto].
    + injection H as <-; cbn; split; [reflexivity|]; constructor; cbn; auto.
    + destruct st as [|t st]; [discriminate|]; injection H as <-; inversion O; subst; split; [reflexivity|constructor; cbn; auto].
    + destruct st as [|t [|t' st]]; try discriminate; injection H as <-.
      inversion O as [|? ? A O']; inversion O'; subst; split;
        [cbn; rewrite <- app_assoc; reflexivity|constructor; cbn; auto].
Qed.

Lemma parse_flat : forall t, ok t -> parse (flat t) = Some t.
Proof.
  intros t O; unfold parse; rewrite <- (app_nil_r (flat t)), undone_flat by exact O; reflexivity.
Qed.

Lemma parse_sound : forall w t, parse w = Some t -> w = flat t /\ ok t.
Proof.
  unfold parse; intros w t H; destruct (undone w) as [[|t' [|]]|] eqn:U; try discriminate.
  injection H as ->; apply undone_sound in U; destruct U as [-> O]; inversion O; subst.
  cbn; rewrite app_nil_r; auto.
Qed.

Theorem machine_is_grammar : forall k w, word k w <-> exists t, parse w = Some t /\ len t = k.
Proof.
  split.
  - intros W; destruct (tree_of_word _ _ W) as (t & O & N & <-); exists t; auto using parse_flat.
  - intros (t & P & <-); apply parse_sound in P; destruct P as [-> O]; auto using word_of_tree.
Qed.

Theorem one_tree : forall t u, ok t -> ok u -> flat t = flat u -> t = u.
Proof.
  intros t u A B H; apply parse_flat in A; apply parse_flat in B; congruence.
Qed.

Theorem no_word_continues_another : forall i j u u' w w',
  word i u -> word j u' -> u ++ w = u' ++ w' -> u = u' /\ i = j.
Proof.
  assert (Head : forall t t' w w', ok t -> ok t' -> flat t ++ w = flat t' ++ w' -> t = t').
  { induction t; destruct t'; cbn [flat app ok]; intros w w' O O' H; try discriminate;
      try (injection H as H; f_equal; apply (IHt _ w w'); tauto); auto.
    rewrite <- !app_assoc in H; injection H as H; destruct O as [O1 O2], O' as [O1' O2'].
    specialize (IHt1 _ _ _ O1 O1' H); subst; apply app_inv_head in H.
    f_equal; apply (IHt2 _ w w'); auto. }
  intros i j u u' w w' A B H.
  destruct (tree_of_word _ _ A) as (t & O & <- & <-), (tree_of_word _ _ B) as (t' & O' & <- & <-).
  rewrite (Head t t' w w'); auto.
Qed.

(** How often a letter stands in a word, as a natural number. *)
Definition is (a b : symbol) : nat :=
  match a, b with sC, sC | sL, sL | sE, sE | sR, sR | sS, sS => 1 | _, _ => 0 end.
Fixpoint many (a : symbol) (w : list symbol) : nat :=
  match w with [] => 0 | b :: w => is a b + many a w end.

Lemma many_is_count : forall a w, Z.of_nat (many a w) = count a w.
Proof.
  induction w as [|b w IH]; [reflexivity|]; cbn [many count].
  rewrite Nat2Z.inj_add, IH; destruct a, b; reflexivity.
Qed.

Lemma many_app : forall a u w, many a (u ++ w) = many a u + many a w.
Proof. intros a; induction u; intros; cbn [app many]; rewrite ?IHu; lia. Qed.

Lemma creations_count : forall t, creations t = many sC (flat t).
Proof. induction t; cbn [creations flat many is]; rewrite ?many_app; lia. Qed.

Theorem ends : forall k w, word k w -> many sE w = many sS w + 1.
Proof. induction 1; cbn [many is] in *; rewrite ?many_app; lia. Qed.

(** The length of the loop is read off the word: S needs no offset. *)
Theorem loop_length : forall k w, word k w -> k + 2 * many sC w = length w + 2.
Proof.
  induction 1; cbn [many is length] in *; rewrite ?many_app, ?app_length; try lia.
  apply loops_are_long in H; apply loops_are_long in H0; lia.
Qed.

Theorem length_of_counts : forall w,
  length w = many sC w + many sL w + many sE w + many sR w + many sS w.
Proof. induction w as [|s w IH]; [reflexivity|]; cbn [length]; destruct s; cbn [many is]; lia. Qed.
