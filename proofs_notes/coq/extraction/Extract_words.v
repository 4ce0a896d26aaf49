(** The proved decoder of Decoder.v and encoder of Traversal.v as OCaml: words of one closed component
    without records. Natural numbers become machine integers: they count faces and vertices. *)
From Clers Require Import Letters Words Decoder Traversal Round_trip.
Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt.
Extraction "sphere.ml" Words.undone Words.len Decoder.decode
  Traversal.encode Round_trip.order.
