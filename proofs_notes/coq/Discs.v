(** A tree drawn on a loop: what the decoder draws for a word.

    EB-FOLD-1, EB-FOLD-2, EB-REVERSI-2: the loop is [a, b, X] with the gate from a to b, as the faces
    inside run it. [disc t a b X ns F] says that the tree t, drawn on this loop with the vertices ns
    for its C in turn, gives the faces F in the order of EB-ORDER-3. It is a function
    ([draw_is_disc], [disc_is_drawn]). Proved for every disc: its length is that of the loop
    ([disc_sizes]), it does not depend on the names of the vertices ([disc_renamed]), and its edges
    are those of the loop and otherwise come in pairs of the two directions ([disc_edges]). *)
Require Import List Arith Lia Permutation.
Require Import Clers.Letters Clers.Words Clers.Meshes.
Import ListNotations.
Open Scope nat_scope.

Inductive disc : tree -> nat -> nat -> list nat -> list nat -> list face -> Prop :=
| disc_E : forall a b v, disc TE a b [v] [] [(v, a, b)]
| disc_C : forall t a b X v ns F, X <> [] ->
    disc t v b (X ++ [a]) ns F -> disc (TC t) a b X (v :: ns) ((v, a, b) :: F)
| disc_R : forall t a b v X ns F,
    disc t a v X ns F -> disc (TR t) a b (v :: X) ns ((v, a, b) :: F)
| disc_L : forall t a b v X ns F,
    disc t v b X ns F -> disc (TL t) a b (X ++ [v]) ns ((v, a, b) :: F)
| disc_S : forall u w a b v X1 X2 n1 n2 F1 F2,
    disc u v b X1 n1 F1 -> disc w a v X2 n2 F2 ->
    disc (TS u w) a b (X1 ++ v :: X2) (n1 ++ n2) ((v, a, b) :: F1 ++ F2).

(** The offset of an S is the length of its right loop, which its tree knows. *)
Fixpoint draw (t : tree) (a b : nat) (X ns : list nat) : list face :=
  match t with
  | TE => match X with v :: _ => [(v, a, b)] | [] => [] end
  | TC t => match ns with v :: ns => (v, a, b) :: draw t v b (X ++ [a]) ns | [] => [] end
  | TR t => match X with v :: X => (v, a, b) :: draw t a v X ns | [] => [] end
  | TL t => let v := last X 0 in (v, a, b) :: draw t v b (removelast X) ns
  | TS u w =>
      let v := nth (len u - 2) X 0 in
      (v, a, b) :: draw u v b (firstn (len u - 2) X) (firstn (creations u) ns)
                ++ draw w a v (skipn (len u - 1) X) (skipn (creations u) ns)
  end.

Lemma disc_sizes : forall t a b X ns F, disc t a b X ns F ->
  len t = length X + 2 /\ creations t = length ns /\ length (flat t) = length F /\ ok t /\ X <> [].
Proof.
  induction 1; cbn [len creations flat ok]; repeat rewrite ?app_length in *; cbn [length app] in *;
    repeat match goal with H : _ /\ _ |- _ => destruct H end.
  - repeat split; congruence.
  - destruct X; [congruence|]; cbn [length] in *; repeat split; auto; try lia.
  - repeat split; auto; try lia; congruence.
  - repeat split; auto; try lia; destruct X; discriminate.
  - rewrite ?app_length; repeat split; auto; try lia; destruct X1; discriminate.
Qed.

Theorem disc_is_drawn : forall t a b X ns F, disc t a b X ns F -> draw t a b X ns = F.
Proof.
  induction 1; cbn [draw].
  - reflexivity.
  - rewrite IHdisc; reflexivity.
  - rewrite IHdisc; reflexivity.
  - rewrite last_last, removelast_last, IHdisc; reflexivity.
  - destruct (disc_sizes _ _ _ _ _ _ H) as (A & B & _).
    replace (len u - 2) with (length X1) by lia; replace (len u - 1) with (length X1 + 1) by lia.
    rewrite B, nth_middle, !firstn_app, !skipn_app, !Nat.sub_diag, !firstn_all, !skipn_all.
    replace (length X1 + 1 - length X1) with 1 by lia.
    rewrite skipn_all2 by lia; cbn [firstn skipn app]; rewrite !app_nil_r, IHdisc1, IHdisc2.
    reflexivity.
Qed.

Theorem draw_is_disc : forall t a b X ns, ok t -> len t = length X + 2 ->
  creations t = length ns -> disc t a b X ns (draw t a b X ns).
Proof.
  induction t; cbn [ok len creations draw]; intros a b X ns O N K.
  - destruct ns as [|v ns]; [discriminate|]; destruct O as [O1 O2].
    cbn in K; apply disc_C; [intros ->; cbn in N; lia|].
    apply IHt; auto; rewrite ?app_length; cbn [length]; lia.
  - assert (3 <= len t) by auto using loops_are_long_tree.
    destruct (exists_last (l := X)) as (X' & v & ->); [intros ->; cbn in N; lia|].
    rewrite last_last, removelast_last; apply disc_L; apply IHt; auto.
    rewrite app_length in N; cbn in N; lia.
  - destruct X as [|v [|]]; cbn in N; try lia; destruct ns; [|discriminate]; constructor.
  - assert (3 <= len t) by auto using loops_are_long_tree.
    destruct X as [|v X]; cbn in N; [lia|]; apply disc_R; apply IHt; auto; lia.
  - destruct O as [O1 O2]; pose proof (loops_are_long_tree _ O1); pose proof (loops_are_long_tree _ O2).
    destruct (nth_split X 0 (n := len t1 - 2)) as (X1 & X2 & sE & L1); [lia|].
    set (v := nth (len t1 - 2) X 0) in *.
    assert (F1 : firstn (len t1 - 2) X = X1).
    { rewrite sE, <- L1, firstn_app, Nat.sub_diag, firstn_all; cbn; apply app_nil_r. }
    assert (F2 : skipn (len t1 - 1) X = X2).
    { rewrite sE, skipn_app, skipn_all2 by lia.
      replace (len t1 - 1 - length X1) with 1 by lia; reflexivity. }
    assert (LX : length X = length X1 + 1 + length X2) by (rewrite sE, app_length; cbn; lia).
    rewrite F1, F2; rewrite sE at 1; rewrite <- (firstn_skipn (creations t1) ns) at 1.
    apply disc_S; [apply IHt1|apply IHt2]; auto; try lia.
    + rewrite firstn_length; lia.
    + rewrite skipn_length; lia.
Qed.

(** Names do not matter: EB-DECODE-1 is up to names. *)
Definition renamed (r : nat -> nat) (f : face) : face := let '(x, y, z) := f in (r x, r y, r z).

Theorem disc_renamed : forall r t a b X ns F, disc t a b X ns F ->
  disc t (r a) (r b) (map r X) (map r ns) (map (renamed r) F).
Proof.
  induction 1; cbn [map renamed]; rewrite ?map_app in *; cbn [map] in *; constructor; auto.
  destruct X; [congruence|discriminate].
Qed.

Lemma disc_vertices : forall t a b X ns F, disc t a b X ns F ->
  forall x, In x (vertices F) <-> In x (a :: b :: X ++ ns).
Proof.
  induction 1; intros x; unfold vertices in *; cbn [flat_map corners app]; cbn [In];
    rewrite ?flat_map_app, ?in_app_iff, ?IHdisc, ?IHdisc1, ?IHdisc2; cbn [In];
    rewrite ?in_app_iff; cbn [In]; rewrite ?in_app_iff; cbn [In]; tauto.
Qed.

(** Permutations of edges by counting. *)
Definition num (l : list edge) (e : edge) : nat := count_occ edge_eq_dec l e.

Lemma num_cons : forall d l e, num (d :: l) e = num [d] e + num l e.
Proof. intros; unfold num; cbn [count_occ]; destruct (edge_eq_dec d e); lia. Qed.

Lemma num_app : forall l m e, num (l ++ m) e = num l e + num m e.
Proof. intros; apply count_occ_app. Qed.

Lemma by_num : forall l m, Permutation l m <-> forall e, num l e = num m e.
Proof. intros; apply (Permutation_count_occ edge_eq_dec). Qed.

Ltac permute :=
  apply by_num; let e := fresh "e" in intros e;
  repeat match goal with P : Permutation _ _ |- _ =>
    pose proof (proj1 (by_num _ _) P e); clear P end;
  repeat (progress (rewrite ?map_app, ?num_app in *; cbn [map app] in *) ||
    match goal with
    | |- context [flip (?x, ?y)] => change (flip (x, y)) with (y, x)
    | H : context [flip (?x, ?y)] |- _ => change (flip (x, y)) with (y, x) in H
    | |- context [num (?d :: ?l) e] =>
        lazymatch l with [] => fail | _ => rewrite (num_cons d l e) end
    | H : context [num (?d :: ?l) e] |- _ =>
        lazymatch l with [] => fail | _ => rewrite (num_cons d l e) in H end
    end);
  change (num [] e) with 0 in *; lia.

Theorem disc_edges : forall t a b X ns F, disc t a b X ns F ->
  exists I, Permutation (edges F) ((a, b) :: path b X a ++ I ++ map flip I).
Proof.
  induction 1 as [a b v|t a b X v ns F _ _ [I P]|t a b v X ns F _ [I P]|t a b v X ns F _ [I P]
    |u w a b v X1 X2 n1 n2 F1 F2 _ [I1 P1] _ [I2 P2]].
  - exists []; unfold edges; cbn [flat_map runs app path map]; permute.
  - exists ((v, a) :: (b, v) :: I).
    change (edges ((v, a, b) :: F)) with ((v, a) :: (a, b) :: (b, v) :: edges F).
    rewrite path_app in P; cbn [path] in P; permute.
  - exists ((v, a) :: I).
    change (edges ((v, a, b) :: F)) with ((v, a) :: (a, b) :: (b, v) :: edges F).
    cbn [path]; permute.
  - exists ((b, v) :: I).
    change (edges ((v, a, b) :: F)) with ((v, a) :: (a, b) :: (b, v) :: edges F).
    rewrite path_app; cbn [path]; permute.
  - exists ((v, a) :: (b, v) :: I1 ++ I2).
    change (edges ((v, a, b) :: F1 ++ F2)) with ((v, a) :: (a, b) :: (b, v) :: edges (F1 ++ F2)).
    rewrite edges_app, path_app; permute.
Qed.
