"""In which order a mutant meets the cases, so that a mistake shows soon. ORCL-MUTANT-4."""

from collections import Counter
from collections.abc import Sequence
from typing import Final

from clers.conformance.cases.case import Case
from clers.oracle.mutants.mutant import Mutant

ASKED_OF: Final = (
    ("clers.kernels.table", ("surface.classify", "word.encode")),
    ("clers.kernels.walk", ("word.encode",)),
    ("clers.kernels.scan", ("word.decode",)),
    ("clers.kernels.gluing", ("word.decode",)),
    ("clers.kernels.naming", ("word.decode",)),
    ("clers.kernels.interval", ("arithmetic.encode", "arithmetic.decode")),
    ("clers.kernels.automaton", ("arithmetic.encode", "arithmetic.decode")),
    ("clers.kernels", ("code.encode", "code.decode")),
    ("clers.complexes", ("surface.classify", "word.encode")),
    ("clers.operators", ("operator.apply",)),
    ("clers.edgebreaker.encode", ("word.encode",)),
    ("clers.edgebreaker", ("word.decode",)),
    ("clers.arithmetic", ("arithmetic.encode", "arithmetic.decode")),
    ("clers.information", ("arithmetic.encode", "arithmetic.decode", "code.encode")),
    ("clers.codes", ("code.encode", "code.decode")),
    ("clers.geometry", ("mesh.encode", "mesh.decode")),
    ("clers.container", ("mesh.encode", "mesh.decode")),
)
"""The operations that show a mistake in a module soon; the first entry that begins its name."""


def in_order(cases: Sequence[Case], mutant: Mutant) -> tuple[Case, ...]:
    """First cases that cite the clause, then those of likely operations, then all others.

    Among them the operations take turns, and each keeps its order. Clause: ORCL-MUTANT-4.
    """
    likely = next((ops for start, ops in ASKED_OF if mutant.module.startswith(start)), ())
    turn: Counter[tuple[int, str]] = Counter()
    keyed: list[tuple[int, int, int]] = []
    for place, case in enumerate(cases):
        rank = 0 if mutant.clause in case.clauses else 1 if case.op in likely else 2
        turn[rank, case.op] += 1
        keyed.append((rank, turn[rank, case.op], place))
    return tuple(cases[place] for _, _, place in sorted(keyed))
