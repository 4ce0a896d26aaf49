(** * King and Rossignac's code: what three tables cost together, and the bound of 11T/6

    Clauses: CODE-KR-1 (the codewords), CODE-KR-4 and CODE-KR-5 (the sum of the three lengths),
    CODE-KR-6 (the bound), CODE-CERTIFICATE-5 (the charges), for section 4 of the note CODE-KR-8's
    ratio: no constant below 11/6 will do.

    What is used of a surface is said by the hypotheses of each theorem: no CL and no CE, the last
    symbol is no C, and the counts of CODE-COUNT-1. That the walk over a surface has these is
    proved in [Counting]. *)

Require Import ZArith List Lia Bool.
From Clers Require Import Letters.
Import ListNotations.
Open Scope Z_scope.

(** ** The codewords *)

Inductive choice := code1 | code2 | code3.

(** CODE-KR-1: the codeword of x after p; no bits where there is no codeword. *)
Definition codeword (t : choice) (p x : symbol) : list bool :=
  match p, x, t with
  | sC, sC, _ => [false]
  | sC, sS, _ => [true; false]
  | sC, sR, _ => [true; true]
  | sC, _, _ => []
  | _, sC, code1 => [false]
  | _, sS, code1 => [true; false; false]
  | _, sR, code1 => [true; false; true]
  | _, sL, code1 => [true; true; false]
  | _, sE, code1 => [true; true; true]
  | _, sC, code2 => [false; false]
  | _, sS, code2 => [true; true; true]
  | _, sR, code2 => [true; false]
  | _, sL, code2 => [true; true; false]
  | _, sE, code2 => [false; true]
  | _, sC, code3 => [false; false]
  | _, sS, code3 => [false; true; false]
  | _, sR, code3 => [false; true; true]
  | _, sL, code3 => [true; false]
  | _, sE, code3 => [true; true]
  end.

Definition cost (t : choice) (p x : symbol) : Z := Z.of_nat (length (codeword t p x)).

(** The bits of w in one of the codes, p the symbol before it. *)
Fixpoint bits (t : choice) (p : symbol) (w : list symbol) : list bool :=
  match w with [] => [] | x :: v => codeword t p x ++ bits t x v end.

Definition total (t : choice) (p : symbol) (w : list symbol) : Z :=
  Z.of_nat (length (bits t p w)).

Lemma total_cons : forall t p x w, total t p (x :: w) = cost t p x + total t x w.
Proof. intros; unfold total, cost; cbn [bits]; rewrite app_length; lia. Qed.

(** No codeword of a context begins another of it, so that bits are read in one way only. *)
Fixpoint begins (u v : list bool) : bool :=
  match u, v with
  | [], _ => true
  | a :: u', b :: v' => Bool.eqb a b && begins u' v'
  | _, _ => false
  end.

Definition follows (p x : symbol) : bool := match p, x with sC, (sL | sE) => false | _, _ => true
  end.

Theorem prefix_free : forall t p x y, follows p x = true -> follows p y = true ->
  begins (codeword t p x) (codeword t p y) = true -> x = y.
Proof. intros [] [] [] []; vm_compute; congruence. Qed.

Lemma begins_app : forall u u' v v', u ++ u' = v ++ v' -> begins u v = true \/ begins v u = true.
Proof.
  induction u as [|a u IH]; intros u' [|b v] v' H; auto.
  cbn in *; injection H as -> H; rewrite Bool.eqb_reflx; exact (IH _ _ _ H).
Qed.

Lemma tame_follows : forall p x w, tame p (x :: w) -> follows p x = true.
Proof. intros [] [] w H; cbn in *; tauto. Qed.

(** Two words with as many symbols and the same bits are one. *)
Theorem uniquely_decodable : forall t u v p, length u = length v -> tame p u -> tame p v ->
  bits t p u = bits t p v -> u = v.
Proof.
  intros t; induction u as [|x u IH]; intros [|y v] p L U V H; try discriminate; auto.
  cbn [bits] in H.
  assert (x = y) as ->.
  { pose proof (tame_follows _ _ _ U) as X; pose proof (tame_follows _ _ _ V) as Y.
    destruct (begins_app _ _ _ _ H) as [B|B].
    - exact (prefix_free _ _ _ _ X Y B).
    - symmetry; exact (prefix_free _ _ _ _ Y X B). }
  f_equal; apply app_inv_head in H; injection L as L.
  exact (IH v y L (tame_cons _ _ _ U) (tame_cons _ _ _ V) H).
Qed.

(** ** What the three tables take together *)

(** The potential: a symbol after a C finds two bits put aside. *)
Definition potential (p : symbol) : Z := 2 * same sC p.

(** CODE-CERTIFICATE-5 for king-rossignac, each entry. *)
Theorem charge : forall p x, follows p x = true ->
  cost code1 p x + cost code2 p x + cost code3 p x
  = 8 - 5 * same sC x + same sS x - same sE x - same sC p * same sS x + potential x - potential p.
Proof. intros [] []; vm_compute; congruence. Qed.

Lemma sum_from : forall w p, tame p w ->
  total code1 p w + total code2 p w + total code3 p w
  = 8 * size w - 5 * count sC w + count sS w - count sE w - pairs sC sS p w
    + potential (final p w) - potential p.
Proof.
  induction w as [|x w IH]; intros p H.
  - cbn; lia.
  - rewrite !total_cons, size_cons; cbn [count pairs final].
    pose proof (IH x (tame_cons _ _ _ H)); pose proof (charge p x (tame_follows _ _ _ H)); lia.
Qed.

(** CODE-KR-4: I + II + III = 8n - 5#C + #S - #E - #CS, for a word that has no CL and no CE and
    ends in another symbol than C. The beginning counts as [otherwise], which is what [sE] does. *)
Theorem sum_of_word : forall w, tame sE w -> final sE w <> sC ->
  total code1 sE w + total code2 sE w + total code3 sE w
  = 8 * size w - 5 * count sC w + count sS w - count sE w - pairs sC sS sE w.
Proof.
  intros w H F; rewrite (sum_from w sE H); unfold potential.
  destruct (final sE w); try congruence; cbn; lia.
Qed.

(** CODE-KR-5: the same in terms of the surface. [T = 2m] is even where the component is closed;
    where it has boundary, [T - B = 2m] is. *)
Theorem sum_closed : forall w T m g, tame sE w -> final sE w <> sC ->
  T = 2 * m -> size w = T - 1 -> count sC w = m - 1 - 2 * g ->
  count sS w - count sE w = 2 * g - 1 ->
  2 * (total code1 sE w + total code2 sE w + total code3 sE w)
  = 11 * T - 8 + 24 * g - 2 * pairs sC sS sE w.
Proof. intros w T m g H F; intros; rewrite (sum_of_word w H F); lia. Qed.

Theorem sum_with_boundary : forall w T B m g b, tame sE w -> final sE w <> sC ->
  T - B = 2 * m -> size w = T -> count sC w = m + 2 - 2 * g - b ->
  count sS w - count sE w = 2 * g + b - 2 ->
  2 * (total code1 sE w + total code2 sE w + total code3 sE w)
  = 11 * T + 5 * B - 24 + 24 * g + 12 * b - 2 * pairs sC sS sE w.
Proof. intros w T B m g b H F; intros; rewrite (sum_of_word w H F); lia. Qed.

(** ** The bound *)

(** CODE-KR-2: the bits of a word are a selector of two and the shortest of the three, here with
    the first C implied: [w] is what follows it. *)
Definition shortest (p : symbol) (w : list symbol) : Z :=
  Z.min (total code1 p w) (Z.min (total code2 p w) (total code3 p w)).

Definition king_rossignac (p : symbol) (w : list symbol) : Z := 2 + shortest p w.

(** CODE-KR-6: at most a third of the sum, rounded down, and two. *)
Theorem third : forall p w,
  king_rossignac p w <= (total code1 p w + total code2 p w + total code3 p w) / 3 + 2.
Proof.
  intros p w; unfold king_rossignac, shortest.
  set (a := total code1 p w); set (b := total code2 p w); set (c := total code3 p w).
  enough (Z.min a (Z.min b c) <= (a + b + c) / 3) by lia.
  apply Z.div_le_lower_bound; lia.
Qed.

(** The implied C saves 1, 2 and 2 bits, five in the sum. *)
Lemma implied_saves : forall w,
  total code1 sE (sC :: w) + total code2 sE (sC :: w) + total code3 sE (sC :: w)
  = total code1 sC w + total code2 sC w + total code3 sC w + 5.
Proof. intros w; rewrite !total_cons; unfold cost; cbn [length codeword]; lia. Qed.

(** CODE-KR-6 with its exact constant: a closed component of genus g takes at most
    floor(11T/6 - 1 + 4g - #CS/3) bits. Here 6 times that number is in the numerator. *)
Theorem bound_closed : forall w T m g, tame sE (sC :: w) -> final sC w <> sC ->
  T = 2 * m -> size (sC :: w) = T - 1 -> count sC (sC :: w) = m - 1 - 2 * g ->
  count sS (sC :: w) - count sE (sC :: w) = 2 * g - 1 ->
  king_rossignac sC w <= (11 * T - 6 + 24 * g - 2 * pairs sC sS sC w) / 6.
Proof.
  intros w T m g H F E N C D.
  pose proof (sum_closed (sC :: w) T m g H F E N C D) as G.
  rewrite implied_saves in G; cbn [pairs same] in G; pose proof (third sC w) as K.
  set (s := total code1 sC w + total code2 sC w + total code3 sC w) in *.
  replace (11 * T - 6 + 24 * g - 2 * pairs sC sS sC w) with ((s + 2 * 3) * 2) by lia.
  replace 6 with (3 * 2) by reflexivity.
  rewrite Z.div_mul_cancel_r, Z.div_add by lia; exact K.
Qed.

(** The line for spheres: floor(11T/6 - 1 - #CS/3). *)
Corollary bound_sphere : forall w T m, tame sE (sC :: w) -> final sC w <> sC ->
  T = 2 * m -> size (sC :: w) = T - 1 -> count sC (sC :: w) = m - 1 ->
  count sS (sC :: w) - count sE (sC :: w) = -1 ->
  king_rossignac sC w <= (11 * T - 6 - 2 * pairs sC sS sC w) / 6.
Proof.
  intros w T m H F E N C D.
  pose proof (bound_closed w T m 0 H F E N ltac:(lia) ltac:(lia)) as G.
  replace (11 * T - 6 + 24 * 0) with (11 * T - 6) in G by lia; exact G.
Qed.

(** CODE-KR-6 where there is boundary: nothing is implied. *)
Theorem bound_with_boundary : forall w T B m g b, tame sE w -> final sE w <> sC ->
  T - B = 2 * m -> size w = T -> count sC w = m + 2 - 2 * g - b ->
  count sS w - count sE w = 2 * g + b - 2 ->
  king_rossignac sE w
  <= (11 * T + 5 * B - 12 + 24 * g + 12 * b - 2 * pairs sC sS sE w) / 6.
Proof.
  intros w T B m g b H F E N C D.
  pose proof (sum_with_boundary w T B m g b H F E N C D) as G; pose proof (third sE w) as K.
  set (s := total code1 sE w + total code2 sE w + total code3 sE w) in *.
  replace (11 * T + 5 * B - 12 + 24 * g + 12 * b - 2 * pairs sC sS sE w)
    with ((s + 2 * 3) * 2) by lia.
  replace 6 with (3 * 2) by reflexivity.
  rewrite Z.div_mul_cancel_r, Z.div_add by lia; exact K.
Qed.

(** ** It cannot be less *)

(** The words (CCCRLR)^m E, without their last symbol. *)
Fixpoint repeated (m : nat) : list symbol :=
  match m with O => [] | Datatypes.S k => [sC; sC; sC; sR; sL; sR] ++ repeated k end.

Definition dear (m : nat) : list symbol := repeated m ++ [sE].

Lemma dear_size : forall m, size (dear m) = 6 * Z.of_nat m + 1.
Proof.
  intros m; unfold dear; rewrite size_app; change (size [sE]) with 1.
  induction m as [|m IH]; [reflexivity|].
  cbn [repeated app]; rewrite !size_cons; lia.
Qed.

Lemma dear_total : forall m t p, p <> sC ->
  total t p (dear m) = 11 * Z.of_nat m + match t with code1 => 3 | _ => 2 end.
Proof.
  unfold dear; induction m as [|m IH]; intros t p P.
  - destruct t, p; try congruence; reflexivity.
  - cbn [repeated app]; rewrite !total_cons, (IH t sR) by discriminate.
    destruct t, p; try congruence; unfold cost; cbn [length codeword]; lia.
Qed.

(** Section 4 of the note: for T = 6m + 2 triangles these words take 11m + 2 bits, which is
    11T/6 - 5/3. So whatever constant k and whatever offset d are promised, k is 11/6 at least:
    here k = x/y, and y > 0. (That these words are spheres' words is a test, not a theorem.) *)
Theorem dear_bits : forall m, (1 <= m)%nat ->
  exists w, dear m = sC :: w /\ size (dear m) = 6 * Z.of_nat m + 1
  /\ king_rossignac sC w = 11 * Z.of_nat m + 2.
Proof.
  intros [|m] M; [lia|]; exists (tl (dear (Datatypes.S m))).
  split; [reflexivity|split; [apply dear_size|]].
  assert (G : forall t, total t sC (tl (dear (Datatypes.S m)))
    = total t sE (dear (Datatypes.S m)) - cost t sE sC).
  { intros t; change (dear (Datatypes.S m)) with (sC :: tl (dear (Datatypes.S m))) at 2.
    rewrite total_cons; lia. }
  unfold king_rossignac, shortest; rewrite !G, !dear_total by discriminate.
  unfold cost; cbn [length codeword]; lia.
Qed.

Theorem constant_not_less : forall x y d, 0 < y ->
  (forall m, (1 <= m)%nat -> y * (11 * Z.of_nat m + 2) <= x * (6 * Z.of_nat m + 2) + d) ->
  11 * y <= 6 * x.
Proof.
  intros x y d Y H; destruct (Z_le_gt_dec (11 * y) (6 * x)) as [|N]; [assumption|exfalso].
  specialize (H (Z.to_nat (1 + Z.abs (2 * x + d)))); rewrite Z2Nat.id in H by lia.
  set (k := 1 + Z.abs (2 * x + d)) in *; assert (2 * x + d < k) by lia.
  specialize (H ltac:(lia)); assert (6 * x * k <= (11 * y - 1) * k) by nia; nia.
Qed.
