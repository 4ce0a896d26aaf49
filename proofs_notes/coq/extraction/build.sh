#!/bin/sh
# Builds an adapter out of proved functions: extracted from Coq, compiled with OCaml's own compiler.
#
#   build.sh PROGRAM            compile the proofs, extract, and write the program there
#   build.sh PROGRAM COMPILED   the same, with the proofs that check.sh left in the folder COMPILED
set -eu
[ $# -ge 1 ] || { echo "usage: build.sh PROGRAM [COMPILED]" >&2; exit 2; }
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
compiled=${2:-}
[ -z "$compiled" ] || compiled=$(cd "$compiled" && pwd)
cd "$(dirname "$0")"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp ./*.v ./*.ml "$work"
if [ -z "$compiled" ]; then
  compiled=$work/proofs
  mkdir "$compiled"
  cp ../*.v ../_CoqProject "$compiled"
  # Of all proofs, those that the extracted functions are in.
  needed=$(cd "$compiled" && coqdep -Q . Clers -sort "$work"/Extract_*.v 2>/dev/null | tr ' ' '\n' | grep -v Extract_)
  (cd "$compiled" && for file in $needed; do coqc -q -Q . Clers "$file"; done)
fi
cd "$work"
for file in Extract_*.v; do
  coqc -q -w -extraction-reserved-identifier,-extraction-opaque-accessed -Q "$compiled" Clers "$file"
done
# Extracted modules first, then what reads and writes.
extracted=$(sed -n 's/^Extraction "\(.*\)\.ml".*/\1/p' Extract_*.v)
set --
for module in $extracted; do set -- "$@" "$module.mli" "$module.ml"; done
ocamlopt -w -a "$@" json.ml protocol.ml arithmetic.ml words.ml drive.ml -o "$program"
