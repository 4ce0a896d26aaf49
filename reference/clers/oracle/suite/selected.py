"""Some cases of a suite, by what they are about; some profiles as a suite. Clause: ORCL-SUITE-9."""

from collections.abc import Collection, Iterator, Mapping
from pathlib import Path
from typing import Final

from msgspec import UnsetType
from msgspec.structs import replace

from clers.conformance.cases.case import Case
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.oracle.suite.files import MANIFEST, Suite, fault, read_bytes
from clers.oracle.suite.rendered import suite_files
from clers.oracle.suite.written import write_suite

ALL: Final = ""
"""Instead of a profile, operation, clause or flag: whatever it is."""


def matching(
    suite: Suite, profile: str = ALL, op: str = ALL, clause: str = ALL, flag: str = ALL
) -> Iterator[tuple[str, Case]]:
    """The cases that match all four, each with its profile. Clause: ORCL-SUITE-10."""
    for part in suite.parts:
        for case in part.cases:
            if (
                profile in (ALL, part.profile)
                and op in (ALL, case.op)
                and (clause == ALL or clause in case.clauses)
                and (flag == ALL or flag in case.flags)
            ):
                yield part.profile, case


def unknown(suite: Suite, profile: str, op: str, clause: str, flag: str) -> str:
    """The first of four words that no case has, or an empty string."""
    known: Mapping[str, Collection[str]] = {
        profile: {part.profile for part in suite.parts},
        op: {part.op for part in suite.parts},
        clause: {name for case in suite.cases for name in case.clauses},
        flag: {name for case in suite.cases for name in case.flags},
    }
    return next((word for word, there in known.items() if word != ALL and word not in there), "")


def some_profiles(suite: Suite, profiles: Collection[str]) -> Suite:
    """The cases of some profiles, with the parents of their faults, as a suite of their own.

    Flags that none has are left out, and so are successors that are not there. ORCL-SUITE-9.
    """
    chosen = [case for part in suite.parts if part.profile in profiles for case in part.cases]
    parents = {case.fault.parent for case in chosen if not isinstance(case.fault, UnsetType)}
    parts = tuple(
        replace(
            part,
            cases=tuple(
                case for case in part.cases if part.profile in profiles or case.id in parents
            ),
        )
        for part in suite.parts
    )
    kept = tuple(part for part in parts if part.cases)
    cases = [case for part in kept for case in part.cases]
    used = {flag for case in (*cases, *suite.canaries) for flag in case.flags}
    known = {case.id for case in cases} | {entry.id for entry in suite.retired}
    return Suite(
        suite.manifest,
        kept,
        tuple(flag for flag in suite.flags if flag.name in used),
        tuple(
            entry if entry.successor in known else replace(entry, successor="")
            for entry in suite.retired
        ),
        suite.canaries,
    )


def copy_suite(
    folder: Path, suite: Suite, into: Path, profiles: Collection[str] = ()
) -> Accepted[tuple[str, ...]] | Rejected:
    """Write a suite, whole or some profiles, into a folder that is empty or not there.

    The paths that were written. The inputs of generation and the mutation score come along with
    the whole suite only. Clause: ORCL-SUITE-9.
    """
    if into.exists() and (not into.is_dir() or any(into.iterdir())):
        return fault(Reason.UNWRITABLE_FILE, str(into), "it is not empty")
    if profiles:
        part = some_profiles(suite, profiles)
        return write_suite(
            into, suite_files(part.parts, part.flags, part.retired, part.canaries, {})
        )
    files: dict[str, bytes] = {}
    for path in (MANIFEST, *suite.paths):
        data = read_bytes(folder, path)
        if isinstance(data, Rejected):
            return data
        files[path] = data.value
    return write_suite(into, files)
