(** * Worked examples: the theorems about surfaces speak of something

    Clauses: EB-DECODE's examples of section 5.7: the tetrahedron, the annulus and the torus of the
    tutorial's Figure 22 are surfaces in the sense of [Surface], and the walk of [Walk] writes the
    words and the kinds of records that the specification prints. *)

Require Import ZArith List Lia Arith Bool Permutation.
From Clers Require Import Letters Surface Edges Walk Walks Counting.
Import ListNotations.
Open Scope nat_scope.

(** ** From face lists *)

Definition triple : Type := (nat * nat * nat)%type.
Definition at_place (t : triple) (k : place) : nat :=
  let '(a, b, c) := t in match k with p0 => a | p1 => b | p2 => c end.
Definition vertex_of (l : list triple) (c : corner) : nat :=
  at_place (nth (fst c) l (0, 0, 0)) (snd c).

(** The corner across: the one whose edge is run the other way. *)
Definition across_of (l : list triple) (c : corner) : option corner :=
  find (fun d => (vertex_of l (next d) =? vertex_of l (prev c))
                 && (vertex_of l (prev d) =? vertex_of l (next c)))
    (corners (seq 0 (length l))).

Definition of_faces (l : list triple) (n : nat) (cs : list (list nat)) : table :=
  let label v := find (fun j => mem v (nth j cs [])) (seq 0 (length cs)) in
  Build_table (length l) n (vertex_of l) (across_of l) label (seq 0 (length cs)).

(** ** Deciding that a table is a surface *)

Definition all (M : table) (p : corner -> bool) : bool := forallb p (all_corners M).
Definition option_is (o : option corner) (c : corner) : bool :=
  match o with Some d => corner_eqb d c | None => false end.

Definition check_opposite (M : table) (c : corner) : bool :=
  match opposite M c with
  | None =>
      match curve M (vertex M (next c)), curve M (vertex M (prev c)) with
      | Some j, Some k => j =? k
      | _, _ => false
      end
  | Some d =>
      (face d <? triangles M) && option_is (opposite M d) c && negb (face c =? face d)
      && (vertex M (next d) =? vertex M (prev c)) && (vertex M (prev d) =? vertex M (next c))
  end.

Definition check_simple (M : table) : bool :=
  forallb (fun f => forallb (fun g => (f =? g)
    || negb (forallb (fun c => existsb (fun d => vertex M c =? vertex M d) (at_face g)) (at_face
      f)))
    (seq 0 (triangles M))) (seq 0 (triangles M)).

Fixpoint nodupb (l : list nat) : bool :=
  match l with [] => true | x :: t => negb (mem x t) && nodupb t end.
Definition subset (l m : list nat) : bool := forallb (fun x => mem x m) l.

(** The faces that a walk from the given ones comes to, n edges far. *)
Fixpoint spread (M : table) (n : nat) (l : list nat) : list nat :=
  match n with
  | 0 => l
  | S k => spread M k (nodup Nat.eq_dec
      (l ++ flat_map (fun c => match opposite M c with Some d => [face d] | None => [] end)
        (corners l)))
  end.

Definition starts_of (M : table) : list nat := map (fun c => vertex M (next c)) (border_corners M).
Definition on_curves (M : table) : list nat :=
  filter (fun v => negb (inner_vertex M v)) (seq 0 (vertices M)).

Definition check (M : table) : bool :=
  all M (check_opposite M)
  && all M (fun c => negb (vertex M c =? vertex M (next c)))
  && check_simple M
  && all M (fun c => vertex M c <? vertices M)
  && forallb (fun v => existsb (fun c => vertex M c =? v) (all_corners M)) (seq 0 (vertices M))
  && (nodupb (starts_of M) && subset (starts_of M) (on_curves M) && subset (on_curves M) (starts_of
    M))
  && nodupb (curves M)
  && forallb (fun k => existsb (fun v => match curve M v with Some j => j =? k | None => false end)
       (seq 0 (vertices M))) (curves M)
  && forallb (fun v => match curve M v with Some j => mem j (curves M) | None => true end)
       (seq 0 (vertices M))
  && forallb (fun f => subset (seq 0 (triangles M)) (spread M (triangles M) [f])) (seq 0 (triangles
    M)).

Lemma all_true : forall M p, all M p = true -> forall c, face c < triangles M -> p c = true.
Proof.
  intros M p H c F; unfold all in H; rewrite forallb_forall in H; apply H.
  apply in_corners, in_seq; lia.
Qed.

Lemma nodupb_true : forall l, nodupb l = true -> NoDup l.
Proof.
  induction l as [|x l IH]; cbn; intros H; constructor; apply andb_true_iff in H;
    destruct H as [A B]; auto.
  apply negb_true_iff, mem_false in A; auto.
Qed.

Lemma subset_true : forall l m, subset l m = true -> incl l m.
Proof. unfold subset; intros l m H x X; rewrite forallb_forall in H; apply mem_true, H, X. Qed.

Lemma spread_joined : forall M n f l, f < triangles M ->
  (forall g, In g l -> g < triangles M /\ joined M f g) ->
  (forall c d, face c < triangles M -> opposite M c = Some d -> face d < triangles M) ->
  forall g, In g (spread M n l) -> joined M f g.
Proof.
  intros M; induction n as [|n IH]; intros f l F H O g I; [apply H; exact I|].
  cbn [spread] in I; refine (IH f _ F _ O g I); clear g I; intros g I.
  apply nodup_In, in_app_iff in I; destruct I as [I|I]; [auto|].
  apply in_flat_map in I; destruct I as [c [C I]]; apply in_corners in C;
    destruct (H _ C) as [FC JC].
  destruct (opposite M c) as [d|] eqn:E; [|destruct I]; destruct I as [<-|[]].
  split; [eauto|eapply across; eauto].
Qed.

Theorem check_surface : forall M, check M = true -> surface M.
Proof.
  intros M H; unfold check in H; rewrite !andb_true_iff in H.
  destruct H as (((((((((A & B) & C) & D) & E) & ((F1 & F2) & F3)) & G) & I) & J) & K).
  assert (OS : forall c, face c < triangles M -> check_opposite M c = true) by (apply all_true;
    auto).
  constructor.
  - intros c d FC O; specialize (OS c FC); unfold check_opposite in OS; rewrite O in OS.
    rewrite !andb_true_iff, negb_true_iff, !Nat.eqb_eq, Nat.eqb_neq, Nat.ltb_lt in OS.
    destruct OS as ((((P & Q) & R) & S) & T); repeat split; auto.
    unfold option_is in Q; destruct (opposite M d) as [e|]; [|discriminate].
    apply corner_eqb_eq in Q; subst; auto.
  - intros c FC E'; apply (all_true _ _ B c) in FC; rewrite E', Nat.eqb_refl in FC; discriminate.
  - intros f g Ff Fg S; unfold check_simple in C; rewrite forallb_forall in C.
    specialize (C f ltac:(apply in_seq; lia)); rewrite forallb_forall in C.
    specialize (C g ltac:(apply in_seq; lia)); apply orb_true_iff in C; destruct C as [C|C].
    + apply Nat.eqb_eq; auto.
    + exfalso; apply negb_true_iff, not_true_iff_false in C; apply C, forallb_forall.
      intros [u k] X; assert (u = f) as -> by (cbn in X; intuition congruence).
      destruct (S k) as [j Z]; apply existsb_exists; exists (g, j); split.
      * destruct j; cbn; auto.
      * apply Nat.eqb_eq; auto.
  - intros c FC; apply (all_true _ _ D c) in FC; apply Nat.ltb_lt; auto.
  - intros v V; rewrite forallb_forall in E; specialize (E v ltac:(apply in_seq; lia)).
    apply existsb_exists in E; destruct E as [c [X Y]]; apply in_corners, in_seq in X.
    apply Nat.eqb_eq in Y; exists c; split; auto; lia.
  - intros c FC O; specialize (OS c FC); unfold check_opposite in OS; rewrite O in OS.
    destruct (curve M (vertex M (next c))) as [j|], (curve M (vertex M (prev c))) as [k|];
      try discriminate; apply Nat.eqb_eq in OS; subst; eauto.
  - apply NoDup_Permutation; [apply nodupb_true; auto|apply NoDup_filter, seq_NoDup|].
    intros v; split; apply subset_true; auto.
  - apply nodupb_true; auto.
  - intros k; split; intros X.
    + rewrite forallb_forall in I; specialize (I k X); apply existsb_exists in I.
      destruct I as [v [V Y]]; apply in_seq in V; exists v; split; [lia|].
      destruct (curve M v); [|discriminate]; apply Nat.eqb_eq in Y; congruence.
    + destruct X as [v [V Y]]; rewrite forallb_forall in J; specialize (J v ltac:(apply in_seq;
        lia)).
      rewrite Y in J; apply mem_true; auto.
  - intros f g Ff Fg; rewrite forallb_forall in K; specialize (K f ltac:(apply in_seq; lia)).
    apply subset_true in K; apply (spread_joined M (triangles M) f [f]); auto.
    + intros x [<-|[]]; split; auto; constructor.
    + intros c d FC O; specialize (OS c FC); unfold check_opposite in OS; rewrite O in OS.
      rewrite !andb_true_iff in OS; apply Nat.ltb_lt; tauto.
    + apply K, in_seq; lia.
Qed.

(** ** Three surfaces *)

Definition tetrahedron : table := of_faces [(0,1,2); (0,3,1); (1,3,2); (0,2,3)] 4 [].
Definition annulus : table :=
  of_faces [(2,5,4); (1,2,0); (3,0,2); (2,4,3); (0,5,1); (0,4,5)] 6 [[2; 5; 1]; [4; 3; 0]].
(** A square of the torus at row i and column j, cut in two. *)
Definition square (i j : nat) : list triple :=
  let i' := if i =? 2 then 0 else S i in
  let j' := if j =? 2 then 0 else S j in
  [(3*i+j, 3*i'+j, 3*i'+j'); (3*i+j, 3*i'+j', 3*i+j')].
Definition torus : table :=
  of_faces (flat_map (fun i => flat_map (square i) [0; 1; 2]) [0; 1; 2]) 9 [].

Theorem three_surfaces : surface tetrahedron /\ surface annulus /\ surface torus.
Proof. split; [|split]; apply check_surface; vm_compute; reflexivity. Qed.

Theorem their_genus : has_genus tetrahedron 0 /\ has_genus annulus 0 /\ has_genus torus 1.
Proof. repeat split; vm_compute; reflexivity. Qed.

Definition whole_walk (M : table) (s : state) : list symbol * list bool :=
  let e := run M (triangles M) s in (rev (word e), records e).

(** Section 5.7: CRE; SLRRLE with a record of the kind boundary; CCCCRCSCRSSRLSEEE with two of the
    kind handle. The annulus begins at corner 2, the first one with an edge on a curve. *)
Theorem their_words :
  whole_walk tetrahedron (begin_closed tetrahedron 0) = ([sC; sR; sE], [])
  /\ whole_walk annulus (begin_border annulus (0, p2)) = ([sS; sL; sR; sR; sL; sE], [true])
  /\ whole_walk torus (begin_closed torus 0)
     = ([sC; sC; sC; sC; sR; sC; sS; sC; sR; sS; sS; sR; sL; sS; sE; sE; sE], [false; false]).
Proof. repeat split; vm_compute; reflexivity. Qed.
