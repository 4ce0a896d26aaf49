"""What must hold of the cases together: ids, flags, what is retired. Clause: ORCL-SUITE-4."""

from collections import Counter
from collections.abc import Iterable, Iterator

from clers.conventions.clause import Clause
from clers.oracle.suite.files import CANARIES, FLAGS, RETIRED, Suite
from clers.oracle.suite.problem import Problem
from clers.oracle.suite.rendered import part_path


def of_ids(suite: Suite) -> Iterator[Problem]:
    """No id twice, none of what is retired. Clauses: ORCL-CASE-2, ORCL-SUITE-6."""
    gone = {entry.id for entry in suite.retired}
    met: dict[str, str] = {}
    for file, name in _places(suite):
        if name in met:
            yield Problem(file, f"its id is in {met[name]} too", Clause.ORCL_CASE_2, name)
        if name in gone:
            yield Problem(file, "its id is retired", Clause.ORCL_SUITE_6, name)
        met[name] = file


def _places(suite: Suite) -> Iterator[tuple[str, str]]:
    for part in suite.parts:
        for case in part.cases:
            yield part_path(part.profile, part.op), case.id
    for case in suite.canaries:
        yield CANARIES, case.id


def of_retired(suite: Suite) -> Iterator[Problem]:
    """Each has a reason, and a successor that is or was in the suite. Clause: ORCL-SUITE-6."""
    known = {case.id for case in suite.cases} | {entry.id for entry in suite.retired}
    for name in _twice(entry.id for entry in suite.retired):
        yield Problem(RETIRED, "it is there twice", Clause.ORCL_SUITE_6, name)
    for entry in suite.retired:
        if not entry.reason:
            yield Problem(RETIRED, "it has no reason", Clause.ORCL_SUITE_6, entry.id)
        if entry.successor and entry.successor not in known:
            what = f"its successor {entry.successor} is not in the suite"
            yield Problem(RETIRED, what, Clause.ORCL_SUITE_6, entry.id)


def of_flags(suite: Suite) -> Iterator[Problem]:
    """Each flag is explained, and once. Clause: ORCL-CASE-5."""
    explained = {flag.name for flag in suite.flags}
    for name in _twice(flag.name for flag in suite.flags):
        yield Problem(FLAGS, f"{name} is explained twice", Clause.ORCL_CASE_5)
    used = {flag for case in (*suite.cases, *suite.canaries) for flag in case.flags}
    for name in sorted(used - explained):
        yield Problem(FLAGS, f"{name} is not explained", Clause.ORCL_CASE_5)
    for name in sorted(explained - used):
        yield Problem(FLAGS, f"no case has {name}", Clause.ORCL_CASE_5)


def _twice(names: Iterable[str]) -> list[str]:
    return [name for name, count in Counter(names).items() if count > 1]
