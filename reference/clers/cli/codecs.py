"""`clers adapter draco`, `meshoptimizer` and `files`: codecs of other people as adapters."""

import os
import sys
from typing import TYPE_CHECKING, Annotated, BinaryIO

import typer

from clers.cli.output import Exit, note, stop

if TYPE_CHECKING:
    from clers.oracle.codecs.codec import Codec, Missing


def _serve(codec: "Codec | Missing") -> None:
    """Serve a codec until bye; or say what is missing, and exit 3. Clause: ORCL-CODEC-10."""
    from functools import partial

    from clers.conformance.adapter import loop
    from clers.oracle.codecs.codec import Missing
    from clers.oracle.codecs.serving import serve

    if isinstance(codec, Missing):
        note(codec.why)
        stop(Exit.ADAPTER)
    with _alone() as replies:
        loop(sys.stdin.buffer, replies, partial(serve, codec))


def _alone() -> BinaryIO:
    """Standard output for replies alone: what a library prints there goes to standard error.

    Libraries in C++ print without asking Python. Clause: ORCL-LINE-1.
    """
    replies = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    return replies


def _one_of(name: str, known: tuple[str, ...], option: str) -> None:
    if name not in known:
        raise typer.BadParameter(f"{name!r} is none of {', '.join(known)}", param_hint=option)


def draco(
    method: Annotated[
        str, typer.Option(help="sequential, edgebreaker-standard or edgebreaker-valence.")
    ] = "edgebreaker-standard",
    quantization: Annotated[
        int | None,
        typer.Option(min=0, max=30, help="Bits an axis, 0 for none; else by the error asked for."),
    ] = None,
) -> None:
    """Serve Draco, by the package DracoPy, as an adapter. Clause: ORCL-CODEC-11."""
    from clers.oracle.codecs import draco as codec

    _one_of(method, tuple(codec.LEVELS), "--method")
    _serve(codec.draco(method, quantization))


def meshoptimizer(
    method: Annotated[str, typer.Option(help="triangles or sequence.")] = "triangles",
) -> None:
    """Serve meshoptimizer's vertex and index codecs as an adapter. Clause: ORCL-CODEC-12."""
    from clers.oracle.codecs import meshopt as codec

    _one_of(method, codec.METHODS, "--method")
    _serve(codec.meshoptimizer(method))


def files(
    encode: Annotated[str, typer.Option(help="From a mesh file {in} to a packed file {out}.")],
    decode: Annotated[str, typer.Option(help="From a packed file {in} to a mesh file {out}.")],
    kind: Annotated[
        str, typer.Option("--format", help="Of the mesh files: ply, obj, off or stl.")
    ] = "ply",
    suffix: Annotated[str, typer.Option(help="Of the packed file.")] = ".bin",
    seconds: Annotated[float, typer.Option(min=0.1, help="For each command, at most.")] = 4.0,
) -> None:
    """Serve any codec that has a command-line encoder and decoder. Clause: ORCL-CODEC-13."""
    from clers.meshfile.formats import Format
    from clers.oracle.codecs import files as codec

    _one_of(kind, tuple(Format), "--format")
    _serve(codec.files(encode, decode, Format(kind), suffix, seconds))
