(** Kraft's inequality for the 32-bit arithmetic coder: spec/02-arithmetic.md, section 2.5.

    Proved here: over any messages of n symbols, each taken once, the sum of 2^-L is at most 1
    (ARITH-LENGTH-3). It follows from [no_code_begins_another] and [kraft]. *)
Require Import ZArith List Lia Bool.
From Clers Require Import Bits Model Kraft Integer_coder.
Import ListNotations.
Open Scope Z_scope.

Section Coder.
  Variable Model : Type.
  Variable now : Model -> table.
  Variable after : Model -> Z -> Model.
  Variable good : Model -> Prop.
  Hypothesis good_now : forall m, good m -> proper (now m).
  Hypothesis good_after : forall m s sl, good m -> total (now m) <= quarter ->
    slot_of (now m) s = Some sl -> good (after m s).

  (** A message of n symbols (or one that ends before), and its code. *)
  Definition coded (m : Model) (n : nat) (c : list Z * list bool) : Prop :=
    is_whole Model now after m n (fst c) /\ encode Model now after m (fst c) = accepted (snd c).

  (** ARITH-LENGTH-3, multiplied by 2^k for some k that no length is over. *)
  Theorem coder_satisfies_kraft : forall m n k sent, good m ->
    Forall (coded m n) sent -> NoDup (map fst sent) ->
    (forall c, In c sent -> (length (snd c) <= k)%nat) ->
    mass k (map snd sent) <= power k.
  Proof.
    intros m n k sent G C D L; apply kraft.
    - clear L; induction C as [|[ms a] sent [W E] C IH]; [constructor|].
      inversion_clear D as [|? ? N D']; cbn [fst snd map] in *; constructor; [|apply IH, D'].
      apply Forall_forall; intros b B; apply in_map_iff in B as ([ks b'] & <- & I); cbn [snd].
      destruct (proj1 (Forall_forall _ _) C _ I) as [K F]; cbn [fst snd] in *.
      assert (X : ms <> ks) by (intros ->; apply N, in_map_iff; exists (ks, b'); auto).
      split; intros more <-.
      + apply X; eapply (no_code_begins_another Model now after good good_now good_after);
          [exact G|exact W|exact K|exact E|exact F].
      + apply X; symmetry; eapply (no_code_begins_another Model now after good good_now good_after);
          [exact G|exact K|exact W|exact F|exact E].
    - intros b B; apply in_map_iff in B as (c & <- & I); apply L, I.
  Qed.
End Coder.
