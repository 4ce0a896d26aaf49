"""What a case needs that an adapter does not have. Clauses: ORCL-CASE-4, ORCL-JUDGE-6."""

from typing import Final

from clers.conformance.cases.case import Case, operation_of
from clers.conformance.messages import Caps, Introduction, Roundtrip
from clers.conformance.payloads import Places


def needs(case: Case, said: Introduction) -> str | None:
    """The first capability that the case needs and the adapter does not declare, if any.

    Looked for in this order: the operation, what the case requires as it is listed, the precision
    of its positions, its size. Clauses: ORCL-JUDGE-6, ORCL-JUDGE-8, ORCL-CODEC-16.
    """
    if case.op not in said.ops:
        return case.op
    required = (*case.requires, *_precision(case))
    lacking = next((name for name in required if not declared(name, said.caps)), None)
    return _too_large(case, said.caps) if lacking is None else lacking


def declared(name: str, caps: Caps) -> bool:
    """Whether a capability is declared; one that has no such name never is. ORCL-HELLO-2."""
    match name.split(".", 1):
        case ["handles"]:
            return caps.handles
        case ["components"]:
            return caps.components
        case ["boundaries", "one"]:
            return caps.boundaries != "none"
        case ["boundaries", "many"]:
            return caps.boundaries == "many"
        case ["code", code]:
            return code in caps.codes
        case ["coder", coder]:
            return coder in caps.coders
        case ["positions", precision]:
            return precision in caps.positions
        case _:
            return False


def _precision(case: Case) -> tuple[str, ...]:
    """The precision that a codec must keep, read off the input. Clause: ORCL-CODEC-16."""
    if case.op != ROUNDTRIP:
        return ()
    operation = operation_of(case)
    if isinstance(operation, Roundtrip) and isinstance(operation.input.positions, Places):
        return (f"positions.{operation.input.positions.precision}",)
    return ()


def _too_large(case: Case, caps: Caps) -> str | None:
    """Which of the two sizes is borne less than the case's. Clause: ORCL-JUDGE-8."""
    subject = case.op.partition(".")[0]
    if subject in FACED and case.size > caps.max_faces:
        return "max_faces"
    if subject in LETTERED and case.size > caps.max_symbols:
        return "max_symbols"
    return None


ROUNDTRIP: Final = "codec.roundtrip"

FACED = frozenset(("surface", "operator", "word", "mesh", "codec"))
LETTERED = frozenset(("arithmetic", "code"))
"""What is limited by faces, and what by symbols. Clause: ORCL-JUDGE-8."""
