"""What a surface alone says about its word: how many symbols, how many of them C, S less E."""

from dataclasses import dataclass

from clers.complexes.topology import Component


@dataclass(frozen=True, slots=True)
class Counts:
    """Of all symbols: their number, the number of C, and #S − #E. Clause: CODE-COUNT-1."""

    symbols: int
    created: int
    split: int


def counts_of_word(word: str) -> Counts:
    """The counts, from the word."""
    return Counts(len(word), word.count("C"), word.count("S") - word.count("E"))


def counts_of(parts: tuple[Component, ...]) -> Counts:
    """The counts, from the surface. Clauses: CODE-COUNT-1, CODE-COUNT-2."""
    each = [_of_component(part) for part in parts]
    return Counts(
        sum(c.symbols for c in each), sum(c.created for c in each), sum(c.split for c in each)
    )


def _of_component(of: Component) -> Counts:
    t, g, b = of.faces, of.genus, of.curves
    if b == 0:
        return Counts(t - 1, t // 2 - 1 - 2 * g, 2 * g - 1)
    return Counts(t, (t - of.boundary_edges) // 2 + 2 - 2 * g - b, 2 * g + b - 2)
