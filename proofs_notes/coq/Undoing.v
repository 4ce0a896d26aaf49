(** Undoing a walk from its end: a walk that passes no gate over has visited discs.

    EB-REVERSI-1, EB-REVERSI-2: what is behind the gates of the stack is one disc for each, on a loop
    whose edges were closed when its gate was entered ([walk_is_forest]). No theorem about curves in
    the plane is used: that the S of a sphere cut off discs follows from this, and from the count
    that says that no gate is passed over ([Records.sphere_without_records]). [walk_is_disc]: the
    whole walk over a sphere is one disc on the loop of P. *)
Require Import List Arith Lia Permutation.
Require Import Clers.Letters Clers.Words Clers.Meshes Clers.Discs Clers.Fans Clers.Decoder
  Clers.Traversal Clers.Visited Clers.Records.
Import ListNotations.
Open Scope nat_scope.

(** What the walk visits from the gates on its stack, if it passes none over: one disc for each, on a
    loop whose edges were closed when its gate was entered. EB-REVERSI-1's stack of loops. *)
Inductive forest : list face -> list edge -> list step -> Prop :=
| forest_nil : forall K, forest K [] []
| forest_cons : forall K a b X t tr1 st tr2,
    disc t a b X (created tr1) (map snd tr1) -> map fst tr1 = flat t ->
    (forall x y, In (x, y) ((a, b) :: path b X a) -> In (y, x) (edges K)) ->
    forest (after tr1 K) st tr2 -> forest K ((a, b) :: st) (tr1 ++ tr2).

Lemma created_app : forall tr1 tr2, created (tr1 ++ tr2) = created tr1 ++ created tr2.
Proof. intros; apply flat_map_app. Qed.

Lemma after_app : forall tr1 tr2 K, after (tr1 ++ tr2) K = after tr2 (after tr1 K).
Proof. intros; unfold after; rewrite map_app, rev_app_distr, app_assoc; reflexivity. Qed.

Lemma edges_after : forall tr K, Permutation (edges (after tr K)) (edges (map snd tr) ++ edges K).
Proof.
  intros; unfold after; rewrite edges_app; apply Permutation_app_tail, edges_perm; symmetry.
  apply Permutation_rev.
Qed.

(** An edge closed by this triangle or before it was closed before it, unless it is its side. *)
Lemma settle : forall v a b K x y, In (y, x) (edges ((v, a, b) :: K)) ->
  (x, y) <> (a, v) -> (x, y) <> (b, a) -> (x, y) <> (v, b) -> In (y, x) (edges K).
Proof.
  intros v a b K x y I A B D.
  change (edges ((v, a, b) :: K)) with ((v, a) :: (a, b) :: (b, v) :: edges K) in I.
  destruct I as [I|[I|[I|I]]]; [injection I as <- <-..|exact I]; congruence.
Qed.

Lemma ring_in_disc : forall t a b X ns F e, disc t a b X ns F -> In e ((a, b) :: path b X a) ->
  In e (edges F).
Proof.
  intros t a b X ns F e D I; destruct (disc_edges _ _ _ _ _ _ D) as [J P].
  apply (Permutation_in _ (Permutation_sym P)); destruct I as [I|I]; [left; exact I|right].
  apply in_app_iff; auto.
Qed.

Lemma ring_once : forall t a b X ns F, disc t a b X ns F -> NoDup (edges F) ->
  NoDup ((a, b) :: path b X a).
Proof.
  intros t a b X ns F D N; destruct (disc_edges _ _ _ _ _ _ D) as [J P].
  apply (Permutation_NoDup P) in N; change ((a, b) :: path b X a ++ J ++ map flip J)
    with (((a, b) :: path b X a) ++ J ++ map flip J) in N; apply NoDup_app_split in N; tauto.
Qed.

(** The flip of an edge of a disc is in the disc too, or the edge is on its loop. *)
Lemma disc_flip : forall t a b X ns F x y, disc t a b X ns F -> In (x, y) (edges F) ->
  In (y, x) (edges F) \/ In (x, y) ((a, b) :: path b X a).
Proof.
  intros t a b X ns F x y D I; destruct (disc_edges _ _ _ _ _ _ D) as [J P].
  apply (Permutation_in _ P) in I; destruct I as [I|I]; [right; left; exact I|].
  apply in_app_iff in I; destruct I as [I|I]; [right; right; exact I|left].
  apply (Permutation_in _ (Permutation_sym P)); right; apply in_app_iff; right; apply in_app_iff.
  apply in_app_iff in I; destruct I as [I|I].
  - right; apply in_map_iff; exists (x, y); auto.
  - left; apply in_map_iff in I; destruct I as ([p q] & E0 & I); injection E0 as <- <-; exact I.
Qed.

Section Sphere.
  Variable M : list face.
  Hypothesis SM : surface M.

  Theorem walk_is_forest : forall K m a b st tr p, Walk M K m a b st tr p -> good M K m a b st ->
    p = [] -> forest K ((a, b) :: st) tr.
  Proof.
    intros K m a b st tr p W G.
    assert (N : NoDup (edges (map snd tr) ++ edges K)).
    { destruct (visited M SM _ _ _ _ _ _ _ W G) as (_ & N & _).
      exact (Permutation_NoDup (edges_after tr K) N). }
    revert N; revert W G.
    enough (A : forall K m a b st tr p, Walk M K m a b st tr p -> good M K m a b st ->
      NoDup (edges (map snd tr) ++ edges K) -> p = [] -> forest K ((a, b) :: st) tr) by eauto.
    clear K m a b st tr p.
    (* what is common to all letters: the rest of the trace is disjoint from what is visited *)
    assert (Shift : forall f (tr : list step) K, NoDup (edges (f :: map snd tr) ++ edges K) ->
      NoDup (edges (map snd tr) ++ edges (f :: K))).
    { intros f tr K N; change (edges (f :: map snd tr)) with (runs f ++ edges (map snd tr)) in N.
      change (edges (f :: K)) with (runs f ++ edges K).
      eapply Permutation_NoDup; [|exact N]; clear; permute. }
    apply (walk_induction M SM (fun K m a b st tr p =>
      NoDup (edges (map snd tr) ++ edges K) -> p = [] -> forest K ((a, b) :: st) tr)).
    - (* C *)
      intros K m a b v st tr p G H V G' IH N E0; cbn [map snd] in N; apply Shift in N.
      specialize (IH N E0); inversion IH as [|K' a' b' X1 t tr1 st' tr2 D Fl Cl Fo]; subst.
      rewrite map_app, edges_app in N; apply NoDup_app_split in N; destruct N as (N1 & _ & N2).
      assert (N3 : NoDup (edges (map snd tr1))) by (apply NoDup_app_split in N1; tauto).
      assert (N4 : forall e, In e (edges (map snd tr1)) -> ~ In e (edges ((v, a, b) :: K))).
      { intros e I; apply N2, in_app_iff; auto. }
      destruct (disc_sizes _ _ _ _ _ _ D) as (_ & _ & _ & _ & NE).
      destruct (exists_last NE) as (X & z & ->).
      assert (R1 := ring_once _ _ _ _ _ _ D N3); rewrite path_app in R1, Cl; cbn [path] in R1, Cl.
      assert (In_D := fun e => ring_in_disc _ _ _ _ _ _ e D); rewrite path_app in In_D; cbn [path] in In_D.
      assert (z = a) as ->.
      { assert (I : In (v, z) (edges ((v, a, b) :: K))) by (apply Cl; right; apply in_app_iff; cbn; auto).
        destruct (face_distinct M SM _ _ _ H) as (VA & VB & AB).
        change (edges ((v, a, b) :: K)) with ((v, a) :: (a, b) :: (b, v) :: edges K) in I.
        destruct I as [I|[I|[I|I]]]; [congruence|congruence|congruence|].
        destruct V; apply (marks _ _ _ _ _ _ G); apply edge_has in I; destruct I as [u I].
        apply has_vertex with z u, I. }
      assert (BA := behind _ _ _ _ _ _ G).
      change ((sC, (v, a, b)) :: tr1 ++ tr2) with (((sC, (v, a, b)) :: tr1) ++ tr2).
      apply forest_cons with X (TC t).
      + change (created ((sC, (v, a, b)) :: tr1)) with (v :: created tr1); cbn [map snd].
        apply disc_C; [|exact D]; intros ->; cbn [path app] in In_D.
        apply (N4 (b, a)); [apply In_D; cbn; auto|do 3 right; exact BA].
      + cbn [map fst flat]; rewrite Fl; reflexivity.
      + intros x y [J|J]; [injection J as <- <-; exact BA|].
        apply settle with v a b; [apply Cl; right; apply in_app_iff; auto|..]; intros E0;
          [|injection E0 as -> ->; apply (N4 (b, a)); [apply In_D; right; apply in_app_iff; auto|do 3 right; exact BA]|];
          rewrite E0 in J; apply NoDup_cons_iff in R1; destruct R1 as [R1 R2];
          apply NoDup_app_split in R2; destruct R2 as (_ & _ & R2).
        * apply (R2 _ J); left; reflexivity.
        * apply R1, in_app_iff; auto.
      + rewrite after_cons; exact Fo.
    - (* R *)
      intros K m a b v st tr p G H V X Y G' IH N E0; cbn [map snd] in N; apply Shift in N.
      specialize (IH N E0); inversion IH as [|K' a' b' X1 t tr1 st' tr2 D Fl Cl Fo]; subst.
      rewrite map_app, edges_app in N; apply NoDup_app_split in N; destruct N as (N1 & _ & N2).
      assert (N3 : NoDup (edges (map snd tr1))) by (apply NoDup_app_split in N1; tauto).
      assert (N4 : forall e, In e (edges (map snd tr1)) -> ~ In e (edges ((v, a, b) :: K))).
      { intros e I; apply N2, in_app_iff; auto. }
      assert (R1 := ring_once _ _ _ _ _ _ D N3); apply NoDup_cons_iff in R1; destruct R1 as [R1 _].
      assert (In_D := fun e => ring_in_disc _ _ _ _ _ _ e D).
      assert (BA := behind _ _ _ _ _ _ G).
      change ((sR, (v, a, b)) :: tr1 ++ tr2) with (((sR, (v, a, b)) :: tr1) ++ tr2).
      apply forest_cons with (v :: X1) (TR t).
      + change (created ((sR, (v, a, b)) :: tr1)) with (created tr1); cbn [map snd]; apply disc_R, D.
      + cbn [map fst flat]; rewrite Fl; reflexivity.
      + cbn [path]; intros x y [J|[J|J]]; [injection J as <- <-; exact BA|injection J as <- <-; exact X|].
        apply settle with v a b; [apply Cl; right; exact J|..]; intros E0; rewrite E0 in J.
        * exact (R1 J).
        * apply (N4 (b, a)); [apply In_D; right; exact J|do 3 right; exact BA].
        * apply (N4 (v, b)); [apply In_D; right; exact J|do 3 right; exact X].
      + rewrite after_cons; exact Fo.
    - (* L *)
      intros K m a b v st tr p G H V X Y G' IH N E0; cbn [map snd] in N; apply Shift in N.
      specialize (IH N E0); inversion IH as [|K' a' b' X1 t tr1 st' tr2 D Fl Cl Fo]; subst.
      rewrite map_app, edges_app in N; apply NoDup_app_split in N; destruct N as (N1 & _ & N2).
      assert (N3 : NoDup (edges (map snd tr1))) by (apply NoDup_app_split in N1; tauto).
      assert (N4 : forall e, In e (edges (map snd tr1)) -> ~ In e (edges ((v, a, b) :: K))).
      { intros e I; apply N2, in_app_iff; auto. }
      assert (R1 := ring_once _ _ _ _ _ _ D N3); apply NoDup_cons_iff in R1; destruct R1 as [R1 _].
      assert (In_D := fun e => ring_in_disc _ _ _ _ _ _ e D).
      assert (BA := behind _ _ _ _ _ _ G).
      change ((sL, (v, a, b)) :: tr1 ++ tr2) with (((sL, (v, a, b)) :: tr1) ++ tr2).
      apply forest_cons with (X1 ++ [v]) (TL t).
      + change (created ((sL, (v, a, b)) :: tr1)) with (created tr1); cbn [map snd]; apply disc_L, D.
      + cbn [map fst flat]; rewrite Fl; reflexivity.
      + rewrite path_app; cbn [path]; intros x y [J|J]; [injection J as <- <-; exact BA|].
        apply in_app_iff in J; destruct J as [J|[J|[]]]; [|injection J as <- <-; exact Y].
        apply settle with v a b; [apply Cl; right; exact J|..]; intros E0; rewrite E0 in J.
        * apply (N4 (a, v)); [apply In_D; right; exact J|do 3 right; exact Y].
        * apply (N4 (b, a)); [apply In_D; right; exact J|do 3 right; exact BA].
        * exact (R1 J).
      + rewrite after_cons; exact Fo.
    - (* S *)
      intros K m a b v st tr p G H V X Y G' IH N E0; cbn [map snd] in N; apply Shift in N.
      specialize (IH N E0); inversion IH as [|K' a' b' X1 t1 tr1 st' tr' D1 Fl1 Cl1 Fo1]; subst.
      inversion Fo1 as [|K' a' b' X2 t2 tr2 st' tr3 D2 Fl2 Cl2 Fo2]; subst.
      rewrite !map_app, !edges_app in N.
      assert (N12 : forall e, In e (edges (map snd tr1)) -> ~ In e (edges (map snd tr2))).
      { apply NoDup_app_split in N; destruct N as (N & _); apply NoDup_app_split in N.
        destruct N as (_ & _ & N); intros e I J; apply (N e I), in_app_iff; auto. }
      assert (Nd : NoDup (edges (map snd tr1)) /\ NoDup (edges (map snd tr2))).
      { apply NoDup_app_split in N; destruct N as (N & _); apply NoDup_app_split in N.
        destruct N as (A1 & N & _); apply NoDup_app_split in N; tauto. }
      destruct Nd as [Nd1 Nd2].
      assert (New : forall e, In e (edges (map snd tr1)) \/ In e (edges (map snd tr2)) ->
        ~ In e (edges ((v, a, b) :: K))).
      { apply NoDup_app_split in N; destruct N as (_ & _ & N); intros e I; apply N.
        rewrite !in_app_iff; tauto. }
      assert (R1 := ring_once _ _ _ _ _ _ D1 Nd1); apply NoDup_cons_iff in R1; destruct R1 as [R1 _].
      assert (R2 := ring_once _ _ _ _ _ _ D2 Nd2); apply NoDup_cons_iff in R2; destruct R2 as [R2 _].
      assert (In1 := fun e => ring_in_disc _ _ _ _ _ _ e D1).
      assert (In2 := fun e => ring_in_disc _ _ _ _ _ _ e D2).
      assert (BA := behind _ _ _ _ _ _ G).
      change ((sS, (v, a, b)) :: tr1 ++ tr2 ++ tr3) with (((sS, (v, a, b)) :: tr1) ++ tr2 ++ tr3).
      rewrite app_assoc; apply forest_cons with (X1 ++ v :: X2) (TS t1 t2).
      + change (created (((sS, (v, a, b)) :: tr1) ++ tr2)) with (created (tr1 ++ tr2)).
        rewrite created_app; cbn [app map snd]; rewrite map_app; apply disc_S; assumption.
      + cbn [app map fst flat]; rewrite map_app, Fl1, Fl2; reflexivity.
      + rewrite path_app; intros x y [J|J]; [injection J as <- <-; exact BA|].
        apply in_app_iff in J; destruct J as [J|J].
        * apply settle with v a b; [apply Cl1; right; exact J|..]; intros E0; rewrite E0 in J.
          -- apply (N12 (a, v)); [apply In1; right; exact J|apply In2; left; reflexivity].
          -- apply (New (b, a)); [left; apply In1; right; exact J|do 3 right; exact BA].
          -- exact (R1 J).
        * assert (J2 : In (x, y) (edges (map snd tr2))) by (apply In2; right; exact J).
          assert (I : In (y, x) (edges ((v, a, b) :: K))).
          { assert (I := Cl2 x y (or_intror J)).
            apply (Permutation_in _ (edges_after tr1 _)), in_app_iff in I; destruct I as [I|I]; [|exact I].
            exfalso; destruct (disc_flip _ _ _ _ _ _ _ _ D1 I) as [I'|I'].
            - exact (N12 _ I' J2).
            - apply (New (x, y)); [right; exact J2|exact (Cl1 _ _ I')]. }
          apply settle with v a b; [exact I|..]; intros E0; rewrite E0 in J, J2.
          -- exact (R2 J).
          -- apply (New (b, a)); [right; exact J2|do 3 right; exact BA].
          -- apply (N12 (v, b)); [apply In1; left; reflexivity|exact J2].
      + rewrite after_app, after_cons; exact Fo2.
    - (* E, the last *)
      intros K m a b v st G H V X Y Q N E0; subst st.
      change [(sE, (v, a, b))] with ([(sE, (v, a, b))] ++ []); apply forest_cons with [v] TE.
      + apply disc_E.
      + reflexivity.
      + cbn [path]; intros x y [J|[J|[J|[]]]]; injection J as <- <-; auto; apply (behind _ _ _ _ _ _ G).
      + constructor.
    - (* E *)
      intros K m a b v passed a' b' rest tr p G H V X Y Q O G' IH N E0.
      apply app_eq_nil in E0; destruct E0 as [-> ->]; cbn [app].
      cbn [map snd] in N; apply Shift in N.
      change ((sE, (v, a, b)) :: tr) with ([(sE, (v, a, b))] ++ tr); apply forest_cons with [v] TE.
      + apply disc_E.
      + reflexivity.
      + cbn [path]; intros x y [J|[J|[J|[]]]]; injection J as <- <-; auto; apply (behind _ _ _ _ _ _ G).
      + rewrite after_cons; apply IH; auto.
  Qed.

  (** The whole walk is one disc on the loop of P. *)
  Theorem walk_is_disc : forall x0 x1 x2 rest tr, M = (x0, x1, x2) :: rest ->
    Walk M [(x0, x1, x2)] [x0; x1; x2] x2 x1 [] tr [] ->
    exists t, disc t x2 x1 [x0] (created tr) (map snd tr) /\ map fst tr = flat t.
  Proof.
    intros x0 x1 x2 rest tr E0 W; assert (G := good_start M SM x0 x1 x2 rest E0).
    assert (Fo := walk_is_forest _ _ _ _ _ _ _ W G eq_refl).
    destruct (visited M SM _ _ _ _ _ _ _ W G) as (_ & N & _).
    apply (Permutation_NoDup (edges_after tr _)), NoDup_app_split in N; destruct N as (N & _).
    destruct (face_distinct M SM x0 x1 x2) as (D1 & D2 & D3); [rewrite E0; left; left; reflexivity|].
    clear E0; inversion Fo as [|K' a' b' X t tr1 st' tr2 D Fl Cl Fo2]; subst.
    inversion Fo2; subst; rewrite app_nil_r in *; exists t; split; [|exact Fl].
    assert (R1 := ring_once _ _ _ _ _ _ D N).
    assert (Next : forall x y, In (x, y) ((x2, x1) :: path x1 X x2) ->
      (x, y) = (x2, x1) \/ (x, y) = (x1, x0) \/ (x, y) = (x0, x2)).
    { intros x y J; assert (I := Cl x y J); cbn in I.
      destruct I as [I|[I|[I|[]]]]; injection I as <- <-; auto. }
    destruct (disc_sizes _ _ _ _ _ _ D) as (_ & _ & _ & _ & NE); destruct X as [|z X]; [congruence|].
    assert (z = x0) as ->.
    { destruct (Next x1 z) as [A|[A|A]]; [right; left; reflexivity|congruence|congruence|congruence]. }
    destruct X as [|z X]; [exact D|exfalso]; cbn [path] in *.
    assert (z = x2) as ->.
    { destruct (Next x0 z) as [A|[A|A]]; [right; right; left; reflexivity|congruence|congruence|congruence]. }
    destruct X as [|z X]; cbn [path] in *.
    - destruct (Next x2 x2) as [A|[A|A]]; [do 3 right; left; reflexivity|congruence|congruence|congruence].
    - assert (z = x1) as ->.
      { destruct (Next x2 z) as [A|[A|A]]; [do 3 right; left; reflexivity|congruence|congruence|congruence]. }
      apply NoDup_cons_iff in R1; destruct R1 as [R1 _]; apply R1; right; right; left; reflexivity.
  Qed.
End Sphere.
