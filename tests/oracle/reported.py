"""A run that came to something of every kind, made by hand."""

from typing import Final

import msgspec
from judged_by_hand import case_of

from clers.conformance import payloads as form
from clers.conformance.cases.case import Case
from clers.conformance.judging.judge import judge, skipped
from clers.conformance.judging.judged import Judged
from clers.conformance.messages import Caps, Introduction, Rejection
from clers.conformance.outcome import Answered, Crash, Declined, Outcome
from clers.conformance.results import Result
from clers.conformance.samples import FACES, GARBAGE, SAMPLES
from clers.conformance.serve import INTRODUCTION
from clers.conventions.reason import Fault
from clers.oracle.reports.report import Report, Ruling

HOSTILE: Final = '<script>alert("1")</script> & `a|b` _c_ *d* [e](f)'
"""What is no markup, whoever says it."""

SAID: Final = Introduction(
    1,
    HOSTILE,
    "0.3",
    "c++",
    ("echo", "word.decode"),
    Caps(
        handles=True,
        boundaries="one",
        components=False,
        max_faces=10,
        max_symbols=20,
        codes=("plain",),
    ),
    {"ties": "<b>"},
)
COMMAND: Final = ("./fast mesh", "<x>")


def numbered(case: Case, name: str, k: int = 0) -> Case:
    """The case under another id, with clauses and flags."""
    return msgspec.structs.replace(
        case,
        id=f"{name}-{k}-aaaaaaaa",
        clauses=("EB-ORDER-1", "EB-WORD-1"),
        flags=("mirrored", "deaf"),
    )


DECODE: Final = case_of(SAMPLES["word.decode"])
CLASSIFY: Final = case_of(SAMPLES["surface.classify"])
BAD: Final = case_of(GARBAGE["word.decode"][0])
ECHO: Final = case_of(SAMPLES["echo"])
MIRRORED: Final = form.Faces(faces=(*FACES[:2], (0, 1, 3), FACES[3]), vertices=4)


def judged(case: Case, outcome: Outcome) -> Judged:
    return judge(case, outcome, INTRODUCTION)


def ruled(case: Case, outcome: Outcome, profile: str = "core") -> Ruling:
    """What a case of a profile came to."""
    return Ruling(profile, case, judged(case, outcome))


def mirrored(name: str, count: int, profile: str = "core") -> tuple[Ruling, ...]:
    """So many failures of one signature, about a tetrahedron."""
    return tuple(
        ruled(numbered(DECODE, name, k), Answered(MIRRORED), profile) for k in range(count)
    )


def classified(count: int) -> tuple[Ruling, ...]:
    """So many of another, about a tetrahedron too."""
    wrong: Result = form.Classified(components=())
    return tuple(ruled(numbered(CLASSIFY, "counted", k), Answered(wrong)) for k in range(count))


RULINGS: Final = (
    ruled(numbered(ECHO, "echo"), Answered({})),
    *mirrored("turned", 22),
    ruled(numbered(BAD, "bad"), Declined(Rejection(Fault.MALFORMED, HOSTILE)), "handles"),
    ruled(numbered(DECODE, "crash"), Crash(-11, HOSTILE), "handles"),
    Ruling("handles", numbered(DECODE, "skip"), skipped(DECODE, "components")),
)
TEXTS: Final = {
    "EB-ORDER-1": (
        "Vertices $v$ are numbered `so`,\nby <i>order</i>, see [there](05-edgebreaker.md)."
    ),
}
NOTES: Final = {"mirrored": "right for left <b>; it matters"}


def report(rulings: tuple[Ruling, ...] = RULINGS, unfinished: str = "") -> Report:
    """The run as a value."""
    return Report(
        suite="abcdefgh",
        specification="0.1",
        adapter=SAID,
        command=COMMAND,
        rulings=rulings,
        notes=NOTES,
        unfinished=unfinished,
        texts=TEXTS,
    )
