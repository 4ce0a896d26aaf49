(** The proved coder of Learner.v as OCaml. Numbers stay what they are in Coq: nothing is replaced by
    machine integers, so that nothing has to be said about their size. *)
From Clers Require Import Model Learner.
Require Import ZArith Extraction ExtrOcamlBasic.
Extraction "coder.ml" Learner.checked Learner.encode_with Learner.decode_with Z.add Z.mul Z.opp.
