"""The manifests of meshes: what they say of a mesh, and how they are read."""

from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import Final

import msgspec

from clers.conventions.result import Accepted, Rejected, and_then
from clers.meshfile.faults import unreadable
from clers.meshfile.reading import contents

SMALL: Final = Path("corpus/meshes/manifest.json")
"""The meshes that are kept here, small and of every kind. Clause: TOOL-CORPUS-3."""

LARGER: Final = Path("corpus/larger.json")
"""The meshes that are fetched when wanted. Clause: TOOL-CORPUS-6."""

DIRTY: Final = Path("corpus/meshes/dirty/manifest.json")
"""The files with faults. Clause: TOOL-CORPUS-4."""


class Client(StrEnum):
    """The ordinary client of a registry of packages. Clause: TOOL-CORPUS-6."""

    NPM = "npm"
    DEBIAN = "debian"


@dataclass(frozen=True, slots=True)
class Source:
    """One file of one version of a package; `member` is its path in a tar file at `path`, if any.

    Clause: TOOL-CORPUS-1.
    """

    client: Client
    package: str
    version: str
    path: str
    sha256: str
    member: str = ""

    @property
    def file(self) -> str:
        """The path of the file itself."""
        return self.member or self.path


@dataclass(frozen=True, slots=True)
class Licence:
    """An SPDX name, the sentence that grants it, and the document where this stands."""

    spdx: str
    sentence: str
    document: str


@dataclass(frozen=True, slots=True)
class Counts:
    """Numbers of a mesh; `closed` counts components without boundary, `handles` sums genera."""

    vertices: int
    faces: int
    components: int
    closed: int
    handles: int
    curves: int


@dataclass(frozen=True, slots=True)
class Fault:
    """What is wrong with a mesh: reason, clause, and element as `--json` prints it."""

    reason: str
    clause: str
    at: dict[str, int | str]


@dataclass(frozen=True, slots=True)
class Entry:
    """A mesh that can be fetched. Clause: TOOL-CORPUS-1. It has `counts`, or is `rejected`."""

    name: str
    file: str
    sha256: str
    bytes: int
    source: Source
    author: str
    licence: str
    about: str
    counts: Counts | None = None
    rejected: Fault | None = None


@dataclass(frozen=True, slots=True)
class Manifest:
    """Meshes, and the licences that their entries name."""

    about: str
    licences: dict[str, Licence]
    meshes: tuple[Entry, ...]


@dataclass(frozen=True, slots=True)
class Dirty:
    """A file with one fault, made by hand. Clause: TOOL-CORPUS-4."""

    name: str
    file: str
    sha256: str
    about: str
    rejected: Fault


@dataclass(frozen=True, slots=True)
class DirtyManifest:
    """The files with faults."""

    about: str
    meshes: tuple[Dirty, ...]


def manifest(path: Path) -> Accepted[Manifest] | Rejected:
    """A manifest of meshes as it stands in a file. Clauses: TOOL-CORPUS-1, TOOL-READ-5."""
    return and_then(contents(path), _manifest)


def _manifest(data: bytes) -> Accepted[Manifest] | Rejected:
    try:
        return Accepted(msgspec.json.decode(data, type=Manifest))
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as error:
        return unreadable(str(error))


def dirty_manifest(path: Path) -> Accepted[DirtyManifest] | Rejected:
    """The manifest of files with faults. Clauses: TOOL-CORPUS-4, TOOL-READ-5."""
    return and_then(contents(path), _dirty_manifest)


def _dirty_manifest(data: bytes) -> Accepted[DirtyManifest] | Rejected:
    try:
        return Accepted(msgspec.json.decode(data, type=DirtyManifest))
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as error:
        return unreadable(str(error))
