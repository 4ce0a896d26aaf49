"""Meshes from public packages, and the hashes of those that are here."""

from hashlib import sha256
from pathlib import Path

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.corpus import npm_module
from clers.corpus.manifest import Entry
from clers.corpus.obtain import Obtain
from clers.meshfile.atomic import unwritable, write_bytes
from clers.meshfile.formats import format_of
from clers.meshfile.mesh import RawMesh
from clers.meshfile.reading import contents, parse
from clers.meshfile.rendering import render


def verify(entry: Entry, folder: Path) -> Accepted[Path] | Rejected:
    """The file of an entry, if it is as stated. Clause: TOOL-CORPUS-5."""
    path = folder / entry.file
    return and_then(
        contents(path),
        lambda data: and_then(
            same_hash(data, entry.sha256, Clause.TOOL_CORPUS_5), lambda _: Accepted(path)
        ),
    )


def fetch(entry: Entry, folder: Path, by: Obtain) -> Accepted[Path] | Rejected:
    """The file of an entry in a folder, obtained unless it is there already.

    Clause: TOOL-CORPUS-6. The folder is made if there is none.
    """
    there = verify(entry, folder)
    if isinstance(there, Accepted):
        return there
    made = and_then(by(entry.source), lambda data: mesh_file(entry, data))
    return and_then(made, lambda data: _put(folder, entry.file, data))


def _put(folder: Path, file: str, data: bytes) -> Accepted[Path] | Rejected:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        return unwritable(error.strerror or str(error))
    return write_bytes(folder / file, data)


def mesh_file(entry: Entry, data: bytes) -> Accepted[bytes] | Rejected:
    """The entry's file, from the bytes of its source's; pure. Clauses: TOOL-CORPUS-2, -6."""
    return and_then(
        same_hash(data, entry.source.sha256, Clause.TOOL_CORPUS_6),
        lambda sound: and_then(
            converted(sound, Path(entry.source.file), Path(entry.file)),
            lambda made: same_hash(made, entry.sha256, Clause.TOOL_CORPUS_6),
        ),
    )


def converted(data: bytes, source: Path, target: Path) -> Accepted[bytes] | Rejected:
    """The bytes of a source as a file of another name. Clause: TOOL-CORPUS-2."""
    if source.suffix == target.suffix:
        return Accepted(data)
    return and_then(
        _parsed(data, source),
        lambda mesh: and_then(format_of(target), lambda known: render(known, mesh)),
    )


def _parsed(data: bytes, source: Path) -> Accepted[RawMesh] | Rejected:
    if source.suffix == ".js":
        return npm_module.parse(data)
    return and_then(format_of(source), lambda known: parse(known, data))


def same_hash(data: bytes, stated: str, clause: Clause) -> Accepted[bytes] | Rejected:
    """The bytes, if they have the stated SHA-256. Clauses: TOOL-CORPUS-5, TOOL-CORPUS-6."""
    got = sha256(data).hexdigest()
    if got != stated:
        detail = f"SHA-256 is {got}, stated is {stated}"
        return Rejected(Reason.BAD_CHECKSUM, clause, detail=detail)
    return Accepted(data)
