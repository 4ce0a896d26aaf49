(** A disc is a disc: the faces around each of its vertices, and that it is all of one piece.

    CPLX-SURFACE-1, CPLX-SURFACE-3, CPLX-COMPONENT-2 for what EB-FOLD-1 draws: at a vertex of the
    loop the faces are one fan from border to border ([fan_on_loop]), at a new vertex one circle
    ([circle_inside]), all faces are linked ([disc_linked]); and with P the disc is a sphere, if no
    edge is run twice and no face doubled ([disc_and_P_is_sphere]). *)
Require Import List Arith Lia Permutation Relation_Operators.
Require Import Clers.Letters Clers.Words Clers.Meshes Clers.Discs.
Import ListNotations.
Open Scope nat_scope.

(** Membership and absence of repetition by counting. *)
Definition cnt (l : list nat) (x : nat) : nat := count_occ Nat.eq_dec l x.

Lemma cnt_cons : forall y l x, cnt (y :: l) x = cnt [y] x + cnt l x.
Proof. intros; unfold cnt; cbn [count_occ]; destruct (Nat.eq_dec y x); lia. Qed.

Lemma cnt_app : forall l m x, cnt (l ++ m) x = cnt l x + cnt m x.
Proof. intros; apply count_occ_app. Qed.

Lemma cnt_self : forall x, cnt [x] x = 1.
Proof. intros; unfold cnt; cbn [count_occ]; destruct (Nat.eq_dec x x); congruence. Qed.

Lemma cnt_other : forall x y, x <> y -> cnt [y] x = 0.
Proof. intros; unfold cnt; cbn [count_occ]; destruct (Nat.eq_dec y x); congruence. Qed.

Lemma in_cnt : forall l x, In x l <-> 1 <= cnt l x.
Proof. intros; apply (count_occ_In Nat.eq_dec). Qed.

Lemma nodup_cnt : forall l, NoDup l <-> forall x, cnt l x <= 1.
Proof. intros; apply (NoDup_count_occ Nat.eq_dec). Qed.

Ltac expand x :=
  repeat (progress (rewrite ?cnt_app in *; cbn [app] in *) ||
    match goal with
    | |- context [cnt (?d :: ?l) x] =>
        lazymatch l with [] => fail | _ => rewrite (cnt_cons d l x) end
    | H : context [cnt (?d :: ?l) x] |- _ =>
        lazymatch l with [] => fail | _ => rewrite (cnt_cons d l x) in H end
    end);
  change (cnt [] x) with 0 in *; rewrite ?cnt_self in *;
  repeat match goal with
  | N : x <> ?y |- _ => rewrite (cnt_other x y N) in *; clear N
  end.

(** Contradiction from what is known of the places of x. *)
Ltac tally x :=
  exfalso;
  repeat match goal with H : NoDup (A := nat) _ |- _ =>
    pose proof (proj1 (nodup_cnt _) H x); clear H end;
  repeat match goal with H : In x _ |- _ => apply in_cnt in H end;
  expand x; lia.

(** Whatever of NoDup is kept when some of the vertices are left out. *)
Ltac fewer :=
  apply nodup_cnt; let x := fresh "x" in intros x;
  repeat match goal with H : NoDup (A := nat) _ |- _ =>
    pose proof (proj1 (nodup_cnt _) H x); clear H end;
  expand x; lia.

Lemma disc_proper : forall t a b X ns F, disc t a b X ns F -> NoDup (a :: b :: X ++ ns) ->
  forall x y, In (x, y) (edges F) -> x <> y.
Proof.
  assert (T : forall a b v x y, NoDup [v; a; b] -> In (x, y) (runs (v, a, b)) -> x <> y).
  { intros a b v x y N [H|[H|[H|[]]]]; injection H as <- <-; intros ->; [tally a|tally b|tally v]. }
  induction 1; intros N x y I;
    (change (edges (?f :: ?G)) with (runs f ++ edges G) in I || idtac);
    unfold edges in I; cbn [flat_map] in I; rewrite in_app_iff in I; destruct I as [I|I];
    try (revert I; apply T; fewer).
  - destruct I.
  - apply IHdisc; [fewer|exact I].
  - apply IHdisc; [fewer|exact I].
  - apply IHdisc; [fewer|exact I].
  - rewrite flat_map_app, in_app_iff in I; destruct I as [I|I];
      [apply IHdisc1|apply IHdisc2]; auto; fewer.
Qed.

Lemma link_cons : forall x f F, link x (f :: F) = link1 x f ++ link x F.
Proof. reflexivity. Qed.

Lemma link_app : forall x F G, link x (F ++ G) = link x F ++ link x G.
Proof. intros; apply flat_map_app. Qed.

Lemma link1_v : forall v a b, v <> a -> v <> b -> link1 v (v, a, b) = [(a, b)].
Proof.
  intros; unfold link1; destruct (Nat.eq_dec v v), (Nat.eq_dec v a), (Nat.eq_dec v b); try congruence.
  reflexivity.
Qed.
Lemma link1_a : forall v a b, a <> v -> a <> b -> link1 a (v, a, b) = [(b, v)].
Proof.
  intros; unfold link1; destruct (Nat.eq_dec a v), (Nat.eq_dec a a), (Nat.eq_dec a b); try congruence.
  reflexivity.
Qed.
Lemma link1_b : forall v a b, b <> v -> b <> a -> link1 b (v, a, b) = [(v, a)].
Proof.
  intros; unfold link1; destruct (Nat.eq_dec b v), (Nat.eq_dec b a), (Nat.eq_dec b b); try congruence.
  reflexivity.
Qed.
Lemma link1_other : forall x v a b, x <> v -> x <> a -> x <> b -> link1 x (v, a, b) = [].
Proof.
  intros; unfold link1; destruct (Nat.eq_dec x v), (Nat.eq_dec x a), (Nat.eq_dec x b); try congruence.
  reflexivity.
Qed.

Lemma link_outside : forall t a b X ns F x, disc t a b X ns F ->
  ~ In x (a :: b :: X ++ ns) -> link x F = [].
Proof. intros t a b X ns F x D H; apply link_absent; rewrite (disc_vertices _ _ _ _ _ _ D); exact H. Qed.

(** The vertices of one triangle are three. *)
Lemma three : forall a b v : nat, NoDup [v; a; b] -> v <> a /\ v <> b /\ a <> b.
Proof.
  intros a b v N; split; [intros ->; tally a|split; [intros ->; tally b|intros ->; tally b]].
Qed.

(** In a disc the faces at a vertex x of its loop, which comes from p and goes on to s, are one fan
    from s to p. *)
Theorem fan_on_loop : forall t a b X ns F, disc t a b X ns F -> NoDup (a :: b :: X ++ ns) ->
  forall p x s, In (p, x) ((a, b) :: path b X a) -> In (x, s) ((a, b) :: path b X a) ->
  exists l, Permutation (link x F) (path s l p).
Proof.
  induction 1 as [a b v|t a b X v ns F _ D IH|t a b v X ns F D IH|t a b v X ns F D IH
    |u w a b v X1 X2 n1 n2 F1 F2 D1 IH1 D2 IH2]; intros N p x s P Q;
    (assert (N3 : NoDup [v; a; b]) by fewer); destruct (three _ _ _ N3) as (VA & VB & AB); clear N3.
  - exists []; cbn in P, Q.
    destruct P as [P|[P|[P|[]]]], Q as [Q|[Q|[Q|[]]]]; injection P as <- <-; injection Q; intros; try congruence;
      subst; rewrite link_cons, ?link1_a, ?link1_b, ?link1_v by auto; reflexivity.
  - rewrite path_app in IH; cbn [path] in IH.
    assert (N' : NoDup (v :: b :: (X ++ [a]) ++ ns)) by fewer; specialize (IH N').
    rewrite link_cons; destruct (Nat.eq_dec x a) as [->|XA]; [|destruct (Nat.eq_dec x b) as [->|XB]].
    + assert (P' : In (p, a) (path b X a)) by (destruct P as [P|P]; [congruence|exact P]).
      destruct Q as [Q|Q]; [injection Q as <-|apply path_in in Q; destruct Q; tally a].
      destruct (IH p a v) as [l K]; [cbn; rewrite in_app_iff; tauto|cbn; rewrite in_app_iff; cbn; tauto|].
      exists (v :: l); rewrite link1_a, K by auto; reflexivity.
    + assert (Q' : In (b, s) (path b X a)) by (destruct Q as [Q|Q]; [congruence|exact Q]).
      destruct P as [P|P]; [injection P as <-|apply path_in in P; destruct P; tally b].
      destruct (IH v b s) as [l K]; [cbn; tauto|cbn; rewrite in_app_iff; tauto|].
      exists (l ++ [v]); rewrite link1_b, K, path_app by auto; cbn [path app]; apply Permutation_cons_append.
    + destruct P as [P|P]; [congruence|]; destruct Q as [Q|Q]; [congruence|].
      assert (x <> v) by (intros ->; apply path_in in Q; destruct Q; tally v).
      destruct (IH p x s) as [l K]; [cbn; rewrite in_app_iff; tauto|cbn; rewrite in_app_iff; tauto|].
      exists l; rewrite link1_other by auto; exact K.
  - assert (N' : NoDup (a :: v :: X ++ ns)) by fewer; specialize (IH N').
    rewrite link_cons; cbn [path In] in P, Q.
    destruct (Nat.eq_dec x a) as [->|XA];
      [|destruct (Nat.eq_dec x b) as [->|XB]; [|destruct (Nat.eq_dec x v) as [->|XV]]].
    + destruct P as [P|[P|P]]; [congruence|congruence|].
      destruct Q as [Q|[Q|Q]]; [injection Q as <-|congruence|apply path_in in Q; destruct Q; tally a].
      destruct (IH p a v) as [l K]; [cbn; tauto|cbn; tauto|].
      exists (v :: l); rewrite link1_a, K by auto; reflexivity.
    + destruct P as [P|[P|P]]; [injection P as <-|congruence|apply path_in in P; destruct P; tally b].
      destruct Q as [Q|[Q|Q]]; [congruence|injection Q as <-|apply path_in in Q; destruct Q; tally b].
      exists []; rewrite link1_b, (link_outside _ _ _ _ _ _ _ D) by (auto; intros I; tally b).
      reflexivity.
    + destruct P as [P|[P|P]]; [congruence|injection P as <-|apply path_in in P; destruct P; tally v].
      destruct Q as [Q|[Q|Q]]; [congruence|congruence|].
      destruct (IH a v s) as [l K]; [cbn; tauto|cbn; tauto|].
      exists (l ++ [a]); rewrite link1_v, K, path_app by auto; cbn [path app]; apply Permutation_cons_append.
    + destruct P as [P|[P|P]]; [congruence|congruence|].
      destruct Q as [Q|[Q|Q]]; [congruence|congruence|].
      destruct (IH p x s) as [l K]; [cbn; tauto|cbn; tauto|].
      exists l; rewrite link1_other by auto; exact K.
  - assert (N' : NoDup (v :: b :: X ++ ns)) by fewer; specialize (IH N').
    rewrite link_cons; rewrite path_app in P, Q; cbn [path In] in P, Q.
    rewrite in_app_iff in P, Q; cbn [In] in P, Q.
    destruct (Nat.eq_dec x a) as [->|XA];
      [|destruct (Nat.eq_dec x b) as [->|XB]; [|destruct (Nat.eq_dec x v) as [->|XV]]].
    + destruct P as [P|[P|[P|[]]]]; [congruence|apply path_in in P; destruct P; tally a|injection P as <-].
      destruct Q as [Q|[Q|[Q|[]]]]; [injection Q as <-|apply path_in in Q; destruct Q; tally a|congruence].
      exists []; rewrite link1_a, (link_outside _ _ _ _ _ _ _ D) by (auto; intros I; tally a).
      reflexivity.
    + destruct P as [P|[P|[P|[]]]]; [injection P as <-|apply path_in in P; destruct P; tally b|congruence].
      destruct Q as [Q|[Q|[Q|[]]]]; [congruence| |congruence].
      destruct (IH v b s) as [l K]; [cbn; tauto|cbn; tauto|].
      exists (l ++ [v]); rewrite link1_b, K, path_app by auto; cbn [path app]; apply Permutation_cons_append.
    + destruct P as [P|[P|[P|[]]]]; [congruence| |congruence].
      destruct Q as [Q|[Q|[Q|[]]]]; [congruence|apply path_in in Q; destruct Q; tally v|injection Q as <-].
      destruct (IH p v b) as [l K]; [cbn; tauto|cbn; tauto|].
      exists (b :: l); rewrite link1_v, K by auto; reflexivity.
    + destruct P as [P|[P|[P|[]]]]; [congruence| |congruence].
      destruct Q as [Q|[Q|[Q|[]]]]; [congruence| |congruence].
      destruct (IH p x s) as [l K]; [cbn; tauto|cbn; tauto|].
      exists l; rewrite link1_other by auto; exact K.
  - assert (N1 : NoDup (v :: b :: X1 ++ n1)) by fewer; specialize (IH1 N1).
    assert (N2 : NoDup (a :: v :: X2 ++ n2)) by fewer; specialize (IH2 N2); clear N1 N2.
    rewrite link_cons, link_app; rewrite path_app in P, Q; cbn [In] in P, Q.
    rewrite in_app_iff in P, Q.
    destruct (Nat.eq_dec x a) as [->|XA];
      [|destruct (Nat.eq_dec x b) as [->|XB]; [|destruct (Nat.eq_dec x v) as [->|XV]]].
    + destruct P as [P|[P|P]]; [congruence|apply path_in in P; destruct P; tally a|].
      destruct Q as [Q|[Q|Q]];
        [injection Q as <-|apply path_in in Q; destruct Q; tally a|apply path_in in Q; destruct Q; tally a].
      destruct (IH2 p a v) as [l K]; [cbn; tauto|cbn; tauto|].
      exists (v :: l); rewrite link1_a, K, (link_outside _ _ _ _ _ _ _ D1) by (auto; intros I; tally a).
      reflexivity.
    + destruct P as [P|[P|P]];
        [injection P as <-|apply path_in in P; destruct P; tally b|apply path_in in P; destruct P; tally b].
      destruct Q as [Q|[Q|Q]]; [congruence| |apply path_in in Q; destruct Q; tally b].
      destruct (IH1 v b s) as [l K]; [cbn; tauto|cbn; tauto|].
      exists (l ++ [v]); rewrite link1_b, K, path_app, (link_outside _ _ _ _ _ _ _ D2)
        by (auto; intros I; tally b).
      rewrite app_nil_r; cbn [path app]; apply Permutation_cons_append.
    + destruct P as [P|[P|P]]; [congruence| |apply path_in in P; destruct P; tally v].
      destruct Q as [Q|[Q|Q]]; [congruence|apply path_in in Q; destruct Q; tally v|].
      destruct (IH1 p v b) as [l1 K1]; [cbn; tauto|cbn; tauto|].
      destruct (IH2 a v s) as [l2 K2]; [cbn; tauto|cbn; tauto|].
      exists (l2 ++ a :: b :: l1); rewrite link1_v, K1, K2, path_app by auto; cbn [path]; permute.
    + rewrite link1_other by auto; cbn [app].
      destruct P as [P|[P|P]]; [congruence| |]; (destruct Q as [Q|[Q|Q]]; [congruence| |]).
      * destruct (IH1 p x s) as [l K]; [cbn; tauto|cbn; tauto|]; exists l.
        apply path_in in P; destruct P as [_ P].
        rewrite K, (link_outside _ _ _ _ _ _ _ D2), app_nil_r by (intros I; tally x); reflexivity.
      * apply path_in in P; apply path_in in Q; destruct P as [_ P], Q as [Q _]; tally x.
      * apply path_in in P; apply path_in in Q; destruct P as [_ P], Q as [Q _]; tally x.
      * destruct (IH2 p x s) as [l K]; [cbn; tauto|cbn; tauto|]; exists l.
        apply path_in in P; destruct P as [_ P].
        rewrite K, (link_outside _ _ _ _ _ _ _ D1) by (intros I; tally x); reflexivity.
Qed.

(** At a vertex that the disc creates its faces are one circle. *)
Theorem circle_inside : forall t a b X ns F, disc t a b X ns F -> NoDup (a :: b :: X ++ ns) ->
  forall x, In x ns -> exists l, Permutation (link x F) (ring l).
Proof.
  induction 1 as [a b v|t a b X v ns F _ D IH|t a b v X ns F D IH|t a b v X ns F D IH
    |u w a b v X1 X2 n1 n2 F1 F2 D1 IH1 D2 IH2]; intros N x I;
    (assert (N3 : NoDup [v; a; b]) by fewer); destruct (three _ _ _ N3) as (VA & VB & AB); clear N3.
  - destruct I.
  - assert (N' : NoDup (v :: b :: (X ++ [a]) ++ ns)) by fewer.
    rewrite link_cons; destruct I as [<-|I].
    + destruct (fan_on_loop _ _ _ _ _ _ D N' a v b) as [l K].
      * right; rewrite path_app, in_app_iff; cbn; tauto.
      * left; reflexivity.
      * exists (a :: b :: l); rewrite link1_v, K by auto; reflexivity.
    + destruct (IH N' x I) as [l K]; exists l; rewrite link1_other; [exact K|..];
        intros ->; [tally v|tally a|tally b].
  - assert (N' : NoDup (a :: v :: X ++ ns)) by fewer.
    destruct (IH N' x I) as [l K]; exists l; rewrite link_cons, link1_other; [exact K|..];
      intros ->; [tally v|tally a|tally b].
  - assert (N' : NoDup (v :: b :: X ++ ns)) by fewer.
    destruct (IH N' x I) as [l K]; exists l; rewrite link_cons, link1_other; [exact K|..];
      intros ->; [tally v|tally a|tally b].
  - assert (N1 : NoDup (v :: b :: X1 ++ n1)) by fewer.
    assert (N2 : NoDup (a :: v :: X2 ++ n2)) by fewer.
    assert (VX : x <> v) by (clear N1 N2; intros ->; tally v).
    assert (AX : x <> a) by (clear N1 N2; intros ->; tally a).
    assert (BX : x <> b) by (clear N1 N2; intros ->; tally b).
    rewrite link_cons, link1_other, link_app by auto; cbn [app].
    specialize (IH1 N1 x); specialize (IH2 N2 x); clear N1 N2; apply in_app_iff in I; destruct I as [I|I].
    + destruct (IH1 I) as [l K]; exists l.
      rewrite K, (link_outside _ _ _ _ _ _ _ D2), app_nil_r by (intros J; tally x); reflexivity.
    + destruct (IH2 I) as [l K]; exists l.
      rewrite K, (link_outside _ _ _ _ _ _ _ D1) by (intros J; tally x); reflexivity.
Qed.

(** All faces of a disc are linked to the first, which lies behind the gate. *)
Theorem disc_linked : forall t a b X ns F, disc t a b X ns F -> exists v G, F = (v, a, b) :: G /\
  forall f, In f F -> clos_refl_trans face (neighbours F) (v, a, b) f.
Proof.
  assert (One : forall f g F G, incl F G -> In f G -> In g F ->
    (exists x y, In (x, y) (runs f) /\ In (y, x) (runs g)) ->
    (forall h, In h F -> clos_refl_trans face (neighbours F) g h) ->
    forall h, In h F -> clos_refl_trans face (neighbours G) f h).
  { intros f g F G I J K A H h M; apply rt_trans with g.
    - apply rt_step; repeat split; auto.
    - apply neighbours_incl with F; auto. }
  induction 1 as [a b v|t a b X v ns F _ _ (x & G & -> & IH)|t a b v X ns F _ (x & G & -> & IH)
    |t a b v X ns F _ (x & G & -> & IH)
    |u w a b v X1 X2 n1 n2 F1 F2 _ (x1 & G1 & E1 & IH1) _ (x2 & G2 & E2 & IH2)];
    eexists; eexists; (split; [reflexivity|]); intros f [<-|I]; try apply rt_refl.
  - destruct I.
  - revert f I; apply One with (x, v, b); [apply incl_tl, incl_refl|left|left| |]; auto.
    exists b, v; cbn; tauto.
  - revert f I; apply One with (x, a, v); [apply incl_tl, incl_refl|left|left| |]; auto.
    exists v, a; cbn; tauto.
  - revert f I; apply One with (x, v, b); [apply incl_tl, incl_refl|left|left| |]; auto.
    exists b, v; cbn; tauto.
  - apply in_app_iff in I; destruct I as [I|I]; revert f I.
    + apply One with (x1, v, b); [apply incl_tl, incl_appl, incl_refl|left|rewrite E1; left| |]; auto.
      exists b, v; cbn; tauto.
    + apply One with (x2, a, v); [apply incl_tl, incl_appr, incl_refl|left|rewrite E2; left| |]; auto.
      exists v, a; cbn; tauto.
Qed.

(** How often an edge is run is how often its end begins an edge of the link. *)
Lemma num_link : forall F x y, num (edges F) (x, y) = cnt (map fst (link x F)) y.
Proof.
  assert (One : forall f x y, num (runs f) (x, y) = cnt (map fst (link1 x f)) y).
  { intros [[p q] r] x y; unfold num, cnt, runs, link1; cbn [count_occ].
    destruct (Nat.eq_dec x p), (Nat.eq_dec x q), (Nat.eq_dec x r); cbn [app map fst count_occ];
      repeat match goal with
      | |- context [edge_eq_dec ?d ?e] => destruct (edge_eq_dec d e)
      | |- context [Nat.eq_dec ?d ?e] => destruct (Nat.eq_dec d e)
      end; congruence. }
  induction F as [|f F IH]; intros x y; [reflexivity|].
  rewrite link_cons, map_app, cnt_app, <- IH, <- One; apply num_app.
Qed.

Lemma map_fst_path : forall X a b, map fst (path a X b) = a :: X.
Proof. induction X; intros; cbn [path map fst]; rewrite ?IHX; reflexivity. Qed.

Lemma map_fst_ring : forall l, map fst (ring l) = l.
Proof. intros [|a X]; [reflexivity|apply map_fst_path]. Qed.

(** A link that is a circular list is a circle, where no edge is run twice and no face is doubled. *)
Lemma circle_of_ring : forall F x l, NoDup (edges F) ->
  (forall x y, In (x, y) (edges F) -> x <> y) -> (forall x y z, has F x y z -> ~ has F y x z) ->
  In x (vertices F) -> Permutation (link x F) (ring l) -> circle F x.
Proof.
  intros F x l N Pr Di V P.
  assert (H : forall y z, has F x y z <-> In (y, z) (ring l)).
  { intros y z; rewrite <- link_has; split; apply Permutation_in; [exact P|symmetry; exact P]. }
  exists l; repeat split; try apply H.
  - apply nodup_cnt; intros y; rewrite <- (map_fst_ring l).
    assert (Q : Permutation (map fst (ring l)) (map fst (link x F))) by (symmetry; apply Permutation_map, P).
    apply (Permutation_count_occ Nat.eq_dec) with (x := y) in Q; unfold cnt at 1; rewrite Q.
    fold (cnt (map fst (link x F)) y); rewrite <- num_link; apply NoDup_count_occ; exact N.
  - destruct l as [|y [|z [|]]]; cbn [length]; try lia; exfalso; cbn [ring path] in H.
    + apply vertex_has in V; destruct V as (y & z & V); apply H in V; exact V.
    + assert (A : has F x y y) by (apply H; left; reflexivity).
      apply has_turn, has_edge in A; apply Pr in A; congruence.
    + assert (A : has F x y z) by (apply H; left; reflexivity).
      assert (B : has F x z y) by (apply H; right; left; reflexivity).
      apply has_turn, has_turn in B; exact (Di _ _ _ A B).
Qed.

(** P and a disc on its loop are a sphere, if no edge is run twice and no face is doubled. *)
Theorem disc_and_P_is_sphere : forall t p0 p1 p2 ns F, disc t p2 p1 [p0] ns F ->
  NoDup (p0 :: p1 :: p2 :: ns) -> NoDup (edges ((p0, p1, p2) :: F)) ->
  (forall x y z, has ((p0, p1, p2) :: F) x y z -> ~ has ((p0, p1, p2) :: F) y x z) ->
  sphere ((p0, p1, p2) :: F).
Proof.
  intros t p0 p1 p2 ns F D N NE Di; set (G := (p0, p1, p2) :: F) in *.
  assert (N' : NoDup (p2 :: p1 :: [p0] ++ ns)) by fewer.
  assert (N3 : NoDup [p0; p1; p2]) by (clear N'; fewer); destruct (three _ _ _ N3) as (D01 & D02 & D12).
  clear N3.
  assert (Pr : forall x y, In (x, y) (edges G) -> x <> y).
  { intros x y I; change (edges G) with (runs (p0, p1, p2) ++ edges F) in I.
    apply in_app_iff in I; destruct I as [I|I]; [|exact (disc_proper _ _ _ _ _ _ D N' _ _ I)].
    destruct I as [I|[I|[I|[]]]]; injection I as <- <-; auto. }
  assert (V : forall x, In x (vertices G) <-> In x (p0 :: p1 :: p2 :: ns)).
  { intros x; change (vertices G) with (corners (p0, p1, p2) ++ vertices F).
    rewrite in_app_iff, (disc_vertices _ _ _ _ _ _ D); cbn; tauto. }
  destruct (disc_edges _ _ _ _ _ _ D) as [I PE]; destruct (disc_sizes _ _ _ _ _ _ D) as (S1 & S2 & S3 & O & _).
  split; [constructor|split].
  - discriminate.
  - exact Pr.
  - exact NE.
  - assert (PG : Permutation (edges G) (((p2, p1) :: (p1, p0) :: (p0, p2) :: I)
                                         ++ map flip ((p2, p1) :: (p1, p0) :: (p0, p2) :: I))).
    { change (edges G) with ((p0, p1) :: (p1, p2) :: (p2, p0) :: edges F); cbn [path] in PE.
      clear N N' NE; permute. }
    intros x y J; apply (Permutation_in _ PG) in J; apply (Permutation_in _ (Permutation_sym PG)).
    apply in_app_iff in J; apply in_app_iff; destruct J as [J|J].
    + right; apply in_map_iff; exists (x, y); auto.
    + left; apply in_map_iff in J; destruct J as ([p q] & sE & J); injection sE as <- <-; exact J.
  - exact Di.
  - assert (Fan := fan_on_loop _ _ _ _ _ _ D N').
    assert (Cir := circle_inside _ _ _ _ _ _ D N').
    intros x I'; apply V in I'.
    assert (exists l, Permutation (link x G) (ring l)) as [l P].
    { cbn [path] in Fan; unfold G; rewrite link_cons.
      destruct I' as [<-|[<-|[<-|I']]].
      - destruct (Fan p1 p0 p2) as [l K]; [cbn; tauto|cbn; tauto|]; exists (p1 :: p2 :: l).
        rewrite link1_v, K by auto; reflexivity.
      - destruct (Fan p2 p1 p0) as [l K]; [cbn; tauto|cbn; tauto|]; exists (p2 :: p0 :: l).
        rewrite link1_a, K by auto; reflexivity.
      - destruct (Fan p0 p2 p1) as [l K]; [cbn; tauto|cbn; tauto|]; exists (p0 :: p1 :: l).
        rewrite link1_b, K by auto; reflexivity.
      - destruct (Cir x I') as [l K]; exists l; rewrite link1_other; [exact K|..]; intros ->; clear N';
          [tally p0|tally p1|tally p2]. }
    apply circle_of_ring with l; auto; apply V; exact I'.
  - destruct (disc_linked _ _ _ _ _ _ D) as (v & F' & sE & H).
    assert (Hub : forall f, In f G -> clos_refl_trans face (neighbours G) (p0, p1, p2) f).
    { intros f [<-|J]; [apply rt_refl|]; apply rt_trans with (v, p2, p1).
      - apply rt_step; repeat split; [left; reflexivity|right; rewrite sE; left; reflexivity|].
        exists p1, p2; cbn; tauto.
      - apply neighbours_incl with F; [apply incl_tl, incl_refl|auto]. }
    intros f g J K; apply rt_trans with (p0, p1, p2); [apply neighbours_sym|]; auto.
  - assert (VC : vertex_count G = length (p0 :: p1 :: p2 :: ns)).
    { unfold vertex_count; apply Permutation_length, NoDup_Permutation; [apply NoDup_nodup|exact N|].
      intros x; rewrite nodup_In; apply V. }
    rewrite VC, length_edges; unfold G; cbn [length] in *.
    pose proof (loop_length _ _ (word_of_tree t O)) as LL; rewrite <- creations_count in LL; lia.
Qed.
