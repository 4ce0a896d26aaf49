"""`clers bench builds`: compiled and interpreted kernels beside each other. TOOL-BUILD-6."""

from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Annotated

import typer

from clers.cli.output import Exit, line, note, progress, stop

if TYPE_CHECKING:
    from clers.oracle.builds import Said


def builds(
    count: Annotated[int, typer.Option(min=0, help="So many random meshes.")] = 100,
    seed: Annotated[int, typer.Option(help="Of the meshes.")] = 1,
    meshes: Annotated[bool, typer.Option("--meshes", help="Leave the vectors out.")] = False,
    say: Annotated[bool, typer.Option("--say", help="Only print this build's hashes.")] = False,
) -> None:
    """Compare what compiled and interpreted kernels make of random meshes and of the vectors."""
    from clers.kernels import COMPILED
    from clers.oracle.builds import first_difference, interpreted

    ours = _ours(count, seed, vectors=not meshes)
    if say:
        for name, said in ours:
            line(f"{name} {said}")
        return
    if not COMPILED:
        note("the kernels of this process are interpreted: there is nothing to compare")
        stop(Exit.SELF_CHECK)
    with interpreted(count, seed, not meshes) as theirs, progress("builds", count) as step:
        same, differs = first_difference(_shown(ours, step), theirs)
    if differs:
        line(f"{differs}: the builds differ, after {same} alike [TOOL-BUILD-6]")
        stop(Exit.NOT_CONFORMING)
    line(f"{same} alike: {count} random meshes, seed {seed}, and {same - count} vectors")


def _ours(count: int, seed: int, *, vectors: bool) -> "Iterator[Said]":
    from clers.conventions.result import Rejected
    from clers.oracle.builds import of_meshes, of_vectors
    from clers.oracle.suite.files import DEFAULT, read_suite

    yield from of_meshes(count, seed)
    if vectors:
        suite = read_suite(DEFAULT)
        if isinstance(suite, Rejected):
            note(f"{DEFAULT}: {suite.line()}")
            stop(Exit.SELF_CHECK)
        yield from of_vectors(suite.value)


def _shown(said: "Iterable[Said]", step: Callable[[str], None]) -> "Iterator[Said]":
    for name, found in said:
        step(name)
        yield name, found
