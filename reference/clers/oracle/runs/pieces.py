"""Pieces of a run: cases that one process is asked, one after the other. ORCL-CHECK-6."""

import copyreg
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import msgspec

from clers.conformance.bounds import DEFAULT_BOUNDS, Bounds
from clers.conformance.cases.case import Case, operation_of
from clers.conformance.judging.judge import judge, skipped
from clers.conformance.judging.judged import Judged
from clers.conformance.judging.needs import needs
from clers.conformance.lines import NoMessage
from clers.conformance.messages import Introduction
from clers.conformance.outcome import Erred, NoProcess, Outcome
from clers.conformance.session import Session, asked
from clers.oracle.runs.said import NOTHING, said

PIECE: Final = 500
"""Cases of a piece. Clause: ORCL-CHECK-6."""


@dataclass(frozen=True, slots=True)
class Adapter:
    """Who is asked, within what bounds, and how its rejections are judged. ORCL-CHECK-12.

    `introduction` is what it said to hello, to which `suite` was named; another process of it must
    say the same.
    """

    command: tuple[str, ...]
    introduction: Introduction
    bounds: Bounds = DEFAULT_BOUNDS
    strict_reasons: bool = False
    suite: str = ""


@dataclass(frozen=True, slots=True)
class Piece:
    """Cases for one process. Clause: ORCL-CHECK-6."""

    adapter: Adapter
    cases: tuple[Case, ...]


@dataclass(frozen=True, slots=True)
class Result:
    """A case, judged, a hash of the reply or `NOTHING`, and the processes started anew for it.

    Between processes it travels as one string of bytes, which is ten times as quick as to have
    each of its parts named. Clauses: ORCL-ORDER-2, ORCL-CHECK-7.
    """

    judged: Judged
    said: str
    restarts: int = 0


_RESULT: Final = msgspec.msgpack.Decoder(Result)


def _result_in(data: bytes) -> Result:
    return _RESULT.decode(data)


def _packed(result: Result) -> tuple[Callable[[bytes], Result], tuple[bytes]]:
    return _result_in, (msgspec.msgpack.encode(result),)


copyreg.pickle(Result, _packed)


def meet(
    command: Sequence[str],
    bounds: Bounds = DEFAULT_BOUNDS,
    *,
    strict_reasons: bool = False,
    suite: str = "",
) -> Adapter | NoProcess:
    """The adapter that a command starts, if it answers hello. Clause: ORCL-CHECK-10."""
    with Session(command, bounds, suite) as session:
        said = session.introduction()
    if isinstance(said, NoProcess):
        return said
    return Adapter(tuple(command), said, bounds, strict_reasons, suite)


def pieces(adapter: Adapter, cases: Sequence[Case]) -> Iterator[Piece]:
    """The cases, cut in order. Clause: ORCL-CHECK-6."""
    for start in range(0, len(cases), PIECE):
        yield Piece(adapter, tuple(cases[start : start + PIECE]))


def ask_piece(piece: Piece) -> Iterator[Result]:
    """Ask a new process case by case; none is left. Clauses: ORCL-CHECK-3, ORCL-CHECK-6."""
    adapter = piece.adapter
    with Session(adapter.command, adapter.bounds, adapter.suite) as session:
        for number, case in enumerate(piece.cases, 1):
            yield _result(session, adapter, number, case)


def _result(session: Session, adapter: Adapter, number: int, case: Case) -> Result:
    lacking = needs(case, adapter.introduction)
    if lacking is not None:
        return Result(skipped(case, lacking), NOTHING)
    starts = max(session.starts, 1)
    outcome = _outcome(session, adapter.introduction, number, case)
    strict = adapter.strict_reasons
    judged = judge(case, outcome, adapter.introduction, strict_reasons=strict)
    return Result(judged, said(outcome), session.starts - starts)


def _outcome(session: Session, introduction: Introduction, number: int, case: Case) -> Outcome:
    """Events are asked for where the case has them and the adapter declares them. ORCL-EVENT-1."""
    traced = case.trace and case.op in introduction.caps.trace
    request = operation_of(case, "full" if traced else "none")
    if isinstance(request, NoMessage):
        return Erred(f"the case is no request: {request.why}")
    here = session.introduction()
    if isinstance(here, NoProcess):
        return here
    if here != introduction:
        return NoProcess("it said hello otherwise than before")
    return session.ask(asked(number, request))
