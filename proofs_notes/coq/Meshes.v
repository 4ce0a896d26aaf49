(** Oriented triangle meshes as lists of faces, and what makes one a sphere.

    CPLX-INPUT-1 and CPLX-INPUT-4 for closed surfaces: [surface F] says that no edge is run twice in
    one direction, every edge is run in both, no face has a vertex twice, no two faces have the same
    three vertices, and the link of every vertex is a circle (CPLX-SURFACE-1). [sphere F] adds that
    F is connected (CPLX-COMPONENT-1) and that its Euler characteristic is 2 (CPLX-COMPONENT-2). *)
Require Import List Arith Lia Bool Permutation Relation_Operators.
Import ListNotations.

Notation face := (nat * nat * nat)%type (only parsing).
Notation edge := (nat * nat)%type (only parsing).
Definition flip (e : edge) : edge := (snd e, fst e).
Definition runs (f : face) : list edge := let '(x, y, z) := f in [(x, y); (y, z); (z, x)].
Definition edges (F : list face) : list edge := flat_map runs F.
Definition corners (f : face) : list nat := let '(x, y, z) := f in [x; y; z].
Definition vertices (F : list face) : list nat := flat_map corners F.

(** The face is named from any of its corners: CPLX-SURFACE-2. *)
Definition has (F : list face) (x y z : nat) : Prop :=
  In (x, y, z) F \/ In (y, z, x) F \/ In (z, x, y) F.

Definition edge_eq_dec (e f : edge) : {e = f} + {e <> f}.
Proof. decide equality; apply Nat.eq_dec. Defined.

(** The third vertex of the face that runs from a to b: EB-GATE-1. *)
Fixpoint apex (F : list face) (a b : nat) : option nat :=
  match F with
  | [] => None
  | (x, y, z) :: F =>
      if edge_eq_dec (x, y) (a, b) then Some z
      else if edge_eq_dec (y, z) (a, b) then Some x
      else if edge_eq_dec (z, x) (a, b) then Some y
      else apex F a b
  end.

(** The edges from a through X to b, and those of a cyclic list. *)
Fixpoint path (a : nat) (X : list nat) (b : nat) : list edge :=
  match X with [] => [(a, b)] | x :: X => (a, x) :: path x X b end.
Definition ring (l : list nat) : list edge := match l with [] => [] | a :: X => path a X a end.

(** The faces F run next to f and g one edge in both directions. *)
Definition neighbours (F : list face) (f g : face) : Prop :=
  In f F /\ In g F /\ exists x y, In (x, y) (runs f) /\ In (y, x) (runs g).
Definition connected (F : list face) : Prop :=
  forall f g, In f F -> In g F -> clos_refl_trans face (neighbours F) f g.

Definition circle (F : list face) (x : nat) : Prop :=
  exists l, NoDup l /\ 3 <= length l /\ forall y z, has F x y z <-> In (y, z) (ring l).

Record surface (F : list face) : Prop := {
  not_empty : F <> [];
  proper : forall x y, In (x, y) (edges F) -> x <> y;
  once : NoDup (edges F);
  closed : forall x y, In (x, y) (edges F) -> In (y, x) (edges F);
  distinct : forall x y z, has F x y z -> ~ has F y x z;
  circles : forall x, In x (vertices F) -> circle F x }.

Definition vertex_count (F : list face) : nat := length (nodup Nat.eq_dec (vertices F)).

(** Each edge of a closed surface is run twice, so this is chi = 2 doubled. *)
Definition sphere (F : list face) : Prop :=
  surface F /\ connected F /\ 2 * vertex_count F + 2 * length F = length (edges F) + 4.

Lemma length_edges : forall F, length (edges F) = 3 * length F.
Proof.
  induction F as [|[[x y] z] F IH]; [reflexivity|].
  unfold edges in *; cbn [flat_map runs app length]; lia.
Qed.

Lemma edges_app : forall F G, edges (F ++ G) = edges F ++ edges G.
Proof. intros; apply flat_map_app. Qed.

Lemma edges_perm : forall F G, Permutation F G -> Permutation (edges F) (edges G).
Proof. intros; apply Permutation_flat_map; assumption. Qed.

Lemma has_turn : forall F x y z, has F x y z -> has F y z x.
Proof. unfold has; tauto. Qed.

Lemma has_edge : forall F x y z, has F x y z -> In (x, y) (edges F).
Proof.
  unfold has, edges; intros F x y z H; apply in_flat_map.
  destruct H as [H|[H|H]]; eexists; (split; [exact H|]); cbn; auto.
Qed.

Lemma edge_has : forall F x y, In (x, y) (edges F) -> exists z, has F x y z.
Proof.
  unfold has, edges; intros F x y H; apply in_flat_map in H; destruct H as ([[p q] r] & I & J).
  cbn in J; destruct J as [J|[J|[J|[]]]]; injection J as <- <-; eauto.
Qed.

Lemma has_vertex : forall F x y z, has F x y z -> In x (vertices F).
Proof.
  unfold has, vertices; intros F x y z H; apply in_flat_map.
  destruct H as [H|[H|H]]; eexists; (split; [exact H|]); cbn; auto.
Qed.

Lemma vertex_has : forall F x, In x (vertices F) -> exists y z, has F x y z.
Proof.
  unfold has, vertices; intros F x H; apply in_flat_map in H; destruct H as ([[p q] r] & I & J).
  cbn in J; destruct J as [<-|[<-|[<-|[]]]]; eauto 6.
Qed.

Lemma has_cons : forall f F x y z, has (f :: F) x y z <-> has [f] x y z \/ has F x y z.
Proof. unfold has; cbn; intros; tauto. Qed.

Lemma has_app : forall F G x y z, has (F ++ G) x y z <-> has F x y z \/ has G x y z.
Proof. unfold has; intros; rewrite !in_app_iff; tauto. Qed.

Lemma has_incl : forall F G x y z, incl F G -> has F x y z -> has G x y z.
Proof. unfold has, incl; intros; intuition auto. Qed.

Lemma apex_has : forall F a b v, apex F a b = Some v -> has F a b v.
Proof.
  induction F as [|[[x y] z] F IH]; cbn [apex]; intros a b v H; [discriminate|].
  apply has_cons; unfold has at 1; cbn [In].
  repeat match type of H with context [if ?d then _ else _] => destruct d as [e|?] end;
    try (injection e as -> ->; injection H as ->); auto 6.
Qed.

Lemma NoDup_app_split : forall (A : Type) (l m : list A), NoDup (l ++ m) ->
  NoDup l /\ NoDup m /\ forall x, In x l -> ~ In x m.
Proof.
  induction l as [|a l IH]; cbn; intros m H.
  - repeat split; auto using NoDup_nil.
  - inversion H as [|? ? N D]; subst; destruct (IH _ D) as (P & Q & X); rewrite in_app_iff in N.
    repeat split; auto.
    + constructor; tauto.
    + intros x [<-|I] J; [tauto|exact (X x I J)].
Qed.

Lemma NoDup_app_join : forall (A : Type) (l m : list A), NoDup l -> NoDup m ->
  (forall x, In x l -> ~ In x m) -> NoDup (l ++ m).
Proof.
  induction l as [|a l IH]; cbn; intros m P Q X; auto.
  inversion P; subst; constructor.
  - rewrite in_app_iff; intros [I|I]; [auto|exact (X a (or_introl eq_refl) I)].
  - apply IH; auto.
Qed.

Lemma has_apex : forall F a b v, NoDup (edges F) -> has F a b v -> apex F a b = Some v.
Proof.
  induction F as [|[[x y] z] F IH]; intros a b v N H; [destruct H as [[]|[[]|[]]]|].
  change (edges ((x, y, z) :: F)) with (runs (x, y, z) ++ edges F) in N.
  apply NoDup_app_split in N; destruct N as (N1 & N2 & X); cbn [runs] in *.
  inversion N1 as [|? ? A1 N1']; inversion N1' as [|? ? A2 ?]; subst; cbn [In] in A1, A2.
  apply has_cons in H; cbn [apex]; destruct H as [H|H].
  - unfold has in H; cbn [In] in H.
    repeat match goal with |- context [if ?d then _ else _] => destruct d end.
    all: assert (D1 : (x, y) <> (y, z)) by (intros D; apply A1; rewrite D; auto).
    all: assert (D2 : (x, y) <> (z, x)) by (intros D; apply A1; rewrite D; auto).
    all: assert (D3 : (y, z) <> (z, x)) by (intros D; apply A2; rewrite D; auto).
    all: clear IH X N1 N1' N2 A1 A2.
    all: destruct H as [[H|[]]|[[H|[]]|[H|[]]]]; injection H as ? ? ?; subst; congruence.
  - assert (I := has_edge _ _ _ _ H).
    repeat match goal with |- context [if ?d then _ else _] => destruct d as [e|?] end;
      try (exfalso; apply (X (a, b)); [rewrite <- e; cbn; tauto|exact I]); auto.
Qed.

Lemma has_unique : forall F a b v w, NoDup (edges F) -> has F a b v -> has F a b w -> v = w.
Proof.
  intros F a b v w N H K; apply (has_apex _ _ _ _ N) in H; apply (has_apex _ _ _ _ N) in K; congruence.
Qed.

Lemma path_app : forall X a v Y b, path a (X ++ v :: Y) b = path a X v ++ path v Y b.
Proof. induction X; intros; cbn [app path]; rewrite ?IHX; reflexivity. Qed.

Lemma path_in : forall X a b x y, In (x, y) (path a X b) -> In x (a :: X) /\ In y (X ++ [b]).
Proof.
  induction X as [|c X IH]; intros a b x y; cbn [path In app].
  - intros [H|[]]; injection H as <- <-; auto.
  - intros [H|H]; [injection H as <- <-; auto|apply IH in H; cbn in H; intuition auto].
Qed.

(** The edges across from x: its link as a list. *)
Definition link1 (x : nat) (f : face) : list edge :=
  let '(p, q, r) := f in
  (if Nat.eq_dec x p then [(q, r)] else []) ++ (if Nat.eq_dec x q then [(r, p)] else [])
  ++ (if Nat.eq_dec x r then [(p, q)] else []).
Definition link (x : nat) (F : list face) : list edge := flat_map (link1 x) F.

Lemma link_has : forall F x y z, In (y, z) (link x F) <-> has F x y z.
Proof.
  induction F as [|[[p q] r] F IH]; intros x y z.
  - cbn; unfold has; cbn; tauto.
  - unfold link in *; cbn [flat_map]; rewrite in_app_iff, IH, has_cons; apply or_iff_compat_r.
    unfold link1, has; rewrite !in_app_iff; cbn [In].
    destruct (Nat.eq_dec x p), (Nat.eq_dec x q), (Nat.eq_dec x r); cbn [In];
      intuition (try congruence); subst;
      repeat match goal with H : (_, _) = (_, _) |- _ => injection H as ? ?; subst end; auto;
      try congruence.
Qed.

Lemma link_absent : forall F x, ~ In x (vertices F) -> link x F = [].
Proof.
  intros F x H; destruct (link x F) as [|[y z] l] eqn:sE; [reflexivity|].
  exfalso; apply H; apply has_vertex with y z; apply link_has; rewrite sE; left; reflexivity.
Qed.

Lemma neighbours_incl : forall F G f g, incl F G ->
  clos_refl_trans face (neighbours F) f g -> clos_refl_trans face (neighbours G) f g.
Proof.
  intros F G f g I H; induction H as [f g (A & B & sC)| |]; [|apply rt_refl|eapply rt_trans; eauto].
  apply rt_step; repeat split; auto.
Qed.

Lemma neighbours_sym : forall F f g, clos_refl_trans face (neighbours F) f g ->
  clos_refl_trans face (neighbours F) g f.
Proof.
  intros F f g H; induction H as [f g (A & B & x & y & P & Q)| |]; [|apply rt_refl|eapply rt_trans; eauto].
  apply rt_step; repeat split; auto; exists y, x; auto.
Qed.
