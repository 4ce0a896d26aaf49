(** * Connected oriented surfaces as corner tables

    Clauses: CPLX-CORNER-1 to CPLX-CORNER-3 (corners, [next], [previous], [opposite]),
    CPLX-SURFACE-1
    as far as it is needed, CPLX-COMPONENT-2 (a component has (3T + B)/2 edges), CPLX-COMPONENT-3
    (the genus).

    A corner 3t + k is written (t, k) with k one of three places. *)

Require Import ZArith List Lia Arith Bool Permutation.
Import ListNotations.

Inductive place := p0 | p1 | p2.
Definition corner : Type := (nat * place)%type.
Definition face (c : corner) : nat := fst c.
Definition turn (k : place) : place := match k with p0 => p1 | p1 => p2 | p2 => p0 end.
Definition next (c : corner) : corner := (fst c, turn (snd c)).
Definition prev (c : corner) : corner := next (next c).
Definition at_face (t : nat) : list corner := [(t, p0); (t, p1); (t, p2)].
Definition corners (l : list nat) : list corner := flat_map at_face l.

Lemma next_prev : forall c, next (prev c) = c. Proof. intros [t []]; reflexivity. Qed.
Lemma prev_next : forall c, prev (next c) = c. Proof. intros [t []]; reflexivity. Qed.
Lemma next_next : forall c, next (next c) = prev c. Proof. reflexivity. Qed.
Lemma prev_prev : forall c, prev (prev c) = next c. Proof. intros [t []]; reflexivity. Qed.
Lemma face_next : forall c, face (next c) = face c. Proof. reflexivity. Qed.
Lemma face_prev : forall c, face (prev c) = face c. Proof. reflexivity. Qed.
Lemma next_inj : forall c d, next c = next d -> c = d.
Proof. intros c d H; rewrite <- (prev_next c), <- (prev_next d); congruence. Qed.
Lemma prev_inj : forall c d, prev c = prev d -> c = d.
Proof. intros c d H; rewrite <- (next_prev c), <- (next_prev d); congruence. Qed.

Lemma same_face : forall c d, face c = face d -> d = c \/ d = next c \/ d = prev c.
Proof. intros [t k] [u j] H; cbn in H; subst; destruct k, j; cbn; auto. Qed.

Definition place_eqb (j k : place) : bool :=
  match j, k with p0, p0 | p1, p1 | p2, p2 => true | _, _ => false end.
Definition corner_eqb (c d : corner) : bool := (fst c =? fst d) && place_eqb (snd c) (snd d).
Lemma corner_eqb_eq : forall c d, corner_eqb c d = true <-> c = d.
Proof.
  intros [t j] [u k]; unfold corner_eqb; cbn [fst snd]; rewrite andb_true_iff, Nat.eqb_eq.
  split; [intros [-> H]; destruct j, k; cbn in H; congruence|].
  intros H; injection H as -> ->; destruct k; auto.
Qed.

Lemma in_corners : forall l c, In c (corners l) <-> In (face c) l.
Proof.
  intros l [t k]; unfold corners, face; rewrite in_flat_map; cbn [fst]; split.
  - intros [u [H I]]; cbn in I; destruct I as [I|[I|[I|[]]]]; injection I; intros; subst; auto.
  - intros H; exists t; split; auto; destruct k; cbn; auto.
Qed.

Lemma nodup_corners : forall l, NoDup l -> NoDup (corners l).
Proof.
  induction 1 as [|t l N _ IH]; [constructor|]; cbn.
  assert (forall k, ~ In (t, k) (corners l)) as K by (intros k I; apply N; apply in_corners in I;
    exact I).
  repeat constructor; cbn; intuition (try discriminate); eapply K; eauto.
Qed.

Definition mem (x : nat) (l : list nat) : bool := existsb (Nat.eqb x) l.
Lemma mem_true : forall x l, mem x l = true <-> In x l.
Proof.
  intros x l; unfold mem; rewrite existsb_exists; split.
  - intros [y [H E]]; apply Nat.eqb_eq in E; congruence.
  - intros H; exists x; split; auto; apply Nat.eqb_refl.
Qed.
Lemma mem_false : forall x l, mem x l = false <-> ~ In x l.
Proof. intros x l; rewrite <- mem_true; destruct (mem x l); split; congruence. Qed.

(** ** Surfaces *)

(** The data: T triangles, n vertices, the vertex of each corner, the corner across its edge, the
    boundary curve of each vertex that lies on one, and the list of the curves. *)
Record table := {
  triangles : nat;
  vertices : nat;
  vertex : corner -> nat;
  opposite : corner -> option corner;
  curve : nat -> option nat;
  curves : list nat
}.

Definition border (M : table) (c : corner) : bool :=
  match opposite M c with None => true | Some _ => false end.
Definition inner_vertex (M : table) (v : nat) : bool :=
  match curve M v with None => true | Some _ => false end.
Definition all_corners (M : table) : list corner := corners (seq 0 (triangles M)).
Definition border_corners (M : table) : list corner := filter (border M) (all_corners M).

(** Two faces are joined if a walk across edges leads from one to the other (CPLX-COMPONENT-1). *)
Inductive joined (M : table) (f : nat) : nat -> Prop :=
| here : joined M f f
| across : forall c d, joined M f (face c) -> face c < triangles M -> opposite M c = Some d ->
    joined M f (face d).

(** What is asked of a connected oriented surface. It is less than CPLX-SURFACE-1 and -2: that the
    faces at a vertex are one fan is used only through [starts] (one border edge leaves each vertex
    of a curve), and that vertices of one curve are joined by border edges is not used at all. *)
Record surface (M : table) : Prop := {
  (* CPLX-CORNER-3: opposite is an involution between two faces, and turns the edge round. *)
  opposite_sound : forall c d, face c < triangles M -> opposite M c = Some d ->
    face d < triangles M /\ opposite M d = Some c /\ face c <> face d
    /\ vertex M (next d) = vertex M (prev c) /\ vertex M (prev d) = vertex M (next c);
  (* CPLX-REJECT-4: the vertices of a triangle are different. *)
  distinct : forall c, face c < triangles M -> vertex M c <> vertex M (next c);
  (* CPLX-REJECT-5: no two triangles have the same three vertices. *)
  simple : forall f g, f < triangles M -> g < triangles M ->
    (forall k, exists j, vertex M (f, k) = vertex M (g, j)) -> f = g;
  (* CPLX-REJECT-3 and -9: the vertices are 0 to n - 1, and each is in a face. *)
  vertex_in : forall c, face c < triangles M -> vertex M c < vertices M;
  vertex_used : forall v, v < vertices M -> exists c, face c < triangles M /\ vertex M c = v;
  (* CPLX-CURVE-1: both ends of a border edge lie on its curve, and the vertices on curves are the
     starts of the border edges, each once. *)
  border_curve : forall c, face c < triangles M -> opposite M c = None ->
    exists k, curve M (vertex M (next c)) = Some k /\ curve M (vertex M (prev c)) = Some k;
  starts : Permutation (map (fun c => vertex M (next c)) (border_corners M))
    (filter (fun v => negb (inner_vertex M v)) (seq 0 (vertices M)));
  curves_once : NoDup (curves M);
  curves_all : forall k, In k (curves M) <-> exists v, v < vertices M /\ curve M v = Some k;
  (* One component. *)
  connected : forall f g, f < triangles M -> g < triangles M -> joined M f g
}.

(** ** Counts *)

(** An edge is counted in its first face: where it is a border edge, or the face across comes
    later. *)
Definition counted (M : table) (c : corner) : bool :=
  match opposite M c with None => true | Some d => face c <? face d end.
Definition edges (M : table) : nat := length (filter (counted M) (all_corners M)).
Definition border_edges (M : table) : nat := length (border_corners M).

Definition euler (M : table) : Z :=
  (Z.of_nat (vertices M) - Z.of_nat (edges M) + Z.of_nat (triangles M))%Z.

(** CPLX-COMPONENT-3: the genus is the g with χ = 2 - 2g - b. *)
Definition has_genus (M : table) (g : Z) : Prop :=
  euler M = (2 - 2 * g - Z.of_nat (length (curves M)))%Z.
