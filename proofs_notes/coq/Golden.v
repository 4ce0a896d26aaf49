(** * The golden code: a word's length depends on the surface alone

    Clauses: CODE-GOLDEN-1 (the costs, and that they are probabilities), CODE-GOLDEN-2 (the sums of
    the tables of Fibonacci numbers), CODE-GOLDEN-4 (the length of a word), CODE-GOLDEN-5 (the
    length in terms of the surface), CODE-CERTIFICATE-5 (the charges).

    No real number is needed: probabilities are numbers a + bφ with integers a and b, in which
    φ is invertible. A length in units is the exponent of 1/φ, exactly. *)

Require Import ZArith List Lia.
From Clers Require Import Letters.
Import ListNotations.
Open Scope Z_scope.

(** ** The ring Z[φ] *)

(** [(a, b)] is a + bφ, with φ² = φ + 1. Since φ is irrational, two are equal only as pairs. *)
Definition ring : Type := (Z * Z)%type.
Definition plus (x y : ring) : ring := (fst x + fst y, snd x + snd y).
Definition times (x y : ring) : ring :=
  (fst x * fst y + snd x * snd y, fst x * snd y + snd x * fst y + snd x * snd y).
Definition one : ring := (1, 0).
Definition phi : ring := (0, 1).
(** 1/φ = φ - 1. *)
Definition inverse : ring := (-1, 1).

Fixpoint power (x : ring) (n : nat) : ring :=
  match n with O => one | Datatypes.S k => times x (power x k) end.

Ltac by_parts := intros; unfold times, plus, one; cbn [fst snd]; f_equal; ring.

Lemma times_comm : forall x y, times x y = times y x. Proof. by_parts. Qed.
Lemma times_assoc : forall x y z, times x (times y z) = times (times x y) z. Proof. by_parts. Qed.
Lemma times_one : forall x, times one x = x.
Proof. intros [a b]; unfold times, one; cbn [fst snd]; f_equal; ring. Qed.

Lemma power_add : forall x m n, power x (m + n) = times (power x m) (power x n).
Proof.
  intros x; induction m as [|m IH]; intros n; cbn [Nat.add power].
  - symmetry; apply times_one.
  - rewrite IH; apply times_assoc.
Qed.

Theorem golden_ratio : times phi phi = plus phi one /\ times phi inverse = one.
Proof. split; reflexivity. Qed.

(** ** The costs *)

(** CODE-GOLDEN-1: the units of x after p; none where there is a dash. *)
Definition units (p x : symbol) : option nat :=
  match p, x with
  | sC, sC => Some 1 | sC, sR => Some 3 | sC, sS => Some 4 | sC, _ => None
  | _, sC => Some 2 | _, sE => Some 3 | _, sL => Some 4 | _, sR => Some 4 | _, sS => Some 5
  end%nat.

Definition probability (p x : symbol) : ring :=
  match units p x with Some n => power inverse n | None => (0, 0) end.

(** CODE-GOLDEN-1: in each context the probabilities of the five symbols add up to 1. *)
Theorem probabilities : forall p, fold_right plus (0, 0) (map (probability p) [sC; sL; sE; sR;
  sS]) = one.
Proof. intros []; reflexivity. Qed.

(** CODE-GOLDEN-2: so do the frequencies, to the 24th Fibonacci number. *)
Fixpoint fibonacci (n : nat) : Z * Z :=
  match n with O => (0, 1) | Datatypes.S k => let (a, b) := fibonacci k in (b, a + b) end.
Definition F (n : nat) : Z := fst (fibonacci n).
Definition frequency (p x : symbol) : Z := match units p x with Some n => F (24 - n) | None => 0
  end.

Theorem frequencies : forall p, F 24 = 46368
  /\ fold_right Z.add 0 (map (frequency p) [sC; sL; sE; sR; sS]) = F 24.
Proof. intros []; split; reflexivity. Qed.

(** ** The length of a word *)

Fixpoint length_of (p : symbol) (w : list symbol) : Z :=
  match w with
  | [] => 0
  | x :: v => match units p x with Some n => Z.of_nat n | None => 0 end + length_of x v
  end.

Fixpoint product (p : symbol) (w : list symbol) : ring :=
  match w with [] => one | x :: v => times (probability p x) (product x v) end.

(** The probability of a word is 1/φ to the power of its length. *)
Theorem length_is_exponent : forall w p, tame p w ->
  0 <= length_of p w /\ product p w = power inverse (Z.to_nat (length_of p w)).
Proof.
  induction w as [|x w IH]; intros p H; [split; [reflexivity|reflexivity]|].
  destruct (IH x (tame_cons _ _ _ H)) as [N E].
  assert (G : exists n, units p x = Some n) by (destruct p, x; cbn in *; try contradiction; eauto).
  destruct G as [n G]; cbn [length_of product]; unfold probability; rewrite G, E.
  split; [lia|].
  rewrite Z2Nat.inj_add, Nat2Z.id, power_add by lia; reflexivity.
Qed.

(** The potential: one unit is put aside by a C. *)
Definition potential (p : symbol) : Z := same sC p.

(** CODE-CERTIFICATE-5 for golden, each entry. *)
Theorem charge : forall p x n, units p x = Some n ->
  Z.of_nat n = 4 - 3 * same sC x + same sS x - same sE x + potential x - potential p.
Proof. intros [] [] n H; cbn in H; try discriminate; injection H as <-; reflexivity. Qed.

Lemma length_from : forall w p, tame p w ->
  length_of p w = 4 * size w - 3 * count sC w + count sS w - count sE w
                  + potential (final p w) - potential p.
Proof.
  induction w as [|x w IH]; intros p H.
  - cbn; lia.
  - rewrite size_cons; cbn [length_of count final]; rewrite (IH x (tame_cons _ _ _ H)).
    assert (G : exists n, units p x = Some n) by (destruct p, x; cbn in *; try contradiction;
      eauto).
    destruct G as [n G]; rewrite G, (charge p x n G); lia.
Qed.

(** CODE-GOLDEN-4: the units of a word are 4n - 3#C + #S - #E. *)
Theorem length_of_word : forall w, tame sE w -> final sE w <> sC ->
  length_of sE w = 4 * size w - 3 * count sC w + count sS w - count sE w.
Proof.
  intros w H N; rewrite (length_from w sE H); unfold potential.
  destruct (final sE w); try congruence; cbn; lia.
Qed.

(** CODE-GOLDEN-5, closed: 5T/2 - 2 + 8g, with T = 2m. *)
Theorem length_closed : forall w T m g, tame sE w -> final sE w <> sC ->
  T = 2 * m -> size w = T - 1 -> count sC w = m - 1 - 2 * g ->
  count sS w - count sE w = 2 * g - 1 ->
  2 * length_of sE w = 5 * T - 4 + 16 * g.
Proof. intros w T m g H N; intros; rewrite (length_of_word w H N); lia. Qed.

(** CODE-GOLDEN-5 for spheres: every sphere of T triangles has the same probability, 1/φ to the
    power 5T/2 - 2. *)
Theorem sphere_probability : forall w T m, tame sE w -> final sE w <> sC ->
  T = 2 * m -> size w = T - 1 -> count sC w = m - 1 -> count sS w - count sE w = -1 ->
  length_of sE w = 5 * m - 2 /\ product sE w = power inverse (Z.to_nat (5 * m - 2)).
Proof.
  intros w T m H N E S C D.
  assert (L : length_of sE w = 5 * m - 2) by (rewrite (length_of_word w H N); lia).
  destruct (length_is_exponent w sE H) as [_ P]; rewrite L in P; auto.
Qed.

(** CODE-GOLDEN-5, with boundary: 5T/2 + 3B/2 - 8 + 8g + 4b, with T - B = 2m. *)
Theorem length_with_boundary : forall w T B m g b, tame sE w -> final sE w <> sC ->
  T - B = 2 * m -> size w = T -> count sC w = m + 2 - 2 * g - b ->
  count sS w - count sE w = 2 * g + b - 2 ->
  2 * length_of sE w = 5 * T + 3 * B - 16 + 16 * g + 8 * b.
Proof. intros w T B m g b H N; intros; rewrite (length_of_word w H N); lia. Qed.

(** CODE-GOLDEN-5, last sentence: if the first C is implied, its two units are not paid. *)
Theorem implied_saves : forall w, length_of sE (sC :: w) = 2 + length_of sC w.
Proof. reflexivity. Qed.
