"""What the strategies reach: how often each genus, number of curves and of components, what sizes.

    python -m clers.generate.distribution --examples 1000 --seed 0

prints the table of chapter 4. The same arguments print the same table, until the program changes,
or Hypothesis, or manifold3d: Hypothesis mixes in numbers that it finds in the program's source.
"""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Final

import typer
from hypothesis import strategies as st

from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.edgebreaker.encode import encode
from clers.generate.sample import sample
from clers.generate.solids import solid_surfaces
from clers.generate.surfaces import closed_surfaces, small_surfaces, spheres, surfaces

STRATEGIES: Final[Mapping[str, st.SearchStrategy[Surface]]] = {
    "surfaces": surfaces(),
    "closed-surfaces": closed_surfaces(),
    "spheres": spheres(),
    "small-surfaces": small_surfaces(),
    "solid-surfaces": solid_surfaces(),
}
"""The strategies of surfaces whose distribution is published."""


@dataclass(frozen=True, slots=True)
class Seen:
    """What is counted of one surface; genus and curves summed over the components."""

    components: int
    genus: int
    curves: int
    faces: int
    trigrams: frozenset[str]


def look(at: Surface) -> Seen:
    """Count one surface. Its trigrams are those of its CLERS word."""
    parts = components(at)
    word = encode(at).stream.word
    return Seen(
        len(parts),
        sum(part.genus for part in parts),
        sum(part.curves for part in parts),
        at.faces,
        frozenset(word[k : k + 3] for k in range(len(word) - 2)),
    )


def draw(strategy: st.SearchStrategy[Surface], examples: int, number: int) -> tuple[Seen, ...]:
    """What that many examples show; `number` is the seed."""
    return tuple(look(at) for at in sample(strategy, examples, number))


HEADER: Final = (
    "strategy",
    "genus 0, 1, …",
    "curves 0, 1, …",
    "components 1, 2, …",
    "faces: median, 90 %, most",
    "trigrams",
)


def row(name: str, seen: Sequence[Seen]) -> tuple[str, ...]:
    """One line of the table: how many examples have each number, from the lowest up."""
    faces = sorted(one.faces for one in seen)
    return (
        f"`{name}`",
        _counts([one.genus for one in seen], 0),
        _counts([one.curves for one in seen], 0),
        _counts([one.components for one in seen], 1),
        f"{faces[len(faces) // 2]}, {faces[len(faces) * 9 // 10]}, {faces[-1]}",
        str(len(frozenset[str]().union(*(one.trigrams for one in seen)))),
    )


def _counts(numbers: list[int], first: int) -> str:
    count = Counter(numbers)
    return " ".join(str(count[k]) for k in range(first, max(numbers) + 1))


def main(
    examples: Annotated[int, typer.Option(min=1, help="Examples of each strategy.")] = 1000,
    number: Annotated[int, typer.Option("--seed", help="Another seed, other examples.")] = 0,
) -> None:
    """Print how often each class of surfaces is drawn, as a Markdown table."""
    lines = [HEADER, tuple("---" for _ in HEADER)]
    lines += [row(name, draw(of, examples, number)) for name, of in STRATEGIES.items()]
    for line in lines:
        typer.echo(f"| {' | '.join(line)} |")


if __name__ == "__main__":
    typer.run(main)
