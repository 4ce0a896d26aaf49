"""The score in the manifest of a suite. Clause: ORCL-MUTANT-6."""

from pathlib import Path

import msgspec

from clers.conventions.result import Accepted, Rejected
from clers.meshfile.atomic import write_bytes
from clers.oracle.mutants.report import Report
from clers.oracle.mutants.trial import Fate
from clers.oracle.suite.files import MANIFEST, read_suite
from clers.oracle.suite.records import Score, Survivor
from clers.oracle.suite.rendered import manifest_bytes


def score_of(found: Report) -> Score:
    """A report as the manifest has it. Clause: ORCL-MUTANT-6."""
    return Score(
        suite=found.suite,
        mutants=len(found.rows),
        killed=found.killed,
        survivors=tuple(
            Survivor(mutant=row.name, why=row.explained)
            for row in found.rows
            if row.fate is not Fate.KILLED
        ),
    )


def write_score(folder: Path, score: Score) -> Accepted[Path] | Rejected:
    """Put a score into a suite's manifest; nothing else of it changes. Clause: ORCL-MUTANT-6."""
    suite = read_suite(folder)
    if isinstance(suite, Rejected):
        return suite
    manifest = msgspec.structs.replace(suite.value.manifest, mutation=score)
    return write_bytes(folder / MANIFEST, manifest_bytes(manifest))
