(** The decoder of closed components without records, and that it makes spheres.

    EB-DECODE-2, EB-GRAMMAR-3, -5, -8, -9 for one closed component without records: [decode] parses
    the word from its end, wants one loop of three edges, draws the tree on P, and refuses a surface
    with an edge run twice or two faces on the same vertices. Vertices and faces are numbered by
    EB-ORDER. Whatever it accepts is a sphere ([decoded_is_sphere]), of as many faces as the word has
    letters and one, and as many vertices as it has C and three ([decoded_counts]; EB-COUNT-2). *)
Require Import List Arith Lia Bool Permutation.
Require Import Clers.Letters Clers.Words Clers.Meshes Clers.Discs Clers.Fans.
Import ListNotations.
Open Scope nat_scope.

Definition face_eq_dec (f g : face) : {f = g} + {f <> g}.
Proof. decide equality; [apply Nat.eq_dec|apply edge_eq_dec]. Defined.

Fixpoint no_repeat (l : list edge) : bool :=
  match l with
  | [] => true
  | e :: l => if in_dec edge_eq_dec e l then false else no_repeat l
  end.

Definition turned_over (F : list face) (f : face) : bool :=
  let '(x, y, z) := f in
  existsb (fun g => if in_dec face_eq_dec g F then true else false) [(y, x, z); (x, z, y); (z, y, x)].

(** EB-GRAMMAR-9, double-edge: two edges, or two triangles, have the same vertices. *)
Definition simple (F : list face) : bool :=
  no_repeat (edges F) && forallb (fun f => negb (turned_over F f)) F.

Definition decode (w : list symbol) : option (list face) :=
  match parse w with
  | None => None
  | Some t =>
      if len t =? 3 then
        let F := (0, 1, 2) :: draw t 2 1 [0] (seq 3 (creations t)) in
        if simple F then Some F else None
      else None
  end.

Lemma no_repeat_NoDup : forall l, no_repeat l = true <-> NoDup l.
Proof.
  induction l as [|e l IH]; cbn [no_repeat]; [split; auto using NoDup_nil|].
  destruct (in_dec edge_eq_dec e l) as [I|I]; rewrite NoDup_cons_iff, <- IH; intuition congruence.
Qed.

Lemma turned_over_has : forall F x y z, turned_over F (x, y, z) = true <-> has F y x z.
Proof.
  intros F x y z; unfold turned_over, has; cbn [existsb].
  repeat match goal with |- context [in_dec ?d ?f ?l] => destruct (in_dec d f l) end; cbn;
    intuition congruence.
Qed.

Lemma simple_spec : forall F, simple F = true <->
  NoDup (edges F) /\ forall x y z, has F x y z -> ~ has F y x z.
Proof.
  intros F; unfold simple; rewrite andb_true_iff, no_repeat_NoDup, forallb_forall.
  apply and_iff_compat_l; split.
  - assert (A : (forall f, In f F -> negb (turned_over F f) = true) ->
      forall x y z, In (x, y, z) F -> ~ has F y x z).
    { intros H x y z I J; apply turned_over_has in J; specialize (H _ I); rewrite J in H; discriminate. }
    intros H x y z [I|[I|I]] J; apply (A H _ _ _ I); unfold has in *; tauto.
  - intros H [[x y] z] I; destruct (turned_over F (x, y, z)) eqn:sE; [|reflexivity].
    apply turned_over_has in sE; exfalso; apply (H x y z); unfold has in *; auto.
Qed.

Lemma decode_inv : forall w F, decode w = Some F -> exists t G, ok t /\ w = flat t /\
  F = (0, 1, 2) :: G /\ disc t 2 1 [0] (seq 3 (creations t)) G /\
  NoDup (edges F) /\ forall x y z, has F x y z -> ~ has F y x z.
Proof.
  unfold decode; intros w F H; destruct (parse w) as [t|] eqn:P; [|discriminate].
  destruct (len t =? 3) eqn:N; [|discriminate]; apply Nat.eqb_eq in N.
  apply parse_sound in P; destruct P as [-> O].
  destruct (simple ((0, 1, 2) :: draw t 2 1 [0] (seq 3 (creations t)))) eqn:Si; [|discriminate].
  injection H as <-; apply simple_spec in Si; destruct Si as [S1 S2].
  exists t, (draw t 2 1 [0] (seq 3 (creations t))); repeat split; auto.
  apply draw_is_disc; auto; rewrite seq_length; reflexivity.
Qed.

Lemma decode_intro : forall t G, ok t -> disc t 2 1 [0] (seq 3 (creations t)) G ->
  NoDup (edges ((0, 1, 2) :: G)) ->
  (forall x y z, has ((0, 1, 2) :: G) x y z -> ~ has ((0, 1, 2) :: G) y x z) ->
  decode (flat t) = Some ((0, 1, 2) :: G).
Proof.
  intros t G O D N Di; unfold decode; rewrite parse_flat by exact O.
  destruct (disc_sizes _ _ _ _ _ _ D) as (-> & _); cbn [length Nat.add Nat.eqb].
  rewrite (disc_is_drawn _ _ _ _ _ _ D), (proj2 (simple_spec _)); auto.
Qed.

Lemma fresh_names : forall n, NoDup (0 :: 1 :: 2 :: seq 3 n).
Proof. intros n; change (0 :: 1 :: 2 :: seq 3 n) with (seq 0 (3 + n)); apply seq_NoDup. Qed.

Theorem decoded_is_sphere : forall w F, decode w = Some F -> sphere F.
Proof.
  intros w F H; apply decode_inv in H; destruct H as (t & G & O & -> & -> & D & N & Di).
  apply disc_and_P_is_sphere with t (seq 3 (creations t)); auto using fresh_names.
Qed.

Theorem decoded_counts : forall w F, decode w = Some F ->
  length F = length w + 1 /\ vertex_count F = many sC w + 3.
Proof.
  intros w F H; assert (Sp := decoded_is_sphere _ _ H); destruct Sp as (_ & _ & X).
  apply decode_inv in H; destruct H as (t & G & O & -> & -> & D & _).
  destruct (disc_sizes _ _ _ _ _ _ D) as (S1 & S2 & S3 & _).
  pose proof (loop_length _ _ (word_of_tree t O)) as LL.
  rewrite length_edges in X; cbn [length] in *; lia.
Qed.

(** Examples of chapter 5: the tetrahedron and the cube. *)
Example tetrahedron : decode [sC; sR; sE] = Some [(0, 1, 2); (3, 2, 1); (0, 3, 1); (2, 3, 0)].
Proof. reflexivity. Qed.
Example pillow : decode [sE] = None.
Proof. reflexivity. Qed.
Example cube_is_accepted : decode [sC; sC; sC; sR; sC; sR; sR; sC; sR; sR; sE] <> None.
Proof. vm_compute; discriminate. Qed.
Example tetrahedron_is_sphere : sphere [(0, 1, 2); (3, 2, 1); (0, 3, 1); (2, 3, 0)].
Proof. exact (decoded_is_sphere _ _ tetrahedron). Qed.
