"""Cases that mistakes asked for: each brings one to light that all others let pass.

Clause: ORCL-MUTANT-8.
"""

from collections.abc import Iterator

from clers.codes.registry import CodeName
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.samples import FACES
from clers.conventions.clause import Clause
from clers.oracle.positives.asked import Asked
from clers.oracle.positives.messages import Told, coded
from clers.oracle.positives.scripts import asked
from clers.oracle.positives.stock import grown
from clers.oracle.positives.words import coded as in_code

TOLD = (
    Told(
        "ends-just-over-half",
        form.StaticForm(frequencies=(33298612, 358451363, 1, 525850734, 156140912)),
        (4, 4, 4, 2),
        ("pending-bits",),
        "after the last symbol high is 2Q before any shift, and in no lower half",
    ),
    Told(
        "ends-just-over-three-quarters",
        form.StaticForm(frequencies=(288392139, 1, 560151786, 103516330, 121680822)),
        (0, 4, 4, 0, 2),
        ("pending-bits",),
        "after the last symbol high is 3Q before any shift, and in no central half",
    ),
)
"""Numbers found by a search: a state that ends just where no half does any more."""

SCRIPTS = (
    ("corner-of-joined-ends", "open-curve 0; add-ear 2; fill-corner 4", Clause.OPER_BORDER_2),
    ("bridge-onto-edge", "open-curve 0; cut-edge 8; bridge 36 14", Clause.OPER_TUBE_5),
    (
        "bridge-with-ends-joined",
        "open-curve 0; add-ear 11; cut-edge 29; bridge 26 23",
        Clause.OPER_TUBE_5,
    ),
)
"""Operators that do nothing, for an edge is there."""


SHORTEST_IN_GOLDEN = (
    ("disk-for-golden", grown(0, 1, 1, 40, 2)),
    ("torus-for-golden", grown(1, 0, 1, 20, 2)),
)
"""Surfaces whose word no code but `golden` makes so short: `best` has to try it."""

LOW = float(-(1 << 53))
AT_THE_EDGE = form.ToFile(
    faces=FACES,
    vertices=4,
    positions=form.Places(
        precision="f64", coordinates=(LOW, 0, 0, LOW + 1, 0, 0, LOW, 1, 0, LOW, 0, 1)
    ),
    code="plain",
    accuracy=form.BitsForm(bits=10),
)
"""At the exponent 0 all axes have few steps, but the lowest number is none of the lattice."""


def from_mutants() -> Iterator[Asked]:
    """Messages, scripts, words, a mesh. Clause: ORCL-MUTANT-8."""
    for name, surface in SHORTEST_IN_GOLDEN:
        yield from in_code(CodeName.BEST, name, surface, "generated")
    yield Asked(
        "lowest-number-of-no-lattice", "mesh.encode", message.MeshEncode(id=0, input=AT_THE_EDGE),
        (Clause.GEOM_CHOICE_1, Clause.GEOM_LATTICE_3), "hand", ("code.plain",), 4,
    )  # fmt: skip
    for tale in TOLD:
        yield from coded("arithmetic", tale)
    for slug, script, clause in SCRIPTS:
        yield asked(slug, script, (Clause.OPER_FAMILY_3, clause))
