(** Kraft's inequality for codes of which none is the beginning of another.

    It is what makes lengths of bits comparable with probabilities: INFO-KRAFT-1 for the prefix
      codes
    of chapter 1, ARITH-LENGTH-3 for the arithmetic coder (Integer_kraft.v). Sums of 2^-L are
    multiplied by 2^n for some n that no length is over: all is in integers. *)
Require Import ZArith List Lia Bool.
From Clers Require Import Bits.
Import ListNotations.
Open Scope Z_scope.

(** Neither is the beginning of the other. *)
Definition apart (a b : list bool) : Prop :=
  (forall more, a ++ more <> b) /\ (forall more, b ++ more <> a).

Definition prefix_free (codes : list (list bool)) : Prop := ForallOrdPairs apart codes.

(** The sum of 2^(n - L). *)
Definition mass (n : nat) (codes : list (list bool)) : Z :=
  fold_right (fun c m => power (n - length c) + m) 0 codes.

(** The codes that begin with b, without it. *)
Definition under (b : bool) (codes : list (list bool)) : list (list bool) :=
  flat_map (fun c => match c with [] => [] | x :: r => if eqb x b then [r] else [] end) codes.

Lemma apart_under : forall b a c, apart (b :: a) (b :: c) -> apart a c.
Proof.
  intros b a c [A C]; split; intros more E; [apply (A more)|apply (C more)]; cbn; congruence.
Qed.

Lemma under_in : forall b codes r, In r (under b codes) -> In (b :: r) codes.
Proof.
  intros b codes r H; apply in_flat_map in H as (c & C & H); destruct c as [|x c]; [contradiction|].
  destruct (eqb x b) eqn:E; [|contradiction]; apply eqb_prop in E as ->; destruct H as [->|[]];
    exact C.
Qed.

Lemma under_free : forall b codes, prefix_free codes -> prefix_free (under b codes).
Proof.
  intros b; induction 1 as [|c codes A _ IH]; [constructor|].
  cbn [under flat_map]; fold (under b codes).
  destruct c as [|x c]; [exact IH|]; destruct (eqb x b) eqn:E; [|exact IH].
  apply eqb_prop in E as ->; constructor; [|exact IH].
  apply Forall_forall; intros r R;
    apply (apart_under b), (proj1 (Forall_forall _ _) A), under_in, R.
Qed.

Lemma mass_splits : forall n codes, ~ In [] codes ->
  mass (S n) codes = mass n (under true codes) + mass n (under false codes).
Proof.
  intros n; induction codes as [|c codes IH]; intros N; [reflexivity|].
  cbn [mass fold_right under flat_map];
    fold (mass (S n) codes) (under true codes) (under false codes).
  rewrite IH by (intros I; apply N; right; exact I).
  destruct c as [|[|] c]; [exfalso; apply N; left; reflexivity|..];
    cbn [eqb app mass fold_right length Nat.sub]; unfold mass; lia.
Qed.

(** Kraft's inequality: INFO-KRAFT-1, the first half. *)
Theorem kraft : forall n codes, prefix_free codes -> (forall c, In c codes ->
  (length c <= n)%nat) ->
  mass n codes <= power n.
Proof.
  induction n as [|n IH]; intros codes F L.
  - (* At most one code, the empty one. *)
    destruct codes as [|c [|d codes]]; [cbn; lia|cbn; lia|].
    inversion_clear F as [|? ? A _]; inversion_clear A as [|? ? [B _] _]; exfalso.
    assert (c = []) as -> by (apply length_zero_iff_nil; specialize (L c (or_introl eq_refl)); lia).
    apply (B d); reflexivity.
  - destruct (in_dec (list_eq_dec bool_dec) [] codes) as [I|I].
    + (* The empty code is the beginning of all: it is alone. *)
      assert (E : codes = [[]]).
      { destruct F as [|c codes A F]; [contradiction|]; destruct I as [->|I].
        - destruct codes as [|d codes]; [reflexivity|]; inversion_clear A as [|? ? [B _] _].
          exfalso; apply (B d); reflexivity.
        - destruct (proj1 (Forall_forall _ _) A [] I) as [_ B]; exfalso; apply (B c); reflexivity. }
      rewrite E; cbn [mass fold_right length]; rewrite Nat.sub_0_r; lia.
    + rewrite mass_splits, power_S by exact I.
      assert (B : forall b, mass n (under b codes) <= power n); [|pose proof (B true);
        pose proof (B false); lia].
      intros b; apply IH; [apply under_free, F|].
      intros c C; apply under_in, L in C; cbn [length] in C; lia.
Qed.
