(** The stream belongs to the rooted surface, not to its names.

    EB-GRAMMAR-10: if an isomorphism (CPLX-ISO-1) takes the first face of one connected closed surface
    to the first face of another, corner by corner, the two have the same stream ([same_root_same_stream]).
    With [Stream.same_stream_same_surface]: streams tell rooted surfaces apart exactly
    ([stream_is_of_rooted_surface]), and the accepted words are, one for one, the spheres with a first
    face ([words_are_rooted_spheres]). *)
Require Import List Arith Lia Permutation.
Require Import Clers.Letters Clers.Words Clers.Meshes Clers.Discs Clers.Fans Clers.Decoder
  Clers.Traversal Clers.Visited Clers.Records Clers.Replay Clers.Undoing Clers.Reversi Clers.Sides
  Clers.Handles Clers.Round_trip Clers.Handles_round_trip Clers.Numbering Clers.Stream.
Import ListNotations.
Open Scope nat_scope.

Definition renamed_edge (r : nat -> nat) (e : edge) : edge := (r (fst e), r (snd e)).
Definition renamed_step (r : nat -> nat) (s : step) : step := (fst s, renamed r (snd s)).

Section Renaming.
  Variables (M N : list face) (r : nat -> nat).
  Hypothesis SM : surface M.
  Hypothesis iso : isomorphism r M N.
  Let re := renamed_edge r.

  Lemma has_to : forall x y z, has M x y z -> has N (r x) (r y) (r z).
  Proof. intros x y z H; apply iso, has_renamed, H. Qed.

  Definition of_M (e : edge) : Prop := In (fst e) (vertices M) /\ In (snd e) (vertices M).

  Lemma of_M_edges : forall K e, (forall x y z, has K x y z -> has M x y z) -> In e (edges K) -> of_M e.
  Proof.
    intros K [x y] I J; apply edge_has in J; destruct J as [z J]; apply I in J; split; cbn.
    - apply has_vertex with y z, J.
    - apply has_vertex with z x, has_turn, J.
  Qed.

  Lemma re_inj : forall e d, of_M e -> of_M d -> re e = re d -> e = d.
  Proof.
    intros [x y] [u v] [A B] [C D] E; injection E as E1 E2; cbn in *.
    f_equal; apply iso; assumption.
  Qed.

  Lemma edges_re : forall K, edges (map (renamed r) K) = map re (edges K).
  Proof. intros; apply edges_renamed. Qed.

  Lemma in_re : forall K e, In e (edges K) -> In (re e) (edges (map (renamed r) K)).
  Proof. intros; rewrite edges_re; apply in_map; assumption. Qed.

  Lemma not_re : forall K e, (forall x y z, has K x y z -> has M x y z) -> of_M e ->
    ~ In e (edges K) -> ~ In (re e) (edges (map (renamed r) K)).
  Proof.
    intros K e I O H J; rewrite edges_re in J; apply in_map_iff in J; destruct J as (d & E & J).
    apply re_inj in E; [subst; contradiction|exact (of_M_edges K d I J)|exact O].
  Qed.

  Lemma walk_renamed : forall K m a b st tr p, Walk M K m a b st tr p -> good M K m a b st ->
    Walk N (map (renamed r) K) (map r m) (r a) (r b) (map re st) (map (renamed_step r) tr) (map re p).
  Proof.
    apply (walk_induction M SM (fun K m a b st tr p =>
      Walk N (map (renamed r) K) (map r m) (r a) (r b) (map re st) (map (renamed_step r) tr) (map re p))).
    - intros K m a b v st tr p G H V G' IH; apply Walk_C; [apply has_to, H| |exact IH].
      intros I; apply in_map_iff in I; destruct I as (u & E & I); apply V.
      assert (u = v) as <-; [|exact I]; apply iso; [| |exact E].
      + apply (marks _ _ _ _ _ _ G) in I; apply vertex_has in I; destruct I as (y & z & I).
        apply has_vertex with y z, (inside _ _ _ _ _ _ G), I.
      + apply has_vertex with a b, has_turn, has_turn, H.
    - intros K m a b v st tr p G H V X Y G' IH.
      apply Walk_R; [apply has_to, H|apply in_map, V|exact (in_re K (v, b) X)| |exact IH].
      apply (not_re K (a, v) (inside _ _ _ _ _ _ G)); [|exact Y]; split; cbn.
      + apply has_vertex with b v, H.
      + apply has_vertex with a b, has_turn, has_turn, H.
    - intros K m a b v st tr p G H V X Y G' IH.
      apply Walk_L; [apply has_to, H|apply in_map, V| |exact (in_re K (a, v) Y)|exact IH].
      apply (not_re K (v, b) (inside _ _ _ _ _ _ G)); [|exact X]; split; cbn.
      + apply has_vertex with a b, has_turn, has_turn, H.
      + apply has_vertex with v a, has_turn, H.
    - intros K m a b v st tr p G H V X Y G' IH.
      apply Walk_S; [apply has_to, H|apply in_map, V| | |exact IH].
      + apply (not_re K (v, b) (inside _ _ _ _ _ _ G)); [|exact X]; split; cbn.
        * apply has_vertex with a b, has_turn, has_turn, H.
        * apply has_vertex with v a, has_turn, H.
      + apply (not_re K (a, v) (inside _ _ _ _ _ _ G)); [|exact Y]; split; cbn.
        * apply has_vertex with b v, H.
        * apply has_vertex with a b, has_turn, has_turn, H.
    - intros K m a b v st G H V X Y Q.
      apply Walk_end; [apply has_to, H|apply in_map, V|exact (in_re K (v, b) X)|exact (in_re K (a, v) Y)|].
      intros g I; apply in_map_iff in I; destruct I as (e & <- & I).
      exact (in_re ((v, a, b) :: K) e (Q e I)).
    - intros K m a b v passed a' b' rest tr p G H V X Y Q O G' IH; rewrite !map_app; cbn [map].
      apply (Walk_E N (map (renamed r) K) (map r m) (r a) (r b) (r v) (map re passed) (r a') (r b')
        (map re rest) (map (renamed_step r) tr) (map re p));
        [apply has_to, H|apply in_map, V|exact (in_re K (v, b) X)|exact (in_re K (a, v) Y)| | |exact IH].
      + intros g I; apply in_map_iff in I; destruct I as (e & <- & I).
        exact (in_re ((v, a, b) :: K) e (Q e I)).
      + apply (not_re ((v, a, b) :: K) (a', b') (inside _ _ _ _ _ _ G')); [|exact O].
        assert (I := behind _ _ _ _ _ _ G').
        apply (of_M_edges _ _ (inside _ _ _ _ _ _ G')) in I; destruct I as [I J]; split; assumption.
  Qed.

  Lemma closing_renamed : forall tr e, of_M e -> (forall x v a b, In (x, (v, a, b)) tr -> has M v a b) ->
    closing (re e) (map (renamed_step r) tr) = closing e tr.
  Proof.
    induction tr as [|[x [[v a] b]] tr IH]; intros e O H; [reflexivity|].
    assert (H0 := H x v a b (or_introl eq_refl)).
    assert (Ov : In v (vertices M)) by (apply has_vertex with a b, H0).
    assert (Oa : In a (vertices M)) by (apply has_vertex with b v, has_turn, H0).
    assert (Ob : In b (vertices M)) by (apply has_vertex with v a, has_turn, has_turn, H0).
    cbn [map renamed_step closing fst snd renamed]; rewrite !map_length.
    rewrite IH by (auto; intros y u c d I; apply (H y u c d); right; exact I).
    destruct (edge_eq_dec e (b, v)) as [->|D1]; [destruct (edge_eq_dec (re (b, v)) (r b, r v)) as [|D];
      [reflexivity|destruct D; reflexivity]|].
    destruct (edge_eq_dec (re e) (r b, r v)) as [E|_].
    { destruct D1; apply re_inj; auto; split; assumption. }
    destruct (edge_eq_dec e (v, a)) as [->|D2]; [destruct (edge_eq_dec (re (v, a)) (r v, r a)) as [|D];
      [reflexivity|destruct D; reflexivity]|].
    destruct (edge_eq_dec (re e) (r v, r a)) as [E|_]; [|reflexivity].
    destruct D2; apply re_inj; auto; split; assumption.
  Qed.

  Lemma items_renamed : forall tr, (forall x v a b, In (x, (v, a, b)) tr -> has M v a b) ->
    items (map (renamed_step r) tr) = items tr.
  Proof.
    induction tr as [|[x [[v a] b]] tr IH]; intros H; [reflexivity|].
    assert (H0 := H x v a b (or_introl eq_refl)).
    assert (Ht : forall y u c d, In (y, (u, c, d)) tr -> has M u c d)
      by (intros y u c d I; apply (H y u c d); right; exact I).
    change (map (renamed_step r) ((x, (v, a, b)) :: tr))
      with ((x, (r v, r a, r b)) :: map (renamed_step r) tr).
    destruct x; cbn [items]; rewrite IH by exact Ht; try reflexivity.
    do 2 f_equal; apply (closing_renamed tr (a, v)); [|exact Ht]; split; cbn.
    - apply has_vertex with b v, has_turn, H0.
    - apply has_vertex with a b, H0.
  Qed.
End Renaming.

Theorem same_root_same_stream : forall M N r trM pM, surface M -> connected M -> surface N -> connected N ->
  isomorphism r M N -> firstn 1 N = map (renamed r) (firstn 1 M) -> encode M = Some (trM, pM) ->
  exists trN pN, encode N = Some (trN, pN) /\ word_of trN = word_of trM /\ records_of trN = records_of trM.
Proof.
  intros M N r trM pM SM CM SN CN Iso Root EM.
  destruct (encode_total M SM CM) as (tr' & p' & x0 & x1 & x2 & rest & E0 & E1 & W).
  rewrite EM in E1; injection E1 as <- <-.
  assert (G := good_start M SM x0 x1 x2 rest E0).
  destruct (visited M SM _ _ _ _ _ _ _ W G) as (In_M & _).
  destruct (encode_total N SN CN) as (trN & pN & y0 & y1 & y2 & restN & E2 & E3 & WN).
  rewrite E0, E2 in Root; cbn in Root; injection Root as -> -> ->.
  assert (W' := walk_renamed M N r SM Iso _ _ _ _ _ _ _ W G); cbn [map renamed] in W'.
  exists trN, pN; split; [exact E3|].
  set (n := length trN + length (map (renamed_step r) trM)).
  assert (A := Walk_is_walk N _ _ _ _ _ _ _ (once N SN) W' n ltac:(unfold n; lia)).
  assert (B := Walk_is_walk N _ _ _ _ _ _ _ (once N SN) WN n ltac:(unfold n; lia)).
  rewrite A in B; injection B as <- _.
  assert (Wd : word_of (map (renamed_step r) trM) = word_of trM).
  { unfold word_of; rewrite map_map; reflexivity. }
  split; [exact Wd|]; unfold records_of; rewrite Wd, (items_renamed M N r Iso); [reflexivity|].
  intros x v a b I; apply In_M; left; unfold after; apply in_app_iff; left; apply -> in_rev.
  apply in_map_iff; exists (x, (v, a, b)); auto.
Qed.

(** Streams tell rooted surfaces apart exactly. *)
Corollary stream_is_of_rooted_surface : forall M N trM trN pM pN,
  surface M -> connected M -> surface N -> connected N ->
  encode M = Some (trM, pM) -> encode N = Some (trN, pN) ->
  (word_of trM = word_of trN /\ records_of trM = records_of trN <->
   exists r, isomorphism r M N /\ firstn 1 N = map (renamed r) (firstn 1 M)).
Proof.
  intros M N trM trN pM pN SM CM SN CN EM EN; split.
  - intros [Wd Rc].
    destruct (same_stream_same_surface M N trM trN pM pN SM CM SN CN EM EN Wd Rc) as (r & Iso & F).
    exists r; split; [exact Iso|].
    assert (NM := not_empty M SM); assert (NN := not_empty N SN).
    destruct M as [|f M]; [congruence|]; destruct N as [|g N]; [congruence|].
    cbn in F; injection F as F _; cbn; rewrite F; reflexivity.
  - intros (r & Iso & Root).
    destruct (same_root_same_stream M N r trM pM SM CM SN CN Iso Root EM) as (tr & p & E & A & B).
    rewrite EN in E; injection E as <- <-; auto.
Qed.

(** One accepted word for each rooted sphere, up to isomorphism: every sphere has the word of one
    decoded sphere, and different decoded spheres are different rooted spheres. *)
Corollary words_are_rooted_spheres :
  (forall M, sphere M -> exists w F r, decode w = Some F /\ isomorphism r F M /\
    firstn 1 M = map (renamed r) (firstn 1 F)) /\
  (forall w u F G r, decode w = Some F -> decode u = Some G -> isomorphism r F G ->
    firstn 1 G = map (renamed r) (firstn 1 F) -> w = u).
Proof.
  split.
  - intros M Sp; destruct (decode_encode M Sp) as (tr & F & E & D & Iso & Fs).
    exists (map fst tr), F, (fun i => nth i (order M tr) 0); repeat split; try apply Iso; [exact D|].
    destruct Sp as (SM & _); assert (NM := not_empty M SM); destruct M as [|f M]; [congruence|].
    apply decode_inv in D; destruct D as (t & G & _ & _ & -> & _).
    cbn [map firstn app] in *; injection Fs as Fs _; cbn; rewrite <- Fs; reflexivity.
  - intros w u F G r DF DG Iso Root.
    destruct (decoded_is_sphere _ _ DF) as (SF & CF & _), (decoded_is_sphere _ _ DG) as (SG & CG & _).
    destruct (encode_decode _ _ DF) as (trF & EF & <- & _), (encode_decode _ _ DG) as (trG & EG & <- & _).
    destruct (same_root_same_stream F G r trF [] SF CF SG CG Iso Root EF) as (tr & p & E & A & _).
    rewrite EG in E; injection E as <- <-; symmetry; exact A.
Qed.
