"""`clers bench builds`: do compiled and interpreted kernels give the same bits?

Meshes are drawn and vectors answered twice: in this process with machine code, and in a second one
with CLERS_KERNELS=interpreted. Each says of every mesh and case a hash of all that came out.
Clause: TOOL-BUILD-6.
"""

import os
import subprocess
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from hashlib import sha256
from itertools import zip_longest
from random import Random

import msgspec

from clers.codes.registry import CodeName
from clers.complexes.corner_table import face_list, surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.container import file
from clers.container.options import InBits, Options
from clers.conventions.result import Rejected, and_then
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.stream import Stream
from clers.generate.bounds import FIRST, go_on
from clers.generate.kinds import random_script
from clers.generate.uniform import uniform_sphere
from clers.geometry.positions import Positions, Precision
from clers.operators.script import AddHandle, AddTetrahedron, OpenCurve, Operator, Relabel
from clers.oracle.suite.answers import outcome_of
from clers.oracle.suite.files import Suite

Said = tuple[str, str]
"""The name of a mesh or a case, and the hash of what came out."""


def of_meshes(count: int, seed: int) -> Iterator[Said]:
    """What the build makes of random meshes of any genus, with curves and components."""
    for k in range(count):
        random = Random(f"{seed} {k}")
        yield f"mesh-{seed}-{k}", of_mesh(random_mesh(random), random)


def random_mesh(random: Random) -> Surface:
    """A sphere, all of a size as likely; or what a script grows, opens, joins and grows again.

    Not drawn by Hypothesis: it also draws the constants that it sees in the sources it finds
    imported, and those of compiled modules it does not see.
    """
    if random.randrange(8) == 0:
        return uniform_sphere(random.randrange(4, 60), random.randrange(1 << 30))
    between: list[Operator] = [AddTetrahedron()] * random.choice((0, 0, 0, 1, 3))
    between += [AddHandle(_any(random), _any(random)) for _ in range(random.choice((0, 0, 1, 3)))]
    between += [OpenCurve(_any(random)) for _ in range(random.choice((0, 0, 1, 4)))]
    random.shuffle(between)
    first, last = (random_script(_any(random), random.randrange(30)) for _ in range(2))
    grown = go_on(FIRST, (*first, *between, *last, Relabel(_any(random))))
    built = surface(grown.mesh)
    if isinstance(built, Rejected):
        raise AssertionError(built.line())
    return built.value


def _any(random: Random) -> int:
    return random.randrange(1 << 30)


def of_mesh(mesh: Surface, random: Random) -> str:
    """The hash of a mesh's stream, its file in each code and what that decodes to, and faults."""
    encoding = encode(mesh)
    said = sha256(repr(encoding).encode())
    flat = tuple(random.randrange(1 << 10) / 8 for _ in range(3 * mesh.vertices))
    for code in CodeName:
        places = Positions(Precision.F32, flat) if code is CodeName.GOLDEN else None
        written = file.encode(mesh, places, Options(code, InBits(12)))
        said.update(repr((written, and_then(written, file.decode))).encode())
    for stream in damaged(encoding.stream, random):
        said.update(repr(decode(stream)).encode())
    for faces in spoilt(face_list(mesh), random):
        said.update(repr(surface(faces)).encode())
    return said.hexdigest()


def damaged(stream: Stream, random: Random) -> Iterator[Stream]:
    """The stream; with another symbol; with another beginning; without its last record."""
    word, records, boundary = stream.word, stream.records, stream.components_with_boundary
    at = random.randrange(len(word))
    yield stream
    yield Stream(f"{word[:at]}{random.choice('CLERS')}{word[at + 1 :]}", records, boundary)
    yield Stream(word, records, random.randrange(boundary + 2))
    yield Stream(word, records[:-1], boundary)


def spoilt(given: FaceList, random: Random) -> Iterator[FaceList]:
    """The face list with one face gone; turned over; with one corner at another vertex."""
    faces, at = given.faces, random.randrange(len(given.faces))
    before, (a, b, c), after = faces[:at], faces[at], faces[at + 1 :]
    yield FaceList((*before, *after), given.vertices)
    yield FaceList((*before, (a, c, b), *after), given.vertices)
    other = random.randrange(given.vertices)
    yield FaceList((*before, (a, b, other), *after), given.vertices)


def of_vectors(suite: Suite) -> Iterator[Said]:
    """What the build answers to the vectors of a suite."""
    for case in suite.cases:
        yield case.id, sha256(msgspec.json.encode(outcome_of(case))).hexdigest()


def first_difference(ours: Iterable[Said], theirs: Iterable[Said]) -> tuple[int, str]:
    """How many say the same before the first that do not, and the name of that one; or ""."""
    same = 0
    for mine, other in zip_longest(ours, theirs):
        if mine != other:
            return same, (mine or other or ("", ""))[0]
        same += 1
    return same, ""


@contextmanager
def interpreted(count: int, seed: int, vectors: bool) -> Iterator[Iterator[Said]]:
    """The same from a process whose kernels are interpreted."""
    words = [
        "--count",
        str(count),
        "--seed",
        str(seed),
        "--say",
        *([] if vectors else ["--meshes"]),
    ]
    with subprocess.Popen(
        [sys.executable, "-m", "clers", "bench", "builds", *words],
        env={**os.environ, "CLERS_KERNELS": "interpreted"},
        stdout=subprocess.PIPE,
        text=True,
    ) as child:
        assert child.stdout is not None
        try:
            yield (_pair(row) for row in child.stdout)
        finally:
            child.kill()


def _pair(row: str) -> Said:
    name, _, said = row.strip().partition(" ")
    return name, said
