(** The round trip of closed surfaces with handles: what Spirale Reversi holds.

    EB-REVERSI-1, EB-REVERSI-2, EB-HANDLE-1, EB-HANDLE-4 for one connected closed surface of any
    genus. Behind each gate of the stack that is not passed over there is a [branch]. Its loop is a
    closed walk of the mesh, so are the loops beside it; their edges were all closed, on the other
    side, before the gate was entered. [walk_is_grove]: undoing a step keeps that, the machine never
    fails, and each side leaves a loop when it is glued to the side that it is glued to in the mesh.
    Nothing about genus or curves is used. *)
Require Import List Arith Lia Permutation.
Require Import Clers.Letters Clers.Meshes Clers.Discs Clers.Traversal Clers.Visited
  Clers.Records Clers.Undoing Clers.Reversi Clers.Sides.
Import ListNotations.
Open Scope nat_scope.

Section Surface.
  Variable M : list face.
  Hypothesis SM : surface M.

  (** The whole trace, P before it as a step. *)
  Variable T : list step.
  Hypothesis NT : NoDup (edges (map snd T)).
  Let phi := edge_at T.
  Let here : forall pre s f tr p, T = pre ++ (s, f) :: tr -> phi (length tr, p) = edge_of f p
    := phi_here T NT.
  Let inj : forall s r, In s (sides 0 T) -> In r (sides 0 T) -> phi s = phi r -> s = r
    := phi_inj T NT.
  Let run_by : forall tr1 pre tr2, T = pre ++ tr1 ++ tr2 ->
    Permutation (map phi (sides (length tr2) tr1)) (edges (map snd tr1)) := phi_sides T NT.
  Let side_in : forall pre tr1 tr2 s, T = pre ++ tr1 ++ tr2 -> In s (sides (length tr2) tr1) ->
    In s (sides 0 T) /\ In (phi s) (edges (map snd tr1)) := sides_in T NT.
  Let closed_at : forall tr pre e s, T = pre ++ tr -> closing e tr = Some s ->
    phi s = e /\ In s (sides 0 tr) /\ snd s <> at_gate := closing_some T NT.

  (** What was visited from one gate on, and its loops, where k symbols come after. *)
  Record branch (K : list face) (a b : nat) (tr : list step) (k : nat)
    (g : side) (X : list side) (Z : list (list side)) (G : list (side * side)) : Prop := {
    gate_edge : phi g = (a, b);
    gate_place : snd g = at_gate;
    loop_closes : trail (map phi X) b a;
    others_close : forall z, In z Z -> exists c, trail (map phi z) c c;
    closed_before : forall s, In s (X ++ concat Z) -> In (flip (phi s)) (edges K);
    each_once : Permutation (sides k tr) (g :: X ++ concat Z ++ both G);
    rightly : forall s r, In (s, r) G -> phi r = flip (phi s);
    gates_inside : forall x v a' b', In (x, (v, a', b')) tr ->
      (a', b') = (a, b) \/ In (b', a') (edges (map snd tr)) }.

  Inductive grove : list face -> list edge -> list step -> state -> Prop :=
  | grove_nil : forall K, grove K [] [] (State [] [] [])
  | grove_pass : forall K e st tr m, In e (edges K) -> grove K st tr m -> grove K (e :: st) tr m
  | grove_cons : forall K a b st tr1 tr2 g X Z G m,
      branch K a b tr1 (length tr2) g X Z G -> grove (after tr1 K) st tr2 m ->
      grove K ((a, b) :: st) (tr1 ++ tr2) (State ((g :: X) :: stack m) (Z ++ beside m) (G ++ glued m)).

  Lemma branch_in : forall K a b tr1 tr2 g X Z G pre s, T = pre ++ tr1 ++ tr2 ->
    branch K a b tr1 (length tr2) g X Z G -> In s (g :: X ++ concat Z ++ both G) ->
    In s (sides 0 T) /\ In (phi s) (edges (map snd tr1)).
  Proof.
    intros K a b tr1 tr2 g X Z G pre s E0 B I; apply (side_in pre tr1 tr2 s E0).
    apply (Permutation_in _ (Permutation_sym (each_once _ _ _ _ _ _ _ _ _ B))), I.
  Qed.

  Lemma branch_once : forall K a b tr1 tr2 g X Z G pre, T = pre ++ tr1 ++ tr2 ->
    branch K a b tr1 (length tr2) g X Z G -> NoDup (g :: X ++ concat Z ++ both G).
  Proof.
    intros K a b tr1 tr2 g X Z G pre E0 B; apply (Permutation_NoDup (each_once _ _ _ _ _ _ _ _ _ B)).
    assert (N := (sides_once T NT)); rewrite E0, app_assoc, sides_app, sides_app in N.
    apply NoDup_app_split in N; destruct N as (N & _); apply NoDup_app_split in N; cbn [Nat.add] in N; tauto.
  Qed.

  (** What is glued in a branch is glued to something in it. *)
  Lemma partner : forall K a b tr k g X Z G q, branch K a b tr k g X Z G -> In q (both G) ->
    exists r, In r (both G) /\ phi r = flip (phi q).
  Proof.
    intros K a b tr k g X Z G q B I; apply in_flat_map in I; destruct I as ([s r] & I & J).
    assert (R := rightly _ _ _ _ _ _ _ _ _ B s r I).
    cbn in J; destruct J as [<-|[<-|[]]].
    - exists r; split; [apply in_flat_map; exists (s, r); cbn; auto|exact R].
    - exists s; split; [apply in_flat_map; exists (s, r); cbn; auto|rewrite R, flip_flip; reflexivity].
  Qed.

  Lemma branch_cover : forall K a b tr1 tr2 g X Z G pre e, T = pre ++ tr1 ++ tr2 ->
    branch K a b tr1 (length tr2) g X Z G -> In e (edges (map snd tr1)) ->
    exists s, In s (g :: X ++ concat Z ++ both G) /\ phi s = e.
  Proof.
    intros K a b tr1 tr2 g X Z G pre e E0 B I.
    apply (Permutation_in _ (Permutation_sym (run_by _ _ _ E0))), in_map_iff in I.
    destruct I as (s & P & I); exists s; split; [|exact P].
    apply (Permutation_in _ (each_once _ _ _ _ _ _ _ _ _ B)), I.
  Qed.

  (** Loops that stay, when the triangle (v, a, b) is undone: they were closed before it. *)
  Lemma stay : forall pre x v a b tr s, T = pre ++ (x, (v, a, b)) :: tr ->
    In (flip (phi s)) (edges ((v, a, b) :: rev (map snd pre))) ->
    phi s <> (a, v) -> phi s <> (b, a) -> phi s <> (v, b) ->
    In (flip (phi s)) (edges (rev (map snd pre))).
  Proof.
    intros pre x v a b tr s E0 I A B D; destruct (phi s) as [p q].
    exact (settle v a b _ p q I A B D).
  Qed.

  Theorem walk_is_grove : forall K m a b st tr p, Walk M K m a b st tr p -> good M K m a b st ->
    forall pre, T = pre ++ tr -> K = rev (map snd pre) ->
    exists s, grove K ((a, b) :: st) tr s /\ undo (items tr) = Some s.
  Proof.
    assert (Next : forall pre (x : symbol) f tr, T = pre ++ (x, f) :: tr -> T = (pre ++ [(x, f)]) ++ tr)
      by (intros; rewrite <- app_assoc; assumption).
    assert (Rev : forall (pre : list step) (x : symbol) f, f :: rev (map snd pre) = rev (map snd (pre ++ [(x, f)])))
      by (intros; rewrite map_app, rev_app_distr; reflexivity).
    apply (walk_induction M SM (fun K m a b st tr p => forall pre, T = pre ++ tr -> K = rev (map snd pre) ->
      exists s, grove K ((a, b) :: st) tr s /\ undo (items tr) = Some s)).
    - (* C *)
      intros K m a b v st tr p Go H V G' IH pre E0 ->.
      destruct (IH _ (Next _ _ _ _ E0) (Rev _ _ _)) as (s & Gr & U).
      inversion Gr as [|K' e st' tr' m' J Gr'|K' a' b' st' tr1 tr2 g X Z G m' B Gr']; subst.
      { destruct (ahead _ _ _ _ _ _ G' J). }
      assert (E1 := Next _ _ _ _ E0).
      assert (In_B := fun r => branch_in _ _ _ _ _ _ _ _ _ _ r E1 B).
      assert (No := branch_once _ _ _ _ _ _ _ _ _ _ E1 B).
      assert (Lt := fun e => (later T NT) _ _ e E1); rewrite map_app, edges_app in Lt.
      assert (Ph := fun q => here pre sC (v, a, b) (tr1 ++ tr2) q E0); cbn [edge_of] in Ph.
      assert (BA := behind _ _ _ _ _ _ Go).
      destruct B as [B1 B2 B3 B4 B5 B6 B7 B8].
      assert (XE : X <> []).
      { intros ->; cbn in B3; destruct (face_distinct M SM _ _ _ H) as (VA & VB & AB); congruence. }
      destruct (exists_last XE) as (X' & f & ->).
      rewrite map_app in B3; apply trail_app in B3; destruct B3 as (z & B3 & B3'); cbn in B3'.
      destruct B3' as [F1 F2].
      assert (Ff : phi f = (a, v)).
      { assert (I := B5 f ltac:(apply in_app_iff; left; apply in_app_iff; right; left; reflexivity)).
        destruct (phi f) as [c d] eqn:Pf; cbn in F1, F2; subst c d.
        change (flip (z, v)) with (v, z) in I.
        destruct (face_distinct M SM _ _ _ H) as (VA & VB & AB).
        change (edges ((v, a, b) :: rev (map snd pre)))
          with ((v, a) :: (a, b) :: (b, v) :: edges (rev (map snd pre))) in I.
        destruct I as [I|[I|[I|I]]]; [congruence|congruence|congruence|].
        destruct V; apply (marks _ _ _ _ _ _ Go); apply edge_has in I; destruct I as [u I].
        apply has_vertex with z u, I. }
      rewrite Ff in F1; cbn in F1; subst z.
      set (n := length (tr1 ++ tr2)) in *.
      exists (State (((n, at_gate) :: X') :: stack m') (Z ++ beside m')
        (((n, at_right), g) :: ((n, at_left), f) :: G ++ glued m')); split.
      + change ((sC, (v, a, b)) :: tr1 ++ tr2) with (((sC, (v, a, b)) :: tr1) ++ tr2).
        change (((n, at_right), g) :: ((n, at_left), f) :: G ++ glued m')
          with ((((n, at_right), g) :: ((n, at_left), f) :: G) ++ glued m').
        apply grove_cons; [constructor|rewrite after_cons; exact Gr'].
        * apply Ph.
        * reflexivity.
        * exact B3.
        * exact B4.
        * intros r I; assert (I' : In r ((X' ++ [f]) ++ concat Z)).
          { rewrite ?in_app_iff in I; rewrite ?in_app_iff; tauto. }
          assert (IB : In r (g :: (X' ++ [f]) ++ concat Z ++ both G)).
          { right; rewrite ?in_app_iff in I; rewrite ?in_app_iff; tauto. }
          destruct (In_B r IB) as [R1 R2].
          apply (stay pre sC v a b (tr1 ++ tr2)); auto; intros E2.
          -- assert (r = f).
             { apply inj; auto; [|congruence].
               apply In_B; right; rewrite !in_app_iff; left; right; left; reflexivity. }
             subst r; clear - No I; apply NoDup_cons_iff in No; destruct No as [_ No].
             rewrite <- app_assoc in No; apply NoDup_app_split in No; destruct No as (_ & No & D).
             apply in_app_iff in I; destruct I as [I|I]; [apply (D f I); left; reflexivity|].
             cbn [app] in No; apply NoDup_cons_iff in No; destruct No as [No _]; apply No.
             apply in_app_iff; left; exact I.
          -- apply (Lt (b, a)); [rewrite <- E2; apply in_app_iff; left; exact R2|].
             rewrite map_app, rev_app_distr; do 3 right; exact BA.
          -- assert (r = g) by (apply inj; auto; [apply In_B; left; reflexivity|congruence]).
             subst r; apply NoDup_cons_iff in No; destruct No as [No _]; apply No.
             rewrite ?in_app_iff in I; rewrite ?in_app_iff; tauto.
        * cbn [sides]; rewrite (Nat.add_comm (length tr2)), <- app_length; fold n; permute_sides.
        * intros s r [I|[I|I]]; [injection I as <- <-|injection I as <- <-|apply B7; exact I];
            rewrite Ph; [exact B1|exact Ff].
        * intros x w c d [I|I]; [injection I as <- <- <- <-; left; reflexivity|right].
          destruct (B8 x w c d I) as [E2|I2].
          -- injection E2 as -> ->; right; right; left; reflexivity.
          -- do 3 right; exact I2.
      + cbn [items undo]; rewrite U, items_length; fold n; cbn [undo1 stack beside glued].
        rewrite rev_app_distr; cbn [rev app]; rewrite rev_involutive; reflexivity.
    - (* R *)
      intros K m a b v st tr p Go H V Xb Yb G' IH pre E0 ->.
      destruct (IH _ (Next _ _ _ _ E0) (Rev _ _ _)) as (s & Gr & U).
      inversion Gr as [|K' e st' tr' m' J Gr'|K' a' b' st' tr1 tr2 g X Z G m' B Gr']; subst.
      { destruct (ahead _ _ _ _ _ _ G' J). }
      assert (E1 := Next _ _ _ _ E0).
      assert (In_B := fun r => branch_in _ _ _ _ _ _ _ _ _ _ r E1 B).
      assert (No := branch_once _ _ _ _ _ _ _ _ _ _ E1 B).
      assert (Lt := fun e => (later T NT) _ _ e E1); rewrite map_app, edges_app in Lt.
      assert (Ph := fun q => here pre sR (v, a, b) (tr1 ++ tr2) q E0); cbn [edge_of] in Ph.
      assert (BA := behind _ _ _ _ _ _ Go).
      destruct B as [B1 B2 B3 B4 B5 B6 B7 B8].
      set (n := length (tr1 ++ tr2)) in *.
      exists (State (((n, at_gate) :: (n, at_right) :: X) :: stack m') (Z ++ beside m')
        (((n, at_left), g) :: G ++ glued m')); split.
      + change ((sR, (v, a, b)) :: tr1 ++ tr2) with (((sR, (v, a, b)) :: tr1) ++ tr2).
        change (((n, at_left), g) :: G ++ glued m') with ((((n, at_left), g) :: G) ++ glued m').
        apply grove_cons; [constructor|rewrite after_cons; exact Gr'].
        * apply Ph.
        * reflexivity.
        * cbn [map trail]; rewrite Ph; split; [reflexivity|exact B3].
        * exact B4.
        * intros r [<-|I]; [rewrite Ph; exact Xb|].
          assert (IB : In r (g :: X ++ concat Z ++ both G)) by (right; rewrite ?in_app_iff in I; rewrite ?in_app_iff; tauto).
          destruct (In_B r IB) as [R1 R2].
          apply (stay pre sR v a b (tr1 ++ tr2)); auto; intros E2.
          -- assert (r = g) by (apply inj; auto; [apply In_B; left; reflexivity|congruence]).
             subst r; apply NoDup_cons_iff in No; destruct No as [No _]; apply No.
             rewrite ?in_app_iff in I; rewrite ?in_app_iff; tauto.
          -- apply (Lt (b, a)); [rewrite <- E2; apply in_app_iff; left; exact R2|].
             rewrite map_app, rev_app_distr; do 3 right; exact BA.
          -- apply (Lt (v, b)); [rewrite <- E2; apply in_app_iff; left; exact R2|].
             rewrite map_app, rev_app_distr; do 3 right; exact Xb.
        * cbn [sides]; rewrite (Nat.add_comm (length tr2)), <- app_length; fold n; permute_sides.
        * intros s r [I|I]; [injection I as <- <-; rewrite Ph; exact B1|apply B7; exact I].
        * intros x w c d [I|I]; [injection I as <- <- <- <-; left; reflexivity|right].
          destruct (B8 x w c d I) as [E2|I2].
          -- injection E2 as -> ->; left; reflexivity.
          -- do 3 right; exact I2.
      + cbn [items undo]; rewrite U, items_length; reflexivity.
    - (* L *)
      intros K m a b v st tr p Go H V Xb Yb G' IH pre E0 ->.
      destruct (IH _ (Next _ _ _ _ E0) (Rev _ _ _)) as (s & Gr & U).
      inversion Gr as [|K' e st' tr' m' J Gr'|K' a' b' st' tr1 tr2 g X Z G m' B Gr']; subst.
      { destruct (ahead _ _ _ _ _ _ G' J). }
      assert (E1 := Next _ _ _ _ E0).
      assert (In_B := fun r => branch_in _ _ _ _ _ _ _ _ _ _ r E1 B).
      assert (No := branch_once _ _ _ _ _ _ _ _ _ _ E1 B).
      assert (Lt := fun e => (later T NT) _ _ e E1); rewrite map_app, edges_app in Lt.
      assert (Ph := fun q => here pre sL (v, a, b) (tr1 ++ tr2) q E0); cbn [edge_of] in Ph.
      assert (BA := behind _ _ _ _ _ _ Go).
      destruct B as [B1 B2 B3 B4 B5 B6 B7 B8].
      set (n := length (tr1 ++ tr2)) in *.
      exists (State (((n, at_gate) :: X ++ [(n, at_left)]) :: stack m') (Z ++ beside m')
        (((n, at_right), g) :: G ++ glued m')); split.
      + change ((sL, (v, a, b)) :: tr1 ++ tr2) with (((sL, (v, a, b)) :: tr1) ++ tr2).
        change (((n, at_right), g) :: G ++ glued m') with ((((n, at_right), g) :: G) ++ glued m').
        apply grove_cons; [constructor|rewrite after_cons; exact Gr'].
        * apply Ph.
        * reflexivity.
        * rewrite map_app; apply trail_app; exists v; split; [exact B3|].
          cbn [map trail]; rewrite Ph; split; reflexivity.
        * exact B4.
        * intros r I; assert (I' : r = (n, at_left) \/ In r (X ++ concat Z)).
          { rewrite ?in_app_iff in I; rewrite ?in_app_iff; cbn [In] in I; intuition auto. }
          destruct I' as [->|I']; [rewrite Ph; exact Yb|].
          assert (IB : In r (g :: X ++ concat Z ++ both G)) by (right; rewrite ?in_app_iff in I'; rewrite ?in_app_iff; tauto).
          destruct (In_B r IB) as [R1 R2].
          apply (stay pre sL v a b (tr1 ++ tr2)); auto; intros E2.
          -- apply (Lt (a, v)); [rewrite <- E2; apply in_app_iff; left; exact R2|].
             rewrite map_app, rev_app_distr; do 3 right; exact Yb.
          -- apply (Lt (b, a)); [rewrite <- E2; apply in_app_iff; left; exact R2|].
             rewrite map_app, rev_app_distr; do 3 right; exact BA.
          -- assert (r = g) by (apply inj; auto; [apply In_B; left; reflexivity|congruence]).
             subst r; apply NoDup_cons_iff in No; destruct No as [No _]; apply No.
             rewrite ?in_app_iff in I'; rewrite ?in_app_iff; tauto.
        * cbn [sides]; rewrite (Nat.add_comm (length tr2)), <- app_length; fold n; permute_sides.
        * intros s r [I|I]; [injection I as <- <-; rewrite Ph; exact B1|apply B7; exact I].
        * intros x w c d [I|I]; [injection I as <- <- <- <-; left; reflexivity|right].
          destruct (B8 x w c d I) as [E2|I2].
          -- injection E2 as -> ->; right; right; left; reflexivity.
          -- do 3 right; exact I2.
      + cbn [items undo]; rewrite U, items_length; reflexivity.
    - (* S *)
      intros K m a b v st tr p Go H V Xb Yb G' IH pre E0 ->.
      destruct (IH _ (Next _ _ _ _ E0) (Rev _ _ _)) as (s & Gr & U).
      inversion Gr as [|K' e st' tr' m' J Gr'|K' a' b' st' tr1 tr' g X Z G m' B Gr']; subst.
      { destruct (ahead _ _ _ _ _ _ G' J). }
      assert (E1 := Next _ _ _ _ E0).
      destruct (face_distinct M SM _ _ _ H) as (VA & VB & AB).
      assert (In_B := fun r => branch_in _ _ _ _ _ _ _ _ _ _ r E1 B).
      assert (No := branch_once _ _ _ _ _ _ _ _ _ _ E1 B).
      assert (Lt : forall e, In e (edges (map snd tr1)) \/ In e (edges (map snd tr')) ->
        ~ In e (edges ((v, a, b) :: rev (map snd pre)))).
      { intros e I; rewrite (Rev pre sS); apply ((later T NT) _ _ e E1); rewrite map_app, edges_app.
        apply in_app_iff, I. }
      assert (Ph := fun q => here pre sS (v, a, b) (tr1 ++ tr') q E0); cbn [edge_of] in Ph.
      assert (BA := behind _ _ _ _ _ _ Go).
      assert (Partner := fun q => partner _ _ _ _ _ _ _ _ _ q B).
      assert (Cover := fun e I => branch_cover _ _ _ _ _ _ _ _ _ _ e E1 B I).
      destruct B as [B1 B2 B3 B4 B5 B6 B7 B8].
      assert (Gx : forall r, In r (X ++ concat Z) -> r <> g).
      { intros r I ->; apply NoDup_cons_iff in No; destruct No as [No _]; apply No.
        rewrite ?in_app_iff in I; rewrite ?in_app_iff; tauto. }
      assert (Stay : forall r, In r (X ++ concat Z) -> phi r <> (a, v) ->
        In (flip (phi r)) (edges (rev (map snd pre)))).
      { intros r I Av; assert (IB : In r (g :: X ++ concat Z ++ both G)) by (right; rewrite ?in_app_iff in I; rewrite ?in_app_iff; tauto).
        destruct (In_B r IB) as [R1 R2].
        apply (stay pre sS v a b (tr1 ++ tr')); auto; intros E2.
        - apply (Lt (b, a)); [left; rewrite <- E2; exact R2|do 3 right; exact BA].
        - apply (Gx r I), inj; auto; [apply In_B; left; reflexivity|congruence]. }
      set (n := length (tr1 ++ tr')) in *.
      assert (Lg : length tr1 + length tr' = n) by (unfold n; rewrite app_length; reflexivity).
      inversion Gr' as [|K' e st' tr2 m2 J Gr2|K' a' b' st' tr2 tr3 g2 X2 Z2 G2 m2 C Gr2]; subst.
      + (* its left gate is passed over *)
        assert (Av : In (a, v) (edges (map snd tr1))).
        { apply (Permutation_in _ (edges_after tr1 _)), in_app_iff in J; destruct J as [J|J]; [exact J|].
          destruct J as [J|[J|[J|J]]]; try congruence; contradiction. }
        assert (Va : ~ In (v, a) (edges (map snd tr1))).
        { intros I; apply (Lt (v, a)); [left; exact I|left; reflexivity]. }
        destruct (closing (a, v) (tr1 ++ tr')) as [e'|] eqn:Cl.
        2:{ exfalso; destruct (edge_in_trace _ _ Av) as (x & w & c & d & I & D).
            destruct (closing_none _ _ Cl x w c d ltac:(apply in_app_iff; auto)) as [D1 D2].
            destruct D as [D|[D|D]]; try congruence; injection D as -> ->.
            destruct (B8 _ _ _ _ I) as [D|D]; [congruence|contradiction]. }
        destruct (closed_at _ _ _ _ E1 Cl) as (C1 & C2 & C3).
        assert (Ie : In e' (X ++ concat Z)).
        { destruct (Cover _ Av) as (s0 & I0 & P0); destruct (In_B s0 I0) as [R1 _].
          assert (e' = s0) as ->.
          { apply inj; [|exact R1|congruence].
            rewrite E1, sides_app; apply in_app_iff; right; exact C2. }
          destruct I0 as [<-|I0]; [contradiction|].
          rewrite !in_app_iff in I0; rewrite ?in_app_iff; destruct I0 as [I0|[I0|I0]]; auto.
          exfalso; destruct (Partner _ I0) as (q & Iq & Pq); rewrite C1 in Pq.
          apply Va; change (v, a) with (flip (a, v)); rewrite <- Pq; apply In_B; right.
          rewrite !in_app_iff; auto. }
        destruct (in_dec side_eq_dec e' X) as [IX|IX].
        * destruct (cut_in _ _ IX) as (A & Y & Cut & ->).
          rewrite map_app in B3; apply trail_app in B3; destruct B3 as (z & T1 & T2 & T3).
          cbn [map] in T2, T3; rewrite C1 in T2, T3; cbn [fst snd] in T2, T3; subst z.
          exists (State (((n, at_gate) :: A) :: stack m') (Y :: Z ++ beside m')
            (((n, at_right), g) :: ((n, at_left), e') :: G ++ glued m')); split.
          -- change ((sS, (v, a, b)) :: tr1 ++ tr') with (((sS, (v, a, b)) :: tr1) ++ tr').
             change (((n, at_right), g) :: ((n, at_left), e') :: G ++ glued m')
               with ((((n, at_right), g) :: ((n, at_left), e') :: G) ++ glued m').
             change (Y :: Z ++ beside m') with ((Y :: Z) ++ beside m').
             apply grove_cons; [constructor|rewrite after_cons; exact Gr2].
             ++ apply Ph.
             ++ reflexivity.
             ++ exact T1.
             ++ intros z [<-|I]; [exists v; exact T3|exact (B4 z I)].
             ++ intros r I; apply Stay.
                ** cbn [concat] in I; rewrite ?in_app_iff in I; rewrite ?in_app_iff; cbn [In]; tauto.
                ** intros E2; assert (r = e').
                   { apply inj; [| |congruence]; apply In_B; right; cbn [concat] in I;
                       rewrite ?in_app_iff in I; rewrite ?in_app_iff; cbn [In]; tauto. }
                   subst r; apply NoDup_cons_iff in No; destruct No as [_ No].
                   rewrite <- app_assoc in No; cbn [app] in No; apply NoDup_remove_2 in No; apply No.
                   cbn [concat] in I; rewrite ?in_app_iff in I; rewrite ?in_app_iff; tauto.
             ++ cbn [sides]; rewrite (Nat.add_comm (length tr')), Lg; cbn [concat]; permute_sides.
             ++ intros x r [I|[I|I]]; [injection I as <- <-|injection I as <- <-|apply B7; exact I];
                  rewrite Ph; [exact B1|exact C1].
             ++ intros x w c d [I|I]; [injection I as <- <- <- <-; left; reflexivity|right].
                destruct (B8 x w c d I) as [E2|I2].
                ** injection E2 as -> ->; right; right; left; reflexivity.
                ** do 3 right; exact I2.
          -- cbn [items undo]; rewrite Cl, U, items_length; fold n; cbn [undo1 stack beside glued].
             rewrite Cut; reflexivity.
        * assert (IZ : In e' (concat Z)) by (apply in_app_iff in Ie; tauto).
          destruct (take_in e' Z (beside m') IZ) as (U1 & z & V1 & A & Y & -> & -> & Tk).
          destruct (B4 (A ++ e' :: Y)) as [c T0]; [apply in_app_iff; right; left; reflexivity|].
          rewrite map_app in T0; apply trail_app in T0; destruct T0 as (z & T1 & T2 & T3).
          cbn [map] in T2, T3; rewrite C1 in T2, T3; cbn [fst snd] in T2, T3; subst z.
          exists (State (((n, at_gate) :: X ++ Y ++ A) :: stack m') ((U1 ++ V1) ++ beside m')
            (((n, at_right), g) :: ((n, at_left), e') :: G ++ glued m')); split.
          -- change ((sS, (v, a, b)) :: tr1 ++ tr') with (((sS, (v, a, b)) :: tr1) ++ tr').
             change (((n, at_right), g) :: ((n, at_left), e') :: G ++ glued m')
               with ((((n, at_right), g) :: ((n, at_left), e') :: G) ++ glued m').
             apply grove_cons; [constructor|rewrite after_cons; exact Gr2].
             ++ apply Ph.
             ++ reflexivity.
             ++ rewrite !map_app; apply trail_app; exists v; split; [exact B3|].
                apply trail_app; exists c; auto.
             ++ intros z I; apply B4; rewrite in_app_iff in I |- *; cbn [In]; tauto.
             ++ intros r I; apply Stay.
                ** rewrite ?concat_app', ?in_app_iff in I; rewrite ?concat_app', ?in_app_iff; cbn [concat]; rewrite !in_app_iff; cbn [In]; tauto.
                ** intros E2; assert (r = e').
                   { apply inj; [| |congruence]; apply In_B; right;
                       rewrite ?concat_app', ?in_app_iff in I; rewrite ?concat_app', ?in_app_iff; cbn [concat]; rewrite !in_app_iff; cbn [In]; tauto. }
                   subst r; clear - No I; apply NoDup_cons_iff in No; destruct No as [_ No].
                   apply (proj1 (NoDup_count_occ side_eq_dec _)) with (x := e') in No.
                   apply (count_occ_In side_eq_dec) in I.
                   rewrite !concat_app', !count_occ_app in *; cbn [concat] in No.
                   rewrite !count_occ_app in No; cbn [count_occ] in No.
                   destruct (side_eq_dec e' e'); [lia|congruence].
             ++ cbn [sides]; rewrite (Nat.add_comm (length tr')), Lg; permute_sides.
             ++ intros x r [I|[I|I]]; [injection I as <- <-|injection I as <- <-|apply B7; exact I];
                  rewrite Ph; [exact B1|exact C1].
             ++ intros x w c' d [I|I]; [injection I as <- <- <- <-; left; reflexivity|right].
                destruct (B8 x w c' d I) as [E2|I2].
                ** injection E2 as -> ->; right; right; left; reflexivity.
                ** do 3 right; exact I2.
          -- cbn [items undo]; rewrite Cl, U, items_length; fold n; cbn [undo1 stack beside glued].
             rewrite cut_out, Tk by exact IX; rewrite <- app_assoc; reflexivity.
      + (* its left gate is gone on at *)
        assert (E2 : T = ((pre ++ [(sS, (v, a, b))]) ++ tr1) ++ tr2 ++ tr3) by (rewrite <- app_assoc; exact E1).
        assert (In_C := fun r => branch_in _ _ _ _ _ _ _ _ _ _ r E2 C).
        assert (NoC := branch_once _ _ _ _ _ _ _ _ _ _ E2 C).
        assert (Lt2 : forall e, In e (edges (map snd tr2)) -> ~ In e (edges (map snd tr1))).
        { intros e I J; apply ((later T NT) _ (tr2 ++ tr3) e E2); [rewrite map_app, edges_app; apply in_app_iff; auto|].
          rewrite map_app, rev_app_distr, edges_app; apply in_app_iff; left.
          apply (Permutation_in _ (edges_perm _ _ (Permutation_rev (map snd tr1)))), J. }
        destruct C as [C1 C2 C3 C4 C5 C6 C7 C8].
        assert (Ig2 : In (a, v) (edges (map snd tr2))) by (rewrite <- C1; apply In_C; left; reflexivity).
        assert (Cl : closing (a, v) (tr1 ++ tr2 ++ tr3) = None).
        { destruct (closing (a, v) (tr1 ++ tr2 ++ tr3)) as [e'|] eqn:Cl; [exfalso|reflexivity].
          destruct (closed_at _ _ _ _ E1 Cl) as (D1 & D2 & D3).
          assert (e' = g2) as ->; [|contradiction].
          apply inj; [|apply In_C; left; reflexivity|congruence].
          rewrite E1, sides_app; apply in_app_iff; right; exact D2. }
        assert (Stay2 : forall r, In r (X2 ++ concat Z2) -> In (flip (phi r)) (edges (rev (map snd pre)))).
        { intros r I; assert (IC : In r (g2 :: X2 ++ concat Z2 ++ both G2)) by (right; rewrite ?in_app_iff in I; rewrite ?in_app_iff; tauto).
          destruct (In_C r IC) as [R1 R2].
          assert (I5 := C5 r I); apply (Permutation_in _ (edges_after tr1 _)), in_app_iff in I5.
          destruct I5 as [I5|I5].
          - exfalso; destruct (Cover _ I5) as (q & Iq & Pq).
            assert (Bad : forall x, In x (edges (map snd tr1)) \/ In x (edges ((v, a, b) :: rev (map snd pre))) ->
              x = flip (phi q) -> False).
            { intros x Ix ->; rewrite Pq, flip_flip in Ix; destruct Ix as [Ix|Ix].
              - exact (Lt2 _ R2 Ix).
              - apply (Lt (phi r)); [right; rewrite map_app, edges_app; apply in_app_iff; auto|exact Ix]. }
            destruct Iq as [<-|Iq].
            + apply (Bad (b, v)); [right; right; right; left; reflexivity|rewrite B1; reflexivity].
            + rewrite !in_app_iff in Iq; destruct Iq as [Iq|[Iq|Iq]].
              * apply (Bad (flip (phi q))); [right; apply B5, in_app_iff; auto|reflexivity].
              * apply (Bad (flip (phi q))); [right; apply B5, in_app_iff; auto|reflexivity].
              * destruct (Partner _ Iq) as (q' & Iq' & Pq').
                apply (Bad (phi q')); [left; apply In_B; right; rewrite !in_app_iff; auto|exact Pq'].
          - apply (stay pre sS v a b (tr1 ++ tr2 ++ tr3)); auto; intros E3.
            + assert (r = g2) by (apply inj; auto; [apply In_C; left; reflexivity|congruence]).
              subst r; apply NoDup_cons_iff in NoC; destruct NoC as [NoC _]; apply NoC.
              rewrite ?in_app_iff in I; rewrite ?in_app_iff; tauto.
            + apply (Lt (b, a)); [right; rewrite map_app, edges_app, <- E3; apply in_app_iff; auto|].
              do 3 right; exact BA.
            + apply (Lt2 (v, b)); [rewrite <- E3; exact R2|rewrite <- B1; apply In_B; left; reflexivity]. }
        exists (State (((n, at_gate) :: X ++ X2) :: stack m2) ((Z ++ Z2) ++ beside m2)
          (((n, at_right), g) :: ((n, at_left), g2) :: (G ++ G2) ++ glued m2)); split.
        * change ((sS, (v, a, b)) :: tr1 ++ tr2 ++ tr3) with (((sS, (v, a, b)) :: tr1) ++ tr2 ++ tr3).
          rewrite app_assoc.
          change (((n, at_right), g) :: ((n, at_left), g2) :: (G ++ G2) ++ glued m2)
            with ((((n, at_right), g) :: ((n, at_left), g2) :: G ++ G2) ++ glued m2).
          apply grove_cons; [constructor|rewrite after_app, after_cons; exact Gr2].
          -- apply Ph.
          -- reflexivity.
          -- rewrite map_app; apply trail_app; exists v; auto.
          -- intros z I; apply in_app_iff in I; destruct I as [I|I]; [exact (B4 z I)|exact (C4 z I)].
          -- intros r I; rewrite concat_app' in I.
             assert (I' : In r (X ++ concat Z) \/ In r (X2 ++ concat Z2)) by (rewrite ?in_app_iff in I; rewrite ?in_app_iff; tauto).
             destruct I' as [I'|I']; [|exact (Stay2 r I')]; apply Stay; [exact I'|]; intros E3.
             apply (Lt2 (a, v) Ig2); rewrite <- E3; apply In_B; right; rewrite ?in_app_iff in I'; rewrite ?in_app_iff; tauto.
          -- rewrite app_length in C6, B6 || rewrite app_length in B6.
             cbn [app sides]; rewrite sides_app, app_length.
             replace (length tr3 + (length tr1 + length tr2)) with n
               by (rewrite <- Lg, app_length; lia).
             replace (length tr3 + length tr2) with (length tr2 + length tr3) by lia.
             permute_sides.
          -- intros x r [I|[I|I]]; [injection I as <- <-; rewrite Ph; exact B1|injection I as <- <-; rewrite Ph; exact C1|].
             apply in_app_iff in I; destruct I as [I|I]; [exact (B7 _ _ I)|exact (C7 _ _ I)].
          -- intros x w c d I.
             change (map snd (((sS, (v, a, b)) :: tr1) ++ tr2)) with ((v, a, b) :: map snd (tr1 ++ tr2)).
             rewrite map_app; change (edges ((v, a, b) :: map snd tr1 ++ map snd tr2))
               with ((v, a) :: (a, b) :: (b, v) :: edges (map snd tr1 ++ map snd tr2)); rewrite edges_app.
             destruct I as [I|I]; [injection I as <- <- <- <-; left; reflexivity|right].
             apply in_app_iff in I; destruct I as [I|I].
             ++ destruct (B8 x w c d I) as [E3|I2]; [injection E3 as -> ->; right; right; left; reflexivity|].
                do 3 right; apply in_app_iff; auto.
             ++ destruct (C8 x w c d I) as [E3|I2]; [injection E3 as -> ->; left; reflexivity|].
                do 3 right; apply in_app_iff; auto.
        * cbn [items undo]; rewrite Cl, U, items_length; fold n; cbn [undo1 stack beside glued].
          rewrite <- !app_assoc; reflexivity.
    - (* E, the last *)
      intros K m a b v st Go H V Xb Yb Q pre E0 ->.
      assert (Ph := fun q => here pre sE (v, a, b) [] q E0); cbn [edge_of length] in Ph.
      exists (State [[(0, at_gate); (0, at_right); (0, at_left)]] [] []); split; [|reflexivity].
      assert (Gr : grove (after [(sE, (v, a, b))] (rev (map snd pre))) st [] (State [] [] [])).
      { clear - Q; induction st as [|e st IH]; [constructor|apply grove_pass].
        - apply Q; left; reflexivity.
        - apply IH; intros g I; apply Q; right; exact I. }
      apply (grove_cons _ a b st [(sE, (v, a, b))] [] (0, at_gate) [(0, at_right); (0, at_left)] [] []
        (State [] [] [])); [|exact Gr].
      constructor; cbn [map trail In app concat both flat_map sides three_sides length Nat.add].
      + apply Ph.
      + reflexivity.
      + rewrite !Ph; auto.
      + intros z [].
      + intros r [<-|[<-|[]]]; rewrite Ph; [exact Xb|exact Yb].
      + reflexivity.
      + intros s r [].
      + intros x w c d [I|[]]; injection I as <- <- <- <-; left; reflexivity.
    - (* E *)
      intros K m a b v passed a' b' rest tr p Go H V Xb Yb Q O G' IH pre E0 ->.
      destruct (IH _ (Next _ _ _ _ E0) (Rev _ _ _)) as (s & Gr & U).
      assert (Ph := fun q => here pre sE (v, a, b) tr q E0); cbn [edge_of] in Ph.
      set (n := length tr) in *.
      exists (State ([(n, at_gate); (n, at_right); (n, at_left)] :: stack s) (beside s) (glued s)); split.
      + assert (Gr2 : grove (after [(sE, (v, a, b))] (rev (map snd pre))) (passed ++ (a', b') :: rest) tr s).
        { change (after [(sE, (v, a, b))] (rev (map snd pre))) with ((v, a, b) :: rev (map snd pre)).
          clear - Q Gr; induction passed as [|e passed IH]; [exact Gr|apply grove_pass].
          - apply Q; left; reflexivity.
          - apply IH; intros g I; apply Q; right; exact I. }
        apply (grove_cons _ a b (passed ++ (a', b') :: rest) [(sE, (v, a, b))] tr (n, at_gate)
          [(n, at_right); (n, at_left)] [] [] s); [|exact Gr2].
        constructor; cbn [map trail In app concat both flat_map sides three_sides].
        * apply Ph.
        * reflexivity.
        * rewrite !Ph; auto.
        * intros z [].
        * intros r [<-|[<-|[]]]; rewrite Ph; [exact Xb|exact Yb].
        * cbn [length]; rewrite Nat.add_0_r; reflexivity.
        * intros x r [].
        * intros x w c d [I|[]]; injection I as <- <- <- <-; left; reflexivity.
      + cbn [items undo]; rewrite U, items_length; reflexivity.
  Qed.
End Surface.
