(** The proved encoder of Traversal.v and the proved decoders of Decoder.v and Rebuild.v as OCaml: one
    closed component, of any genus. Natural numbers become machine integers: they count faces and vertices. *)
From Clers Require Import Letters Words Decoder Traversal Reversi Round_trip Numbering Stream Rebuild.
Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt.
Extraction "sphere.ml" Words.undone Words.len Decoder.decode
  Traversal.encode Round_trip.order
  Decoder.simple Stream.records_of Rebuild.decode_stream.
