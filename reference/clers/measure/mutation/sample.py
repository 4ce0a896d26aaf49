"""Which modules are mutated, and which of their mutants are tried."""

import importlib.util
from collections.abc import Sequence
from dataclasses import dataclass
from fnmatch import fnmatch
from pathlib import Path
from random import Random
from typing import Final

from clers.measure.mutation.mutant import Mutant
from clers.measure.mutation.mutants import mutants
from clers.measure.mutation.outcome import Subject
from clers.measure.mutation.served import source_file
from clers.measure.mutation.vocabulary import vocabulary

JUDGES: Final = ("laws*", "given*")
"""Modules that state laws and domains: they judge, so a package's name does not stand for them."""


@dataclass(frozen=True, slots=True)
class Drawn:
    """A mutant of a module, in the sample."""

    subject: Subject
    mutant: Mutant


def subjects(names: Sequence[str], without: Sequence[str]) -> tuple[Subject, ...] | str:
    """The modules that names stand for, or the name that no module has.

    A package stands for all its modules but those of laws and domains, and those whose dotted
    name matches a pattern of `without`.
    """
    found: dict[str, Subject] = {}
    for name in names:
        try:
            spec = importlib.util.find_spec(name)
        except ModuleNotFoundError:
            spec = None
        file = None if spec is None else source_file(spec)
        if spec is None or file is None:
            return name
        if spec.submodule_search_locations is None:
            found[name] = _subject(name, file)
            continue
        folder = file.parent
        for path in sorted(folder.rglob("*.py")):
            parts = path.relative_to(folder).with_suffix("").parts
            module = ".".join((name, *(part for part in parts if part != "__init__")))
            judges = any(fnmatch(part, pattern) for part in parts for pattern in JUDGES)
            if not judges and not any(fnmatch(module, pattern) for pattern in without):
                found[module] = _subject(module, path)
    return tuple(found[module] for module in sorted(found))


def _subject(module: str, path: Path) -> Subject:
    return Subject(module, str(path.resolve()), path.read_text(encoding="utf-8"))


def draw(
    found: Sequence[Subject], root: str, sample: int | None, seed: int
) -> tuple[int, tuple[Drawn, ...]]:
    """The number of all mutants, and the sample, in the order of the draw.

    A smaller sample begins a larger one; None draws all. Clause: TOOL-MUTATION-5.
    """
    spec = importlib.util.find_spec(root)
    assert spec is not None, "a subject of it was found"
    assert spec.origin is not None, "it is no namespace"
    words = vocabulary(Path(spec.origin).parent)
    every = [Drawn(of, mutant) for of in found for mutant in mutants(of.source, words)]
    order = list(range(len(every)))
    Random(seed).shuffle(order)
    return len(every), tuple(every[i] for i in order[:sample])
