"""A suite as a folder of files: read whole and strictly. Clauses: ORCL-SUITE-1, ORCL-SUITE-2."""

from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Final, TypeVar

import msgspec

from clers.conformance.cases.case import Case
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.oracle.suite.records import (
    FORMAT,
    Canaries,
    Flag,
    Flags,
    Manifest,
    Part,
    Retired,
    RetiredList,
)

DEFAULT: Final = Path(__file__).resolve().parents[4] / "corpus" / "vectors"
"""The suite that belongs to this checkout. Clause: ORCL-SUITE-1."""

MANIFEST: Final = "manifest.json"
FLAGS: Final = "flags.json"
RETIRED: Final = "retired.json"
CANARIES: Final = "canaries.json"
"""The files that every suite has beside its cases. Clause: ORCL-SUITE-1."""

A = TypeVar("A")


@dataclass(frozen=True, slots=True)
class Suite:
    """Golden vectors: the cases by file, in the manifest's order, and all that is said of them.

    Clauses: ORCL-SUITE-1, ORCL-SUITE-2.
    """

    manifest: Manifest
    parts: tuple[Part, ...]
    flags: tuple[Flag, ...]
    retired: tuple[Retired, ...]
    canaries: tuple[Case, ...]

    @property
    def cases(self) -> tuple[Case, ...]:
        """All cases in the order of the manifest; the canaries are not among them."""
        return tuple(case for part in self.parts for case in part.cases)

    @property
    def paths(self) -> tuple[str, ...]:
        """The paths of its files, but for the manifest's."""
        cases = (entry.path for entry in self.manifest.files)
        return (*cases, *(entry.path for entry in self.manifest.others))


def read_suite(folder: Path) -> Accepted[Suite] | Rejected:
    """The suite in a folder, if every file of the manifest is there as it says.

    Rejects a file that cannot be read or is of another form, another checksum, or another number of
    cases; the detail begins with the file's name. Clauses: ORCL-SUITE-1, ORCL-SUITE-2.
    """
    found = read_unsealed(folder)
    if isinstance(found, Rejected):
        return found
    said = found.value.manifest
    digests = {entry.path: entry.sha256 for entry in said.files}
    digests.update((entry.path, entry.sha256) for entry in said.others)
    for path, digest in digests.items():
        data = read_bytes(folder, path)
        if isinstance(data, Rejected):
            return data
        if sha256(data.value).hexdigest() != digest:
            return fault(Reason.BAD_CHECKSUM, path, "its SHA-256 is not the manifest's")
    for entry, part in zip(said.files, found.value.parts, strict=True):
        if len(part.cases) != entry.cases:
            detail = f"{len(part.cases)} cases, {entry.cases} by the manifest"
            return fault(Reason.COUNT_MISMATCH, entry.path, detail)
    if sum(entry.cases for entry in said.files) != said.count:
        return fault(Reason.COUNT_MISMATCH, MANIFEST, f"its files have other than {said.count}")
    return found


def read_unsealed(folder: Path) -> Accepted[Suite] | Rejected:
    """The suite in a folder, whatever its manifest says of checksums and counts.

    For what mends a suite, or names all that is wrong with it. Clause: ORCL-SUITE-1.
    """
    manifest = read_document(folder, MANIFEST, Manifest)
    if isinstance(manifest, Rejected):
        return manifest
    said = manifest.value
    if said.format != FORMAT:
        return fault(Reason.UNKNOWN_VERSION, MANIFEST, f"format {said.format}, not {FORMAT}")
    parts: list[Part] = []
    for entry in said.files:
        part = read_document(folder, entry.path, Part)
        if isinstance(part, Rejected):
            return part
        parts.append(part.value)
    flags = read_document(folder, FLAGS, Flags)
    retired = read_document(folder, RETIRED, RetiredList)
    canaries = read_document(folder, CANARIES, Canaries)
    if isinstance(flags, Rejected):
        return flags
    if isinstance(retired, Rejected):
        return retired
    if isinstance(canaries, Rejected):
        return canaries
    return Accepted(
        Suite(said, tuple(parts), flags.value.flags, retired.value.retired, canaries.value.cases)
    )


def read_bytes(folder: Path, path: str) -> Accepted[bytes] | Rejected:
    """The bytes of a file of the suite; its path must lead nowhere else. Clause: ORCL-SUITE-1."""
    if path.startswith("/") or ".." in path.split("/"):
        return fault(Reason.UNREADABLE_FILE, path, "leads out of the folder")
    try:
        return Accepted((folder / path).read_bytes())
    except (OSError, ValueError) as error:
        why = error.strerror if isinstance(error, OSError) else str(error)
        return fault(Reason.UNREADABLE_FILE, str(folder / path), str(why))


def read_document(folder: Path, path: str, kind: type[A]) -> Accepted[A] | Rejected:
    """What a file of the suite says. Clauses: ORCL-SUITE-1, ORCL-CASE-7."""
    found = read_bytes(folder, path)
    return found if isinstance(found, Rejected) else document(path, found.value, kind)


def document(path: str, data: bytes, kind: type[A]) -> Accepted[A] | Rejected:
    """What a file says, of the form that it must have. Clauses: ORCL-SUITE-1, ORCL-CASE-7."""
    try:
        return Accepted(msgspec.json.decode(data, type=kind))
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as error:
        return fault(Reason.UNREADABLE_FILE, path, str(error))


def fault(reason: Reason, path: str, detail: str) -> Rejected:
    """Why a file of a suite is not good. Clause: ORCL-SUITE-1."""
    return Rejected(reason, Clause.ORCL_SUITE_1, detail=f"{path}: {detail}")
