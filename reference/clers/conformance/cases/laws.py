"""The laws of cases: edits lead back, and sealing a file anew heals no more than its seals."""

from dataclasses import dataclass
from typing import Final

from msgspec import Raw

from clers.conformance.cases.case import Edit
from clers.conformance.cases.edits import NoEdit, edited, inverse, same_input
from clers.conformance.cases.seals import resealed
from clers.container.file import inspect
from clers.container.given import FILES
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Given, Law, every, same
from clers.conventions.result import Accepted
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE


@dataclass(frozen=True, slots=True)
class Editing:
    """A JSON value, and edits of which each has its place."""

    given: Raw
    edits: tuple[Edit, ...]


EDITING: Final = Given("edited-values", "JSON values, each with edits that apply to it", Editing)


def _leads_back(editing: Editing) -> Verdict:
    """There by the edits, and back by their inverse; a second time back there is no way."""
    there = edited(editing.given, editing.edits)
    if isinstance(there, NoEdit):
        return Fails("a value", there.why, WHOLE)
    back = edited(there, inverse(editing.edits))
    if isinstance(back, NoEdit):
        return Fails("the value before", back.why, WHOLE)
    return every(
        same(True, same_input(editing.given, back)),
        same(editing.edits, inverse(inverse(editing.edits))),
    )


def _seals_alone(data: bytes) -> Verdict:
    """What is sound stays as it is; twice is once; the length and the first nine bytes stay."""
    once = resealed(data)
    sound = isinstance(inspect(data), Accepted)
    return every(
        same(data, once) if sound else Holds(),
        same(once, resealed(once)),
        same((len(data), data[:9]), (len(once), once[:9])),
    )


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "edits-are-undone-by-their-inverse",
        Clause.ORCL_FAULT_6,
        "a value, edited and edited back in the opposite order, is the value",
        EDITING,
        _leads_back,
    ),
    Law(
        "sealing-changes-seals-alone",
        Clause.ORCL_FAULT_2,
        "making the seals of a file anew changes no sound file, and twice is as once",
        FILES,
        _seals_alone,
    ),
)
