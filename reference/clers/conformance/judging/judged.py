"""What a case came to. Clauses: ORCL-JUDGE-1, ORCL-JUDGE-4."""

from enum import StrEnum

from msgspec import UNSET, Struct, UnsetType


class Status(StrEnum):
    """What a case came to, in a word. Clause: ORCL-JUDGE-1."""

    PASS = "pass"
    FAIL = "fail"
    SKIP = "skip"
    CRASH = "crash"
    TIMEOUT = "timeout"
    PROTOCOL = "protocol-error"
    ERROR = "error"
    FLAKY = "flaky"
    XFAIL = "xfail"
    XPASS = "xpass"


GOOD = frozenset((Status.PASS, Status.SKIP, Status.XFAIL))
"""What leaves the exit code at 0. Clause: ORCL-CHECK-4."""


class Divergence(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """The first place where an answer parts from what is right. Clause: ORCL-JUDGE-4.

    `kind` is the kind of place, without numbers ("symbol", "face", "byte of WORD"); `place` is the
    place in words ("symbol 5 (S), face 6", "byte 40, in section WORD"); `symbol`, `record`, `face`,
    `vertex`, `bit`, `byte`, `component` and `stage` are that place as numbers, where it has them;
    `triangle` has the vertices that were got in place of a face's.
    """

    kind: str
    place: str
    expected: str
    got: str
    symbol: int | UnsetType = UNSET
    record: int | UnsetType = UNSET
    face: int | UnsetType = UNSET
    vertex: int | UnsetType = UNSET
    bit: int | UnsetType = UNSET
    byte: int | UnsetType = UNSET
    component: int | UnsetType = UNSET
    stage: int | UnsetType = UNSET
    triangle: tuple[int, int, int] | UnsetType = UNSET


class Judged(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """A case, judged: its id, operation and clauses, the status, and why in one line.

    `signature` is the class of a failure, the same for failures of one kind whatever the mesh, so
    that a smaller mesh can be known to fail alike. Clauses: ORCL-JUDGE-1, ORCL-JUDGE-5.
    """

    id: str
    op: str
    clauses: tuple[str, ...]
    status: Status
    why: str = ""
    signature: str = ""
    divergence: Divergence | UnsetType = UNSET
