"""Many mutants over the cases of a suite, some at a time."""

from collections.abc import Generator, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from clers.conformance.cases.case import Case
from clers.conventions.result import Rejected
from clers.oracle.mutants.every import BY_NAME
from clers.oracle.mutants.likely import in_order
from clers.oracle.mutants.trial import Fate, Tried, tried
from clers.oracle.pool.place import Local, Lost
from clers.oracle.pool.spread import spread
from clers.oracle.suite.files import read_suite


@dataclass(frozen=True, slots=True)
class Item:
    """A mutant made by hand, by its name, and the folder of the suite that it meets."""

    name: str
    folder: str


def run(names: Sequence[str], folder: Path, workers: int) -> Generator[Tried, None, None]:
    """The fate of each mutant, in order, as it is known. Clause: ORCL-MUTANT-3.

    Close it to end what still runs.
    """
    items = [Item(name, str(folder)) for name in names]
    with closing(spread(try_one, items, Local(workers))) as fates:
        for found in fates:
            yield Tried(Fate.LOST, 0, why=found.why) if isinstance(found, Lost) else found


def try_one(item: Item) -> Iterator[Tried]:
    """One mutant beside the cases, the likely killers first. ORCL-MUTANT-2 … ORCL-MUTANT-4."""
    yield tried([item.name], in_order(cases_of(item.folder), BY_NAME[item.name]))


@lru_cache(maxsize=1)
def cases_of(folder: str) -> tuple[Case, ...]:
    """The cases of a suite that was found to be good; read once by each process."""
    found = read_suite(Path(folder))
    if isinstance(found, Rejected):
        raise AssertionError(f"the suite is no longer good: {found.line()}")
    return found.value.cases
