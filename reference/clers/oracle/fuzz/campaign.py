"""A campaign: all families of an adapter, in turn or by several workers. ORCL-FUZZ-3, ORCL-FUZZ-4.

Each finding is written when it is found, and again when it is shrunk.
"""

from collections.abc import Generator, Iterator
from contextlib import ExitStack
from dataclasses import dataclass, replace
from math import inf
from pathlib import Path
from time import monotonic
from typing import Final, assert_never

from clers.conformance.bounds import DEFAULT_BOUNDS, Bounds
from clers.conformance.outcome import NoProcess
from clers.conformance.session import Session
from clers.conventions.result import Rejected
from clers.oracle.finding import Finding, Party, write
from clers.oracle.fuzz.checks import Asker, asker
from clers.oracle.fuzz.families import Family, families, opposed
from clers.oracle.fuzz.found import finding as finding_of
from clers.oracle.fuzz.found import party, shrunk_from
from clers.oracle.fuzz.hunt import Event, First, Round, Small, hunt
from clers.oracle.pool.place import Cluster, Local, Lost, Place
from clers.oracle.pool.spread import spread

EXAMPLES: Final = 300
"""Examples of each operation where neither a number nor a time is given."""

ENDLESS: Final = 1 << 62
RESTARTS: Final = 1 << 20
"""An adapter that crashes is started as often as it takes; ORCL-FUZZ-5 bounds that instead."""


@dataclass(frozen=True, slots=True)
class Plan:
    """What a campaign is to do. `examples` are for each operation, `seconds` for all together.

    `scheduler` is the address of a Dask scheduler, `workers` how many it has, or this machine.
    """

    command: tuple[str, ...]
    folder: Path
    against: tuple[str, ...] = ()
    only: tuple[str, ...] = ()
    number: int = 0
    examples: int | None = None
    seconds: float | None = None
    workers: int = 1
    scheduler: str = ""
    bounds: Bounds = DEFAULT_BOUNDS


@dataclass(frozen=True, slots=True)
class Wrote:
    """A finding is in its file, or none if the machine that found it has not the folder."""

    family: str
    finding: Finding
    path: Path | Rejected | None


@dataclass(frozen=True, slots=True)
class Did:
    """A family went on by a round. Clause: ORCL-FUZZ-5."""

    family: str
    round: Round


News = Wrote | Did


@dataclass(frozen=True, slots=True)
class Met:
    """An adapter that said hello, or two; and what there is to fuzz of them."""

    first: Party
    second: Party | None
    families: tuple[Family, ...]


def meet(plan: Plan, stack: ExitStack) -> Met | NoProcess:
    """Start the adapters; the stack ends them. Clauses: ORCL-FUZZ-6, ORCL-AGAINST-1."""
    bounds = replace(plan.bounds, restarts=RESTARTS)
    askers: list[tuple[Asker, Party]] = []
    for command in (plan.command, plan.against):
        if command:
            session = stack.enter_context(Session(command, bounds))
            said = session.introduction()
            if isinstance(said, NoProcess):
                return NoProcess(f"{' '.join(command)}: {said.why}", said.errors)
            askers.append((asker(session.ask, said), party(command, said)))
    (first, here), *others = askers
    if others:
        return Met(here, others[0][1], opposed(first, others[0][0], plan.only))
    return Met(here, None, families(first, plan.only))


def names(plan: Plan) -> tuple[str, ...] | NoProcess:
    """The families of a plan; the adapters are started once for that. Clause: ORCL-FUZZ-6."""
    with ExitStack() as stack:
        met = meet(plan, stack)
        return met if isinstance(met, NoProcess) else tuple(f.name for f in met.families)


def fuzz(plan: Plan, known: tuple[str, ...]) -> Generator[News | NoProcess, None, None]:
    """News as they come, until all examples are drawn or the time is over. Close it to end it.

    `known` are the plan's families. Clauses: ORCL-FUZZ-3, ORCL-FUZZ-4.
    """
    if plan.workers <= 1 and not plan.scheduler:
        until = inf if plan.seconds is None else monotonic() + plan.seconds
        with ExitStack() as stack:
            met = meet(plan, stack)
            if isinstance(met, NoProcess):
                yield met
                return
            yield from _in_turn(plan, met, met.families, until)
        return
    items = [(plan, name, len(known)) for name in known]
    for found in spread(one_family, items, place_of(plan)):
        match found:
            case Lost(why):
                yield NoProcess(why)
            case Wrote(name, finding, None):
                yield Wrote(name, finding, _written(plan, finding))
            case _:
                yield found


def place_of(plan: Plan) -> Place:
    """Where the families are hunted. Clauses: ORCL-FUZZ-8, ORCL-POOL-1, ORCL-POOL-3."""
    return Cluster(plan.scheduler) if plan.scheduler else Local(plan.workers)


def one_family(item: tuple[Plan, str, int]) -> Iterator[News | NoProcess]:
    """One family from its first example to its last, with its part of the time. ORCL-FUZZ-8."""
    plan, name, count = item
    until = inf
    if plan.seconds is not None:
        until = monotonic() + plan.seconds * plan.workers / max(count, plan.workers)
    with ExitStack() as stack:
        met = meet(plan, stack)
        if isinstance(met, NoProcess):
            yield met
            return
        mine = tuple(family for family in met.families if family.name == name)
        yield from _in_turn(plan, met, mine, until)


def _in_turn(plan: Plan, met: Met, some: tuple[Family, ...], until: float) -> Iterator[News]:
    """A round of each family after the other, again and again. Clause: ORCL-FUZZ-3."""
    examples = plan.examples
    if examples is None:
        examples = EXAMPLES if plan.seconds is None else ENDLESS
    hunts = [
        (family.name, hunt(family, plan.number, max(examples // family.share, 1), until))
        for family in some
    ]
    while hunts:
        going = list[tuple[str, Iterator[Event]]]()
        for name, events in hunts:
            for event in events:
                yield _news(plan, met, name, event)
                if isinstance(event, Round):
                    going.append((name, events))
                    break
        hunts = going


def _news(plan: Plan, met: Met, name: str, event: Event) -> News:
    """The event told, its finding written. Clause: ORCL-FUZZ-4."""
    match event:
        case Round():
            return Did(name, event)
        case First(_, tried):
            found = finding_of(tried, met.first, met.second)
        case Small(first, least):
            shrunk = shrunk_from(first, least)
            found = finding_of(least.tried, met.first, met.second, shrunk)
        case _:
            assert_never(event)
    return Wrote(name, found, None if plan.scheduler else _written(plan, found))


def _written(plan: Plan, found: Finding) -> Path | Rejected:
    written = write(plan.folder, found)
    return written if isinstance(written, Rejected) else written.value
