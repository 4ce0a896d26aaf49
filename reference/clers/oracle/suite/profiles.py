"""The profile of a case, from what it asks and requires. Clause: ORCL-SUITE-3."""

from collections.abc import Mapping
from typing import Final

from clers.conformance.cases.case import Case

OF_KIND: Final[Mapping[str, str]] = {
    "arithmetic": "codes",
    "code": "codes",
    "operator": "operators",
    "mesh": "geometry",
    "codec": "geometry",
}
"""The profiles of the operations that have one, by the first word of their name. ORCL-SUITE-3."""

LIMITS: Final = "limits"


def profile_of(case: Case) -> str:
    """The profile of a case that is not of the limits. Clause: ORCL-SUITE-3."""
    kind = case.op.partition(".")[0]
    if kind in OF_KIND:
        return OF_KIND[kind]
    needed = {name.partition(".")[0] for name in case.requires}
    found = [name for name in ("handles", "boundaries", "components") if name in needed]
    return found[0] if len(found) == 1 else "mixed" if found else "core"
