"""A request that is to be a case, and the case with the reference's answer. Clause: ORCL-CASE-1."""

from dataclasses import dataclass
from typing import Final

import msgspec
from msgspec import Raw

from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conformance.cases.case import Case, Comparison, Origin
from clers.conformance.cases.identity import named
from clers.conformance.messages import EventReply, OkReply, Operation
from clers.conformance.serve import serve
from clers.conventions.clause import Clause

TRACED: Final = 60
"""The most faces of a case with a trace."""

UNNAMED: Final = "unnamed-aaaaaaaa"


@dataclass(frozen=True, slots=True)
class Asked:
    """A request with a good input, and what a case says beside it. Clause: ORCL-CASE-1."""

    slug: str
    op: str
    request: Operation
    clauses: tuple[Clause, ...]
    origin: Origin
    requires: tuple[str, ...] = ()
    size: int = 0
    flags: tuple[str, ...] = ()
    comment: str = ""
    compare: Comparison = "exact"


def answered(asked: Asked) -> Case:
    """The case with the answer of the reference, which must accept the input. Clause: ORCL-CASE-1.

    The trace is there if the request asks for one. An input that is not accepted is a slip of who
    wrote it, and an AssertionError.
    """
    *events, last = serve(asked.request)
    if not isinstance(last, OkReply):
        raise AssertionError(f"{asked.op} {asked.slug}: {last}")
    case = Case(
        id=UNNAMED,
        op=asked.op,
        clauses=tuple(map(str, asked.clauses)),
        origin=asked.origin,
        requires=asked.requires,
        size=asked.size,
        flags=tuple(sorted(set(asked.flags))),
        input=Raw(msgspec.json.encode(asked.request.input)),
        ok=last.ok,
        trace=tuple(event.ev for event in events if isinstance(event, EventReply)),
        compare=asked.compare,
        comment=asked.comment,
    )
    return named(asked.slug, case)


def needed(surface: Surface) -> tuple[str, ...]:
    """The capabilities that a surface needs, by the alphabet. Clause: ORCL-CASE-4."""
    parts = components(surface)
    curves = sum(part.curves for part in parts)
    return (
        *(["boundaries.one" if curves == 1 else "boundaries.many"] if curves else []),
        *(["components"] if len(parts) > 1 else []),
        *(["handles"] if any(part.genus for part in parts) else []),
    )
