"""Any codec with a command-line encoder and decoder, through files. Clause: ORCL-CODEC-13."""

import shlex
import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final

from clers.conformance import payloads as form
from clers.conformance.messages import Failure
from clers.conventions.result import Rejected, and_then
from clers.meshfile.atomic import write_bytes
from clers.meshfile.formats import Format
from clers.meshfile.reading import read
from clers.meshfile.rendering import render
from clers.oracle.codecs.codec import Answer, Codec, Missing, refused
from clers.oracle.codecs.prepared import Prepared, prepared
from clers.oracle.codecs.raw import mesh_in, raw_of

LONGEST: Final = 400
"""So many characters of what a command said are handed on, from its end."""


@dataclass(frozen=True, slots=True)
class Setting:
    """The two command lines as words, the format of meshes, the suffix of what is compressed."""

    encode: tuple[str, ...]
    decode: tuple[str, ...]
    format: Format
    suffix: str
    seconds: float


def files(
    encode: str, decode: str, of: Format, suffix: str = ".bin", seconds: float = 4.0
) -> Codec | Missing:
    """The codec that two command lines make, or what is wrong with them. ORCL-CODEC-10, -13."""
    lines: list[tuple[str, ...]] = []
    for name, line in (("--encode", encode), ("--decode", decode)):
        try:
            words = tuple(shlex.split(line))
        except ValueError as fault:
            return Missing(f"{name}: {fault}")
        lacking = [hole for hole in ("{in}", "{out}") if not any(hole in word for word in words)]
        if lacking:
            return Missing(f"{name}: there is no {' and no '.join(lacking)} in {line!r}")
        if shutil.which(words[0]) is None:
            return Missing(f"{name}: no program {words[0]!r} is found")
        lines.append(words)
    setting = Setting(lines[0], lines[1], of, suffix, seconds)
    policy = {"encode": encode, "decode": decode, "format": str(of)}
    return Codec(Path(lines[0][0]).name, "", "", partial(_through, setting), policy)


def _through(by: Setting, given: form.ThroughForm) -> Answer:
    mesh = prepared(given)
    if not isinstance(mesh, Prepared):
        return mesh
    with TemporaryDirectory(prefix="clers-") as name:
        folder = Path(name)
        start, packed, end = (
            folder / f"mesh.{by.format}",
            folder / f"packed{by.suffix}",
            folder / f"back.{by.format}",
        )
        written = and_then(render(by.format, raw_of(mesh)), lambda data: write_bytes(start, data))
        if isinstance(written, Rejected):
            return refused(f"{by.format} cannot hold it: {written.line()}", str(written.reason))
        fault = _run(by.encode, start, packed, by.seconds)
        if isinstance(fault, Ended):
            return refused(fault.said("the encoder"))
        fault = fault or _run(by.decode, packed, end, by.seconds)
        if fault is not None:
            return Failure(fault.said("the decoder") if isinstance(fault, Ended) else fault.why)
        found = read(end)
        if isinstance(found, Rejected):
            return Failure(f"what the decoder wrote is no {by.format} file: {found.line()}")
        back = mesh_in(found.value)
        return back if mesh.placed else form.MeshForm(faces=back.faces, vertices=back.vertices)


@dataclass(frozen=True, slots=True)
class Ended:
    """A command ended with an exit code above 0, and what it said."""

    code: int
    words: str

    def said(self, who: str) -> str:
        """The fault in one line."""
        return f"{who} ended with exit code {self.code}: {self.words}"


@dataclass(frozen=True, slots=True)
class Broken:
    """A command was ended by a signal, took too long, or wrote nothing."""

    why: str


def _run(words: Sequence[str], source: Path, target: Path, seconds: float) -> Ended | Broken | None:
    """Run a command on two files; what went wrong, if anything did. Clause: ORCL-CODEC-13."""
    command = [w.replace("{in}", str(source)).replace("{out}", str(target)) for w in words]
    try:
        ran = subprocess.run(
            command, stdin=subprocess.DEVNULL, capture_output=True, timeout=seconds, check=False
        )
    except subprocess.TimeoutExpired:
        return Broken(f"{words[0]} took more than {seconds:g} s")
    except OSError as fault:
        return Broken(f"{words[0]} cannot be started: {fault.strerror}")
    said = " ".join((ran.stderr + b" " + ran.stdout).decode(errors="replace").split())[-LONGEST:]
    if ran.returncode > 0:
        return Ended(ran.returncode, said)
    if ran.returncode < 0:
        return Broken(f"{words[0]} was ended by signal {-ran.returncode}: {said}")
    if not target.is_file():
        return Broken(f"{words[0]} ended well and wrote no file: {said}")
    return None
