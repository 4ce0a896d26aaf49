(** * The components of finite graphs, and what an edge does to their number

    Clauses: OPER-SHEET-3 and CPLX-COMPLEX-6 (the number of components), for OPER-EFFECT-2.

    A new vertex adds one; an edge between vertices that are joined already adds none; an edge
    between others takes one away. *)

Require Import List Lia Arith Permutation Relation_Operators.
Import ListNotations.

Definition edge : Type := (nat * nat)%type.

(** Joined by a way along the edges, in either direction. *)
Definition linked (E : list edge) : nat -> nat -> Prop :=
  clos_refl_sym_trans nat (fun x y => In (x, y) E).

(** One vertex of each component. *)
Definition representatives (V : list nat) (E : list edge) (R : list nat) : Prop :=
  NoDup R /\ incl R V /\ (forall v, In v V -> exists r, In r R /\ linked E v r)
  /\ forall r r', In r R -> In r' R -> linked E r r' -> r = r'.

Definition components (V : list nat) (E : list edge) (n : nat) : Prop :=
  exists R, representatives V E R /\ length R = n.

Lemma linked_refl : forall E x, linked E x x. Proof. intros; apply rst_refl. Qed.
Lemma linked_sym : forall E x y, linked E x y -> linked E y x. Proof. intros; apply rst_sym;
  auto. Qed.
Lemma linked_trans : forall E x y z, linked E x y -> linked E y z -> linked E x z.
Proof. intros; eapply rst_trans; eauto. Qed.
Lemma linked_edge : forall E x y, In (x, y) E -> linked E x y. Proof. intros; apply rst_step;
  auto. Qed.
Lemma linked_more : forall E E' x y, incl E E' -> linked E x y -> linked E' x y.
Proof.
  intros E E' x y I H; induction H;
    [apply rst_step; auto|apply rst_refl|apply rst_sym; auto|eapply rst_trans; eauto].
Qed.

(** The number is a number: no two choices differ. *)
Lemma pigeonhole : forall (P : nat -> nat -> Prop) l m, NoDup l ->
  (forall x, In x l -> exists y, In y m /\ P x y) ->
  (forall x x' y, In x l -> In x' l -> P x y -> P x' y -> x = x') -> length l <= length m.
Proof.
  intros P; induction l as [|x l IH]; intros m N H U; cbn; [lia|].
  apply NoDup_cons_iff in N; destruct N as [NI N].
  destruct (H x (or_introl eq_refl)) as (y & Y & PY); apply in_split in Y.
  destruct Y as (m1 & m2 & ->); rewrite app_length; cbn.
  assert (length l <= length (m1 ++ m2)); [|rewrite app_length in *; lia].
  apply IH; auto.
  - intros z Z; destruct (H z (or_intror Z)) as (w & W & PW); exists w; split; auto.
    apply in_app_iff in W; apply in_app_iff; destruct W as [W|[<-|W]]; auto; exfalso.
    apply NI; rewrite (U x z y); cbn; auto.
  - intros a b c A B; apply U; cbn; auto.
Qed.

Theorem components_unique : forall V E m n, components V E m -> components V E n -> m = n.
Proof.
  assert (K : forall V E R R', representatives V E R -> representatives V E R' ->
    length R <= length R').
  { intros V E R R' (N & I & _ & U) (_ & _ & C & _).
    apply (pigeonhole (fun x y => linked E x y)); auto.
    intros x x' y X X' A B; apply U; auto; eapply linked_trans; [exact A|apply linked_sym; auto]. }
  intros V E m n (R & HR & <-) (R' & HR' & <-).
  apply Nat.le_antisymm; eauto.
Qed.

Lemma components_perm : forall V V' E E' n, Permutation V V' -> Permutation E E' ->
  components V E n -> components V' E' n.
Proof.
  intros V V' E E' n PV PE (R & (N & I & C & U) & L).
  assert (F : forall x y, linked E x y -> linked E' x y).
  { intros x y; apply linked_more; intros e; apply Permutation_in; auto. }
  assert (G : forall x y, linked E' x y -> linked E x y).
  { intros x y; apply linked_more; intros e; apply Permutation_in, Permutation_sym; auto. }
  exists R; split; auto; split; [auto|split; [|split]].
  - intros x X; apply (Permutation_in _ PV), I, X.
  - intros v H; destruct (C v (Permutation_in _ (Permutation_sym PV) H)) as (r & A & B); eauto.
  - intros r r' A B D; apply U; auto.
Qed.

Theorem no_component : components [] [] 0.
Proof. exists []; split; auto; repeat split; [constructor|intros x []|intros v []|intros r r' []].
  Qed.

(** Edges lie between vertices. *)
Definition within (V : list nat) (E : list edge) : Prop :=
  forall x y, In (x, y) E -> In x V /\ In y V.

Lemma linked_within : forall V E x y, within V E -> linked E x y -> x = y \/ (In x V /\ In y V).
Proof.
  intros V E x y W H; induction H as [x y H|x|x y H IH|x y z H IH G IG]; auto.
  - destruct IH as [->|[A B]]; auto.
  - destruct IH as [->|[A B]], IG as [->|[C D]]; auto.
Qed.

(** A new vertex. *)
Theorem add_vertex : forall V E n v, within V E -> ~ In v V -> components V E n ->
  components (v :: V) E (S n).
Proof.
  intros V E n v W NV (R & (N & I & C & U) & L).
  exists (v :: R); split; [|cbn; auto]; split; [|split; [|split]].
  - constructor; auto.
  - intros x [<-|X]; [left|right]; auto.
  - intros x [<-|X]; [exists v; split; [left; auto|apply linked_refl]|].
    destruct (C x X) as (r & A & B); exists r; split; [right|]; auto.
  - intros r r' [<-|A] [<-|B] H; auto.
    + destruct (linked_within V E _ _ W H) as [E1|[E1 E2]]; [auto|contradiction].
    + destruct (linked_within V E _ _ W H) as [E1|[E1 E2]]; [auto|contradiction].
Qed.

(** An edge between vertices that are joined already. *)
Theorem add_known : forall V E n x y, linked E x y -> components V E n ->
  components V ((x, y) :: E) n.
Proof.
  intros V E n x y H (R & (N & I & C & U) & L).
  assert (G : forall a b, linked ((x, y) :: E) a b -> linked E a b).
  { intros a b K; induction K as [a b K|a|a b K IH|a b c K IH K' IH'].
    - destruct K as [K|K]; [injection K as <- <-; auto|apply linked_edge; auto].
    - apply linked_refl.
    - apply linked_sym; auto.
    - eapply linked_trans; eauto. }
  exists R; split; auto; split; [auto|split; [auto|split]].
  - intros v X; destruct (C v X) as (r & A & B); exists r; split; auto.
    eapply linked_more; [|exact B]; intros e K; right; auto.
  - intros r r' A B K; apply U; auto.
Qed.

(** An edge between vertices that are not. *)
Theorem add_joining : forall V E n x y, In x V -> In y V -> ~ linked E x y -> components V E n ->
  exists m, n = S m /\ components V ((x, y) :: E) m.
Proof.
  intros V E n x y X Y NL (R & (N & I & C & U) & L).
  destruct (C x X) as (rx & RX & LX); destruct (C y Y) as (ry & RY & LY).
  set (Q := fun a b => linked E a b \/ (linked E a x /\ linked E y b) \/ (linked E a y /\ linked E
    x b)).
  assert (G : forall a b, linked ((x, y) :: E) a b -> Q a b).
  { intros a b K; unfold Q; induction K as [a b K|a|a b K IH|a b c K IH K' IH'].
    - destruct K as [K|K]; [injection K as <- <-|left; apply linked_edge; auto].
      right; left; split; apply linked_refl.
    - left; apply linked_refl.
    - destruct IH as [A|[[A B]|[A B]]]; [left|right; right|right; left];
        try split; apply linked_sym; auto.
    - assert (S1 : linked E x y -> False) by auto.
      destruct IH as [A|[[A B]|[A B]]], IH' as [A'|[[A' B']|[A' B']]].
      + left; exact (linked_trans _ _ _ _ A A').
      + right; left; split; [exact (linked_trans _ _ _ _ A A')|exact B'].
      + right; right; split; [exact (linked_trans _ _ _ _ A A')|exact B'].
      + right; left; split; [exact A|exact (linked_trans _ _ _ _ B A')].
      + exfalso; apply S1, linked_sym; exact (linked_trans _ _ _ _ B A').
      + left; exact (linked_trans _ _ _ _ A B').
      + right; right; split; [exact A|exact (linked_trans _ _ _ _ B A')].
      + left; exact (linked_trans _ _ _ _ A B').
      + exfalso; apply S1; exact (linked_trans _ _ _ _ B A'). }
  pose proof RY as SP; apply in_split in SP; destruct SP as (R1 & R2 & ER).
  exists (length (R1 ++ R2)); split; [rewrite <- L, ER, !app_length; cbn; lia|].
  assert (NR : ~ In ry (R1 ++ R2)) by (rewrite ER in N; apply NoDup_remove_2 in N; auto).
  assert (IR : forall r, In r (R1 ++ R2) -> In r R).
  { intros r H; rewrite ER; apply in_app_iff in H; apply in_app_iff; cbn; tauto. }
  assert (XY : rx <> ry).
  { intros <-; apply NL; eapply linked_trans; [exact LX|apply linked_sym; exact LY]. }
  assert (ML : forall a b, linked E a b -> linked ((x, y) :: E) a b).
  { intros a b; apply linked_more; intros e K; right; auto. }
  exists (R1 ++ R2); split; auto; split; [|split; [|split]].
  - rewrite ER in N; apply NoDup_remove_1 in N; auto.
  - intros r H; auto.
  - intros v V'; destruct (C v V') as (r & A & B); destruct (Nat.eq_dec r ry) as [->|NE].
    + exists rx; split.
      * rewrite ER in RX; apply in_app_iff in RX; apply in_app_iff.
        destruct RX as [Z|[Z|Z]]; [left; exact Z|congruence|right; exact Z].
      * apply linked_trans with ry; [apply ML; auto|].
        apply linked_trans with y; [apply ML, linked_sym; auto|].
        apply linked_trans with x; [apply linked_sym, linked_edge; left; auto|apply ML; auto].
    + exists r; split; [|apply ML; auto].
      rewrite ER in A; apply in_app_iff in A; apply in_app_iff.
      destruct A as [Z|[Z|Z]]; [left; exact Z|congruence|right; exact Z].
  - intros r r' A B K; apply G in K; destruct K as [K|[[K K']|[K K']]]; [apply U; auto| |]; exfalso.
    + apply NR; replace ry with r'; auto; apply U; auto.
      apply linked_trans with y; [apply linked_sym; auto|auto].
    + apply NR; replace ry with r; auto; apply U; auto.
      apply linked_trans with y; auto.
Qed.
