(** The proved decoder of Decoder.v as OCaml: words of one closed component without records. Natural
    numbers become machine integers here: they count faces and vertices. *)
From Clers Require Import Letters Words Decoder.
Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt.
Extraction "sphere.ml" Words.undone Words.len Decoder.decode.
