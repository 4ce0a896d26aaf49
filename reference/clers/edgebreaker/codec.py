"""A connectivity codec as a value: what the laws take as their subject."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from clers.complexes.surface import Surface
from clers.conventions.result import Accepted, Rejected, and_then
from clers.edgebreaker.decode import decode
from clers.edgebreaker.definition import decode_by_fold
from clers.edgebreaker.encode import encode
from clers.edgebreaker.fast_zip import wrap_and_fast_zip
from clers.edgebreaker.label import label
from clers.edgebreaker.outline import Outline, outline
from clers.edgebreaker.reversi import reversi
from clers.edgebreaker.stream import Encoding, Stream
from clers.edgebreaker.wrap_zip import wrap_and_zip


@dataclass(frozen=True, slots=True)
class Codec:
    """An encoder and a decoder of connectivity. Clause: CONV-LAW-1."""

    name: str
    encode: Callable[[Surface], Encoding]
    decode: Callable[[Stream], Accepted[Surface] | Rejected]


def _checked(
    glue: Callable[[Outline], list[int]],
) -> Callable[[Stream], Accepted[Surface] | Rejected]:
    """A decoder from a way to glue that trusts its stream: the grammar is checked before."""

    def checked(stream: Stream) -> Accepted[Surface] | Rejected:
        return and_then(
            outline(stream),
            lambda outlined: and_then(reversi(outlined), lambda _: label(outlined, glue(outlined))),
        )

    return checked


REFERENCE: Final = Codec("spirale-reversi", encode, decode)
WRAP_AND_ZIP: Final = Codec("wrap-and-zip", encode, _checked(wrap_and_zip))
FAST_ZIP: Final = Codec("fast-zip", encode, _checked(wrap_and_fast_zip))
FOLD: Final = Codec("fold", encode, decode_by_fold)

LINEAR: Final = (REFERENCE, WRAP_AND_ZIP, FAST_ZIP)
"""The decoders that are linear; FOLD is the definition and quadratic. Clause: EB-DECODE-3."""
