(** The round trip of connected closed surfaces of any genus: the gluing, and the surface again.

    EB-DECODE-1 for one connected closed surface with its handle data, CPLX-ISO-1, CPLX-ISO-2.
    [handles_round_trip]: Spirale Reversi, told the symbols and for each S with a record the side
    that closes it, glues every side of the mesh once, to the side that it is glued to in the mesh.
    [same_items_same_surface]: the symbols with those sides determine the surface: two surfaces with
    the same are isomorphic, the faces of the one on the faces of the other in the order of the visit.
    The vertices are found as EB-REVERSI-3 finds them, as classes of corners under swings. *)
Require Import List Arith Lia Permutation Relation_Operators.
Require Import Clers.Letters Clers.Words Clers.Meshes Clers.Discs Clers.Traversal Clers.Visited
  Clers.Records Clers.Undoing Clers.Reversi Clers.Sides Clers.Handles Clers.Round_trip.
Import ListNotations.
Open Scope nat_scope.

(** The trace with P before it; what stands for P's symbol does not matter. *)
Definition whole (M : list face) (tr : list step) : list step :=
  match M with [] => tr | P :: _ => (sC, P) :: tr end.

Section Surface.
  Variables (M : list face) (tr : list step) (p : list edge).
  Hypothesis SM : surface M.
  Hypothesis CM : connected M.
  Hypothesis walked : encode M = Some (tr, p).
  Let T := whole M tr.
  Let phi := edge_at T.

  Lemma whole_is_M : NoDup (edges (map snd T)) /\
    forall x y z, has M x y z <-> has (map snd T) x y z.
  Proof.
    destruct (encode_total M SM CM) as (tr' & p' & x0 & x1 & x2 & rest & E0 & E1 & W).
    rewrite walked in E1; injection E1 as <- <-.
    assert (G := good_start M SM x0 x1 x2 rest E0).
    assert (TE : T = (sC, (x0, x1, x2)) :: tr) by (unfold T; rewrite E0; reflexivity).
    destruct (visited M SM _ _ _ _ _ _ _ W G) as (_ & N & _).
    assert (P : Permutation (after tr [(x0, x1, x2)]) (map snd T)).
    { rewrite TE; unfold after; cbn [map snd]; rewrite <- Permutation_rev, Permutation_app_comm; reflexivity. }
    split; [exact (Permutation_NoDup (edges_perm _ _ P) N)|].
    intros x y z; rewrite (all_visited M SM x0 x1 x2 rest E0 tr p W CM x y z).
    split; apply has_incl; intros f; apply Permutation_in; [exact P|symmetry; exact P].
  Qed.

  Lemma whole_once : Permutation (map phi (sides 0 T)) (edges M).
  Proof.
    destruct whole_is_M as [N H].
    assert (P := phi_sides T N T [] [] (eq_sym (app_nil_r T))); cbn [length] in P; fold phi in P; rewrite P.
    apply NoDup_Permutation; [exact N|apply (once M SM)|]; intros [x y]; split; intros I;
      apply edge_has in I; destruct I as [z I]; apply has_edge with z, H, I.
  Qed.

  Theorem handles_round_trip : exists pairs, glue (items tr) = Some pairs /\
    Permutation (both pairs) (sides 0 T) /\
    forall s r, In (s, r) pairs -> phi r = flip (phi s).
  Proof.
    destruct whole_is_M as [NT _].
    destruct (encode_total M SM CM) as (tr' & p' & x0 & x1 & x2 & rest & E0 & E1 & W).
    rewrite walked in E1; injection E1 as <- <-.
    assert (G := good_start M SM x0 x1 x2 rest E0).
    assert (TE : T = [(sC, (x0, x1, x2))] ++ tr) by (unfold T; rewrite E0; reflexivity).
    destruct (face_distinct M SM x0 x1 x2) as (D1 & D2 & D3); [rewrite E0; left; left; reflexivity|].
    destruct (walk_is_grove M SM T NT _ _ _ _ _ _ _ W G _ TE eq_refl) as (m & Gr & U).
    inversion Gr as [|K' e st' tr' m' J Gr'|K' a' b' st' tr1 tr2 g X Z Gl m' B Gr']; subst K'.
    { subst; destruct (ahead _ _ _ _ _ _ G J). }
    subst a' b' st' m; inversion Gr'; subst tr2 m'; rewrite app_nil_r in *; subst tr1.
    assert (TE' : T = [(sC, (x0, x1, x2))] ++ tr ++ []) by (rewrite app_nil_r; exact TE).
    assert (In_B := fun r => branch_in T NT _ _ _ _ [] _ _ _ _ _ r TE' B).
    assert (No := branch_once T NT _ _ _ _ [] _ _ _ _ _ TE' B).
    destruct B as [B1 B2 B3 B4 B5 B6 B7 B8]; fold phi in B1, B3, B4, B5, B7.
    assert (Ph := fun q => phi_here T NT [] sC (x0, x1, x2) tr q TE); cbn [edge_of] in Ph; fold phi in Ph.
    set (n := length tr) in *.
    assert (Two : forall r, In r (X ++ concat Z) -> phi r = (x1, x0) \/ phi r = (x0, x2)).
    { intros r I; assert (I' := B5 r I); destruct (phi r) as [x y] eqn:Pr; cbn in I'.
      destruct I' as [I'|[I'|[I'|[]]]]; injection I' as <- <-; auto.
      exfalso; assert (IB : In r (g :: X ++ concat Z ++ both Gl)) by (right; rewrite !in_app_iff in *; tauto).
      assert (r = g).
      { apply (phi_inj T NT); [apply In_B; exact IB|apply In_B; left; reflexivity|fold phi; congruence]. }
      subst r; apply NoDup_cons_iff in No; destruct No as [No _]; apply No.
      rewrite !in_app_iff in *; tauto. }
    assert (XE : exists e1 e2, X = [e1; e2] /\ phi e1 = (x1, x0) /\ phi e2 = (x0, x2)).
    { destruct X as [|e1 [|e2 [|e3 X]]]; cbn [map trail app] in *.
      - congruence.
      - destruct (Two e1) as [A|A]; [left; reflexivity|..]; rewrite A in B3; cbn in B3; destruct B3; congruence.
      - exists e1, e2; destruct B3 as (F1 & F2 & _).
        destruct (Two e1) as [A|A]; [left; reflexivity|..]; rewrite A in F1, F2; cbn in F1, F2; [|congruence].
        destruct (Two e2) as [A'|A']; [right; left; reflexivity|..]; rewrite A' in F2; cbn in F2; [congruence|].
        auto.
      - exfalso; destruct B3 as (F1 & F2 & F3 & _).
        destruct (Two e1) as [A|A]; [left; reflexivity|..]; rewrite A in F1, F2; cbn in F1, F2; [|congruence].
        destruct (Two e2) as [A'|A']; [right; left; reflexivity|..]; rewrite A' in F2, F3; cbn in F2, F3; [congruence|].
        destruct (Two e3) as [A3|A3]; [right; right; left; reflexivity|..]; rewrite A3 in F3; cbn in F3; congruence. }
    destruct XE as (e1 & e2 & -> & P1 & P2).
    assert (ZE : concat Z = []).
    { destruct (concat Z) as [|r L0] eqn:CZ; [reflexivity|exfalso].
      assert (Ir : In r ([e1; e2] ++ r :: L0)) by (right; right; left; reflexivity).
      assert (I1 : In e1 (g :: [e1; e2] ++ (r :: L0) ++ both Gl)) by (right; left; reflexivity).
      assert (I2 : In e2 (g :: [e1; e2] ++ (r :: L0) ++ both Gl)) by (do 2 right; left; reflexivity).
      assert (I3 : In r (g :: [e1; e2] ++ (r :: L0) ++ both Gl)) by (do 3 right; left; reflexivity).
      destruct (In_B _ I1) as [J1 _], (In_B _ I2) as [J2 _], (In_B _ I3) as [J3 _].
      assert (r = e1 \/ r = e2) as [->| ->].
      { destruct (Two r Ir) as [A|A]; [left|right]; apply (phi_inj T NT); auto; fold phi; congruence. }
      - apply NoDup_cons_iff in No; destruct No as [_ No]; apply NoDup_cons_iff in No; destruct No as [No _].
        apply No; right; left; reflexivity.
      - apply NoDup_cons_iff in No; destruct No as [_ No]; apply NoDup_cons_iff in No; destruct No as [_ No].
        apply NoDup_cons_iff in No; destruct No as [No _]; apply No; left; reflexivity. }
    exists ((g, (n, at_gate)) :: (e1, (n, at_left)) :: (e2, (n, at_right)) :: Gl); split; [|split].
    - unfold glue; rewrite U; cbn [stack beside glued]; rewrite !app_nil_r, ZE, items_length; reflexivity.
    - rewrite ZE in B6; cbn [app length] in B6; rewrite TE; cbn [app sides Nat.add]; fold n.
      permute_sides.
    - intros s r [I|[I|[I|I]]]; [injection I as <- <-..|exact (B7 s r I)];
        rewrite Ph, ?B1, ?P1, ?P2; reflexivity.
  Qed.

  (** ** Corners around a vertex *)

  Definition before_side (s : side) : side :=
    (fst s, match snd s with at_gate => at_left | at_right => at_gate | at_left => at_right end).

  Lemma sides_whole : forall tr0 k s, In s (sides k tr0) -> forall q, In (fst s, q) (sides k tr0).
  Proof.
    induction tr0 as [|x tr0 IH]; intros k s I q; [destruct I|]; cbn [sides] in *.
    apply in_app_iff in I; apply in_app_iff; destruct I as [I|I]; [left|right; exact (IH k s I q)].
    destruct I as [<-|[<-|[<-|[]]]]; destruct q; cbn; auto.
  Qed.

  Lemma side_face : forall s, In s (sides 0 T) -> exists x v a b,
    In (x, (v, a, b)) T /\ forall q, phi (fst s, q) = edge_of (v, a, b) q.
  Proof.
    assert (A : forall tr0 pre s, T = pre ++ tr0 -> In s (sides 0 tr0) -> exists x v a b,
      In (x, (v, a, b)) T /\ forall q, phi (fst s, q) = edge_of (v, a, b) q).
    { induction tr0 as [|[x [[v a] b]] tr0 IH]; intros pre s E0 I; [destruct I|]; cbn [sides] in I.
      apply in_app_iff in I; destruct I as [I|I].
      - exists x, v, a, b; split; [rewrite E0; apply in_app_iff; right; left; reflexivity|].
        intros q; destruct I as [<-|[<-|[<-|[]]]]; cbn [fst]; unfold phi; rewrite E0; apply edge_at_here.
      - apply (IH (pre ++ [(x, (v, a, b))]) s); [rewrite <- app_assoc; exact E0|exact I]. }
    intros s; exact (A T [] s eq_refl).
  Qed.

  Variable pairs : list (side * side).
  Hypothesis glued_all : Permutation (both pairs) (sides 0 T).
  Hypothesis glued_right : forall s r, In (s, r) pairs -> phi r = flip (phi s).

  Definition mates (s r : side) : Prop := In (s, r) pairs \/ In (r, s) pairs.
  Definition swing (s r : side) : Prop := In s (sides 0 T) /\ mates (before_side s) r.

  Lemma mates_flip : forall s r, mates s r -> phi r = flip (phi s).
  Proof.
    intros s r [I|I]; [exact (glued_right s r I)|].
    rewrite (glued_right r s I), flip_flip; reflexivity.
  Qed.

  Lemma mate_exists : forall s, In s (sides 0 T) -> exists r, mates s r /\ In r (sides 0 T).
  Proof.
    intros s I; apply (Permutation_in _ (Permutation_sym glued_all)) in I.
    apply in_flat_map in I; destruct I as ([x y] & I & J).
    assert (B : forall z, In z [x; y] -> In z (sides 0 T)).
    { intros z K; apply (Permutation_in _ glued_all), in_flat_map; exists (x, y); auto. }
    cbn in J; destruct J as [<-|[<-|[]]]; [exists y|exists x]; split; unfold mates; auto; apply B; cbn; auto.
  Qed.

  Lemma before_here : forall s, In s (sides 0 T) -> exists x y z, has M x y z /\
    phi s = (x, y) /\ phi (before_side s) = (z, x) /\ In (before_side s) (sides 0 T).
  Proof.
    intros s I; destruct (side_face s I) as (x & v & a & b & J & Ph).
    assert (H : has M v a b).
    { apply whole_is_M; left; apply in_map_iff; exists (x, (v, a, b)); auto. }
    assert (B : In (before_side s) (sides 0 T)) by (apply (sides_whole T 0 s I)).
    destruct s as [i q]; unfold before_side in *; cbn [fst snd] in *; rewrite !Ph; destruct q; cbn [edge_of].
    - exists a, b, v; repeat split; auto; apply has_turn, H.
    - exists b, v, a; repeat split; auto; apply has_turn, has_turn, H.
    - exists v, a, b; repeat split; auto.
  Qed.

  (** A swing stays at its vertex. *)
  Lemma swing_stays : forall s r, swing s r -> fst (phi r) = fst (phi s).
  Proof.
    intros s r [I Ma]; destruct (before_here s I) as (x & y & z & _ & P1 & P2 & _).
    rewrite (mates_flip _ _ Ma), P1, P2; reflexivity.
  Qed.

  (** Swings lead to all corners of the vertex. *)
  Lemma swings_reach : forall s r, In s (sides 0 T) -> In r (sides 0 T) ->
    fst (phi s) = fst (phi r) -> clos_refl_trans side swing s r.
  Proof.
    intros s r Is Ir E0; destruct (phi s) as [x y] eqn:Ps, (phi r) as [x' y'] eqn:Pr; cbn in E0; subst x'.
    destruct (before_here s Is) as (x1 & y1 & z & H & P1 & _); rewrite Ps in P1; injection P1 as <- <-.
    destruct (before_here r Ir) as (x1 & y1 & z' & H' & P1' & _); rewrite Pr in P1'; injection P1' as <- <-.
    destruct whole_is_M as [NT _].
    assert (Ci : circle M x) by (apply (circles M SM), has_vertex with y z, H).
    assert (Q : exists q, In q (sides 0 T) /\ phi q = (x, y') /\ clos_refl_trans side swing s q).
    { apply (circle_forward M x (fun w => exists q, In q (sides 0 T) /\ phi q = (x, w) /\
        clos_refl_trans side swing s q) Ci) with y z z'; auto.
      - intros u w Hu (q & Iq & Pq & Sq).
        destruct (before_here q Iq) as (x2 & y2 & w' & H2 & P2 & P3 & I3).
        rewrite Pq in P2; injection P2 as <- <-.
        assert (w' = w) as -> by exact (has_unique M x u w' w (once M SM) H2 Hu).
        destruct (mate_exists _ I3) as (t & Ma & It).
        exists t; repeat split; auto.
        + rewrite (mates_flip _ _ Ma), P3; reflexivity.
        + apply rt_trans with q; [exact Sq|apply rt_step; split; auto].
      - exists s; repeat split; auto using rt_refl. }
    destruct Q as (q & Iq & Pq & Sq).
    assert (q = r) as <- by (apply (phi_inj T NT); auto; fold phi; congruence).
    exact Sq.
  Qed.
End Surface.

Lemma sides_by_length : forall k T U, length T = length U -> sides k T = sides k U.
Proof.
  induction T as [|x T IH]; intros [|y U] E0; try discriminate; [reflexivity|].
  cbn [length] in E0; cbn [sides]; f_equal; [f_equal; lia|apply IH; lia].
Qed.

Lemma whole_length : forall M tr, M <> [] -> length (whole M tr) = length tr + 1.
Proof. intros [|f M] tr NE; [congruence|]; cbn; lia. Qed.

(** One surface's corners at a vertex are the other's. *)
Lemma same_vertices : forall M N trM trN pM pN, surface M -> connected M -> surface N -> connected N ->
  encode M = Some (trM, pM) -> encode N = Some (trN, pN) -> items trM = items trN ->
  forall s r, In s (sides 0 (whole M trM)) -> In r (sides 0 (whole M trM)) ->
  fst (edge_at (whole M trM) s) = fst (edge_at (whole M trM) r) ->
  fst (edge_at (whole N trN) s) = fst (edge_at (whole N trN) r).
Proof.
  intros M N trM trN pM pN SM CM SN CN EM EN It s r Is Ir E0.
  destruct (handles_round_trip M trM pM SM CM EM) as (pairs & G1 & G2 & G3).
  destruct (handles_round_trip N trN pN SN CN EN) as (pairs' & H1 & H2 & H3).
  rewrite It, H1 in G1; injection G1 as ->.
  assert (Le : length trM = length trN) by (rewrite <- (items_length trM), It, items_length; reflexivity).
  assert (Sd : sides 0 (whole M trM) = sides 0 (whole N trN)).
  { apply sides_by_length; rewrite !whole_length by (apply not_empty; assumption); lia. }
  assert (Rt := swings_reach M trM pM SM CM EM pairs G2 G3 s r Is Ir E0).
  clear E0 Is Ir; induction Rt as [s r Sw| |s q r _ A _ B]; [|reflexivity|congruence].
  symmetry; apply (swing_stays N trN pN SN CN EN pairs H3); destruct Sw as [I Ma]; split; [|exact Ma].
  rewrite <- Sd; exact I.
Qed.

Theorem same_items_same_surface : forall M N trM trN pM pN,
  surface M -> connected M -> surface N -> connected N ->
  encode M = Some (trM, pM) -> encode N = Some (trN, pN) -> items trM = items trN ->
  exists r, isomorphism r M N /\
    map (renamed r) (firstn 1 M ++ map snd trM) = firstn 1 N ++ map snd trN.
Proof.
  intros M N trM trN pM pN SM CM SN CN EM EN It.
  assert (Le : length trM = length trN) by (rewrite <- (items_length trM), It, items_length; reflexivity).
  set (T := whole M trM); set (U := whole N trN).
  assert (TU : length T = length U).
  { unfold T, U; rewrite !whole_length by (apply not_empty; assumption); lia. }
  assert (Sd : sides 0 T = sides 0 U) by (apply sides_by_length, TU).
  assert (There := same_vertices M N trM trN pM pN SM CM SN CN EM EN It); fold T U in There.
  assert (Back := same_vertices N M trN trM pN pM SN CN SM CM EN EM (eq_sym It)); fold T U in Back.
  rewrite <- Sd in Back.
  set (r := fun x => match find (fun s => fst (edge_at T s) =? x) (sides 0 T) with
                     | Some s => fst (edge_at U s) | None => 0 end).
  assert (Rs : forall s, In s (sides 0 T) -> r (fst (edge_at T s)) = fst (edge_at U s)).
  { intros s I; unfold r; destruct (find _ (sides 0 T)) as [q|] eqn:Fi.
    - apply find_some in Fi; destruct Fi as [Iq Eq]; apply Nat.eqb_eq in Eq; apply There; auto.
    - apply (find_none _ _ Fi) in I; rewrite Nat.eqb_refl in I; discriminate. }
  assert (Faces : map (renamed r) (map snd T) = map snd U).
  { assert (A : forall T1 U1 preT preU, T = preT ++ T1 -> U = preU ++ U1 -> length T1 = length U1 ->
      map (renamed r) (map snd T1) = map snd U1).
    { induction T1 as [|[x [[v a] b]] T1 IH]; intros [|[y [[v' a'] b']] U1] preT preU ET EU L1;
        try discriminate; [reflexivity|]; cbn [map snd renamed]; cbn [length] in L1.
      assert (PT := fun q => f_equal (fun X => edge_at X (length T1, q)) ET); cbn beta in PT.
      assert (PU := fun q => f_equal (fun X => edge_at X (length U1, q)) EU); cbn beta in PU.
      assert (L2 : length T1 = length U1) by lia.
      assert (Q : forall q, r (fst (edge_of (v, a, b) q)) = fst (edge_of (v', a', b') q)).
      { intros q; rewrite <- (edge_at_here preT x (v, a, b) T1 q), <- PT.
        rewrite <- (edge_at_here preU y (v', a', b') U1 q), <- PU, <- L2; apply Rs.
        rewrite ET, sides_app; apply in_app_iff; right; cbn [sides]; apply in_app_iff; left.
        destruct q; cbn; auto. }
      f_equal; [f_equal; [f_equal|]|].
      - exact (Q at_left).
      - exact (Q at_gate).
      - exact (Q at_right).
      - apply (IH U1 (preT ++ [(x, (v, a, b))]) (preU ++ [(y, (v', a', b'))]));
          [rewrite <- app_assoc; exact ET|rewrite <- app_assoc; exact EU|exact L2]. }
    apply (A T U [] []); auto. }
  assert (HM := proj2 (whole_is_M M trM pM SM CM EM)); fold T in HM.
  assert (HN := proj2 (whole_is_M N trN pN SN CN EN)); fold U in HN.
  assert (Vs : forall x, In x (vertices M) -> exists s, In s (sides 0 T) /\ fst (edge_at T s) = x).
  { intros x I; apply vertex_has in I; destruct I as (y & z & I); apply has_edge in I.
    apply (Permutation_in _ (Permutation_sym (whole_once M trM pM SM CM EM))), in_map_iff in I.
    destruct I as (s & Ps & I); exists s; split; [exact I|]; fold T in Ps; rewrite Ps; reflexivity. }
  exists r; split; [split|].
  - intros x y Ix Iy E0; destruct (Vs x Ix) as (s & Is & <-), (Vs y Iy) as (q & Iq & <-).
    rewrite !Rs in E0 by assumption; apply Back; auto.
  - intros x y z; rewrite HN, <- Faces; unfold has.
    assert (A : forall f, In f (map (renamed r) (map snd T)) -> forall u v w, f = (u, v, w) ->
      has (map (renamed r) M) u v w).
    { intros f I u v w ->; apply in_map_iff in I; destruct I as ([[p1 q1] t1] & E0 & I).
      injection E0 as <- <- <-; apply has_renamed, HM; left; exact I. }
    assert (B : forall f, In f (map (renamed r) M) -> forall u v w, f = (u, v, w) ->
      has (map (renamed r) (map snd T)) u v w).
    { intros f I u v w ->; apply in_map_iff in I; destruct I as ([[p1 q1] t1] & E0 & I).
      injection E0 as <- <- <-; apply has_renamed, HM; left; exact I. }
    split; intros [I|[I|I]].
    + exact (A _ I _ _ _ eq_refl).
    + apply has_turn, has_turn; exact (A _ I _ _ _ eq_refl).
    + apply has_turn; exact (A _ I _ _ _ eq_refl).
    + exact (B _ I _ _ _ eq_refl).
    + apply has_turn, has_turn; exact (B _ I _ _ _ eq_refl).
    + apply has_turn; exact (B _ I _ _ _ eq_refl).
  - assert (FM : firstn 1 M ++ map snd trM = map snd T).
    { unfold T; destruct M; [destruct (not_empty _ SM); reflexivity|reflexivity]. }
    assert (FN : firstn 1 N ++ map snd trN = map snd U).
    { unfold U; destruct N; [destruct (not_empty _ SN); reflexivity|reflexivity]. }
    rewrite FM, FN; exact Faces.
Qed.
