(** * What the M operators alone make

    Clause: OPER-EULER-6: what they make of the empty sheet has no genus, and no component with more
    than one loop. No M operator cuts a loop; M EKL needs two loops, and those lie in different
    components, so it never makes a handle. *)

Require Import ZArith List Lia Arith Bool Permutation Relation_Operators.
From Clers Require Import Graph Sheets Sheets_of_sheets Euler Scripts.
Import ListNotations.

(** The five that make: M STV is the 0-handle with three edges, and polygons may be among them. *)
Definition is_make (r : row) : bool :=
  match r with
  | zero_handle _ | make_ev | make_te | make_sg | make_ekl_one | make_ekl_two => true
  | _ => false
  end.

(** Two loops have no vertices that are joined. *)
Definition far (E : list edge) (l m : list nat) : Prop :=
  forall x y, In x l -> In y m -> ~ linked E x y.

(** No component has two loops. *)
Definition one_each (s : sheet) : Prop := ForallOrdPairs (far (all_sides s)) (loops s).

Lemma far_sym : forall E l m, far E l m -> far E m l.
Proof. intros E l m H x y X Y K; apply (H y x Y X), linked_sym, K. Qed.

Lemma pairs_order : forall (R : list nat -> list nat -> Prop), (forall l m, R l m -> R m l) ->
  forall L M, Permutation L M -> ForallOrdPairs R L -> ForallOrdPairs R M.
Proof.
  intros R S L M P; induction P as [|x L M P IH|x y L|L M N P IH P' IH']; intros H; auto.
  - inversion H as [|? ? F G]; subst; constructor; auto.
    apply (Permutation_Forall P); auto.
  - inversion H as [|? ? F G]; subst; inversion G as [|? ? F' G']; subst.
    inversion F as [|? ? A B]; subst; repeat constructor; auto.
Qed.

Lemma pairs_weaker : forall (R Q : list nat -> list nat -> Prop) L,
  (forall l m, In l L -> In m L -> R l m -> Q l m) -> ForallOrdPairs R L -> ForallOrdPairs Q L.
Proof.
  intros R Q L H P; induction P as [|l L F P IH]; constructor.
  - apply Forall_forall; intros m M; apply H; cbn; auto; rewrite Forall_forall in F; auto.
  - apply IH; intros; apply H; cbn; auto.
Qed.

Lemma pairs_head : forall (R : list nat -> list nat -> Prop) l L,
  ForallOrdPairs R (l :: L) <-> (forall m, In m L -> R l m) /\ ForallOrdPairs R L.
Proof.
  intros R l L; split; intros H.
  - inversion H as [|? ? F G]; subst; rewrite Forall_forall in F; auto.
  - constructor; [apply Forall_forall|]; apply H.
Qed.

Lemma linked_perm : forall E E' x y, Permutation E E' -> linked E x y -> linked E' x y.
Proof. intros E E' x y P; apply linked_more; intros e; apply Permutation_in; auto. Qed.

(** Sides between vertices that are joined already join nothing new. *)
Lemma linked_known : forall N E x y, (forall a b, In (a, b) N -> linked E a b) ->
  linked (N ++ E) x y -> linked E x y.
Proof.
  intros N E x y H K; induction K as [a b K|a|a b K IH|a b c K IH K' IH'].
  - apply in_app_iff in K; destruct K as [K|K]; [auto|apply linked_edge; auto].
  - apply linked_refl.
  - apply linked_sym; auto.
  - eapply linked_trans; eauto.
Qed.

(** Sides that a map of the vertices takes to joined ones. *)
Lemma linked_image : forall (f : nat -> nat) E E' x y,
  (forall a b, In (a, b) E' -> linked E (f a) (f b)) -> linked E' x y -> linked E (f x) (f y).
Proof.
  intros f E E' x y H K; induction K as [a b K|a|a b K IH|a b c K IH K' IH']; auto.
  - apply linked_refl.
  - apply linked_sym; auto.
  - eapply linked_trans; eauto.
Qed.

(** A new edge joins what was joined to one end with what was joined to the other. *)
Lemma linked_new : forall E a c x y, linked (two_sides a c ++ E) x y ->
  linked E x y \/ (linked E x a /\ linked E c y) \/ (linked E x c /\ linked E a y).
Proof.
  intros E a c x y K; induction K as [p q K|p|p q K IH|p q r K IH K' IH'].
  - destruct K as [K|[K|K]]; [injection K as <- <-|injection K as <- <-|left; apply linked_edge; auto].
    + right; left; split; apply linked_refl.
    + right; right; split; apply linked_refl.
  - left; apply linked_refl.
  - destruct IH as [A|[[A B]|[A B]]]; [left|right; right|right; left]; try split;
      apply linked_sym; auto.
  - destruct IH as [A|[[A B]|[A B]]], IH' as [A'|[[A' B']|[A' B']]].
    + left; exact (linked_trans _ _ _ _ A A').
    + right; left; split; [exact (linked_trans _ _ _ _ A A')|exact B'].
    + right; right; split; [exact (linked_trans _ _ _ _ A A')|exact B'].
    + right; left; split; [exact A|exact (linked_trans _ _ _ _ B A')].
    + right; left; split; [exact A|exact B'].
    + left; exact (linked_trans _ _ _ _ A B').
    + right; right; split; [exact A|exact (linked_trans _ _ _ _ B A')].
    + left; exact (linked_trans _ _ _ _ A B').
    + right; right; split; [exact A|exact B'].
Qed.

(** The vertices of a loop are vertices of the sheet. *)
Lemma loop_vertices : forall s l x, good s -> In l (loops s) -> In x l -> In x (vertices s).
Proof.
  intros s l x G L X; rewrite <- cycle_fst in X; apply in_map_iff in X.
  destruct X as [[a b] [E X]]; cbn in E; subst a.
  apply (sides_within s G x b); unfold all_sides, sides; apply in_app_iff; right.
  apply in_flat_map; exists l; auto.
Qed.

Lemma makes_one_each : forall r s s', good s -> one_each s -> is_make r = true -> makes r s s' ->
  one_each s' /\ r <> make_ekl_one.
Proof.
  intros r s s' G H I M; pose proof (loop_vertices s) as LV.
  pose proof (sides_within s G) as W; pose proof (makes_good r s s' G M) as G'.
  destruct (makes_sides r s s' M) as (N & P & D).
  unfold one_each in *; destruct M; try discriminate; try subst s; cbn [loops vertices] in *.
  - (* the 0-handle *)
    split; [|discriminate]; destruct D as (l' & _ & _ & _ & D & _ & _).
    assert (K : forall x y, linked (all_sides (Sheet (rev l ++ V) (rev l :: F) (l :: L))) x y ->
      (In x l /\ In y l) \/ linked (all_sides (Sheet V F L)) x y).
    { intros x y K; assert (KP : Permutation
        (all_sides (Sheet (rev l ++ V) (rev l :: F) (l :: L)))
        ((cycle (rev l) ++ cycle l) ++ all_sides (Sheet V F L))).
      { unfold all_sides, sides; cbn [faces loops flat_map]; reorder. }
      apply (linked_perm _ _ _ _ KP) in K.
      induction K as [p q K|p|p q K IH|p q r K IH K' IH'].
      - apply in_app_iff in K; destruct K as [K|K]; [left|right; apply linked_edge; auto].
        apply in_app_iff in K; destruct K as [K|K]; apply cycle_in in K; cbn [fst snd] in K; auto.
        rewrite <- !in_rev in K; auto.
      - right; apply linked_refl.
      - destruct IH as [[A B]|A]; [left|right; apply linked_sym]; auto.
      - destruct IH as [[A B]|A], IH' as [[A' B']|A']; auto.
        + left; split; auto.
          destruct (linked_within _ _ _ _ W A') as [<-|[Z _]]; auto; destruct (H2 q B Z).
        + left; split; auto.
          destruct (linked_within _ _ _ _ W A) as [->|[_ Z]]; auto; destruct (H2 q A' Z).
        + right; eapply linked_trans; eauto. }
    apply pairs_head; split.
    + intros m Hm x y X Y Z; apply K in Z; destruct Z as [[_ Z]|Z].
      * apply (H2 y Z), (LV m); auto.
      * destruct (linked_within _ _ _ _ W Z) as [<-|[Z' _]]; [|apply (H2 x X Z')].
        apply (H2 x X), (LV m); auto.
    + eapply pairs_weaker; [|exact H]; intros u w U U' Q x y X Y Z; apply K in Z.
      destruct Z as [[Z _]|Z]; [|apply (Q x y X Y Z)].
      apply (H2 x Z), (LV u); auto.
  - (* M EV *)
    split; [|discriminate].
    set (f := fun x => if Nat.eq_dec x v then a else x).
    assert (FV : f v = a) by (unfold f; destruct (Nat.eq_dec v v); congruence).
    assert (FO : forall x, In x V -> f x = x).
    { intros x Hx; unfold f; destruct (Nat.eq_dec x v); congruence. }
    set (s0 := Sheet V F ((a :: b :: X) :: L)) in *.
    set (s1 := Sheet (v :: V) F ((a :: v :: a :: b :: X) :: L)) in *.
    assert (AV : In a V) by (apply (LV (a :: b :: X)); cbn; auto).
    assert (KP : Permutation (all_sides s1) (two_sides a v ++ all_sides s0)).
    { unfold s1, s0; unfold_sides; reorder. }
    assert (K : forall x y, linked (all_sides s1) x y -> linked (all_sides s0) (f x) (f y)).
    { intros x y; apply linked_image; intros p q E; apply (Permutation_in _ KP) in E.
      destruct E as [E|[E|E]]; [injection E as <- <-|injection E as <- <-|].
      - rewrite FV, (FO a AV); apply linked_refl.
      - rewrite FV, (FO a AV); apply linked_refl.
      - destruct (W p q E) as [A B]; rewrite (FO p A), (FO q B); apply linked_edge; auto. }
    apply pairs_head in H; destruct H as [HF HP]; apply pairs_head; split.
    + intros m Hm x y Hx Hy Z; apply K in Z.
      rewrite (FO y) in Z by (apply (LV m); cbn; auto).
      assert (Q : In (f x) (a :: b :: X)).
      { destruct Hx as [<-|[<-|Hx]]; [rewrite (FO a AV); left; auto|rewrite FV; left; auto|].
        rewrite (FO x); [exact Hx|apply (LV (a :: b :: X)); cbn; auto]. }
      exact (HF m Hm _ _ Q Hy Z).
    + eapply pairs_weaker; [|exact HP]; intros u w U U' Q x y Hx Hy Z; apply K in Z.
      rewrite (FO x), (FO y) in Z; [apply (Q x y Hx Hy Z)|apply (LV w)|apply (LV u)]; cbn; auto.
  - (* M TE *)
    split; [|discriminate]; destruct D as (a' & c' & _ & _ & J & _ & EN); subst N.
    assert (K : forall x y, linked (all_sides (Sheet V ([a; b; c] :: F) ((a :: c :: X) :: L))) x y ->
      linked (all_sides (Sheet V F ((a :: b :: c :: X) :: L))) x y).
    { intros x y Z; apply (linked_perm _ _ _ _ P) in Z; eapply linked_known; [|exact Z].
      intros p q [E|[E|[]]]; injection E as <- <-; [auto|apply linked_sym; auto]. }
    apply pairs_head in H; destruct H as [HF HP]; apply pairs_head; split.
    + intros m Hm x y Hx Hy Z; apply (HF m Hm x y); auto; cbn in *; tauto.
    + eapply pairs_weaker; [|exact HP]; intros u w U U' Q x y Hx Hy Z; apply (Q x y Hx Hy); auto.
  - (* M SG *)
    split; [|discriminate]; destruct D as [_ ->]; cbn [app] in P.
    apply pairs_head in H; destruct H as [_ HP].
    eapply pairs_weaker; [|exact HP]; intros u w U U' Q x y Hx Hy Z; apply (Q x y Hx Hy).
    eapply linked_perm; [exact P|exact Z].
  - (* M EKL in one component: there is none *)
    exfalso; apply pairs_head in H; destruct H as [HF _].
    apply (HF (c :: Y) (or_introl eq_refl) a c); cbn; auto.
  - (* M EKL between two *)
    split; [|discriminate].
    set (s0 := Sheet V F ((a :: X) :: (c :: Y) :: L)) in *.
    set (s1 := Sheet V F ((a :: (c :: Y) ++ c :: a :: X) :: L)) in *.
    assert (KP : Permutation (all_sides s1) (two_sides a c ++ all_sides s0)).
    { unfold s1, s0; unfold_sides; rewrite (path_app Y c c); cbn [path]; reorder. }
    apply pairs_head in H; destruct H as [HA H]; apply pairs_head in H; destruct H as [HC HP].
    assert (FA : forall m y, In m L -> In y m -> ~ linked (all_sides s0) a y).
    { intros m y Hm Hy; apply (HA m); cbn; auto. }
    assert (FC : forall m y, In m L -> In y m -> ~ linked (all_sides s0) c y).
    { intros m y Hm Hy; apply (HC m); cbn; auto. }
    apply pairs_head; split.
    + intros m Hm x y Hx Hy Z; apply (linked_perm _ _ _ _ KP) in Z; apply linked_new in Z.
      destruct Z as [Z|[[_ Z]|[_ Z]]]; [|exact (FC m y Hm Hy Z)|exact (FA m y Hm Hy Z)].
      assert (Q : In x (a :: X) \/ In x (c :: Y)).
      { cbn [In app] in Hx |- *; rewrite in_app_iff in Hx; cbn [In] in Hx; tauto. }
      destruct Q as [Q|Q]; [apply (HA m (or_intror Hm) x y Q Hy Z)|apply (HC m Hm x y Q Hy Z)].
    + eapply pairs_weaker; [|exact HP]; intros u w U U' Q x y Hx Hy Z.
      apply (linked_perm _ _ _ _ KP) in Z; apply linked_new in Z.
      destruct Z as [Z|[[_ Z]|[_ Z]]];
        [exact (Q x y Hx Hy Z)|exact (FC w y U' Hy Z)|exact (FA w y U' Hy Z)].
Qed.

Lemma alike_one_each : forall E L L', alike L L' -> ForallOrdPairs (far E) L ->
  ForallOrdPairs (far E) L'.
Proof.
  intros E L L' A; induction A as [L M P|l m L T|L M N _ IH _ IH']; intros H; auto.
  - apply (pairs_order (far E) (far_sym E) L M P H).
  - apply pairs_head in H; destruct H as [HF HP]; apply pairs_head; split; auto.
    intros w Hw x y Hx; apply (HF w Hw x y); destruct T as (p & q & -> & ->).
    apply in_app_iff; apply in_app_iff in Hx; tauto.
Qed.

(** OPER-EULER-6. *)
Theorem only_makes : forall R t, forallb is_make R = true -> script R empty t ->
  one_each t /\ of_genus t 0.
Proof.
  intros R t B S.
  assert (G0 : good empty) by
    (constructor; cbn; first [apply NoDup_nil|solve [intros x []]|solve [intros x y []]]).
  assert (C0 : in_components empty 0) by (exists 0%nat; split; [apply no_component|auto]).
  assert (H0 : of_genus empty 0) by (exists 0%Z; split; [exact C0|reflexivity]).
  enough (K : one_each t /\ sum_of dg R = 0%Z).
  { destruct K as [K E]; split; auto; destruct (from_nothing R t S) as (c & _ & H & _).
    rewrite E in H; exact H. }
  remember empty as s eqn:ES.
  induction S as [s|R s V F F' L L' S IH A A'|R s t t' r S IH M].
  - subst; split; [constructor|reflexivity].
  - destruct (IH B ES G0 C0 H0) as [K E]; split; auto; unfold one_each in *; cbn [loops] in *.
    destruct (alike_sides L L' A) as [PL _], (alike_sides F F' A') as [PF _].
    apply (alike_one_each _ L L' A) in K.
    eapply pairs_weaker; [|exact K]; intros u w _ _ Q x y X Y Z; apply (Q x y X Y).
    eapply linked_perm; [|exact Z]; unfold all_sides; cbn [faces loops].
    apply Permutation_sym, Permutation_app; auto.
  - cbn [forallb] in B; apply andb_true_iff in B; destruct B as [B1 B2].
    destruct (IH B2 ES G0 C0 H0) as [K E].
    destruct (script_effects R s t 0 0 G0 C0 H0 S) as [G _].
    destruct (makes_one_each r t t' G K B1 M) as [K' NE]; split; auto.
    cbn [sum_of fold_right]; fold (sum_of dg R); rewrite E.
    destruct r; try discriminate B1; try reflexivity; congruence.
Qed.
