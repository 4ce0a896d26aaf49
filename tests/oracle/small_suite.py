"""A suite that is small enough to be right by sight, and commands to ask."""

import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Final

from msgspec import Raw
from msgspec.json import encode

from clers.conformance.bounds import Bounds
from clers.conformance.cases.case import Case
from clers.conformance.cases.identity import named
from clers.conformance.messages import Rejection
from clers.conventions.reason import Fault
from clers.conventions.result import Accepted
from clers.oracle.runs.pieces import Adapter, meet
from clers.oracle.suite.files import Suite, read_suite
from clers.oracle.suite.records import Part, Retired
from clers.oracle.suite.rendered import suite_files

TESTS: Final = Path(__file__).parent
PATIENT: Final = Bounds(start=30.0, request=20.0, farewell=5.0)
HASTY: Final = replace(PATIENT, request=0.2)

FACES: Final = [[0, 1, 2], [3, 2, 1], [0, 3, 1], [2, 3, 0]]
"""A tetrahedron: the word CRE."""


def right(slug: str, op: str, given: object, ok: object, **more: tuple[str, ...]) -> Case:
    """A case with a result."""
    return named(
        slug,
        Case(
            id="",
            op=op,
            clauses=more.get("clauses", ("ORCL-OP-1",)),
            origin="hand",
            requires=more.get("requires", ()),
            input=Raw(encode(given)),
            ok=Raw(encode(ok)),
        ),
    )


def wrong(slug: str, op: str, given: object, fault: Fault, reason: str) -> Case:
    """A case that is to be rejected."""
    return named(
        slug,
        Case(
            id="",
            op=op,
            clauses=("EB-GRAMMAR-1",),
            origin="hand",
            input=Raw(encode(given)),
            reject=Rejection(fault, reason),
        ),
    )


def word(letters: str) -> dict[str, object]:
    return {"word": letters, "handles": [], "components_with_boundary": 0}


ECHOES: Final = tuple(right(f"echo-{k}", "echo", {"number": k}, {"number": k}) for k in range(10))
WORDS: Final = (
    right(
        "tetrahedron",
        "word.decode",
        word("CRE"),
        {"faces": FACES, "vertices": 4},
        clauses=("EB-DECODE-1",),
    ),
    wrong("no-symbol", "word.decode", word("CRX"), Fault.INVALID, "unknown-symbol"),
)
CODED: Final = (
    right(
        "plain",
        "code.encode",
        {"code": "plain", **word("CRE")},
        {"hex": "bc", "length": 6},
        requires=("code.plain",),
    ),
)
CANARIES: Final = (
    right("canary", "echo", {"right": True}, {"right": False}),
    right("mute-canary", "code.encode", {"code": "plain", **word("CRE")}, {"hex": "", "length": 0}),
)
RETIRED: Final = (
    Retired(id="old-aaaaaaaa", reason="it was wrong", successor=WORDS[0].id),
    Retired(id="gone-aaaaaaaa", reason="it was twice there"),
)


def small_suite(
    folder: Path,
    echoes: Sequence[Case] = ECHOES,
    words: Sequence[Case] = WORDS,
    coded: Sequence[Case] = CODED,
) -> Suite:
    """The suite, written to a folder and read."""
    parts = (
        Part(profile="core", op="echo", cases=tuple(echoes)),
        Part(profile="core", op="word.decode", cases=tuple(words)),
        Part(profile="codes", op="code.encode", cases=tuple(coded)),
    )
    for path, data in suite_files(parts, (), RETIRED, CANARIES, {}).items():
        file = folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(data)
    found = read_suite(folder)
    assert isinstance(found, Accepted), found
    return found.value


def bad_adapter(name: str, *arguments: str) -> tuple[str, ...]:
    """The command of an adapter whose plumbing is bad."""
    folder = TESTS.parent / "conformance" / "bad_adapters"
    return sys.executable, str(folder / f"{name}.py"), *arguments


def wrong_adapter(name: str, *arguments: str) -> tuple[str, ...]:
    """The command of an adapter that is wrong about meshes."""
    return sys.executable, str(TESTS / "wrong_adapters" / f"{name}.py"), *arguments


HEART: Final = wrong_adapter("by_heart")
"""Passes all of the suite, and starts quickly."""

BIT: Final = wrong_adapter("by_heart", "bit")
"""Fails in the last case."""


def adapter(command: Sequence[str], bounds: Bounds = PATIENT) -> Adapter:
    found = meet(command, bounds)
    assert isinstance(found, Adapter), found
    return found
