"""The symbol that needs no bits: a word whose first component is closed begins with C."""

from collections.abc import Iterable
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol
from clers.edgebreaker.stream import SYMBOLS, Stream

NUMBER: Final = {symbol: number for number, symbol in enumerate(SYMBOLS)}
"""The numbers of the symbols in models. Clause: EB-WORD-1."""


_NUMBERS: Final = bytes.maketrans(SYMBOLS.encode(), bytes(range(len(SYMBOLS))))
_LETTERS: Final = bytes.maketrans(bytes(range(len(SYMBOLS))), SYMBOLS.encode())
_ALPHABET: Final = SYMBOLS.encode()


def numbers(symbols: str, clause: Clause) -> Accepted[bytes] | Rejected:
    """The numbers of symbols, in a byte each; a symbol out of the alphabet is blamed. EB-WORD-1."""
    fault = stranger(symbols, clause)
    return Accepted(symbols.encode().translate(_NUMBERS)) if fault is None else fault


def stranger(symbols: str, clause: Clause) -> Rejected | None:
    """The first symbol that is not in the alphabet, if there is one. Clause: EB-WORD-1."""
    if not symbols.encode("ascii", "replace").translate(None, _ALPHABET):
        return None
    where = next(i for i, x in enumerate(symbols) if x not in NUMBER)
    return Rejected(Reason.NOT_IN_ALPHABET, clause, AtSymbol(where))


def letters(found: Iterable[int]) -> str:
    """The symbols of these numbers. Clause: EB-WORD-1."""
    return bytes(found).translate(_LETTERS).decode()


def implied(components_with_boundary: int) -> str:
    """The part of the word that is not coded: C if all components are closed. CODE-IMPLIED-1."""
    return "" if components_with_boundary else "C"


def coded_part(stream: Stream) -> Accepted[str] | Rejected:
    """The symbols of a word that a code writes. Clause: CODE-IMPLIED-1, CODE-IMPLIED-2."""
    head = implied(stream.components_with_boundary)
    if not stream.word.startswith(head):
        detail = "a closed component begins with C"
        return Rejected(Reason.NOT_IN_ALPHABET, Clause.CODE_IMPLIED_2, AtSymbol(0), detail)
    return Accepted(stream.word[len(head) :])
