(** Sides of the triangles of a walk, and the edges of the mesh that they run.

    EB-GATE-1, EB-HANDLE-4: a side is a step and a place, at the gate, right or left; [edge_at] says
    which edge of the mesh it runs, one for each side ([phi_once], [phi_inj]). [items] is what the
    machine of [Reversi] is told of a walk: the symbols, and at each S the side that closes its left
    edge otherwise than as a gate. [trail] is a walk along edges. *)
Require Import List Arith Lia Permutation.
Require Import Clers.Letters Clers.Meshes Clers.Discs Clers.Traversal Clers.Undoing Clers.Reversi.
Import ListNotations.
Open Scope nat_scope.

(** The edge that a triangle (apex, left end, right end) runs at a place. *)
Definition edge_of (f : face) (p : place) : edge :=
  let '(v, a, b) := f in
  match p with at_gate => (a, b) | at_right => (b, v) | at_left => (v, a) end.

Fixpoint edge_at (T : list step) (s : side) : edge :=
  match T with
  | [] => (0, 0)
  | (_, f) :: T => if fst s =? length T then edge_of f (snd s) else edge_at T s
  end.

(** The sides of the steps, where k symbols come after them. *)
Definition three_sides (n : nat) : list side := [(n, at_gate); (n, at_right); (n, at_left)].
Fixpoint sides (k : nat) (tr : list step) : list side :=
  match tr with [] => [] | _ :: tr => three_sides (k + length tr) ++ sides k tr end.

(** The side, not at a gate, that runs an edge: EB-HANDLE-4. *)
Fixpoint closing (e : edge) (tr : list step) : option side :=
  match tr with
  | [] => None
  | (_, (v, a, b)) :: tr =>
      if edge_eq_dec e (b, v) then Some (length tr, at_right)
      else if edge_eq_dec e (v, a) then Some (length tr, at_left)
      else closing e tr
  end.

(** What the decoder is told: the symbols, and at each S the side that closes its left edge, if that
    is not a gate. *)
Fixpoint items (tr : list step) : list (symbol * option side) :=
  match tr with
  | [] => []
  | (sS, (v, a, b)) :: tr => (sS, closing (a, v) tr) :: items tr
  | (s, _) :: tr => (s, None) :: items tr
  end.

Lemma items_length : forall tr, length (items tr) = length tr.
Proof. induction tr as [|[[] [[v a] b]] tr IH]; cbn [items length]; congruence. Qed.

Lemma sides_app : forall k tr1 tr2, sides k (tr1 ++ tr2) = sides (k + length tr2) tr1 ++ sides k tr2.
Proof.
  induction tr1 as [|x tr1 IH]; intros tr2; [reflexivity|].
  cbn [app sides]; rewrite IH, app_length, <- app_assoc.
  replace (k + (length tr1 + length tr2)) with (k + length tr2 + length tr1) by lia; reflexivity.
Qed.

Definition both (pairs : list (side * side)) : list side := flat_map (fun p => [fst p; snd p]) pairs.

Lemma both_app : forall l m, both (l ++ m) = both l ++ both m.
Proof. intros; apply flat_map_app. Qed.

Lemma concat_app' : forall l m : list (list side), concat (l ++ m) = concat l ++ concat m.
Proof. intros; apply concat_app. Qed.

(** Permutations of sides by counting. *)
Definition num_s (l : list side) (s : side) : nat := count_occ side_eq_dec l s.

Lemma num_s_cons : forall d l s, num_s (d :: l) s = num_s [d] s + num_s l s.
Proof. intros; unfold num_s; cbn [count_occ]; destruct (side_eq_dec d s); lia. Qed.

Lemma num_s_app : forall l m s, num_s (l ++ m) s = num_s l s + num_s m s.
Proof. intros; apply count_occ_app. Qed.

Lemma by_num_s : forall l m, Permutation l m <-> forall s, num_s l s = num_s m s.
Proof. intros; apply (Permutation_count_occ side_eq_dec). Qed.

Ltac permute_sides :=
  unfold three_sides in *; apply by_num_s; let s := fresh "s" in intros s;
  repeat match goal with P : Permutation (A := nat * place) _ _ |- _ =>
    pose proof (proj1 (by_num_s _ _) P s); clear P end;
  repeat (progress (rewrite ?both_app, ?concat_app', ?num_s_app in *;
                    cbn [app both concat flat_map fst snd three_sides] in *) ||
    match goal with
    | |- context [flat_map _ ?l] => change (flat_map _ l) with (both l)
    | H : context [flat_map _ ?l] |- _ => change (flat_map _ l) with (both l) in H
    | |- context [num_s (?d :: ?l) s] =>
        lazymatch l with [] => fail | _ => rewrite (num_s_cons d l s) end
    | H : context [num_s (?d :: ?l) s] |- _ =>
        lazymatch l with [] => fail | _ => rewrite (num_s_cons d l s) in H end
    end);
  change (num_s [] s) with 0 in *; lia.

(** A walk along edges, each beginning where the one before ends. *)
Fixpoint trail (l : list edge) (x y : nat) : Prop :=
  match l with [] => x = y | e :: l => fst e = x /\ trail l (snd e) y end.

Lemma trail_app : forall l m x y, trail (l ++ m) x y <-> exists z, trail l x z /\ trail m z y.
Proof.
  induction l as [|e l IH]; intros m x y; cbn [app trail].
  - split; [intros H; exists x; auto|intros (z & -> & H); exact H].
  - rewrite IH; split; [intros (A & z & B & D); eauto|intros (z & (A & B) & D); eauto].
Qed.

Lemma edge_at_here : forall pre s f tr p, edge_at (pre ++ (s, f) :: tr) (length tr, p) = edge_of f p.
Proof.
  intros pre s f tr p; induction pre as [|[s' f'] pre IH]; cbn [app edge_at fst snd].
  - rewrite Nat.eqb_refl; reflexivity.
  - destruct (length tr =? length (pre ++ (s, f) :: tr)) eqn:E0; [|exact IH].
    apply Nat.eqb_eq in E0; rewrite app_length in E0; cbn [length] in E0; lia.
Qed.

Lemma closing_none : forall tr e, closing e tr = None ->
  forall x v a b, In (x, (v, a, b)) tr -> e <> (b, v) /\ e <> (v, a).
Proof.
  induction tr as [|[x [[v a] b]] tr IH]; intros e H y w c d I; [destruct I|]; cbn [closing] in H.
  destruct (edge_eq_dec e (b, v)) as [E1|D1]; [discriminate|].
  destruct (edge_eq_dec e (v, a)) as [E2|D2]; [discriminate|].
  destruct I as [I|I]; [injection I as <- <- <- <-; auto|exact (IH e H _ _ _ _ I)].
Qed.

Lemma edge_in_trace : forall (tr : list step) e, In e (edges (map snd tr)) ->
  exists x v a b, In (x, (v, a, b)) tr /\ (e = (v, a) \/ e = (a, b) \/ e = (b, v)).
Proof.
  intros tr e I; apply in_flat_map in I; destruct I as ([[v a] b] & I & J).
  apply in_map_iff in I; destruct I as ([x f] & E0 & I); cbn in E0; subst f.
  exists x, v, a, b; split; [exact I|]; cbn in J; intuition auto.
Qed.

Section Trace.
  (** The whole trace, P before it as a step. *)
  Variable T : list step.
  Hypothesis NT : NoDup (edges (map snd T)).
  Let phi := edge_at T.

  Lemma phi_here : forall pre s f tr p, T = pre ++ (s, f) :: tr ->
    phi (length tr, p) = edge_of f p.
  Proof. intros; unfold phi; subst T; apply edge_at_here. Qed.

  Lemma phi_sides : forall tr1 pre tr2, T = pre ++ tr1 ++ tr2 ->
    Permutation (map phi (sides (length tr2) tr1)) (edges (map snd tr1)).
  Proof.
    induction tr1 as [|[s [[v a] b]] tr1 IH]; intros pre tr2 E0; [reflexivity|].
    cbn [sides three_sides map app].
    assert (H := fun p => phi_here pre s (v, a, b) (tr1 ++ tr2) p E0).
    rewrite app_length in H; rewrite (Nat.add_comm (length tr2)), !H.
    specialize (IH (pre ++ [(s, (v, a, b))]) tr2); rewrite <- app_assoc in IH; specialize (IH E0).
    cbn [edge_of snd]; change (edges ((v, a, b) :: map snd tr1))
      with ((v, a) :: (a, b) :: (b, v) :: edges (map snd tr1)); permute.
  Qed.

  Lemma phi_once : NoDup (map phi (sides 0 T)).
  Proof.
    assert (P := phi_sides T [] [] (eq_sym (app_nil_r T))).
    exact (Permutation_NoDup (Permutation_sym P) NT).
  Qed.

  Lemma sides_once : NoDup (sides 0 T).
  Proof. exact (NoDup_map_inv _ _ phi_once). Qed.

  Lemma phi_inj : forall s r, In s (sides 0 T) -> In r (sides 0 T) -> phi s = phi r -> s = r.
  Proof.
    assert (A : forall l, NoDup (map phi l) -> forall s r, In s l -> In r l -> phi s = phi r -> s = r).
    { induction l as [|x l IH]; cbn [map]; intros N s r I J E0; [destruct I|].
      apply NoDup_cons_iff in N; destruct N as [N1 N2].
      destruct I as [<-|I], J as [<-|J]; auto; destruct N1.
      - rewrite E0; apply in_map, J.
      - rewrite <- E0; apply in_map, I. }
    intros s r; apply A, phi_once.
  Qed.

  Lemma sides_in : forall pre tr1 tr2 s, T = pre ++ tr1 ++ tr2 -> In s (sides (length tr2) tr1) ->
    In s (sides 0 T) /\ In (phi s) (edges (map snd tr1)).
  Proof.
    intros pre tr1 tr2 s E0 I; split.
    - rewrite E0, app_assoc, sides_app, sides_app; apply in_app_iff; left; apply in_app_iff; right; exact I.
    - apply (Permutation_in _ (phi_sides _ _ _ E0)), in_map, I.
  Qed.

  (** What comes later runs no edge that was visited. *)
  Lemma later : forall pre tr e, T = pre ++ tr -> In e (edges (map snd tr)) ->
    ~ In e (edges (rev (map snd pre))).
  Proof.
    intros pre tr e E0 I J; assert (N := NT); rewrite E0, map_app, edges_app in N.
    apply NoDup_app_split in N; destruct N as (_ & _ & N); apply (N e); [|exact I].
    apply (Permutation_in _ (edges_perm _ _ (Permutation_sym (Permutation_rev (map snd pre))))), J.
  Qed.

  Lemma closing_some : forall tr pre e s, T = pre ++ tr -> closing e tr = Some s ->
    phi s = e /\ In s (sides 0 tr) /\ snd s <> at_gate.
  Proof.
    induction tr as [|[x [[v a] b]] tr IH]; intros pre e s E0 H; [discriminate|]; cbn [closing] in H.
    assert (Ph := fun p => phi_here pre x (v, a, b) tr p E0); cbn [edge_of] in Ph.
    destruct (edge_eq_dec e (b, v)) as [->|D1]; [|destruct (edge_eq_dec e (v, a)) as [->|D2]].
    - injection H as <-; rewrite Ph; repeat split; [right; left; reflexivity|discriminate].
    - injection H as <-; rewrite Ph; repeat split; [do 2 right; left; reflexivity|discriminate].
    - specialize (IH (pre ++ [(x, (v, a, b))]) e s); rewrite <- app_assoc in IH.
      destruct (IH E0 H) as (A & B & D); repeat split; auto; cbn [sides]; apply in_app_iff; auto.
  Qed.
End Trace.
