(** * The five letters, and how often they stand in a word

    Clauses: EB-WORD-1 (the alphabet), EB-COUNT-1 (no C is followed by L or E), CODE-COUNT-2
    (#CC + #CR + #CS = #C, which is that equation and "the last symbol is no C" together).

    The constructors have a small [s] before the letter, because [S] is Coq's successor.
    Counts are integers, so that [lia] can subtract them. *)

Require Import ZArith List Lia.
Import ListNotations.
Open Scope Z_scope.

Inductive symbol := sC | sL | sE | sR | sS.

Definition same (a b : symbol) : Z :=
  match a, b with
  | sC, sC | sL, sL | sE, sE | sR, sR | sS, sS => 1
  | _, _ => 0
  end.

(** #a in w. *)
Fixpoint count (a : symbol) (w : list symbol) : Z :=
  match w with [] => 0 | x :: t => same a x + count a t end.

(** #ab in w, where p is the symbol before w. *)
Fixpoint pairs (a b p : symbol) (w : list symbol) : Z :=
  match w with [] => 0 | x :: t => same a p * same b x + pairs a b x t end.

(** The number of symbols. *)
Definition size (w : list symbol) : Z := Z.of_nat (length w).

(** The last symbol of w, or p if there is none. *)
Fixpoint final (p : symbol) (w : list symbol) : symbol :=
  match w with [] => p | x :: t => final x t end.

(** EB-COUNT-1: no CL and no CE, where p is the symbol before w. *)
Fixpoint tame (p : symbol) (w : list symbol) : Prop :=
  match w with
  | [] => True
  | x :: t => match p, x with sC, (sL | sE) => False | _, _ => tame x t end
  end.

Lemma size_cons : forall a w, size (a :: w) = 1 + size w.
Proof. intros; unfold size; cbn [length]; lia. Qed.

Lemma size_app : forall u w, size (u ++ w) = size u + size w.
Proof. intros; unfold size; rewrite app_length; lia. Qed.

Lemma count_app : forall a u w, count a (u ++ w) = count a u + count a w.
Proof. intros a; induction u; intros; cbn [count app]; rewrite ?IHu; lia. Qed.

Lemma final_app : forall u p w, final p (u ++ w) = final (final p u) w.
Proof. induction u; intros; cbn [app final]; auto. Qed.

Lemma count_nonneg : forall a w, 0 <= count a w.
Proof. intros a; induction w as [|x w IH]; cbn [count]; [lia|]; destruct a, x; cbn [same]; lia. Qed.

(** Every symbol is one of the five. *)
Lemma size_counts : forall w,
  size w = count sC w + count sL w + count sE w + count sR w + count sS w.
Proof.
  induction w as [|x w IH]; [reflexivity|].
  rewrite size_cons; destruct x; cbn [count same]; lia.
Qed.

Lemma tame_cons : forall p x w, tame p (x :: w) -> tame x w.
Proof. intros p x w H; destruct p, x; cbn in *; tauto. Qed.

Lemma tame_app : forall u p w, tame p u -> tame (final p u) w -> tame p (u ++ w).
Proof.
  induction u as [|x u IH]; intros p w H G; [exact G|].
  cbn [app final] in *; pose proof (IH x w (tame_cons _ _ _ H) G).
  destruct p, x; cbn in *; tauto.
Qed.

Lemma tame_app_right : forall u p w, tame p (u ++ w) -> tame (final p u) w.
Proof.
  induction u as [|x u IH]; intros p w H; [exact H|]; cbn [final]; apply IH.
  exact (tame_cons p x (u ++ w) H).
Qed.

(** CODE-COUNT-2, second sentence: in a word with no CL and no CE that does not end in C,
    #CC + #CR + #CS = #C. *)
Theorem pairs_after_c : forall w p, tame p w -> final p w <> sC ->
  pairs sC sC p w + pairs sC sR p w + pairs sC sS p w = same sC p + count sC w.
Proof.
  induction w as [|x w IH]; intros p H F; cbn [pairs count final] in *.
  - destruct p; cbn; congruence.
  - specialize (IH x (tame_cons _ _ _ H) F).
    destruct p, x; cbn in H; try contradiction; cbn [same] in *; lia.
Qed.
