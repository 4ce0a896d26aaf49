"""Mutants that a tool draws, beside the cases: what did nobody think of? ORCL-MUTANT-7."""

from collections.abc import Generator, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from clers.conformance.cases.case import Case
from clers.measure.mutation.mutant import difference, mutated
from clers.measure.mutation.outcome import ON_IMPORT
from clers.measure.mutation.sample import Drawn, draw, subjects
from clers.oracle.mutants.campaign import cases_of
from clers.oracle.mutants.reached import Lines, Reached
from clers.oracle.mutants.trial import Fate, Tried, tried
from clers.oracle.pool.place import Local, Lost
from clers.oracle.pool.spread import spread


@dataclass(frozen=True, slots=True)
class Item:
    """A module with another source, and the numbers of the cases that can tell."""

    folder: str
    module: str
    source: str
    cases: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Found:
    """A drawn mutant, its change by lines, and its fate. Clause: ORCL-MUTANT-7."""

    module: str
    place: str
    kind: str
    difference: str
    tried: Tried


@dataclass(frozen=True, slots=True)
class Sample:
    """How many mutants there are, and those that were drawn. Clause: ORCL-MUTANT-7."""

    mutants: int
    drawn: tuple[Drawn, ...]


def sample(known: Reached, number: int, seed: int) -> Sample:
    """So many mutants of the modules that serving executes, by the seed alone. ORCL-MUTANT-7."""
    found = subjects(sorted(known.modules), ())
    assert not isinstance(found, str), "what was imported can be found"
    total, drawn = draw(found, "clers", number, seed)
    return Sample(total, drawn)


def able(drawn: Drawn, lines: Lines, count: int) -> tuple[int, ...]:
    """The numbers of the cases that execute the changed statement; all if importing does.

    Clause: ORCL-MUTANT-7.
    """
    span = range(drawn.mutant.first, drawn.mutant.last + 1)
    at = {by for line in span for by in lines.get(line, ())}
    return tuple(range(count)) if ON_IMPORT in at else tuple(sorted(at))


def run(
    of: Sample, known: Reached, folder: Path, count: int, workers: int
) -> Generator[Found, None, None]:
    """The fate of each drawn mutant, in order, as it is known. Clause: ORCL-MUTANT-7."""
    items = [
        Item(
            str(folder),
            drawn.subject.module,
            mutated(drawn.subject.source, drawn.mutant),
            able(drawn, known.modules[drawn.subject.module], count),
        )
        for drawn in of.drawn
    ]
    with closing(spread(try_one, items, Local(workers))) as fates:
        for drawn, fate in zip(of.drawn, fates, strict=True):
            yield Found(
                drawn.subject.module,
                drawn.mutant.place,
                drawn.mutant.kind,
                difference(drawn.subject.source, drawn.mutant),
                Tried(Fate.LOST, 0, why=fate.why) if isinstance(fate, Lost) else fate,
            )


def try_one(item: Item) -> Iterator[Tried]:
    """One source beside the cases that execute what is other in it. Clause: ORCL-MUTANT-7."""
    if not item.cases:
        yield Tried(Fate.UNREACHED, 0)
        return
    every = cases_of(item.folder)
    with TemporaryDirectory() as place:
        file = Path(place) / "source.py"
        file.write_text(item.source, encoding="utf-8")
        yield tried((item.module, str(file)), mixed([every[number] for number in item.cases]))


def mixed(cases: Sequence[Case]) -> tuple[Case, ...]:
    """Operations and profiles by turns, though each kind of case comes in order."""
    turn: dict[str, int] = {}
    keyed: list[tuple[int, int]] = []
    for place, case in enumerate(cases):
        turn[case.op] = turn.get(case.op, 0) + 1
        keyed.append((turn[case.op], place))
    return tuple(cases[place] for _, place in sorted(keyed))
