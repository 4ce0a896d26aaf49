"""Scripts as text: pieces between semicolons and line ends, each an operator, each a step."""

import re
from collections.abc import Callable
from typing import Final, TypeVar

from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtStep

T = TypeVar("T")

_END: Final = re.compile(r"[;\r\n]")
_WORD: Final = re.compile(r"[^ \t]+")
_BLANKS: Final = " \t"


def pieces_of(text: str) -> list[str]:
    """What stands between semicolons and line ends, if it is not empty. Clause: OPER-SCRIPT-6."""
    return [piece for part in _END.split(text) if (piece := part.strip(_BLANKS))]


def words(piece: str) -> list[str]:
    """What blanks and tabs separate; no other character does. Clause: OPER-SCRIPT-6."""
    return _WORD.findall(piece)


def read_each(
    text: str, one: Callable[[str, AtStep], Accepted[T] | Rejected]
) -> Accepted[tuple[T, ...]] | Rejected:
    """What each piece says that is not empty, or the first rejection.

    Clauses: OPER-SCRIPT-6, OPER-BUILD-5, OPER-MOVE-8, OPER-ATTACH-8, OPER-FAMILY-1.
    """
    found: list[T] = []
    for piece in pieces_of(text):
        operator = one(piece, AtStep(len(found)))
        if isinstance(operator, Rejected):
            return operator
        found.append(operator.value)
    return Accepted(tuple(found))
