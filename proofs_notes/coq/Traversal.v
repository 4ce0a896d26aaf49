(** The traversal of one closed component, and what it counts.

    EB-COMPONENT-2, EB-TRAVERSE-1 … EB-TRAVERSE-6, EB-HANDLE-1: [encode M] walks over M from P, its
    first face, and answers the letters with their triangles, and the left gates that were passed
    over because their triangle had been visited: one record for each. [Walk] is the same machine as
    a relation, one rule a letter ([walk_is_Walk], [Walk_is_walk]). Proved here: on a surface the
    walk always ends ([Walk_ends]), and each new triangle has not been visited ([advance]). *)
Require Import List Arith Lia Bool Permutation.
Require Import Clers.Letters Clers.Words Clers.Meshes Clers.Discs.
Import ListNotations.
Open Scope nat_scope.

Notation step := (symbol * face)%type (only parsing).

(** EB-TRAVERSE-5: pass over the gates whose triangle has been visited. *)
Fixpoint pop (K : list face) (stack : list edge) : list edge * option (edge * list edge) :=
  match stack with
  | [] => ([], None)
  | g :: rest =>
      if in_dec edge_eq_dec g (edges K) then let (passed, next) := pop K rest in (g :: passed, next)
      else ([], Some (g, rest))
  end.

Definition put (s : symbol) (f : face) (passed : list edge) (r : option (list step * list edge)) :=
  match r with Some (tr, p) => Some ((s, f) :: tr, passed ++ p) | None => None end.

(** M: the mesh; K: the faces visited, last first; m: the vertices marked; a, b: the gate. A gate's
    triangle has been visited if a face of K runs the gate: EB-GATE-2. n: enough. *)
Fixpoint walk (n : nat) (M K : list face) (m : list nat) (a b : nat) (stack : list edge)
  : option (list step * list edge) :=
  match n with
  | 0 => None
  | S n =>
    match apex M a b with
    | None => None
    | Some v =>
      let f := (v, a, b) in
      if in_dec Nat.eq_dec v m then
        match in_dec edge_eq_dec (v, b) (edges K), in_dec edge_eq_dec (a, v) (edges K) with
        | left _, right _ => put sR f [] (walk n M (f :: K) m a v stack)
        | right _, left _ => put sL f [] (walk n M (f :: K) m v b stack)
        | left _, left _ =>
            match pop (f :: K) stack with
            | (passed, None) => Some ([(sE, f)], passed)
            | (passed, Some ((a', b'), rest)) => put sE f passed (walk n M (f :: K) m a' b' rest)
            end
        | right _, right _ => put sS f [] (walk n M (f :: K) m v b ((a, v) :: stack))
        end
      else put sC f [] (walk n M (f :: K) (v :: m) v b stack)
    end
  end.

Definition encode (M : list face) : option (list step * list edge) :=
  match M with
  | [] => None
  | (x, y, z) :: _ => walk (length M) M [(x, y, z)] [x; y; z] z y []
  end.

Inductive Walk (M : list face)
  : list face -> list nat -> nat -> nat -> list edge -> list step -> list edge -> Prop :=
| Walk_C : forall K m a b v st tr p, has M a b v -> ~ In v m ->
    Walk M ((v, a, b) :: K) (v :: m) v b st tr p -> Walk M K m a b st ((sC, (v, a, b)) :: tr) p
| Walk_R : forall K m a b v st tr p, has M a b v -> In v m ->
    In (v, b) (edges K) -> ~ In (a, v) (edges K) ->
    Walk M ((v, a, b) :: K) m a v st tr p -> Walk M K m a b st ((sR, (v, a, b)) :: tr) p
| Walk_L : forall K m a b v st tr p, has M a b v -> In v m ->
    ~ In (v, b) (edges K) -> In (a, v) (edges K) ->
    Walk M ((v, a, b) :: K) m v b st tr p -> Walk M K m a b st ((sL, (v, a, b)) :: tr) p
| Walk_S : forall K m a b v st tr p, has M a b v -> In v m ->
    ~ In (v, b) (edges K) -> ~ In (a, v) (edges K) ->
    Walk M ((v, a, b) :: K) m v b ((a, v) :: st) tr p -> Walk M K m a b st ((sS, (v, a, b)) :: tr) p
| Walk_end : forall K m a b v st, has M a b v -> In v m ->
    In (v, b) (edges K) -> In (a, v) (edges K) ->
    (forall g, In g st -> In g (edges ((v, a, b) :: K))) ->
    Walk M K m a b st [(sE, (v, a, b))] st
| Walk_E : forall K m a b v passed a' b' rest tr p, has M a b v -> In v m ->
    In (v, b) (edges K) -> In (a, v) (edges K) ->
    (forall g, In g passed -> In g (edges ((v, a, b) :: K))) ->
    ~ In (a', b') (edges ((v, a, b) :: K)) ->
    Walk M ((v, a, b) :: K) m a' b' rest tr p ->
    Walk M K m a b (passed ++ (a', b') :: rest) ((sE, (v, a, b)) :: tr) (passed ++ p).

Lemma pop_spec : forall K st passed next, pop K st = (passed, next) ->
  (forall g, In g passed -> In g (edges K)) /\
  match next with
  | None => st = passed
  | Some (g, rest) => st = passed ++ g :: rest /\ ~ In g (edges K)
  end.
Proof.
  induction st as [|g st IH]; cbn [pop]; intros passed next H.
  - injection H as <- <-; split; [intros g []|reflexivity].
  - destruct (in_dec edge_eq_dec g (edges K)) as [I|I].
    + destruct (pop K st) as [p n]; injection H as <- <-; destruct (IH p n eq_refl) as [A B].
      split; [intros h [<-|J]; auto|]; destruct n as [[h rest]|]; [destruct B as [-> B]; auto|congruence].
    + injection H as <- <-; split; [intros h []|auto].
Qed.

Lemma pop_passes : forall K passed st, (forall g, In g passed -> In g (edges K)) ->
  pop K (passed ++ st) = let (p, next) := pop K st in (passed ++ p, next).
Proof.
  induction passed as [|g passed IH]; cbn [app pop]; intros st H; [destruct (pop K st); reflexivity|].
  destruct (in_dec edge_eq_dec g (edges K)) as [I|I]; [|destruct I; apply H; left; reflexivity].
  rewrite IH by (intros h J; apply H; right; exact J); destruct (pop K st); reflexivity.
Qed.

Lemma put_inv : forall s f passed r x, put s f passed r = Some x ->
  exists tr p, r = Some (tr, p) /\ x = ((s, f) :: tr, passed ++ p).
Proof. intros s f passed [[tr p]|] x H; [injection H as <-; eauto|discriminate]. Qed.

Theorem walk_is_Walk : forall n M K m a b st tr p,
  walk n M K m a b st = Some (tr, p) -> Walk M K m a b st tr p.
Proof.
  induction n as [|n IH]; cbn [walk]; intros M K m a b st tr p H; [discriminate|].
  destruct (apex M a b) as [v|] eqn:A; [|discriminate]; apply apex_has in A.
  destruct (in_dec Nat.eq_dec v m).
  - destruct (in_dec edge_eq_dec (v, b) (edges K)), (in_dec edge_eq_dec (a, v) (edges K)).
    + destruct (pop ((v, a, b) :: K) st) as [passed [[[a' b'] rest]|]] eqn:P; apply pop_spec in P.
      * destruct P as (P & -> & Q); apply put_inv in H; destruct H as (tr' & p' & H & X).
        injection X as -> ->; apply Walk_E; auto.
      * destruct P as (P & ->); injection H as <- <-; apply Walk_end; auto.
    + apply put_inv in H; destruct H as (tr' & p' & H & X); injection X as -> ->; apply Walk_R; auto.
    + apply put_inv in H; destruct H as (tr' & p' & H & X); injection X as -> ->; apply Walk_L; auto.
    + apply put_inv in H; destruct H as (tr' & p' & H & X); injection X as -> ->; apply Walk_S; auto.
  - apply put_inv in H; destruct H as (tr' & p' & H & X); injection X as -> ->; apply Walk_C; auto.
Qed.

Theorem Walk_is_walk : forall M K m a b st tr p, NoDup (edges M) ->
  Walk M K m a b st tr p -> forall n, length tr <= n -> walk n M K m a b st = Some (tr, p).
Proof.
  intros M K m a b st tr p N; induction 1 as [K m a b v st tr p H V W IH|K m a b v st tr p H V X Y W IH
    |K m a b v st tr p H V X Y W IH|K m a b v st tr p H V X Y W IH|K m a b v st H V X Y P
    |K m a b v passed a' b' rest tr p H V X Y P Q W IH]; intros [|n] Le; cbn [length] in Le; try lia;
    cbn [walk]; rewrite (has_apex _ _ _ _ N H); destruct (in_dec Nat.eq_dec v m); try contradiction;
    try (destruct (in_dec edge_eq_dec (v, b) (edges K)), (in_dec edge_eq_dec (a, v) (edges K));
         try contradiction);
    try (rewrite IH by lia; reflexivity).
  - rewrite <- (app_nil_r st) at 1; rewrite pop_passes by exact P; cbn [pop]; rewrite app_nil_r; reflexivity.
  - rewrite pop_passes by exact P; cbn [pop].
    destruct (in_dec edge_eq_dec (a', b') (edges ((v, a, b) :: K))); [contradiction|].
    rewrite app_nil_r, IH by lia; reflexivity.
Qed.

(** What holds before every step. *)
Record good (M K : list face) (m : list nat) (a b : nat) (st : list edge) : Prop := {
  inside : forall x y z, has K x y z -> has M x y z;
  fresh : NoDup (edges K);
  marks : forall x, In x m <-> In x (vertices K);
  behind : In (b, a) (edges K);
  ahead : ~ In (a, b) (edges K);
  waiting : forall x y, In (x, y) st -> In (y, x) (edges K) }.

Section Surface.
  Variable M : list face.
  Hypothesis SM : surface M.

  Lemma face_ahead : forall K m a b st, good M K m a b st -> exists v, has M a b v.
  Proof.
    intros K m a b st G; apply edge_has, (closed M SM).
    destruct (edge_has _ _ _ (behind _ _ _ _ _ _ G)) as [v H].
    apply has_edge with v, (inside _ _ _ _ _ _ G), H.
  Qed.

  Lemma face_distinct : forall a b v, has M a b v -> v <> a /\ v <> b /\ a <> b.
  Proof.
    intros a b v H; repeat split; apply (proper M SM).
    - apply has_edge with b; apply has_turn, has_turn, H.
    - apply (closed M SM), has_edge with a, has_turn, H.
    - apply has_edge with v, H.
  Qed.

  Lemma visited_once : forall K a b v, (forall x y z, has K x y z -> has M x y z) ->
    has M a b v -> In (a, b) (edges K) -> has K a b v.
  Proof.
    intros K a b v I H J; apply edge_has in J; destruct J as [w J].
    rewrite (has_unique _ _ _ _ _ (once M SM) H (I _ _ _ J)); exact J.
  Qed.

  (** The triangle ahead has not been visited, none of its edges is run by a visited one. *)
  Lemma advance : forall K m a b st v, good M K m a b st -> has M a b v ->
    (forall x y z, has ((v, a, b) :: K) x y z -> has M x y z) /\
    NoDup (edges ((v, a, b) :: K)) /\
    (forall e, In e (runs (v, a, b)) -> ~ In e (edges K)) /\
    (forall x, In x (vertices ((v, a, b) :: K)) <-> x = v \/ In x m) /\
    (In (v, b) (edges K) -> In v m) /\ (In (a, v) (edges K) -> In v m).
  Proof.
    intros K m a b st v G H; destruct (face_distinct _ _ _ H) as (VA & VB & AB).
    assert (New : forall e, In e (runs (v, a, b)) -> ~ In e (edges K)).
    { assert (T1 := has_turn _ _ _ _ H); assert (T2 := has_turn _ _ _ _ T1).
      intros e [<-|[<-|[<-|[]]]] I; apply (ahead _ _ _ _ _ _ G); auto.
      - apply (visited_once K _ _ b (inside _ _ _ _ _ _ G)) in I; [|exact T2].
        apply has_edge with v, has_turn, I.
      - apply (visited_once K _ _ a (inside _ _ _ _ _ _ G)) in I; [|exact T1].
        apply has_edge with v, has_turn, has_turn, I. }
    assert (Ends : In a (vertices K) /\ In b (vertices K)).
    { destruct (edge_has _ _ _ (behind _ _ _ _ _ _ G)) as [w J].
      split; [apply has_vertex with w b, has_turn, J|apply has_vertex with a w, J]. }
    split; [|split; [|split; [exact New|split; [|split]]]].
    - intros x y z J; apply has_cons in J; destruct J as [J|J]; [|exact (inside _ _ _ _ _ _ G _ _ _ J)].
      assert (T1 := has_turn _ _ _ _ H); assert (T2 := has_turn _ _ _ _ T1).
      unfold has in J; cbn [In] in J; intuition congruence.
    - change (NoDup (runs (v, a, b) ++ edges K)); apply NoDup_app_join; auto using (fresh _ _ _ _ _ _ G).
      cbn [runs]; repeat constructor; cbn [In]; intuition congruence.
    - intros x; change (vertices ((v, a, b) :: K)) with ([v; a; b] ++ vertices K).
      rewrite in_app_iff, (marks _ _ _ _ _ _ G); cbn [In]; intuition (subst; auto).
    - intros I; apply (marks _ _ _ _ _ _ G); apply edge_has in I; destruct I as [w I].
      apply has_vertex with b w, I.
    - intros I; apply (marks _ _ _ _ _ _ G); apply edge_has in I; destruct I as [w I].
      apply has_vertex with w a, has_turn, I.
  Qed.

  (** One step keeps the good: next gate by the right or the left edge, or from the stack. *)
  Lemma good_right : forall K m m' a b st st' v, good M K m a b st -> has M a b v ->
    ~ In (v, b) (edges K) -> (forall x, In x m' <-> x = v \/ In x m) ->
    (forall x y, In (x, y) st' -> In (x, y) st \/ (x, y) = (a, v)) ->
    good M ((v, a, b) :: K) m' v b st'.
  Proof.
    intros K m m' a b st st' v G H Op Mk St; destruct (face_distinct _ _ _ H) as (VA & VB & AB).
    destruct (advance _ _ _ _ _ _ G H) as (A1 & A2 & A3 & A4 & _).
    change (edges ((v, a, b) :: K)) with (runs (v, a, b) ++ edges K) in *.
    constructor; auto.
    - intros x; rewrite A4; apply Mk.
    - apply in_app_iff; left; cbn; auto.
    - intros I; apply in_app_iff in I; destruct I as [I|I]; [|contradiction].
      cbn in I; intuition congruence.
    - intros x y I; apply in_app_iff; destruct (St _ _ I) as [J|J].
      + right; apply (waiting _ _ _ _ _ _ G), J.
      + injection J as -> ->; left; cbn; auto.
  Qed.

  Lemma good_left : forall K m a b st v, good M K m a b st -> has M a b v ->
    ~ In (a, v) (edges K) -> In v m -> good M ((v, a, b) :: K) m a v st.
  Proof.
    intros K m a b st v G H Op Mk; destruct (face_distinct _ _ _ H) as (VA & VB & AB).
    destruct (advance _ _ _ _ _ _ G H) as (A1 & A2 & A3 & A4 & _).
    change (edges ((v, a, b) :: K)) with (runs (v, a, b) ++ edges K) in *.
    constructor; auto.
    - intros x; rewrite A4; intuition (subst; auto).
    - apply in_app_iff; left; cbn; auto.
    - intros I; apply in_app_iff in I; destruct I as [I|I]; [|contradiction].
      cbn in I; intuition congruence.
    - intros x y I; apply in_app_iff; right; apply (waiting _ _ _ _ _ _ G), I.
  Qed.

  Lemma good_popped : forall K m a b passed a' b' rest v,
    good M K m a b (passed ++ (a', b') :: rest) -> has M a b v ->
    ~ In (a', b') (edges ((v, a, b) :: K)) -> In v m -> good M ((v, a, b) :: K) m a' b' rest.
  Proof.
    intros K m a b passed a' b' rest v G H Op Mk.
    destruct (advance _ _ _ _ _ _ G H) as (A1 & A2 & A3 & A4 & _).
    assert (W : forall x y, In (x, y) ((a', b') :: rest) -> In (y, x) (edges ((v, a, b) :: K))).
    { intros x y I; change (edges ((v, a, b) :: K)) with (runs (v, a, b) ++ edges K).
      apply in_app_iff; right; apply (waiting _ _ _ _ _ _ G), in_app_iff; right; exact I. }
    constructor; auto.
    - intros x; rewrite A4; intuition (subst; auto).
    - apply W; left; reflexivity.
    - intros x y I; apply W; right; exact I.
  Qed.

  Lemma visited_bounded : forall K, (forall x y z, has K x y z -> has M x y z) ->
    NoDup (edges K) -> length K <= length M.
  Proof.
    intros K I N; assert (J : incl (edges K) (edges M)).
    { intros [x y] J; apply edge_has in J; destruct J as [z J]; apply has_edge with z, I, J. }
    apply (NoDup_incl_length N) in J; rewrite !length_edges in J; lia.
  Qed.

  Theorem Walk_ends : forall n K m a b st, length M < n + length K -> good M K m a b st ->
    exists tr p, Walk M K m a b st tr p.
  Proof.
    induction n as [|n IH]; intros K m a b st Le G.
    { pose proof (visited_bounded _ (inside _ _ _ _ _ _ G) (fresh _ _ _ _ _ _ G)); lia. }
    destruct (face_ahead _ _ _ _ _ G) as [v H]; destruct (face_distinct _ _ _ H) as (VA & VB & AB).
    destruct (advance _ _ _ _ _ _ G H) as (A1 & A2 & A3 & A4 & A5 & A6).
    assert (Le' : length M < n + length ((v, a, b) :: K)) by (cbn [length]; lia).
    destruct (in_dec Nat.eq_dec v m) as [V|V].
    - destruct (in_dec edge_eq_dec (v, b) (edges K)) as [X|X], (in_dec edge_eq_dec (a, v) (edges K)) as [Y|Y].
      + destruct (pop ((v, a, b) :: K) st) as [passed [[[a' b'] rest]|]] eqn:P; apply pop_spec in P.
        * destruct P as (P & -> & Q).
          destruct (IH _ _ _ _ _ Le' (good_popped _ _ _ _ _ _ _ _ _ G H Q V)) as (tr & p & W).
          eexists; eexists; apply Walk_E; eauto.
        * destruct P as (P & ->); eexists; eexists; apply Walk_end; eauto.
      + destruct (IH _ _ _ _ _ Le' (good_left _ _ _ _ _ _ G H Y V)) as (tr & p & W).
        eexists; eexists; apply Walk_R; eauto.
      + destruct (IH ((v, a, b) :: K) m v b st Le') as (tr & p & W).
        { apply good_right with m st; auto; intros x; intuition (subst; auto). }
        eexists; eexists; apply Walk_L; eauto.
      + destruct (IH ((v, a, b) :: K) m v b ((a, v) :: st) Le') as (tr & p & W).
        { apply good_right with m st; auto; [intros x; intuition (subst; auto)|].
          intros x y [I|I]; auto. }
        eexists; eexists; apply Walk_S; eauto.
    - destruct (IH ((v, a, b) :: K) (v :: m) v b st Le') as (tr & p & W).
      { apply good_right with m st; auto; cbn; intuition auto. }
      eexists; eexists; apply Walk_C; eauto.
  Qed.

  (** The start: P is visited, and the gate lies across the edge from its second to its third vertex. *)
  Lemma good_start : forall x y z rest, M = (x, y, z) :: rest -> good M [(x, y, z)] [x; y; z] z y [].
  Proof.
    intros x y z rest sE.
    assert (H : has M x y z) by (rewrite sE; left; left; reflexivity).
    destruct (face_distinct _ _ _ H) as (D1 & D2 & D3).
    assert (T1 := has_turn _ _ _ _ H); assert (T2 := has_turn _ _ _ _ T1).
    constructor.
    - intros p q r J; unfold has in J; cbn [In] in J; intuition congruence.
    - cbn; repeat constructor; cbn [In]; intuition congruence.
    - intros p; cbn; tauto.
    - cbn; auto.
    - cbn; intuition congruence.
    - intros p q [].
  Qed.
End Surface.
