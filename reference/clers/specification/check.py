"""All rules on the specification, as one list. Clause: CONV-CLAUSE-2."""

from typing import Final

from clers.specification.coverage import implemented, judged, parses, read_again
from clers.specification.examples import as_shown
from clers.specification.finding import Finding, Rule
from clers.specification.identity import (
    cited_exists,
    generated,
    in_its_chapter,
    laws_written_once,
    numbered,
    stated_once,
    well_formed,
)
from clers.specification.imports import earlier_only
from clers.specification.leave import every_may
from clers.specification.links import indexed, resolved
from clers.specification.numbers import as_computed
from clers.specification.proofs import RULES as PROOFS
from clers.specification.reasons import reasons_said
from clers.specification.registry import registered
from clers.specification.repository import Repository
from clers.specification.tutorial import every_place
from clers.specification.values import VALUES
from clers.specification.worked.rule import as_worked

RULES: Final[tuple[Rule, ...]] = (
    well_formed,
    stated_once,
    numbered,
    in_its_chapter,
    parses,
    cited_exists,
    implemented,
    judged,
    laws_written_once,
    registered,
    read_again,
    generated,
    resolved,
    indexed,
    as_shown,
    as_computed(VALUES),
    as_worked,
    earlier_only,
    every_may,
    every_place,
    reasons_said,
    *PROOFS,
)


def check(of: Repository) -> tuple[Finding, ...]:
    """Everything wrong with a repository's specification; nothing means that all rules hold."""
    return tuple(finding for rule in RULES for finding in rule(of))
