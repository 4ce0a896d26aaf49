(** * The edges of a surface, counted from the faces on their sides

    Clauses: CPLX-COMPONENT-2 (a component has (3T + B)/2 edges). Faces are taken one after another:
    each inner edge is open once, from the face that is taken first. *)

Require Import ZArith List Lia Arith Bool Permutation.
From Clers Require Import Surface.
Import ListNotations.
Open Scope nat_scope.

(** ** Counting with sums *)

Definition one_if (b : bool) : nat := if b then 1 else 0.
Fixpoint sum {A} (f : A -> nat) (l : list A) : nat :=
  match l with [] => 0 | x :: t => f x + sum f t end.

Lemma sum_app : forall A (f : A -> nat) l m, sum f (l ++ m) = sum f l + sum f m.
Proof. induction l; intros; cbn; rewrite ?IHl; lia. Qed.
Lemma sum_ext : forall A (f g : A -> nat) l, (forall x, In x l -> f x = g x) -> sum f l = sum g l.
Proof. induction l; intros H; cbn; auto; rewrite (H a), IHl; cbn; auto; intros; apply H; cbn;
  auto. Qed.
Lemma sum_plus : forall A (f g : A -> nat) l, sum (fun x => f x + g x) l = sum f l + sum g l.
Proof. induction l; cbn; lia. Qed.
Lemma sum_zero : forall A (f : A -> nat) l, (forall x, In x l -> f x = 0) -> sum f l = 0.
Proof. induction l; intros H; cbn; auto; rewrite (H a), IHl; cbn; auto; intros; apply H; cbn;
  auto. Qed.
Lemma sum_swap : forall A B (f : A -> B -> nat) l m,
  sum (fun x => sum (f x) m) l = sum (fun y => sum (fun x => f x y) l) m.
Proof.
  induction l as [|a l IH]; intros m; cbn [sum].
  - symmetry; apply sum_zero; auto.
  - rewrite IH, <- sum_plus; reflexivity.
Qed.
Lemma sum_perm : forall A (f : A -> nat) l m, Permutation l m -> sum f l = sum f m.
Proof. induction 1; cbn; lia. Qed.
Lemma sum_filter : forall A (p : A -> bool) l, length (filter p l) = sum (fun x => one_if (p x)) l.
Proof. induction l; cbn; auto; destruct (p a); cbn; lia. Qed.
Lemma sum_const : forall A (l : list A) k, sum (fun _ => k) l = k * length l.
Proof. induction l as [|a l IH]; intros; cbn [sum length]; rewrite ?IH; nia. Qed.

Lemma sum_point : forall l c, NoDup l -> sum (fun x => one_if (corner_eqb x c)) l
  = one_if (existsb (corner_eqb c) l).
Proof.
  induction l as [|a l IH]; intros c H; cbn; auto.
  apply NoDup_cons_iff in H; destruct H as [N H].
  destruct (corner_eqb a c) eqn:E; cbn.
  - apply corner_eqb_eq in E; subst.
    assert (corner_eqb c c = true) as -> by (apply corner_eqb_eq; auto); cbn.
    rewrite sum_zero; auto; intros x I; destruct (corner_eqb x c) eqn:F; auto.
    apply corner_eqb_eq in F; subst; contradiction.
  - rewrite IH by auto.
    destruct (corner_eqb c a) eqn:F; auto; apply corner_eqb_eq in F; subst.
    assert (corner_eqb a a = true) by (apply corner_eqb_eq; auto); congruence.
Qed.

Lemma sum_corners : forall (f : corner -> nat) l,
  sum f (corners l) = sum (fun t => f (t, p0) + f (t, p1) + f (t, p2)) l.
Proof.
  induction l as [|t l IH]; [reflexivity|].
  change (corners (t :: l)) with (at_face t ++ corners l); rewrite sum_app, IH; cbn [sum at_face];
    lia.
Qed.

(** The three corners of a face, beginning with any. *)
Lemma three_corners : forall (f : corner -> nat) c,
  f (face c, p0) + f (face c, p1) + f (face c, p2) = f c + f (next c) + f (prev c).
Proof.
  intros f [t []]; unfold prev, next, face; cbn [fst snd turn]; lia.
Qed.

(** ** Each inner edge is open from one of its faces *)

(** Whether a face that is not in the list lies across from corner c. *)
Definition open (M : table) (vis : list nat) (c : corner) : bool :=
  match opposite M c with None => false | Some d => negb (mem (face d) vis) end.

(** Faces are taken one after another, the last one first in the list: how many sides are open when
    the face is taken, together. *)
Fixpoint opened (M : table) (vis : list nat) : nat :=
  match vis with
  | [] => 0
  | t :: l => sum (fun c => one_if (open M vis c)) (at_face t) + opened M l
  end.

Definition inner_sides (M : table) (l : list nat) : nat :=
  sum (fun c => one_if (negb (border M c))) (corners l).
Definition frontier (M : table) (l : list nat) : nat :=
  sum (fun c => one_if (open M l c)) (corners l).

(** Whether the face t lies across from c. *)
Definition leads_to (M : table) (t : nat) (c : corner) : bool :=
  match opposite M c with None => false | Some d => face d =? t end.

(** As many sides lead from the faces l to face t as from t to them. *)
Lemma both_ways : forall M l t, surface M -> NoDup l -> t < triangles M -> ~ In t l ->
  (forall u, In u l -> u < triangles M) ->
  sum (fun c => one_if (leads_to M t c)) (corners l)
  = sum (fun c => one_if (negb (border M c) && negb (open M l c))) (at_face t).
Proof.
  intros M l t HM N TT NI HL.
  transitivity (sum (fun c => sum (fun e => one_if
    match opposite M c with Some d => corner_eqb d e | None => false end) (at_face t)) (corners l)).
  - apply sum_ext; intros c I; unfold leads_to; destruct (opposite M c) as [[u k]|]; cbn; auto.
    unfold corner_eqb; cbn [fst snd]; destruct (u =? t) eqn:E; cbn [andb one_if]; auto.
    destruct k; reflexivity.
  - rewrite sum_swap; apply sum_ext; intros e I.
    assert (FE : face e = t) by (apply (in_corners [t]) in I; destruct I as [I|[]]; auto).
    transitivity (sum (fun x => one_if match opposite M e with
      Some d => corner_eqb x d | None => false end) (corners l)).
    + apply sum_ext; intros x J; apply in_corners in J; apply HL in J; f_equal.
      destruct (opposite M x) as [d|] eqn:X, (opposite M e) as [d'|] eqn:Y; auto.
      * destruct (corner_eqb d e) eqn:P, (corner_eqb x d') eqn:Q; auto; exfalso.
        -- apply corner_eqb_eq in P; subst d.
           destruct (opposite_sound M HM x e J X) as (_ & O & _).
           rewrite Y in O; injection O as ->.
           assert (corner_eqb x x = true) by (apply corner_eqb_eq; auto); congruence.
        -- apply corner_eqb_eq in Q; subst d'.
           destruct (opposite_sound M HM e x ltac:(congruence) Y) as (_ & O & _).
           rewrite X in O; injection O as ->.
           assert (corner_eqb e e = true) by (apply corner_eqb_eq; auto); congruence.
      * destruct (corner_eqb d e) eqn:P; auto; apply corner_eqb_eq in P; subst d.
        destruct (opposite_sound M HM x e J X) as (_ & O & _); congruence.
      * destruct (corner_eqb x d') eqn:Q; auto; apply corner_eqb_eq in Q; subst d'.
        destruct (opposite_sound M HM e x ltac:(congruence) Y) as (_ & O & _); congruence.
    + unfold border, open; destruct (opposite M e) as [d|] eqn:Y.
      * rewrite sum_point by (apply nodup_corners; auto); f_equal; cbn [negb andb].
        rewrite negb_involutive; apply eq_true_iff_eq; rewrite existsb_exists, mem_true; split.
        -- intros [z [Z E]]; apply corner_eqb_eq in E; subst; apply in_corners; auto.
        -- intros Z; exists d; split; [apply in_corners; auto|apply corner_eqb_eq; auto].
      * apply sum_zero; auto.
Qed.

(** Twice the sides opened so far are the inner sides of the faces taken and the sides still open.
    *)
Lemma opened_twice : forall M l, surface M -> NoDup l -> (forall u, In u l -> u < triangles M) ->
  2 * opened M l = inner_sides M l + frontier M l.
Proof.
  intros M l HM; induction l as [|t l IH]; intros N HL; [reflexivity|].
  apply NoDup_cons_iff in N; destruct N as [NI N].
  assert (TT : t < triangles M) by (apply HL; cbn; auto).
  assert (HL' : forall u, In u l -> u < triangles M) by (intros; apply HL; cbn; auto).
  specialize (IH N HL'); pose proof (both_ways M l t HM N TT NI HL') as W.
  unfold inner_sides, frontier in *; cbn [opened].
  change (corners (t :: l)) with (at_face t ++ corners l); rewrite !sum_app.
  assert (A : sum (fun c => one_if (open M l c)) (corners l)
    = sum (fun c => one_if (open M (t :: l) c)) (corners l)
      + sum (fun c => one_if (leads_to M t c)) (corners l)).
  { rewrite <- sum_plus; apply sum_ext; intros c I; unfold open, leads_to.
    destruct (opposite M c) as [d|]; auto; unfold mem; cbn [existsb].
    fold (mem (face d) l); destruct (face d =? t) eqn:E; cbn [orb negb one_if].
    - apply Nat.eqb_eq in E; rewrite E; apply mem_false in NI; rewrite NI; auto.
    - lia. }
  assert (B : sum (fun c => one_if (negb (border M c))) (at_face t)
    = sum (fun c => one_if (open M (t :: l) c)) (at_face t)
      + sum (fun c => one_if (negb (border M c) && negb (open M l c))) (at_face t)).
  { rewrite <- sum_plus; apply sum_ext; intros c I; unfold open, border.
    assert (FE : face c = t) by (apply (in_corners [t]) in I; destruct I as [I|[]]; auto).
    destruct (opposite M c) as [d|] eqn:O; auto.
    destruct (opposite_sound M HM c d ltac:(congruence) O) as (_ & _ & D & _).
    unfold mem; cbn [existsb negb andb]; fold (mem (face d) l).
    destruct (face d =? t) eqn:E; [apply Nat.eqb_eq in E; congruence|]; cbn [orb].
    destruct (mem (face d) l); reflexivity. }
  lia.
Qed.

(** A list of all faces, each once, has nothing left open. *)
Lemma opened_all : forall M l, surface M -> NoDup l -> (forall t, In t l <-> t < triangles M) ->
  2 * opened M l + border_edges M = 3 * triangles M /\ length l = triangles M.
Proof.
  intros M l HM N A.
  assert (P : Permutation l (seq 0 (triangles M))).
  { apply NoDup_Permutation; auto using seq_NoDup; intros t; rewrite A, in_seq; lia. }
  assert (L : length l = triangles M) by (rewrite (Permutation_length P); apply seq_length).
  split; auto; rewrite (opened_twice M l HM N) by (intros; apply A; auto).
  assert (Z : frontier M l = 0).
  { unfold frontier; apply sum_zero; intros c I; apply in_corners, A in I; unfold open.
    destruct (opposite M c) as [d|] eqn:O; auto.
    destruct (opposite_sound M HM c d I O) as (F & _); apply A, mem_true in F; rewrite F; auto. }
  rewrite Z; unfold inner_sides, border_edges, border_corners, all_corners.
  rewrite sum_filter, !sum_corners.
  rewrite (sum_perm _ _ _ _ P), Nat.add_0_r, <- sum_plus.
  rewrite (sum_ext _ _ (fun _ => 3)).
  - rewrite sum_const, seq_length; lia.
  - intros t _; destruct (border M (t, p0)), (border M (t, p1)), (border M (t, p2)); reflexivity.
Qed.

(** CPLX-COMPONENT-2: 2E = 3T + B. *)
Theorem twice_the_edges : forall M, surface M ->
  2 * edges M = 3 * triangles M + border_edges M.
Proof.
  intros M HM; set (down := fix down n := match n with 0 => [] | S k => k :: down k end).
  assert (D : forall n t, In t (down n) <-> t < n).
  { induction n as [|n IH]; intros t; cbn; [lia|]; rewrite IH; lia. }
  assert (N : forall n, NoDup (down n)).
  { induction n as [|n IH]; cbn; constructor; auto; rewrite D; lia. }
  destruct (opened_all M (down (triangles M)) HM (N _) (D _)) as [O _].
  assert (G : forall n, n <= triangles M ->
    sum (fun c => one_if (counted M c)) (corners (seq 0 n))
    = opened M (down n) + sum (fun c => one_if (border M c)) (corners (seq 0 n))).
  { induction n as [|n IH]; intros L; [reflexivity|].
    rewrite seq_S; unfold corners; rewrite flat_map_app; fold (corners (seq 0 n)).
    rewrite !sum_app; cbn [opened down flat_map]; fold down; rewrite app_nil_r, IH by lia.
    cbn [plus].
    assert (E : sum (fun c => one_if (counted M c)) (at_face n)
      = sum (fun c => one_if (open M (down (S n)) c)) (at_face n)
        + sum (fun c => one_if (border M c)) (at_face n)).
    { rewrite <- sum_plus; apply sum_ext; intros c I.
      assert (F : face c = n) by (apply (in_corners [n]) in I; destruct I as [I|[]]; auto).
      unfold counted, open, border; destruct (opposite M c) as [d|] eqn:OC; auto.
      destruct (opposite_sound M HM c d ltac:(lia) OC) as (_ & _ & X & _).
      destruct (mem (face d) (down (S n))) eqn:Y.
      - apply mem_true, D in Y; destruct (Nat.ltb_spec (face c) (face d)); cbn; lia.
      - apply mem_false in Y; rewrite D in Y; destruct (Nat.ltb_spec (face c) (face d)); cbn; lia. }
    change (down (S n)) with (n :: down n) in E; lia. }
  specialize (G (triangles M) (le_n _)).
  unfold edges, border_edges, border_corners, all_corners in *; rewrite !sum_filter in *; lia.
Qed.
