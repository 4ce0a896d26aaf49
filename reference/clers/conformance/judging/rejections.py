"""Where rejections part. Clauses: ORCL-JUDGE-7, ORCL-FAULT-3, ORCL-DIVERGE-11."""

from clers.conformance.judging.judged import Divergence
from clers.conformance.messages import Rejection
from clers.conventions.reason import Fault


def of_rejection(right: Rejection, got: Rejection, *, strict: bool) -> Divergence | None:
    """The class; if `strict`, then the reason, the element, the clause. ORCL-DIVERGE-11.

    Limits are a reader's own: where `limit` is right every class is, unless `strict`. ORCL-LIMIT-2.
    """
    if right.fault is Fault.LIMIT and not strict:
        return None
    if right.fault != got.fault:
        kind = f"{got.fault} instead of {right.fault}"
        return _at(kind, "the class of the rejection", line_of(right), line_of(got))
    if not strict:
        return None
    for name, expected, given in (
        ("reason", right.reason, got.reason),
        ("element", element_of(right), element_of(got)),
        ("clause", right.clause, got.clause),
    ):
        if expected != given:
            return _at(name, f"the {name} of the rejection", expected or "none", given or "none")
    return None


def _at(kind: str, place: str, expected: str, got: str) -> Divergence:
    return Divergence(kind=kind, place=place, expected=expected, got=got)


def line_of(rejection: Rejection) -> str:
    """A rejection in one line, as far as it says anything. Clause: CONV-RESULT-4."""
    parts = (
        f"{rejection.fault}:" if rejection.reason else str(rejection.fault),
        rejection.reason,
        f"at {element_of(rejection)}" if element_of(rejection) else "",
        f"[{rejection.clause}]" if rejection.clause else "",
    )
    return " ".join(part for part in parts if part)


def element_of(rejection: Rejection) -> str:
    """The element that is blamed: each key with its value, by name. Clause: CONV-RESULT-2."""
    return ", ".join(f"{key} {value}" for key, value in sorted(rejection.at.items()) if value != "")
