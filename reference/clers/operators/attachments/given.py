"""The domains that laws of attachments range over; `clers.generate` draws from them."""

from dataclasses import dataclass
from typing import Final

from clers.complexes.simplicial import Complex
from clers.conventions.law import Given
from clers.operators.attachments.attachment import Attachment
from clers.operators.attachments.gluing import Gluing
from clers.operators.attachments.operator import CurveOperator, Handle, Operator, Script


@dataclass(frozen=True, slots=True)
class Gluable:
    """A complex and an attachment that may apply to it or not. Clause: OPER-ATTACH-2."""

    before: Complex
    glued: Attachment


@dataclass(frozen=True, slots=True)
class Unnamed:
    """A complex and a gluing that may fit it or not. Clause: OPER-ATTACH-9."""

    before: Complex
    gluing: Gluing


@dataclass(frozen=True, slots=True)
class OperatorStep:
    """A complex and any operator, applicable or not. Clause: OPER-ATTACH-3."""

    before: Complex
    operator: Operator


@dataclass(frozen=True, slots=True)
class CurveStep:
    """A complex of vertices and edges and a curve operator. Clause: OPER-CURVE-1."""

    before: Complex
    operator: CurveOperator


@dataclass(frozen=True, slots=True)
class SolidStep:
    """A 3-manifold and a handle, applicable or not. Clause: OPER-SOLID-5."""

    before: Complex
    operator: Handle


@dataclass(frozen=True, slots=True)
class AnyScript:
    """A list of operators, applicable or not. Clause: OPER-ATTACH-7."""

    script: Script


SMALL_COMPLEXES: Final = Given(
    "complexes-to-build", "complexes of dimension 4 at most, empty or not", Complex
)
GLUABLE: Final = Given(
    "attachments", "a complex and an attachment of dimension 4 at most, applicable or not", Gluable
)
AT_MANIFOLDS: Final = Given(
    "attachments-to-manifolds",
    "a manifold of dimension 1, 2 or 3 and a simplex of that dimension glued to it",
    Gluable,
)
UNNAMED: Final = Given("gluings", "a complex and a gluing without names", Unnamed)
OPERATOR_STEPS: Final = Given(
    "attachment-steps", "a complex and an operator of attachments, applicable or not", OperatorStep
)
CURVE_STEPS: Final = Given(
    "curve-steps", "vertices and edges, and an operator of curves", CurveStep
)
SOLID_STEPS: Final = Given(
    "solid-handles", "a 3-manifold and a handle, applicable or not", SolidStep
)
SCRIPTS: Final = Given("attachment-scripts", "scripts of attachments from nothing", AnyScript)
