"""All families of cases with a good input, in order. Clause: ORCL-SUITE-5."""

from collections.abc import Callable, Iterator, Mapping
from typing import Final

from clers.oracle.positives.asked import Asked
from clers.oracle.positives.echoes import echoes
from clers.oracle.positives.exhaustive import exhaustive
from clers.oracle.positives.from_mutants import from_mutants
from clers.oracle.positives.meshes import files, roundtrips
from clers.oracle.positives.messages import messages
from clers.oracle.positives.scripts import scripts
from clers.oracle.positives.stock import at_random, by_hand, by_rule, by_scripts
from clers.oracle.positives.walks import walks
from clers.oracle.positives.words import words

Inputs = Mapping[str, bytes]
"""The files of the suite's folder `inputs/`, by name."""

FAMILIES: Final[Mapping[str, Callable[[Inputs], Iterator[Asked]]]] = {
    "echoes": lambda _: echoes(),
    "exhaustive": lambda _: exhaustive(),
    "by hand": lambda _: walks(by_hand()),
    "by rule": lambda _: walks(by_rule()),
    "by scripts": lambda _: walks(by_scripts()),
    "at random": lambda _: walks(at_random()),
    "messages": lambda _: messages(),
    "words": lambda _: words(),
    "operators": lambda _: scripts(),
    "files": files,
    "roundtrips": roundtrips,
    "from mutants": lambda _: from_mutants(),
}
"""Each family by its name, a function of what is stored literally."""
