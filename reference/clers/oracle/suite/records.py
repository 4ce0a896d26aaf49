"""What the files of a suite say, as frozen records. Clauses: ORCL-SUITE-1, ORCL-SUITE-2."""

from typing import Annotated, Final

from msgspec import UNSET, Meta, Struct, UnsetType

from clers.conformance.cases.case import Case, Name

FORMAT: Final = 1
"""The number of this form of a suite. Clause: ORCL-SUITE-2."""

Digest = Annotated[str, Meta(pattern="^[0-9a-f]{64}$")]
"""A SHA-256, in hexadecimal."""


class Part(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A file of cases: those of one profile and one operation. Clause: ORCL-SUITE-1."""

    profile: str
    op: str
    cases: tuple[Case, ...]


class Flag(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A mistake that cases bring to light: what it is, and why it matters. Clause: ORCL-CASE-5."""

    name: str
    mistake: str
    matters: str


class Flags(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """The file `flags.json`. Clause: ORCL-CASE-5."""

    flags: tuple[Flag, ...]


class Retired(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True, omit_defaults=True):
    """A case that is no longer asked, why, and the one that took its place. ORCL-SUITE-6."""

    id: Name
    reason: str
    successor: str = ""


class RetiredList(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """The file `retired.json`. Clause: ORCL-SUITE-6."""

    retired: tuple[Retired, ...]


class Canaries(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """The file `canaries.json`: wrong cases, which everybody must fail. Clause: ORCL-SUITE-7."""

    cases: tuple[Case, ...]


class FileEntry(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A file of cases, as the manifest has it. Clause: ORCL-SUITE-2."""

    path: str
    profile: str
    op: str
    cases: int
    sha256: Digest


class OtherEntry(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Another file of the folder, as the manifest has it. Clause: ORCL-SUITE-2."""

    path: str
    sha256: Digest


class ProfileEntry(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A profile: what its cases ask, and how many they are. Clauses: ORCL-SUITE-2, ORCL-SUITE-3."""

    name: str
    about: str
    cases: int


class Survivor(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A fault that no case brings to light, and why. Clause: ORCL-SUITE-2."""

    mutant: str
    why: str


class Score(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """How many seeded faults the cases of the suite named bring to light. Clause: ORCL-SUITE-2."""

    suite: str
    mutants: int
    killed: int
    survivors: tuple[Survivor, ...] = ()


class Manifest(
    Struct, frozen=True, forbid_unknown_fields=True, kw_only=True, rename={"count": "cases"}
):
    """The file `manifest.json`: what belongs to the suite. Clause: ORCL-SUITE-2.

    `suite` is the suite's name, `count` the number of its cases, canaries not among them.
    """

    format: int
    spec: str
    suite: str
    count: int
    profiles: tuple[ProfileEntry, ...]
    files: tuple[FileEntry, ...]
    others: tuple[OtherEntry, ...]
    mutation: Score | UnsetType = UNSET
