"""A run of `clers fuzz`: carried out, shown as it goes, summed up. Clauses: ORCL-FUZZ-4, -6."""

import signal
from collections import Counter
from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from time import monotonic
from types import FrameType

from msgspec import UnsetType

from clers.cli.adapter_command import nobody
from clers.cli.output import Exit, json, line, note, progress, stop, table
from clers.conformance.outcome import NoProcess
from clers.conventions.result import Rejected
from clers.oracle.finding import Finding
from clers.oracle.fuzz.campaign import EXAMPLES, Did, Plan, Wrote, fuzz, names


@dataclass(slots=True)
class Tally:
    """What a campaign has come to so far."""

    families: tuple[str, ...]
    drawn: Counter[str] = field(default_factory=Counter)
    asked: Counter[str] = field(default_factory=Counter)
    broken: dict[str, str] = field(default_factory=dict)
    found: dict[str, tuple[str, Finding, Path | Rejected | None]] = field(default_factory=dict)
    gone: NoProcess | None = None

    def take(self, news: Wrote | Did | NoProcess) -> None:
        """Note what happened; a finding shrunk takes the place of itself. Clause: ORCL-FUZZ-4."""
        match news:
            case Did(name, done):
                self.drawn[name] += done.drawn
                self.asked[name] += done.asked
                if done.broken:
                    self.broken[name] = done.broken
            case Wrote(name, found, path):
                self.found[f"{name} {found.judged.signature}"] = (name, found, path)
            case NoProcess():
                self.gone = news

    def line(self, name: str) -> str:
        """A family and its counts, for the progress bar."""
        number = sum(of == name for of, _, _ in self.found.values())
        return f"{name} {self.drawn[name]}" + (f", {number} found" if number else "")


def carry_out(plan: Plan, adapter: str, against: str, *, as_json: bool) -> None:
    """Fuzz, tell, and end with the campaign's code. Clauses: ORCL-FUZZ-4, ORCL-FUZZ-6."""
    begun = monotonic()
    known = names(plan)
    if isinstance(known, NoProcess):
        nobody(known, as_json=as_json)
    tally = Tally(known)
    interrupted = not _go_on(plan, tally)
    if as_json:
        json(_record(tally))
    else:
        _print(tally, adapter, against, monotonic() - begun)
    if interrupted:
        stop(Exit.INTERRUPTED)
    if any(isinstance(path, Rejected) for _, _, path in tally.found.values()):
        stop(Exit.SELF_CHECK)
    if tally.found:
        stop(Exit.NOT_CONFORMING)
    stop(Exit.CONFORMING if tally.gone is None else Exit.ADAPTER)


@contextmanager
def _interrupts() -> Iterator[list[int]]:
    """The interrupts so far: one that comes while garbage is collected raises nothing."""
    told: list[int] = []

    def note_it(number: int, frame: FrameType | None) -> None:
        told.append(number)
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGINT, note_it)
    try:
        yield told
    finally:
        signal.signal(signal.SIGINT, before)


def _go_on(plan: Plan, tally: Tally) -> bool:
    """Until the end, or an interrupt: then false. Clause: ORCL-FUZZ-4."""
    rounds = len(tally.families) * max((plan.examples or EXAMPLES) // 50, 1)
    total = rounds if plan.seconds is None else int(plan.seconds)
    begun, shown = monotonic(), 0
    with (
        _interrupts() as told,
        progress("fuzz", total) as step,
        closing(fuzz(plan, tally.families)) as news,
    ):
        try:
            for event in news:
                tally.take(event)
                if told:
                    return False
                name = "" if isinstance(event, NoProcess) else tally.line(event.family)
                if plan.seconds is None:
                    step(name)
                for _ in range(int(monotonic() - begun) - shown if plan.seconds else 0):
                    step(name)
                    shown += 1
        except KeyboardInterrupt:
            return False
        except Exception:
            if told:  # what an interrupt broke off in the middle of something
                return False
            raise
    return True


def _print(tally: Tally, adapter: str, against: str, seconds: float) -> None:
    """A table of what was asked, and a block for each finding."""
    rows = [
        [name, tally.drawn[name], tally.asked[name], _state(tally, name)] for name in tally.families
    ]
    table(["family", "drawn", "asked", ""], rows)
    for _, found, path in tally.found.values():
        line("")
        for text in block(found, path, adapter, against):
            line(text)
    if tally.gone is not None:
        note(f"stopped: {tally.gone.why}")
    number = len(tally.found)
    drawn = sum(tally.drawn.values())
    line(f"{drawn} examples in {seconds:.0f} s: {number or 'nothing'} found")


def _state(tally: Tally, name: str) -> str:
    number = sum(of == name for of, _, _ in tally.found.values())
    said = [f"{number} found"] if number else []
    if name in tally.broken:
        said.append(f"not asked further: {tally.broken[name]}")
    return "; ".join(said)


def block(found: Finding, path: Path | Rejected | None, adapter: str, against: str) -> list[str]:
    """A finding in a few lines: what, where, how small, and how to see it again. ORCL-FIND-1."""
    judged, shrunk, second = found.judged, found.shrunk, found.against
    name = path.line() if isinstance(path, Rejected) else str(path)
    clauses = " ".join(judged.clauses)
    law = f" law {found.law}" if found.law else ""
    said = [f"FOUND {found.case.id}  {judged.status}{law}  {clauses}", f"  {judged.why}"]
    if isinstance(shrunk, UnsetType):
        said.append(f"  not shrunk: {name}")
    else:
        least = "" if shrunk.minimal else ", not minimal: patience was used up"
        size = f"{shrunk.before} → {shrunk.after} {shrunk.unit}"
        said.append(f"  shrunk {size}: {name}  ({shrunk.asked} requests{least})")
    if not isinstance(second, UnsetType):
        for who, by_reference in (
            (found.adapter.name, second.first),
            (second.adapter.name, second.second),
        ):
            said.append(f"  {who}, says the reference: {by_reference.status} {by_reference.why}")
    other = f" --against '{against}'" if against else ""
    said.append(f"  reproduce:  clers replay {name} -a '{adapter}'{other}")
    return said


def _record(tally: Tally) -> dict[str, object]:
    return {
        "families": [
            {
                "name": name,
                "drawn": tally.drawn[name],
                "asked": tally.asked[name],
                "broken": tally.broken.get(name, ""),
            }
            for name in tally.families
        ],
        "gone": "" if tally.gone is None else tally.gone.why,
        "findings": [
            {"file": path.line() if isinstance(path, Rejected) else str(path), "finding": found}
            for _, found, path in tally.found.values()
        ],
    }
