"""The vectors of a suite by the clauses that they test. Clause: TOOL-SITE-4."""

from collections import defaultdict
from pathlib import Path

from clers.conventions.result import Accepted, Rejected
from clers.oracle.suite.files import read_suite
from clers.site.dossier import Vectors


def by_clause(folder: Path) -> Accepted[dict[str, tuple[Vectors, ...]]] | Rejected:
    """For each clause its cases by profile and operation, in the suite's order.

    Rejects a suite that is not as its manifest says.
    """
    suite = read_suite(folder)
    if isinstance(suite, Rejected):
        return suite
    found: defaultdict[str, list[Vectors]] = defaultdict(list)
    for part in suite.value.parts:
        cases: defaultdict[str, list[str]] = defaultdict(list)
        for case in part.cases:
            for clause in case.clauses:
                cases[str(clause)].append(case.id)
        for clause, names in cases.items():
            found[clause].append(Vectors(part.profile, part.op, tuple(names)))
    return Accepted({clause: tuple(some) for clause, some in found.items()})
