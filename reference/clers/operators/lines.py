"""Scripts as text: pieces between semicolons and line ends, each an operator, each a step."""

import re
from collections.abc import Callable
from typing import Final, TypeVar

from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtStep

T = TypeVar("T")

_END: Final = re.compile(r"[;\r\n]")


def read_each(
    text: str, one: Callable[[str, AtStep], Accepted[T] | Rejected]
) -> Accepted[tuple[T, ...]] | Rejected:
    """What each piece says that is not empty, or the first rejection.

    Clauses: OPER-SCRIPT-6, OPER-BUILD-5, OPER-MOVE-8, OPER-ATTACH-8, OPER-FAMILY-1.
    """
    found: list[T] = []
    for piece in filter(None, map(str.strip, _END.split(text))):
        operator = one(piece, AtStep(len(found)))
        if isinstance(operator, Rejected):
            return operator
        found.append(operator.value)
    return Accepted(tuple(found))
