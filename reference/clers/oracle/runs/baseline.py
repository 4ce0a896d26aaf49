"""Known failures: read, held against a run, and written anew. ORCL-BASELINE-1 … ORCL-BASELINE-5."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import msgspec
from msgspec import Struct

from clers.conformance.cases.case import Name
from clers.conformance.judging.judged import GOOD, Judged, Status
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.oracle.suite.files import Suite


class Known(Struct, frozen=True, forbid_unknown_fields=True):
    """A failure that is known. Clause: ORCL-BASELINE-1."""

    id: Name
    status: Status
    signature: str


class Baseline(Struct, frozen=True, forbid_unknown_fields=True):
    """The known failures of an adapter, by id. Clause: ORCL-BASELINE-1."""

    suite: str
    known: tuple[Known, ...]


@dataclass(frozen=True, slots=True)
class Stale:
    """An id that the suite does not have, and what became of it. Clause: ORCL-BASELINE-4."""

    id: str
    fate: str


def read_baseline(path: Path) -> Accepted[Baseline] | Rejected:
    """The baseline in a file. Clauses: ORCL-BASELINE-1, ORCL-BASELINE-5."""
    try:
        baseline = msgspec.json.decode(path.read_bytes(), type=Baseline)
    except OSError as fault:
        return _none(fault.strerror or str(fault))
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as fault:
        return _none(str(fault))
    bad = [known.id for known in baseline.known if known.status in (*GOOD, Status.XPASS)]
    return _none(f"{bad[0]} is no failure") if bad else Accepted(baseline)


def _none(why: str) -> Rejected:
    return Rejected(Reason.UNREADABLE_FILE, Clause.ORCL_BASELINE_1, detail=why)


def baseline_bytes(baseline: Baseline) -> bytes:
    """The file of a baseline: one failure a line, by id. Clause: ORCL-BASELINE-1."""
    rows = sorted(baseline.known, key=lambda known: known.id)
    lines = b",\n".join(map(msgspec.json.encode, rows))
    suite = msgspec.json.encode(baseline.suite)
    return b'{"suite":%b,"known":[%b]}\n' % (suite, b"\n%b\n" % lines if rows else b"")


class Expected:
    """The known failures by id, to hold results against. Clause: ORCL-BASELINE-2."""

    def __init__(self, known: Iterable[Known] = ()) -> None:
        self._known = {entry.id: entry for entry in known}

    def of(self, judged: Judged) -> Judged:
        """The result, seen by who knows the failures. Clause: ORCL-BASELINE-2."""
        entry = self._known.get(judged.id)
        if entry is None or judged.status is Status.SKIP:
            return judged
        if judged.status is Status.PASS:
            status = Status.XFAIL if entry.status is Status.FLAKY else Status.XPASS
            return _seen(judged, status, f"known as {entry.status}, it passes")
        if (entry.status, entry.signature) == (judged.status, judged.signature):
            return _seen(judged, Status.XFAIL, judged.why)
        return _seen(judged, judged.status, f"{judged.why} (known otherwise: {_named(entry)})")


def _seen(judged: Judged, status: Status, why: str) -> Judged:
    return msgspec.structs.replace(judged, status=status, why=why)


def _named(entry: Known) -> str:
    return entry.signature or str(entry.status)


def written(suite: Suite, results: Iterable[Judged], before: Baseline | None) -> Baseline:
    """The failures of a run, before they were held against anything, as a baseline.

    Of `before` the cases that the run did not judge are kept, if the suite has them.
    Clause: ORCL-BASELINE-3.
    """
    judged = {result.id: result for result in results if result.status is not Status.SKIP}
    there = {case.id for case in suite.cases}
    kept = [
        known
        for known in (before.known if before is not None else ())
        if known.id in there and known.id not in judged
    ]
    failures = [
        Known(result.id, result.status, result.signature)
        for result in judged.values()
        if result.status not in GOOD
    ]
    return Baseline(suite.manifest.suite, (*kept, *failures))


def stale(suite: Suite, baseline: Baseline) -> tuple[Stale, ...]:
    """The ids that the suite does not have, as they stand. Clause: ORCL-BASELINE-4."""
    there = {case.id for case in suite.cases}
    retired = {entry.id: entry for entry in suite.retired}
    found: list[Stale] = []
    for known in baseline.known:
        if known.id in there:
            continue
        entry = retired.get(known.id)
        if entry is None:
            found.append(Stale(known.id, "unknown to the suite"))
        elif entry.successor:
            found.append(Stale(known.id, f"retired, now {entry.successor}: {entry.reason}"))
        else:
            found.append(Stale(known.id, f"retired: {entry.reason}"))
    return tuple(found)
