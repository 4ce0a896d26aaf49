"""All mutants of a source: a pure function of its text."""

import ast
import warnings
from collections.abc import Iterator, Mapping, Sequence
from typing import Final

from clers.measure.mutation.expressions import Change, expression
from clers.measure.mutation.mutant import Mutant, mutated
from clers.measure.mutation.statements import statement
from clers.measure.mutation.text import text
from clers.measure.mutation.vocabulary import Vocabulary
from clers.measure.mutation.walk import Around, walk

NO_WORDS: Final[Mapping[str, Sequence[str]]] = {}


def mutants(source: str, words: Vocabulary = NO_WORDS) -> tuple[Mutant, ...]:
    """Every mutant of a module, by place, each once; each parses. Clauses: TOOL-MUTATION-1, -2.

    `words` has the members of the enumerations that the module may name.
    """
    pieces = text(source)
    found: dict[Mutant, None] = {}
    for (place, kind, after), around in _changes(source, words):
        before = pieces.cut(place)
        if before != after:
            found[Mutant(*place, kind, before, after, around.first, around.last)] = None
    seen: set[str] = {source}
    kept: list[Mutant] = []
    for mutant in sorted(found):
        new = mutated(source, mutant)
        if new not in seen and _parses(new):
            seen.add(new)
            kept.append(mutant)
    return tuple(kept)


def _changes(source: str, words: Vocabulary) -> Iterator[tuple[Change, Around]]:
    pieces = text(source)
    for node, around in walk(ast.parse(source)):
        if isinstance(node, ast.expr):
            changes = expression(node, pieces, words)
        else:
            changes = statement(node, pieces, around)
        for change in changes:
            yield change, around


def _parses(source: str) -> bool:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            compile(source, "mutant", "exec")
        except (SyntaxError, ValueError):
            return False
    return True
