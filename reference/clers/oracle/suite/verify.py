"""All that must hold of a suite in a folder. Clause: ORCL-SUITE-4."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.result import Rejected
from clers.oracle.suite.answers import of_answer, of_canary
from clers.oracle.suite.files import CANARIES, Suite, read_unsealed
from clers.oracle.suite.folders import of_folder
from clers.oracle.suite.problem import Problem
from clers.oracle.suite.rendered import part_path
from clers.oracle.suite.single import of_case
from clers.oracle.suite.together import of_flags, of_ids, of_retired

STEPS: Final = 60
"""About how many times `verify` says what it begins: once for each file of cases, and thrice."""


def verify(folder: Path, step: Callable[[str], None] = lambda _: None) -> tuple[Problem, ...]:
    """What does not hold of the suite in a folder, nothing if all does. Clause: ORCL-SUITE-4.

    A file that cannot be read at all is the only problem then.
    """
    step("files")
    read = read_unsealed(folder)
    if isinstance(read, Rejected):
        file, _, what = read.detail.partition(": ")
        return (Problem(file, f"{read.reason}: {what}", Clause.ORCL_SUITE_1),)
    suite = read.value
    return (
        *of_folder(folder, suite),
        *of_ids(suite),
        *of_retired(suite),
        *of_flags(suite),
        *_of_cases(suite, step),
    )


def _of_cases(suite: Suite, step: Callable[[str], None]) -> Iterator[Problem]:
    known = {case.id: case for case in suite.cases}
    for part in suite.parts:
        file = part_path(part.profile, part.op)
        step(file)
        for case in part.cases:
            found = tuple(of_case(file, part.profile, part.op, case))
            yield from found or of_answer(file, case, known)
    step(CANARIES)
    for case in suite.canaries:
        yield from of_canary(case)
