"""Cases that mistakes asked for: each brings one to light that all others let pass.

Clause: ORCL-MUTANT-8.
"""

from collections.abc import Iterator

from clers.conformance import payloads as form
from clers.conventions.clause import Clause
from clers.oracle.positives.asked import Asked
from clers.oracle.positives.messages import Told, coded
from clers.oracle.positives.scripts import asked

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
)
"""Operators that do nothing, for an edge is there."""


def from_mutants() -> Iterator[Asked]:
    """Messages and scripts. Clause: ORCL-MUTANT-8."""
    for tale in TOLD:
        yield from coded("arithmetic", tale)
    for slug, script, clause in SCRIPTS:
        yield asked(slug, script, (Clause.OPER_FAMILY_3, clause))
