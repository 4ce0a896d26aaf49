"""The registry: every law of every chapter, each name once. Clause: CONV-LAW-3.

A chapter joins by its import and one line in `CHAPTERS`; `clers spec check` finds laws left out.
"""

from collections import Counter
from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Final

from clers.arithmetic import laws as arithmetic
from clers.codes import laws as codes
from clers.complexes import laws as complexes
from clers.conformance import laws as conformance
from clers.conformance.cases import laws as cases
from clers.conformance.judging import laws as judging
from clers.conformance.judging import laws_meshes as meshes
from clers.container import laws as container
from clers.conventions.law import AnyLaw
from clers.edgebreaker import laws as edgebreaker
from clers.geometry import laws as geometry
from clers.information import laws as information
from clers.meshfile import laws as meshfile
from clers.operators import laws as operators
from clers.pictures import laws as pictures
from clers.site import laws as site

CHAPTERS: Final[Mapping[int, tuple[AnyLaw, ...]]] = MappingProxyType(
    {
        1: information.LAWS,
        2: arithmetic.LAWS,
        3: complexes.LAWS,
        4: operators.LAWS,
        5: edgebreaker.LAWS,
        6: codes.LAWS,
        7: geometry.LAWS,
        8: container.LAWS,
        9: (*conformance.LAWS, *cases.LAWS, *judging.LAWS, *meshes.LAWS),
        10: (*meshfile.LAWS, *pictures.LAWS, *site.LAWS),
    }
)

ALL: Final[tuple[AnyLaw, ...]] = tuple(law for laws in CHAPTERS.values() for law in laws)


def names_given_twice(laws: Iterable[AnyLaw]) -> tuple[str, ...]:
    """The names that several laws have, sorted; none in a sound registry."""
    return tuple(sorted(name for name, n in Counter(law.name for law in laws).items() if n > 1))
