"""Inputs with two faults: which of them the reference names, as the clauses put them in order."""

from typing import Final

import msgspec
import pytest

from clers.conformance.lines import NoMessage, line_of, request_in
from clers.conformance.messages import Bye, RejectReply
from clers.conformance.serve import serve

Named = tuple[str, dict[str, object], str]
"""The reason, the element and the clause."""

FLAT: Final = {"kind": "static", "frequencies": [1, 1]}
HANDLE: Final = {"kind": "handle", "side": "right"}
CORNER: Final = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]


def bits(digits: str, length: int | None = None) -> dict[str, object]:
    """Binary digits as a message has them, or said to be others than they are."""
    filled = digits + "0" * (-len(digits) % 8)
    octets = (filled[i : i + 8] for i in range(0, len(filled), 8))
    number = len(digits) if length is None else length
    return {"hex": "".join(f"{int(octet, 2):02x}" for octet in octets), "length": number}


def word(code: str, symbols: str, *handles: tuple[int, int], boundaries: int = 0) -> object:
    """The input of `code.encode`: each record has its S and its closing symbol."""
    records = [{**HANDLE, "s": s, "at": at} for s, at in handles]
    return {
        "code": code,
        "word": symbols,
        "handles": records,
        "components_with_boundary": boundaries,
    }


def coded(code: str, given: object, symbols: int, *closings: tuple[int, int]) -> object:
    """The input of `code.decode`: each closing has its *passed* and *between*."""
    seen = [{**HANDLE, "passed": passed, "between": between} for passed, between in closings]
    return {
        "code": code,
        "bits": given,
        "symbols": symbols,
        "components_with_boundary": 0,
        "closings": seen,
    }


def triangle(last: float, accuracy: object, *, precision: str = "f64", faces: object) -> object:
    """The input of `mesh.encode`."""
    places = {"precision": precision, "coordinates": [*CORNER[:-1], last]}
    return {
        "faces": faces,
        "vertices": 3,
        "positions": places,
        "code": "enumerative",
        "accuracy": accuracy,
    }


GOOD: Final = [[0, 1, 2]]
FINE: Final = {"kind": "lattice", "exponent": -60}
NONE: Final = {"kind": "lattice", "exponent": -2000}

ORDERS: Final[dict[str, tuple[str, object, Named]]] = {
    # ORCL-OP-4: the model, the bits as bytes, the message
    "model-before-bytes": (
        "arithmetic.decode",
        {
            "coder": "rans",
            "model": {"kind": "adaptive", "frequencies": [1, -1], "increment": 0, "limit": 0},
            "bits": bits("0", 99),
            "count": 1,
        },
        ("bad-table", {"symbol": 1}, "INFO-STATIC-3"),
    ),
    "bytes-before-message": (
        "arithmetic.decode",
        {"coder": "arithmetic", "model": FLAT, "bits": bits("1" * 9, 1), "count": 9},
        ("trailing-bits", {"byte": 1, "section": ""}, "ARITH-BITS-3"),
    ),
    "too-short-before-too-low": (
        "arithmetic.decode",
        {"coder": "rans", "model": FLAT, "bits": bits("0" * 48), "count": 0},
        ("truncated-bits", {"symbol": 0}, "ARITH-BYTES-2"),
    ),
    # ORCL-OP-6: what codes are given to encode
    "first-symbol-before-records": (
        "code.encode",
        word("plain", "R", (7, 7)),
        ("not-in-alphabet", {"symbol": 0}, "CODE-IMPLIED-2"),
    ),
    "records-before-the-code": (
        "code.encode",
        word("golden", "CLX", (7, 7)),
        ("not-representable", {"record": 0}, "CODE-HAND-2"),
    ),
    "records-from-the-last-on": (
        "code.encode",
        word("plain", "SSREE", (1, 1), (0, 1), (0, 1), boundaries=1),
        ("not-representable", {"record": 1}, "CODE-HAND-2"),
    ),
    "strangers-before-pairs": (
        "code.encode",
        word("golden", "CLX"),
        ("not-in-alphabet", {"symbol": 1}, "CODE-GOLDEN-1"),
    ),
    "strangers-before-factors": (
        "code.encode",
        word("minimax-3", "CLX"),
        ("not-in-alphabet", {"symbol": 1}, "CODE-MINIMAX-4"),
    ),
    "strangers-before-loops": (
        "code.encode",
        word("context", "CXC"),
        ("not-in-alphabet", {"symbol": 0}, "CODE-CONTEXT-1"),
    ),
    "either-in-turn": (
        "code.encode",
        word("king-rossignac", "CLX"),
        ("not-in-alphabet", {"symbol": 0}, "CODE-KR-1"),
    ),
    "records-before-the-sphere": (
        "code.encode",
        word("enumerative", "CSXEE", (0, 1)),
        ("not-representable", {}, "CODE-ENUM-1"),
    ),
    # ORCL-OP-6: what they are given to decode
    "closings-before-bytes": (
        "code.decode",
        coded("plain", bits("0", 99), 0, (0, 0), (0, -1)),
        ("record-out-of-range", {"record": 0}, "CODE-HAND-3"),
    ),
    "bytes-before-no-symbols": (
        "code.decode",
        coded("plain", bits("0", 99), 0),
        ("truncated-bits", {}, "ARITH-BITS-3"),
    ),
    "no-symbols-before-the-code": (
        "code.decode",
        coded("enumerative", bits(""), 0, (0, 0)),
        ("empty-word", {}, "CODE-IMPLIED-2"),
    ),
    "closings-before-odd-numbers-before-bits": (
        "code.decode",
        coded("enumerative", bits(""), 4),
        ("not-representable", {}, "CODE-ENUM-1"),
    ),
    # ORCL-OP-7
    "faces-before-positions": (
        "mesh.encode",
        triangle(1e308, NONE, precision="f32", faces=[[0, 1, 1]]),
        ("repeated-index", {"face": 0}, "CPLX-REJECT-4"),
    ),
    "positions-before-accuracy": (
        "mesh.encode",
        triangle(1e308, NONE, precision="f32", faces=GOOD),
        ("not-representable", {"vertex": 2}, "GEOM-POSITION-4"),
    ),
    "exponent-before-numbers": (
        "mesh.encode",
        triangle(1e308, NONE, faces=GOOD),
        ("bad-lattice", {}, "GEOM-LATTICE-1"),
    ),
    "numbers-before-the-box": (
        "mesh.encode",
        triangle(1.0, FINE, faces=GOOD),
        ("not-representable", {"vertex": 1}, "GEOM-LATTICE-3"),
    ),
    "box-before-the-code": (
        "mesh.encode",
        triangle(1.0, {"kind": "lattice", "exponent": -40}, faces=GOOD),
        ("bad-lattice", {}, "GEOM-BOX-2"),
    ),
    "accuracy-before-the-code": (
        "mesh.encode",
        triangle(1.0, {"kind": "bits", "bits": 0}, faces=GOOD),
        ("bad-lattice", {}, "GEOM-CHOICE-1"),
    ),
}


def named(operation: str, given: object) -> Named:
    """What the reference names of an input that it rejects."""
    asked = msgspec.json.encode({"op": operation, "id": 1, "in": given, "trace": "none"})
    request = request_in(asked)
    assert not isinstance(request, NoMessage | Bye), request
    *_, reply = serve(request)
    assert isinstance(reply, RejectReply), line_of(reply)
    return reply.reject.reason, dict(reply.reject.at), reply.reject.clause


@pytest.mark.parametrize("name", ORDERS)
def test_of_two_faults(name: str) -> None:
    """Clauses: ORCL-OP-4, ORCL-OP-6, ORCL-OP-7, CONV-RESULT-5."""
    operation, given, right = ORDERS[name]
    assert named(operation, given) == right


SCRIPTS: Final = (
    # OPER-FAMILY-1: all is read before anything is applied
    ("attach 0 1 / 0; collapse x", 1, "bad-operand", "OPER-MOVE-8"),
    ("contract 5 / 6; collapse / 0 1", 1, "bad-operand", "OPER-MOVE-8"),
    # OPER-MOVE-2: what can be read is refused in its turn
    ("contract 5 / 6; collapse 1 0 / 0 1", 0, "missing-simplex", "OPER-CONTRACT-1"),
    # OPER-MOVE-3: operands, what is missing, what is there, the condition
    ("attach 0 1; split 5 / 1 / 5 / ", 1, "bad-operand", "OPER-MOVE-2"),
    ("attach 0 1; split 5 / 1 / / ", 1, "missing-simplex", "OPER-CONTRACT-4"),
    ("attach 0 1 2; split 0 / 1 / / 1", 1, "present-simplex", "OPER-CONTRACT-4"),
    # OPER-CONTRACT-4: what does not fit, then what rejects the contraction
    ("attach 0 1; split 0 / 2 / / 1", 1, "wrong-link", "OPER-CONTRACT-4"),
    ("attach 0 1; split 0 / 2 / 1 / 1", 1, "link-condition", "OPER-CONTRACT-1"),
    # OPER-ATTACH-2: what is missing before what is there; a handle's attachments in turn
    ("attach 0 1; attach 0 1 2 / 1 2", 1, "missing-simplex", "OPER-ATTACH-2"),
    ("handle 0 1 / 2 | 1 0", 0, "bad-operand", "OPER-ATTACH-1"),
    ("handle 0 1 / 0 | 1 0", 0, "missing-simplex", "OPER-ATTACH-2"),
    # OPER-ATTACH-3: from the last on; missing ones, ones that stay; then the operator
    ("undo handle 1 0 2 | 3 4 5", 0, "missing-simplex", "OPER-ATTACH-3"),
    ("undo handle 3 4 5 | 1 0 2", 0, "bad-operand", "OPER-ATTACH-1"),
    (
        "attach 0 1; attach 0 2 / 0; attach 0 3 / 0; undo attach 0 1 2",
        3, "missing-simplex", "OPER-ATTACH-3",
    ),
    ("attach 0 1; attach 0 2 / 0; attach 0 3 / 0; undo edge-between-ends 0 1",
     3, "operator-not-applicable", "OPER-CURVE-4"),
    # OPER-CURVE-1: an attachment first, then a curve, then what each asks
    ("attach 0 1 2; edge-between-ends 0 3", 1, "missing-simplex", "OPER-ATTACH-2"),
    ("attach 0 1 2; attach 0 3 / 0; edge-at-interior 3 1", 2, "operator-not-applicable",
     "OPER-CURVE-1"),
)  # fmt: skip


@pytest.mark.parametrize(("script", "step", "reason", "clause"), SCRIPTS)
def test_of_two_faults_in_a_script(script: str, step: int, reason: str, clause: str) -> None:
    """Clauses: ORCL-OP-3, OPER-FAMILY-1, OPER-MOVE-3, OPER-ATTACH-3, OPER-CURVE-1."""
    assert named("operator.apply", {"script": script}) == (reason, {"step": step}, clause)
