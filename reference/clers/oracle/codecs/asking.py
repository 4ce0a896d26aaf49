"""One mesh through one codec: what became of it. Clause: ORCL-CODEC-14."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, assert_never

from clers.conformance import payloads as form
from clers.conformance.in_words import in_words
from clers.conformance.judging.comparing.difference import Difference
from clers.conformance.judging.comparing.sites import Bound
from clers.conformance.judging.meshes import Differs, Same, Undecided, compare
from clers.conformance.messages import Roundtrip
from clers.conformance.outcome import (
    Answered,
    Crash,
    Declined,
    Erred,
    Flaky,
    NoProcess,
    Outcome,
    ProtocolError,
    TimedOut,
    Unsupported,
)
from clers.conformance.session import Session, asked
from clers.oracle.codecs.settings import Setting


@dataclass(frozen=True, slots=True)
class Became:
    """What became of a mesh: in a word, why, the differences by name, and what came back.

    `word` is `same`, `different`, `refused`, `unsupported`, `undecided`, or how the process broke.
    """

    word: str
    why: str = ""
    differences: tuple[Difference, ...] = ()
    came: form.MeshForm | None = None

    @property
    def findings(self) -> frozenset[str]:
        """The names of what is to be reported: differences, or how the process broke."""
        if self.word in QUIET:
            return frozenset()
        return frozenset(d.kind for d in self.differences) or frozenset((self.word,))


QUIET: Final = frozenset(("same", "refused", "unsupported"))
"""Answers that a codec has a right to. Clause: ORCL-CODEC-2."""

Ask = Callable[[form.MeshForm], Became]


def asking(session: Session, setting: Setting) -> Ask:
    """How a codec is asked about a mesh."""

    def ask(mesh: form.MeshForm) -> Became:
        error = setting.allowed(mesh)
        through = form.ThroughForm.of(mesh, error)
        return became(mesh, session.ask(asked(1, Roundtrip(id=1, input=through))), error)

    return ask


def became(mesh: form.MeshForm, outcome: Outcome, error: Bound) -> Became:
    """What an outcome says of a mesh."""
    match outcome:
        case Answered(result=form.MeshForm() as came):
            return _compared(mesh, came, error)
        case Declined(rejection=rejection):
            return Became("refused", rejection.detail or rejection.reason)
        case Unsupported(cap=cap):
            return Became("unsupported", cap)
        case Crash():
            return Became("crash", in_words(outcome))
        case TimedOut():
            return Became("time-out", in_words(outcome))
        case Answered() | Erred() | ProtocolError() | Flaky() | NoProcess():
            return Became("error", in_words(outcome))
        case _:
            assert_never(outcome)


def _compared(
    mesh: form.MeshForm, came: form.MeshForm, error: tuple[float, float, float]
) -> Became:
    found = compare(mesh, came, error)
    match found:
        case Same():
            return Became("same", came=came)
        case Differs(differences):
            return Became("different", differences[0].line(), differences, came)
        case Undecided(why):
            return Became("undecided", why, came=came)
        case _:
            assert_never(found)
