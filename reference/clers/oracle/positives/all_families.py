"""All families of cases with a good input, in order. Clause: ORCL-SUITE-5."""

from collections.abc import Callable, Iterator, Mapping
from typing import Final

from clers.oracle.positives.asked import Asked
from clers.oracle.positives.exhaustive import exhaustive

Inputs = Mapping[str, bytes]
"""The files of the suite's folder `inputs/`, by name."""

FAMILIES: Final[Mapping[str, Callable[[Inputs], Iterator[Asked]]]] = {
    "exhaustive": lambda _: exhaustive(),
}
"""Each family by its name, a function of what is stored literally."""
