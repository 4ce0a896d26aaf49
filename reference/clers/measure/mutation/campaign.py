"""A campaign: mutants drawn, tests chosen, fates collected."""

import importlib
from collections import Counter
from collections.abc import Callable, Collection, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Final

import msgspec

from clers.measure.mutation.child import Child, Limits, answers, finish, start
from clers.measure.mutation.mutant import Mutant, difference, mutated
from clers.measure.mutation.outcome import ON_IMPORT, Baseline, Fate, Judged, Report, Subject, Trial
from clers.measure.mutation.sample import Drawn, draw
from clers.measure.mutation.trial import baseline, trial

GRACE: Final = 2.0
FACTOR: Final = 5.0


@dataclass(frozen=True, slots=True)
class Plan:
    """What to do: modules, tests, how many mutants, and how.

    `sample` is None for all mutants; `memory` is in bytes.
    """

    subjects: tuple[Subject, ...]
    root: str
    tests: tuple[str, ...]
    sample: int | None
    seed: int
    workers: int
    memory: int


def reached(drawn: Drawn, known: Baseline) -> tuple[str, ...]:
    """The tests that can kill a mutant. Clause: TOOL-MUTATION-4."""
    names = tuple(known.tests)
    lines = known.lines.get(drawn.subject.path, {})
    span = range(drawn.mutant.first, drawn.mutant.last + 1)
    at = {test for line in span for test in lines.get(line, ())}
    if ON_IMPORT not in at:
        return tuple(names[i] for i in sorted(at))
    at_module = {test for tests in lines.values() for test in tests}
    first = [*sorted(at - {ON_IMPORT}), *sorted(at_module - at)]
    rest = [i for i in range(len(names)) if i not in at_module]
    return tuple(names[i] for i in (*first, *rest))


def run(plan: Plan, step: Callable[[str], None]) -> Report | str:
    """Try every drawn mutant, or say why the tests cannot be run. Clause: TOOL-MUTATION-3.

    Ended by Ctrl-C it reports what was found until then.
    """
    total, sample = draw(plan.subjects, plan.root, plan.sample, plan.seed)
    return over(plan, total, sample, step)


def over(
    plan: Plan, total: int, sample: Sequence[Drawn], step: Callable[[str], None]
) -> Report | str:
    """Try these of so many mutants, as `run` does. Clause: TOOL-MUTATION-3."""
    known = _baseline(plan, sample)
    if isinstance(known, str):
        return known
    for name in known.loaded:
        with suppress(ImportError):
            importlib.import_module(name)
    asked = {name for drawn in sample for name in reached(drawn, known)}
    known = _steady(plan, known, asked)
    if not known.tests:
        return "no test passes"
    judged: dict[Drawn, Trial] = {}
    _try_all(plan, sample, known, judged, step)
    fates = Counter(found.fate for found in judged.values())
    gone = fates[Fate.KILLED] + fates[Fate.TIMED_OUT]
    return Report(
        modules=tuple(of.module for of in plan.subjects),
        tests=plan.tests,
        sample=plan.sample,
        seed=plan.seed,
        mutants=total,
        sampled=len(sample),
        complete=len(judged) == len(sample),
        killed=fates[Fate.KILLED],
        timed_out=fates[Fate.TIMED_OUT],
        survived=fates[Fate.SURVIVED],
        unreached=fates[Fate.UNREACHED],
        score=gone / max(1, len(judged)),
        left_out=known.failed,
        judged=tuple(_judged(drawn, judged[drawn]) for drawn in sorted(judged, key=_place)),
    )


def _place(drawn: Drawn) -> tuple[str, Mutant]:
    return drawn.subject.module, drawn.mutant


def _judged(drawn: Drawn, found: Trial) -> Judged:
    change = difference(drawn.subject.source, drawn.mutant)
    return Judged(drawn.subject.module, drawn.mutant, change, found.fate, found.by)


def _baseline(plan: Plan, sample: Sequence[Drawn]) -> Baseline | str:
    """Run the tests once, in a child, for nothing of the package is to stay imported.

    Lines are noted of the modules with drawn mutants only: to note them is what takes the time.
    """
    traced = tuple({drawn.subject.module: drawn.subject for drawn in sample}.values())
    child = start(lambda _: baseline(traced, plan.root, plan.tests), Limits(plan.memory, 3600.0))
    while not any(answers([child])):
        pass
    answer = finish(child)
    if not answer:
        return "the tests could not be run"
    known = msgspec.json.decode(answer, type=Baseline)
    return known if known.tests else "no test passes"


def _steady(plan: Plan, known: Baseline, asked: Collection[str]) -> Baseline:
    """Try the unchanged source as if it were a mutant, without the tests that fail then.

    Only the tests that some mutant will be asked are tried: `asked`.
    """
    unchanged = plan.subjects[0]
    left_out: list[str] = []
    while names := [name for name in known.tests if name in asked and name not in left_out]:
        seconds = limits(names, dict.fromkeys(names, 0), known)
        child = _start(plan, unchanged, unchanged.source, seconds)
        found = _answer(child)
        if found.fate is Fate.SURVIVED:
            break
        left_out.extend([found.by] if found.by in known.tests else names)
    names = [name for name in known.tests if name not in left_out]
    number = {i: names.index(name) for i, name in enumerate(known.tests) if name in names}
    lines = {
        path: {
            line: tuple(number.get(i, i) for i in tests if i == ON_IMPORT or i in number)
            for line, tests in by_line.items()
        }
        for path, by_line in known.lines.items()
    }
    passed = {name: known.tests[name] for name in names}
    return Baseline(passed, (*known.failed, *left_out), lines, known.loaded)


def _answer(child: Child) -> Trial:
    """Wait for a child's verdict on a mutant."""
    while not any(answers([child])):
        pass
    return _trial(finish(child))


def _trial(answer: bytes) -> Trial:
    """No answer: the child was ended for its time, or the interpreter crashed."""
    return msgspec.json.decode(answer, type=Trial) if answer else Trial(Fate.TIMED_OUT)


def _try_all(
    plan: Plan,
    sample: Sequence[Drawn],
    known: Baseline,
    judged: dict[Drawn, Trial],
    step: Callable[[str], None],
) -> None:
    """Put the fate of each mutant into `judged`; on Ctrl-C end what runs, and keep what is done."""
    running: dict[int, tuple[Child, Drawn]] = {}
    kills: Counter[tuple[str, str]] = Counter()
    waiting = list(reversed(sample))
    try:
        while waiting or running:
            while waiting and len(running) < plan.workers:
                drawn = waiting.pop()
                names = reached(drawn, known)
                step(f"{drawn.subject.module}:{drawn.mutant.place}")
                if not names:
                    judged[drawn] = Trial(Fate.UNREACHED)
                    continue
                killers = {n: kills[drawn.subject.module, n] for n in names}
                source = mutated(drawn.subject.source, drawn.mutant)
                seconds = limits(names, killers, known)
                child = _start(plan, drawn.subject, source, seconds)
                running[child.pid] = (child, drawn)
            for child in list(answers([child for child, _ in running.values()])):
                _, drawn = running.pop(child.pid)
                judged[drawn] = found = _trial(finish(child))
                kills[drawn.subject.module, found.by] += found.fate is Fate.KILLED
    except KeyboardInterrupt:
        pass
    finally:
        for child, _ in running.values():
            finish(child)


def limits(
    names: Sequence[str], killers: Mapping[str, int], known: Baseline
) -> Mapping[str, float]:
    """Seconds of processor time for each test, in the order in which to run them.

    First those that killed most in this module, then the quick ones. Clause: TOOL-MUTATION-3.
    """
    place = {name: i for i, name in enumerate(names)}
    order = sorted(names, key=lambda n: (-killers[n], known.tests[n], place[n]))
    return {name: GRACE + FACTOR * known.tests[name] for name in order}


def _start(plan: Plan, subject: Subject, source: str, seconds: Mapping[str, float]) -> Child:
    """Begin to run tests on another source of a module."""
    within = Limits(plan.memory, 60.0 + 10.0 * sum(seconds.values()))
    return start(lambda write: trial(subject, source, plan.root, seconds, write), within)
