(** The traversal of a connected closed surface visits every face once.

    EB-TRAVERSE-1, EB-COMPONENT-3: when the stack is used up, no edge between a visited face and an
    unvisited one is left, because the link of each vertex is a circle: the triangles at the apex of a
    C are all visited in the end ([C_closed]), and so are those at P. Therefore, the mesh being
    connected, every face has been visited ([all_visited]), each once ([visited]). *)
Require Import List Arith Lia Bool Permutation Relation_Operators.
Require Import Clers.Letters Clers.Words Clers.Meshes Clers.Discs Clers.Traversal.
Import ListNotations.
Open Scope nat_scope.

(** The faces visited after a trace, last first, and the vertices that its C created. *)
Definition after (tr : list step) (K : list face) : list face := rev (map snd tr) ++ K.
Definition created1 (s : step) : list nat := match s with (sC, (v, _, _)) => [v] | _ => [] end.
Definition created (tr : list step) : list nat := flat_map created1 tr.

Lemma after_cons : forall s f tr K, after ((s, f) :: tr) K = after tr (f :: K).
Proof. intros; unfold after; cbn [map snd rev]; rewrite <- app_assoc; reflexivity. Qed.

Lemma after_keeps : forall tr K e, In e (edges K) -> In e (edges (after tr K)).
Proof. intros; unfold after; rewrite edges_app; apply in_or_app; auto. Qed.

(** A property handed on around a circle, either way. *)
Lemma path_forward : forall (Q : nat -> Prop) X a b,
  (forall y z, In (y, z) (path a X b) -> Q y -> Q z) -> Q a -> forall y, In y (a :: X ++ [b]) -> Q y.
Proof.
  induction X as [|c X IH]; cbn [path app]; intros a b H A y [<-|I]; auto.
  - destruct I as [<-|[]]; apply (H a); cbn; auto.
  - apply (IH c b); auto; [intros p q J; apply H; right; exact J|apply (H a); cbn; auto].
Qed.

Lemma path_backward : forall (Q : nat -> Prop) X a b,
  (forall y z, In (y, z) (path a X b) -> Q z -> Q y) -> Q b -> forall y, In y (a :: X ++ [b]) -> Q y.
Proof.
  induction X as [|c X IH]; cbn [path app]; intros a b H B y I.
  - destruct I as [<-|[<-|[]]]; auto; apply (H a b); cbn; auto.
  - assert (A : forall y, In y (c :: X ++ [b]) -> Q y).
    { apply IH; auto; intros p q J; apply H; right; exact J. }
    destruct I as [<-|I]; [apply (H a c); cbn; auto; apply A; left; reflexivity|apply A; exact I].
Qed.

Lemma ring_forward : forall (Q : nat -> Prop) l, (forall y z, In (y, z) (ring l) -> Q y -> Q z) ->
  forall y, In y l -> Q y -> forall z, In z l -> Q z.
Proof.
  intros Q l H y I A; apply in_split in I; destruct I as ([|a l1] & l2 & ->); cbn [app ring] in *.
  - assert (B := path_forward Q l2 y y H A); intros z [<-|J]; auto; apply B; right.
    apply in_or_app; auto.
  - rewrite path_app in H.
    assert (B := path_forward Q l2 y a (fun p q J => H p q (in_or_app _ _ _ (or_intror J))) A).
    assert (Q a) by (apply B; right; apply in_or_app; cbn; auto).
    assert (D := path_forward Q l1 a y (fun p q J => H p q (in_or_app _ _ _ (or_introl J))) H0).
    intros z [<-|J]; auto; apply in_app_or in J; destruct J as [J|[<-|J]]; auto.
    + apply D; right; apply in_or_app; auto.
    + apply B; right; apply in_or_app; auto.
Qed.

Lemma ring_backward : forall (Q : nat -> Prop) l, (forall y z, In (y, z) (ring l) -> Q z -> Q y) ->
  forall y, In y l -> Q y -> forall z, In z l -> Q z.
Proof.
  intros Q l H y I A; apply in_split in I; destruct I as ([|a l1] & l2 & ->); cbn [app ring] in *.
  - assert (B := path_backward Q l2 y y H A); intros z [<-|J]; auto; apply B; right.
    apply in_or_app; auto.
  - rewrite path_app in H.
    assert (D := path_backward Q l1 a y (fun p q J => H p q (in_or_app _ _ _ (or_introl J))) A).
    assert (Q a) by (apply D; left; reflexivity).
    assert (B := path_backward Q l2 y a (fun p q J => H p q (in_or_app _ _ _ (or_intror J))) H0).
    intros z [<-|J]; auto; apply in_app_or in J; destruct J as [J|[<-|J]]; auto.
    + apply D; right; apply in_or_app; auto.
    + apply B; right; apply in_or_app; auto.
Qed.

Lemma ring_ends : forall l y z, In (y, z) (ring l) -> In y l /\ In z l.
Proof.
  intros [|a X] y z I; [destruct I|]; apply path_in in I; destruct I as [I J]; split; auto.
  apply in_app_or in J; destruct J as [J|[<-|[]]]; [right; exact J|left; reflexivity].
Qed.

Lemma circle_forward : forall M x (Q : nat -> Prop), circle M x ->
  (forall y z, has M x y z -> Q y -> Q z) ->
  forall y z, has M x y z -> Q y -> forall y' z', has M x y' z' -> Q y'.
Proof.
  intros M x Q (l & _ & _ & H) F y z A B y' z' A'; apply H, ring_ends in A; apply H, ring_ends in A'.
  apply (ring_forward Q l) with y; try tauto; intros p q J; apply F, H, J.
Qed.

Lemma circle_backward : forall M x (Q : nat -> Prop), circle M x ->
  (forall y z, has M x y z -> Q z -> Q y) ->
  forall y z, has M x y z -> Q z -> forall y' z', has M x y' z' -> Q z'.
Proof.
  intros M x Q (l & _ & _ & H) F y z A B y' z' A'; apply H, ring_ends in A; apply H, ring_ends in A'.
  apply (ring_backward Q l) with z; try tauto; intros p q J; apply F, H, J.
Qed.

Section Surface.
  Variable M : list face.
  Hypothesis SM : surface M.

  (** A rule for induction over a walk that knows of [good]. *)
  Lemma walk_induction :
    forall P : list face -> list nat -> nat -> nat -> list edge -> list step -> list edge -> Prop,
    (forall K m a b v st tr p, good M K m a b st -> has M a b v -> ~ In v m ->
      good M ((v, a, b) :: K) (v :: m) v b st -> P ((v, a, b) :: K) (v :: m) v b st tr p ->
      P K m a b st ((sC, (v, a, b)) :: tr) p) ->
    (forall K m a b v st tr p, good M K m a b st -> has M a b v -> In v m ->
      In (v, b) (edges K) -> ~ In (a, v) (edges K) ->
      good M ((v, a, b) :: K) m a v st -> P ((v, a, b) :: K) m a v st tr p ->
      P K m a b st ((sR, (v, a, b)) :: tr) p) ->
    (forall K m a b v st tr p, good M K m a b st -> has M a b v -> In v m ->
      ~ In (v, b) (edges K) -> In (a, v) (edges K) ->
      good M ((v, a, b) :: K) m v b st -> P ((v, a, b) :: K) m v b st tr p ->
      P K m a b st ((sL, (v, a, b)) :: tr) p) ->
    (forall K m a b v st tr p, good M K m a b st -> has M a b v -> In v m ->
      ~ In (v, b) (edges K) -> ~ In (a, v) (edges K) ->
      good M ((v, a, b) :: K) m v b ((a, v) :: st) -> P ((v, a, b) :: K) m v b ((a, v) :: st) tr p ->
      P K m a b st ((sS, (v, a, b)) :: tr) p) ->
    (forall K m a b v st, good M K m a b st -> has M a b v -> In v m ->
      In (v, b) (edges K) -> In (a, v) (edges K) ->
      (forall g, In g st -> In g (edges ((v, a, b) :: K))) -> P K m a b st [(sE, (v, a, b))] st) ->
    (forall K m a b v passed a' b' rest tr p, good M K m a b (passed ++ (a', b') :: rest) ->
      has M a b v -> In v m -> In (v, b) (edges K) -> In (a, v) (edges K) ->
      (forall g, In g passed -> In g (edges ((v, a, b) :: K))) ->
      ~ In (a', b') (edges ((v, a, b) :: K)) ->
      good M ((v, a, b) :: K) m a' b' rest -> P ((v, a, b) :: K) m a' b' rest tr p ->
      P K m a b (passed ++ (a', b') :: rest) ((sE, (v, a, b)) :: tr) (passed ++ p)) ->
    forall K m a b st tr p, Walk M K m a b st tr p -> good M K m a b st -> P K m a b st tr p.
  Proof.
    intros P HC HR HL HS Hend HE K m a b st tr p W.
    induction W as [K m a b v st tr p H V W IH|K m a b v st tr p H V X Y W IH
      |K m a b v st tr p H V X Y W IH|K m a b v st tr p H V X Y W IH|K m a b v st H V X Y Q
      |K m a b v passed a' b' rest tr p H V X Y Q O W IH]; intros G.
    - assert (~ In (v, b) (edges K)) by (destruct (advance M SM _ _ _ _ _ _ G H) as (_ & _ & _ & _ & A & _); auto).
      assert (G' : good M ((v, a, b) :: K) (v :: m) v b st).
      { apply good_right with m st; auto; cbn; intuition auto. }
      apply HC; auto.
    - assert (G' := good_left M SM _ _ _ _ _ _ G H Y V); apply HR; auto.
    - assert (G' : good M ((v, a, b) :: K) m v b st).
      { apply good_right with m st; auto; intros x; intuition (subst; auto). }
      apply HL; auto.
    - assert (G' : good M ((v, a, b) :: K) m v b ((a, v) :: st)).
      { apply good_right with m st; auto; [intros x; intuition (subst; auto)|intros x y [I|I]; auto]. }
      apply HS; auto.
    - apply Hend; auto.
    - assert (G' := good_popped M SM _ _ _ _ _ _ _ _ _ G H O V); apply HE; auto.
  Qed.

  (** The faces visited are faces of the mesh, each once; the vertices created are new, each once. *)
  Lemma visited : forall K m a b st tr p, Walk M K m a b st tr p -> good M K m a b st ->
    (forall x y z, has (after tr K) x y z -> has M x y z) /\ NoDup (edges (after tr K)) /\
    NoDup (created tr) /\ (forall x, In x (created tr) -> ~ In x m) /\
    (forall x, In x (vertices (after tr K)) <-> In x m \/ In x (created tr)).
  Proof.
    apply (walk_induction (fun K m a b st tr p =>
      (forall x y z, has (after tr K) x y z -> has M x y z) /\ NoDup (edges (after tr K)) /\
      NoDup (created tr) /\ (forall x, In x (created tr) -> ~ In x m) /\
      (forall x, In x (vertices (after tr K)) <-> In x m \/ In x (created tr)))).
    - intros K m a b v st tr p G H V G' (I1 & I2 & I3 & I4 & I5); rewrite after_cons.
      change (created ((sC, (v, a, b)) :: tr)) with (v :: created tr); repeat split; auto.
      + constructor; [intros J; apply (I4 _ J); left; reflexivity|exact I3].
      + intros x [<-|J]; [exact V|intros J'; apply (I4 _ J); right; exact J'].
      + intros J; apply I5 in J; cbn [In] in *; tauto.
      + intros J; apply I5; cbn [In] in *; tauto.
    - intros K m a b v st tr p G H V X Y G' IH; rewrite after_cons; exact IH.
    - intros K m a b v st tr p G H V X Y G' IH; rewrite after_cons; exact IH.
    - intros K m a b v st tr p G H V X Y G' IH; rewrite after_cons; exact IH.
    - intros K m a b v st G H V X Y Q; destruct (advance M SM _ _ _ _ _ _ G H) as (A1 & A2 & A3 & A4 & _).
      change (after [(sE, (v, a, b))] K) with ((v, a, b) :: K); change (created [(sE, (v, a, b))]) with (@nil nat).
      repeat split; auto using NoDup_nil.
      + intros J; apply A4 in J; intuition (subst; auto).
      + intros [J|[]]; apply A4; auto.
    - intros K m a b v passed a' b' rest tr p G H V X Y Q O G' IH; rewrite after_cons; exact IH.
  Qed.

  (** An edge open at the end, visited on its first side only, was open before and no gate, or is the
      left edge of a C. *)
  Lemma open_edges : forall K m a b st tr p, Walk M K m a b st tr p -> good M K m a b st ->
    forall x y, In (x, y) (edges (after tr K)) -> ~ In (y, x) (edges (after tr K)) ->
    (In (x, y) (edges K) /\ (y, x) <> (a, b) /\ ~ In (y, x) st)
    \/ exists a' b', In (sC, (x, a', b')) tr /\ y = a'.
  Proof.
    apply (walk_induction (fun K m a b st tr p => forall x y, In (x, y) (edges (after tr K)) ->
      ~ In (y, x) (edges (after tr K)) -> (In (x, y) (edges K) /\ (y, x) <> (a, b) /\ ~ In (y, x) st)
      \/ exists a' b', In (sC, (x, a', b')) tr /\ y = a')).
    - intros K m a b v st tr p G H V G' IH x y I J; rewrite after_cons in I, J.
      destruct (IH _ _ I J) as [(A & B & D)|(a' & b' & A & B)]; [|right; exists a', b'; split; [right|]; auto].
      change (edges ((v, a, b) :: K)) with ((v, a) :: (a, b) :: (b, v) :: edges K) in A.
      destruct A as [A|[A|[A|A]]].
      + injection A as <- <-; right; exists a, b; split; [left|]; reflexivity.
      + injection A as <- <-; destruct J; apply after_keeps; right; right; right; apply (behind _ _ _ _ _ _ G).
      + injection A as <- <-; congruence.
      + left; split; [exact A|split; [|exact D]].
        intros E0; injection E0 as -> ->; destruct J; apply after_keeps; right; left; reflexivity.
    - intros K m a b v st tr p G H V X Y G' IH x y I J; rewrite after_cons in I, J.
      destruct (IH _ _ I J) as [(A & B & D)|(a' & b' & A & B)]; [|right; exists a', b'; split; [right|]; auto].
      change (edges ((v, a, b) :: K)) with ((v, a) :: (a, b) :: (b, v) :: edges K) in A.
      destruct A as [A|[A|[A|A]]].
      + injection A as <- <-; congruence.
      + injection A as <- <-; destruct J; apply after_keeps; right; right; right; apply (behind _ _ _ _ _ _ G).
      + injection A as <- <-; destruct J; apply after_keeps; right; right; right; exact X.
      + left; split; [exact A|split; [|exact D]].
        intros E0; injection E0 as -> ->; destruct J; apply after_keeps; right; left; reflexivity.
    - intros K m a b v st tr p G H V X Y G' IH x y I J; rewrite after_cons in I, J.
      destruct (IH _ _ I J) as [(A & B & D)|(a' & b' & A & B)]; [|right; exists a', b'; split; [right|]; auto].
      change (edges ((v, a, b) :: K)) with ((v, a) :: (a, b) :: (b, v) :: edges K) in A.
      destruct A as [A|[A|[A|A]]].
      + injection A as <- <-; destruct J; apply after_keeps; right; right; right; exact Y.
      + injection A as <- <-; destruct J; apply after_keeps; right; right; right; apply (behind _ _ _ _ _ _ G).
      + injection A as <- <-; congruence.
      + left; split; [exact A|split; [|exact D]].
        intros E0; injection E0 as -> ->; destruct J; apply after_keeps; right; left; reflexivity.
    - intros K m a b v st tr p G H V X Y G' IH x y I J; rewrite after_cons in I, J.
      destruct (IH _ _ I J) as [(A & B & D)|(a' & b' & A & B)]; [|right; exists a', b'; split; [right|]; auto].
      change (edges ((v, a, b) :: K)) with ((v, a) :: (a, b) :: (b, v) :: edges K) in A.
      destruct A as [A|[A|[A|A]]].
      + injection A as <- <-; destruct D; left; reflexivity.
      + injection A as <- <-; destruct J; apply after_keeps; right; right; right; apply (behind _ _ _ _ _ _ G).
      + injection A as <- <-; congruence.
      + left; split; [exact A|split; [|intros D'; apply D; right; exact D']].
        intros E0; injection E0 as -> ->; destruct J; apply after_keeps; right; left; reflexivity.
    - intros K m a b v st G H V X Y Q x y I J; left.
      change (after [(sE, (v, a, b))] K) with ((v, a, b) :: K) in *.
      change (edges ((v, a, b) :: K)) with ((v, a) :: (a, b) :: (b, v) :: edges K) in *.
      destruct I as [A|[A|[A|A]]].
      + injection A as <- <-; destruct J; right; right; right; exact Y.
      + injection A as <- <-; destruct J; right; right; right; apply (behind _ _ _ _ _ _ G).
      + injection A as <- <-; destruct J; right; right; right; exact X.
      + split; [exact A|split].
        * intros E0; injection E0 as -> ->; destruct J; right; left; reflexivity.
        * intros D; apply J, Q, D.
    - intros K m a b v passed a' b' rest tr p G H V X Y Q O G' IH x y I J; rewrite after_cons in I, J.
      destruct (IH _ _ I J) as [(A & B & D)|(a'' & b'' & A & B)]; [|right; exists a'', b''; split; [right|]; auto].
      change (edges ((v, a, b) :: K)) with ((v, a) :: (a, b) :: (b, v) :: edges K) in A.
      destruct A as [A|[A|[A|A]]].
      + injection A as <- <-; destruct J; apply after_keeps; right; right; right; exact Y.
      + injection A as <- <-; destruct J; apply after_keeps; right; right; right; apply (behind _ _ _ _ _ _ G).
      + injection A as <- <-; destruct J; apply after_keeps; right; right; right; exact X.
      + left; split; [exact A|split].
        * intros E0; injection E0 as -> ->; destruct J; apply after_keeps; right; left; reflexivity.
        * intros D'; apply in_app_iff in D'; destruct D' as [D'|[D'|D']]; [|congruence|contradiction].
          apply J, after_keeps, Q, D'.
  Qed.

  Lemma seen_at_end : forall K m a b st tr p x y z, Walk M K m a b st tr p -> good M K m a b st ->
    has M x y z -> In (x, y) (edges (after tr K)) -> has (after tr K) x y z.
  Proof.
    intros K m a b st tr p x y z W G H I; destruct (visited _ _ _ _ _ _ _ W G) as (A & _).
    apply (visited_once M SM); auto.
  Qed.

  (** All triangles at the apex of a C are visited in the end; so its left edge is closed. *)
  Lemma C_closed : forall K m a b st tr p, Walk M K m a b st tr p -> good M K m a b st ->
    forall v a' b', In (sC, (v, a', b')) tr -> In (a', v) (edges (after tr K)).
  Proof.
    intros K m a b st tr p W.
    induction W as [K m a b v st tr p H V W IH|K m a b v st tr p H V X Y W IH
      |K m a b v st tr p H V X Y W IH|K m a b v st tr p H V X Y W IH|K m a b v st H V X Y Q
      |K m a b v passed a' b' rest tr p H V X Y Q O W IH]; intros G w a0 b0 I.
    - assert (W' := Walk_C M _ _ _ _ _ _ _ _ H V W).
      assert (G' : good M ((v, a, b) :: K) (v :: m) v b st).
      { destruct (advance M SM _ _ _ _ _ _ G H) as (_ & _ & _ & _ & A & _).
        apply good_right with m st; auto; cbn; intuition auto. }
      destruct I as [I|I]; [injection I as <- <- <-|rewrite after_cons; apply (IH G' w a0 b0 I)].
      set (T := after ((sC, (v, a, b)) :: tr) K) in *.
      destruct (face_distinct M SM _ _ _ H) as (VA & VB & AB).
      assert (Ci : circle M v).
      { apply (circles M SM), has_vertex with a b, has_turn, has_turn, H. }
      assert (St : In (v, a) (edges T)) by (unfold T; rewrite after_cons; apply after_keeps; left; reflexivity).
      assert (Fw : forall y z, has M v y z -> In (v, y) (edges T) -> In (v, z) (edges T)).
      { intros y z A B; assert (D : has T v y z) by (apply (seen_at_end _ _ _ _ _ _ _ _ _ _ W' G); auto).
        destruct (in_dec edge_eq_dec (v, z) (edges T)) as [J|J]; [exact J|exfalso].
        assert (D' : In (z, v) (edges T)) by (apply has_edge with y, has_turn, has_turn, D).
        destruct (open_edges _ _ _ _ _ _ _ W' G _ _ D' J) as [(F & _)|(a1 & b1 & F & E1)].
        - apply V, (marks _ _ _ _ _ _ G); apply edge_has in F; destruct F as [u F].
          apply has_vertex with u z, has_turn, F.
        - destruct F as [F|F]; [injection F as -> -> ->; congruence|subst a1].
          apply J; unfold T; rewrite after_cons; apply (IH G' z v b1 F). }
      assert (Av : exists u, has M a v u).
      { apply edge_has, (closed M SM), has_edge with b, has_turn, has_turn, H. }
      destruct Av as [u Av].
      assert (Q : In (v, u) (edges T)).
      { apply (circle_forward M v (fun y => In (v, y) (edges T)) Ci Fw a b) with a; auto.
        - apply has_turn, has_turn, H.
        - apply has_turn, Av. }
      apply (seen_at_end _ _ _ _ _ _ _ v u a W' G) in Q; [|apply has_turn, Av].
      apply has_edge with u, has_turn, has_turn, Q.
    - destruct I as [I|I]; [discriminate|rewrite after_cons].
      apply (IH (good_left M SM _ _ _ _ _ _ G H Y V) w a0 b0 I).
    - destruct I as [I|I]; [discriminate|rewrite after_cons].
      refine (IH _ w a0 b0 I); apply good_right with m st; auto; intros x; intuition (subst; auto).
    - destruct I as [I|I]; [discriminate|rewrite after_cons]; refine (IH _ w a0 b0 I).
      apply good_right with m st; auto; [intros x; intuition (subst; auto)|intros x y [J|J]; auto].
    - destruct I as [I|[]]; discriminate.
    - destruct I as [I|I]; [discriminate|rewrite after_cons].
      apply (IH (good_popped M SM _ _ _ _ _ _ _ _ _ G H O V) w a0 b0 I).
  Qed.

  Section Whole.
    Variables x0 x1 x2 : nat.
    Variable rest : list face.
    Hypothesis start : M = (x0, x1, x2) :: rest.
    Variable tr : list step.
    Variable p : list edge.
    Hypothesis W : Walk M [(x0, x1, x2)] [x0; x1; x2] x2 x1 [] tr p.
    Let T := after tr [(x0, x1, x2)].
    Let G := good_start M SM x0 x1 x2 rest start.

    Lemma P_in : has M x0 x1 x2.
    Proof. rewrite start; left; left; reflexivity. Qed.

    Lemma seen : forall x y z, has M x y z -> In (x, y) (edges T) -> has T x y z.
    Proof. intros x y z; apply (seen_at_end _ _ _ _ _ _ _ x y z W G). Qed.

    (** Only two edges of P could be open. *)
    Lemma open_at_P : forall x y, In (x, y) (edges T) -> ~ In (y, x) (edges T) ->
      (x, y) = (x0, x1) \/ (x, y) = (x2, x0).
    Proof.
      intros x y I J; destruct (open_edges _ _ _ _ _ _ _ W G _ _ I J) as [(A & B & _)|(a & b & A & ->)].
      - cbn in A; destruct A as [A|[A|[A|[]]]]; auto; injection A as <- <-; congruence.
      - destruct J; apply (C_closed _ _ _ _ _ _ _ W G _ _ _ A).
    Qed.

    Lemma all_closed : forall x y, In (x, y) (edges T) -> In (y, x) (edges T).
    Proof.
      assert (H := P_in); destruct (face_distinct M SM _ _ _ H) as (D1 & D2 & D3).
      assert (H1 := has_turn _ _ _ _ H); assert (H2 := has_turn _ _ _ _ H1).
      assert (P0 : In (x0, x1) (edges T)) by (apply after_keeps; cbn; auto).
      assert (P1 : In (x1, x2) (edges T)) by (apply after_keeps; cbn; auto).
      assert (P2 : In (x2, x0) (edges T)) by (apply after_keeps; cbn; auto).
      assert (C1 : In (x1, x0) (edges T)).
      { assert (Ci : circle M x1) by (apply (circles M SM), has_vertex with x2 x0, H1).
        assert (Bw : forall y z, has M x1 y z -> In (z, x1) (edges T) -> In (y, x1) (edges T)).
        { intros y z A B; destruct (in_dec edge_eq_dec (y, x1) (edges T)) as [J|J]; [exact J|exfalso].
          assert (I : In (x1, y) (edges T)).
          { apply has_edge with z, has_turn, (seen z x1 y); [apply has_turn, has_turn, A|exact B]. }
          destruct (open_at_P _ _ I J) as [E0|E0]; injection E0; intros; subst; congruence. }
        destruct (edge_has M x1 x0) as [u A]; [apply (closed M SM), has_edge with x2, H|].
        assert (Q := circle_backward M x1 (fun z => In (z, x1) (edges T)) Ci Bw x2 x0 H1 P0 _ _ A).
        apply has_edge with u, has_turn, (seen u x1 x0); [apply has_turn, has_turn, A|exact Q]. }
      assert (C2 : In (x0, x2) (edges T)).
      { assert (Ci : circle M x2) by (apply (circles M SM), has_vertex with x0 x1, H2).
        assert (Fw : forall y z, has M x2 y z -> In (x2, y) (edges T) -> In (x2, z) (edges T)).
        { intros y z A B; destruct (in_dec edge_eq_dec (x2, z) (edges T)) as [J|J]; [exact J|exfalso].
          assert (I : In (z, x2) (edges T)).
          { apply has_edge with y, has_turn, has_turn, (seen x2 y z); auto. }
          destruct (open_at_P _ _ I J) as [E0|E0]; injection E0; intros; subst; congruence. }
        destruct (edge_has M x0 x2) as [u A]; [apply (closed M SM), has_edge with x1, H2|].
        assert (A1 := has_turn _ _ _ _ A).
        assert (Q := circle_forward M x2 (fun y => In (x2, y) (edges T)) Ci Fw x0 x1 H2 P2 _ _ A1).
        apply has_edge with u, has_turn, has_turn, (seen x2 u x0); auto. }
      intros x y I; destruct (in_dec edge_eq_dec (y, x) (edges T)) as [J|J]; [exact J|exfalso].
      destruct (open_at_P _ _ I J) as [E0|E0]; injection E0 as -> ->; contradiction.
    Qed.

    Hypothesis connected_M : connected M.

    Theorem all_visited : forall x y z, has M x y z <-> has T x y z.
    Proof.
      destruct (visited _ _ _ _ _ _ _ W G) as (In_M & _); intros x y z; split; [|apply In_M].
      assert (A : forall f, In f M -> incl (runs f) (edges T)).
      { intros f I.
        assert (Way := connected_M (x0, x1, x2) f ltac:(rewrite start; left; reflexivity) I).
        apply Operators_Properties.clos_rt_rtn1 in Way; induction Way as [|g h N Way IH].
        - intros e J; apply after_keeps; cbn in *; tauto.
        - destruct N as (Ig & Ih & p' & q & J & J'); specialize (IH Ig).
          assert (B : In (q, p') (edges T)) by (apply all_closed, IH; auto).
          destruct h as [[u v] w]; cbn in J'.
          assert (Hh : has M u v w) by (left; exact Ih).
          assert (B' : has T u v w).
          { destruct J' as [J'|[J'|[J'|[]]]]; injection J' as -> ->.
            - apply seen; auto.
            - apply has_turn, has_turn, seen; auto; apply has_turn; exact Hh.
            - apply has_turn, seen; auto; apply has_turn, has_turn; exact Hh. }
          intros e [<-|[<-|[<-|[]]]].
          + apply has_edge with w, B'.
          + apply has_edge with u, has_turn, B'.
          + apply has_edge with v, has_turn, has_turn, B'. }
      intros H; apply seen; auto; apply has_edge, in_flat_map in H; destruct H as (f & I & J).
      exact (A f I _ J).
    Qed.
  End Whole.
End Surface.
