(** Round trip of the arithmetic coder over the rationals, for any adaptive model. *)
Require Import QArith Lqa List.
Import ListNotations.
Open Scope Q_scope.

Section Coder.
  Variables Sym Model : Type.
  Variables lo hi : Model -> Sym -> Q.          (* the sub-interval of a symbol *)
  Variable next : Model -> Sym -> Model.        (* what the model learns *)
  Variable find : Model -> Q -> Sym.            (* the symbol in whose sub-interval a number lies *)
  Hypothesis proper : forall m s, 0 <= lo m s /\ lo m s < hi m s /\ hi m s <= 1.
  Hypothesis found : forall m s x, lo m s <= x -> x < hi m s -> find m x = s.

  Fixpoint encode (m : Model) (ms : list Sym) : Q * Q :=
    match ms with
    | [] => (0, 1)
    | s :: t => let (a, b) := encode (next m s) t in
                let w := hi m s - lo m s in (lo m s + w * a, lo m s + w * b)
    end.

  Fixpoint decode (n : nat) (m : Model) (x : Q) : list Sym :=
    match n with
    | O => []
    | S k => let s := find m x in s :: decode k (next m s) ((x - lo m s) / (hi m s - lo m s))
    end.

  Lemma inside : forall ms m, let (a, b) := encode m ms in 0 <= a /\ a < b /\ b <= 1.
  Proof.
    induction ms as [|s t IH]; intros m; cbn; [lra|].
    specialize (IH (next m s)); destruct (encode (next m s) t) as [a b].
    destruct (proper m s) as (H0 & H1 & H2), IH as (I0 & I1 & I2).
    repeat split; nra.
  Qed.

  Theorem round_trip : forall ms m x,
    let (a, b) := encode m ms in a <= x -> x < b -> decode (length ms) m x = ms.
  Proof.
    induction ms as [|s t IH]; intros m x; cbn; [reflexivity|].
    pose proof (inside t (next m s)) as J.
    specialize (IH (next m s) ((x - lo m s) / (hi m s - lo m s))).
    destruct (encode (next m s) t) as [a b]; intros Ha Hb.
    destruct (proper m s) as (H0 & H1 & H2), J as (J0 & J1 & J2).
    rewrite (found m s x) by nra.
    f_equal; apply IH.
    - apply Qle_shift_div_l; lra.
    - apply Qlt_shift_div_r; lra.
  Qed.
End Coder.
