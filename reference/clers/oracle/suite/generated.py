"""The whole suite, made anew: every case with its profile, and the files. Clause: ORCL-SUITE-5."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Final

from msgspec import UNSET

from clers.conformance.cases.case import Case
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.oracle.negatives import FLAGS as FLAGS_OF_NEGATIVES
from clers.oracle.negatives import canaries, negatives
from clers.oracle.positives.all_families import FAMILIES
from clers.oracle.positives.asked import answered
from clers.oracle.positives.flags import FLAGS
from clers.oracle.positives.real import MESHES
from clers.oracle.suite.adding import Found, shrunk
from clers.oracle.suite.files import MANIFEST, Suite, fault, read_bytes, read_unsealed
from clers.oracle.suite.profiles import profile_of
from clers.oracle.suite.records import Flag
from clers.oracle.suite.rendered import parts_of, suite_files
from clers.oracle.suite.retiring import Reused, Unretired, retire
from clers.oracle.suite.written import present

INPUTS: Final = "inputs/"
"""Where a suite keeps what is not made by code. Clause: ORCL-SUITE-5."""

STEPS: Final = len(FAMILIES) + 1
"""How often `generate` says what it begins."""

Files = dict[str, bytes]


def inputs_of(folder: Path) -> Accepted[Files] | Rejected:
    """The literal inputs in the folder of a suite, by their paths there. Clause: ORCL-SUITE-5."""
    found: Files = {}
    for path in present(folder):
        if path.startswith(INPUTS):
            data = read_bytes(folder, path)
            if isinstance(data, Rejected):
                return data
            found[path] = data.value
    return Accepted(found)


def before(folder: Path) -> Accepted[Suite | None] | Rejected:
    """The suite that a folder has, if there is one; what it says of checksums is not asked."""
    return read_unsealed(folder) if (folder / MANIFEST).exists() else Accepted(None)


def all_cases(
    inputs: Mapping[str, bytes], findings: Sequence[Found], step: Callable[[str], None]
) -> tuple[tuple[str, Case], ...]:
    """Every case with its profile, positives before negatives. Clause: ORCL-SUITE-5.

    A case that two families ask under one id is there once.
    """
    found: dict[str, tuple[str, Case]] = {}
    for name, family in FAMILIES.items():
        step(name)
        for asked in family(inputs):
            case = answered(asked)
            found.setdefault(case.id, (profile_of(case), case))
    for one in findings:
        found.setdefault(one.case.id, (one.profile, one.case))
    step("negatives")
    parents = {name: case for name, (_, case) in found.items()}
    for profile, _, case in negatives(parents):
        found.setdefault(case.id, (profile, case))
    return tuple(found.values())


def all_flags() -> tuple[Flag, ...]:
    """Every flag that cases may have, explained. Clause: ORCL-CASE-5."""
    return (*FLAGS, *FLAGS_OF_NEGATIVES)


def generate(
    inputs: Mapping[str, bytes],
    old: Suite | None,
    reason: str = "",
    step: Callable[[str], None] = lambda _: None,
) -> Files | Unretired | Reused | Rejected:
    """The files of the suite; of the old one its score and what is retired are kept.

    Rejected where a file of the inputs is none, or the meshes of the corpus are not there.
    Clauses: ORCL-SUITE-5, ORCL-SUITE-6.
    """
    if not MESHES.is_dir():
        return fault(Reason.UNREADABLE_FILE, str(MESHES), "not there: a checkout is needed")
    findings = shrunk(inputs)
    if isinstance(findings, Rejected):
        return findings
    cases = all_cases(inputs, findings.value, step)
    gone = retire(
        old.cases if old else (),
        tuple(case for _, case in cases),
        old.retired if old else (),
        reason,
    )
    if isinstance(gone, Unretired | Reused):
        return gone
    score = old.manifest.mutation if old else UNSET
    return suite_files(parts_of(cases), all_flags(), gone, canaries(), inputs, score)
