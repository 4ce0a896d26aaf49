#!/bin/sh
# Checks every proof of this folder with Coq; nothing compiled is left behind.
#
#   check.sh            check all
#   check.sh FOLDER     the same, and keep what is compiled in FOLDER
#
# All *.v files are compiled in the order of their imports. Then Coq is asked on what each theorem
# rests: every Theorem and Corollary of the files, and every name that a note beside this folder
# gives as `Clers.File.name`. The answer must be: on nothing. Needs coq, make and awk.
set -eu
cd "$(dirname "$0")"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp _CoqProject ./*.v "$work"
cp ../*.md "$work" 2>/dev/null || true
into=${1:-}
[ -z "$into" ] || into=$(mkdir -p "$into" && cd "$into" && pwd)
cd "$work"
set -- *.v

# The files without what is in comments.
mkdir bare
for file; do
  awk '{
    out = ""
    for (i = 1; i <= length($0); i++) {
      two = substr($0, i, 2)
      if (two == "(*") { depth++; i++ }
      else if (two == "*)" && depth) { depth--; i++ }
      else if (!depth) out = out substr($0, i, 1)
    }
    print out
  }' "$file" >"bare/$file"
done

# 1. Nothing is assumed and nothing is left out.
words='Axioms?|Parameters?|Conjectures?|Admitted|admit|give_up|Admit Obligations|Unset (Guard|Positivity|Universe) Check(ing)?|bypass_check'
if (cd bare && grep -nwE "$words" ./*.v); then
  echo "check.sh: a proof assumes something" >&2
  exit 1
fi

# 2. Everything compiles.
coq_makefile -f _CoqProject "$@" -o Makefile >/dev/null
make -j 2 --no-print-directory -s || { echo "check.sh: a file does not compile" >&2; exit 1; }

# 3. Every theorem rests on nothing. Here a line is a sentence, and a name has its modules before it.
for file; do
  { tr '\n' ' ' <"bare/$file"; echo; } | sed 's/\. /.\n/g' | awk -v name="Clers.${file%.v}." '
    $1 == "Module" && $2 != "Type" && !/:=/ { sub(/\..*/, "", $2); at[++depth] = $2 "." ; next }
    $1 == "Section" { at[++depth] = ""; next }
    $1 == "End" { if (depth) depth--; next }
    {
      for (i = 1; i <= 2; i++)
        if ($i == "Theorem" || $i == "Corollary") {
          path = ""
          for (d = 1; d <= depth; d++) path = path at[d]
          theorem = $(i + 1); sub(/[^A-Za-z0-9_'"'"'].*/, "", theorem)
          print name path theorem
          break
        }
    }'
done >theorems
grep -ohE '`Clers(\.[A-Za-z0-9_'"'"']+){2,}`' ./*.md 2>/dev/null | tr -d '`' >named || true
sort -u theorems named >all
{
  for file; do echo "From Clers Require ${file%.v}."; done
  while read -r name; do
    printf 'Goal True. idtac "? %s". Abort.\nPrint Assumptions %s.\n' "$name" "$name"
  done <all
} >asked.v
coqc -q -Q . Clers asked.v >answers || { echo "check.sh: a note names what there is not" >&2; exit 1; }
awk '
  $1 == "?" { name = $2; next }
  $0 == "Closed under the global context" { next }
  { print name ": " $0; bad = 1 }
  END { exit bad }' answers || { echo "check.sh: a theorem rests on something" >&2; exit 1; }
closed=$(grep -c '^Closed under the global context$' answers || true)
if [ "$closed" -ne "$(wc -l <all)" ]; then
  echo "check.sh: $closed answers for $(wc -l <all) theorems" >&2
  exit 1
fi

[ -z "$into" ] || cp "$@" ./*.vo "$into"
echo "$# files, $(wc -l <theorems) theorems, $(cat "$@" | wc -l) lines: all checked, nothing assumed"
