"""The operators on sheets, as data: each names what it needs and makes by vertices."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class MakeSTV:
    """χ+1, c+1, b+1: an initial triangle. Clause: OPER-EULER-1."""

    p: int
    q: int
    r: int


@dataclass(frozen=True, slots=True)
class MakeEV:
    """χ+0: an edge to a new vertex `v`, from the corner of `a` before a → b. OPER-EULER-2."""

    a: int
    b: int
    v: int


@dataclass(frozen=True, slots=True)
class MakeTE:
    """χ+0: a triangle on bounding edges a → b → c, and the edge ac. Clause: OPER-EULER-3."""

    a: int
    b: int
    c: int


@dataclass(frozen=True, slots=True)
class MakeSG:
    """χ+1, b−1: a triangle closes a loop of three edges. Clause: OPER-EULER-4."""

    a: int
    b: int
    c: int


@dataclass(frozen=True, slots=True)
class MakeEKL:
    """χ−1, b−1, and g+1 or c−1: an edge joins the corners before a → b, c → d. OPER-EULER-5."""

    a: int
    b: int
    c: int
    d: int


@dataclass(frozen=True, slots=True)
class ZeroHandle:
    """χ+1, c+1, b+1: a new component, one triangle. Clause: OPER-SURFACE-1."""

    p: int
    q: int
    r: int


@dataclass(frozen=True, slots=True)
class ZeroHandlePolygon:
    """χ+1, c+1, b+1: a new component, one infinite face. Clause: OPER-SURFACE-1."""

    polygon: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Complete:
    """χ+0: a triangle on two consecutive bounding edges a → b → c. Clause: OPER-SURFACE-2."""

    a: int
    b: int
    c: int


@dataclass(frozen=True, slots=True)
class Glue:
    """χ+0: a triangle with a new vertex `v` on the bounding edge a → b. OPER-SURFACE-3."""

    a: int
    b: int
    v: int


@dataclass(frozen=True, slots=True)
class Join:
    """χ−1, c−1, b−1: a triangle (a, b, c) to another component. Clause: OPER-SURFACE-4."""

    a: int
    b: int
    c: int
    d: int


@dataclass(frozen=True, slots=True)
class Lower:
    """χ−1, b+1: a triangle (a, b, c) cuts a loop. Clause: OPER-SURFACE-5."""

    a: int
    b: int
    c: int
    d: int


@dataclass(frozen=True, slots=True)
class Upper:
    """χ−1, g+1, b−1: a triangle (a, b, c) joins loops of a component. Clause: OPER-SURFACE-6."""

    a: int
    b: int
    c: int
    d: int


@dataclass(frozen=True, slots=True)
class TwoHandle:
    """χ+1, b−1: a triangle closes a loop of three edges. Clause: OPER-SURFACE-7."""

    a: int
    b: int
    c: int


@dataclass(frozen=True, slots=True)
class JoinStrip:
    """χ−1, c−1, b−1: two triangles glue a → b to c → d. Clause: OPER-SURFACE-9."""

    a: int
    b: int
    c: int
    d: int


@dataclass(frozen=True, slots=True)
class LowerStrip:
    """χ−1, b+1: two triangles glue a → b to c → d. Clause: OPER-SURFACE-9, Figure 11."""

    a: int
    b: int
    c: int
    d: int


@dataclass(frozen=True, slots=True)
class UpperStrip:
    """χ−1, g+1, b−1: two triangles glue a → b to c → d. Clause: OPER-SURFACE-9, Figure 12."""

    a: int
    b: int
    c: int
    d: int


Euler = MakeSTV | MakeEV | MakeTE | MakeSG | MakeEKL
"""The five Euler operators that make. Clauses: OPER-EULER-1 … OPER-EULER-6."""

OneHandle = Join | Lower | Upper
Strip = JoinStrip | LowerStrip | UpperStrip
Handle = ZeroHandle | ZeroHandlePolygon | Complete | Glue | OneHandle | TwoHandle
"""The handle operators of one triangle. Clauses: OPER-SURFACE-1 … OPER-SURFACE-7."""

Constructive = Euler | Handle | Strip


@dataclass(frozen=True, slots=True)
class Undo:
    """The inverse of an operator that makes, with the same operands. Clause: OPER-SHEET-6."""

    of: Constructive


Operator = Constructive | Undo
Script = tuple[Operator, ...]


def inverse(operator: Operator) -> Operator:
    """Undo what makes, make what undoes. An involution. Clause: OPER-SHEET-6."""
    match operator:
        case Undo(of):
            return of
        case _:
            return Undo(operator)


def taken_apart(script: Script) -> Script:
    """The inverses in reverse order. Clauses: OPER-SHEET-6, OPER-BUILD-2."""
    return tuple(inverse(operator) for operator in reversed(script))
