"""Run a law on examples drawn for its domain; shrink what fails. Clause: CONV-LAW-5."""

from collections.abc import Callable
from dataclasses import dataclass
from random import Random

from hypothesis import Phase, Verbosity, find, settings
from hypothesis.errors import Flaky, NoSuchExample, Unsatisfiable
from hypothesis.strategies import SearchStrategy

from clers.conventions.law import AnyLaw
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import WHOLE, in_words


@dataclass(frozen=True, slots=True)
class Held:
    """The law held on every example; a small domain may have fewer than were asked for."""

    examples: int


@dataclass(frozen=True, slots=True)
class Failed:
    """The law failed: the smallest example found, and the verdict on it, in words."""

    example: str
    expected: str
    got: str
    where: str


@dataclass(frozen=True, slots=True)
class Unjudged:
    """Nothing can be said of the law: its domain has no generator, or one that fails."""

    why: str


Outcome = Held | Failed | Unjudged


def judge(
    law: AnyLaw, strategy: SearchStrategy[object] | None, examples: int, seed: int
) -> Outcome:
    """Judge a law on examples of a strategy; the same arguments give the same outcome.

    A law that raises an exception on an example has failed there, for laws are total.
    """
    if strategy is None:
        return Unjudged(f"no generator for the domain {law.domain}")
    drawn = 0

    def fails(example: object) -> bool:
        nonlocal drawn
        drawn += 1
        return isinstance(_verdict(law, example), Fails)

    try:
        example = _smallest(strategy, fails, examples, seed)
    except (NoSuchExample, Unsatisfiable):
        return Held(drawn) if drawn else Unjudged(f"the generator of {law.domain} draws nothing")
    except Flaky:
        return Unjudged("two verdicts on one example: the law or its generator is not pure")
    except Exception as error:
        return Unjudged(f"the generator of {law.domain} raised {_said(error)}")
    verdict = _verdict(law, example)
    if isinstance(verdict, Fails):
        return Failed(repr(example), verdict.expected, verdict.got, in_words(verdict.where))
    return Unjudged("two verdicts on one example: the law or its generator is not pure")


def _smallest(
    strategy: SearchStrategy[object], fails: Callable[[object], bool], examples: int, seed: int
) -> object:
    """The smallest example found that fails; raises `NoSuchExample` if none was found."""
    quiet = settings(
        max_examples=examples,
        database=None,
        deadline=None,
        derandomize=False,
        phases=(Phase.generate, Phase.shrink),
        print_blob=False,
        verbosity=Verbosity.quiet,
    )
    return find(strategy, fails, settings=quiet, random=Random(seed))


def _verdict(law: AnyLaw, example: object) -> Verdict:
    """The law's verdict, or a failing one that names the exception."""
    try:
        return law.check(example)
    except Exception as error:
        return Fails("a verdict", f"raised {_said(error)}", WHOLE)


def _said(error: Exception) -> str:
    return f"{type(error).__name__}: {error}"
