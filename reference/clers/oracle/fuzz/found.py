"""From what was tried to a finding. Clauses: ORCL-FIND-1, ORCL-AGAINST-2."""

from collections.abc import Sequence

from msgspec import UNSET

from clers import SPEC_VERSION
from clers.conformance.in_words import in_words
from clers.conformance.messages import PROTOCOL, Introduction, Operation
from clers.oracle.finding import Finding, Other, Party, Shrunk
from clers.oracle.fuzz.checks import Tried
from clers.oracle.fuzz.shrinking.engine import Least
from clers.oracle.fuzz.shrinking.sizes import measure


def party(command: Sequence[str], said: Introduction) -> Party:
    """An adapter as a finding names it. Clause: ORCL-FIND-1."""
    return Party(
        command=tuple(command), name=said.name, version=said.version, language=said.language
    )


def finding(
    tried: Tried, adapter: Party, second: Party | None = None, shrunk: Shrunk | None = None
) -> Finding:
    """The finding that a request showed. Clauses: ORCL-FIND-1, ORCL-AGAINST-2."""
    against = tried.against
    other = UNSET
    return Finding(
        request=tried.asked.line.decode().rstrip("\n"),
        case=tried.case,
        judged=tried.judged,
        outcome=in_words(tried.outcome),
        adapter=adapter,
        protocol=PROTOCOL,
        spec=SPEC_VERSION,
        law=tried.law,
        against=other
        if against is None or second is None
        else Other(
            adapter=second,
            outcome=in_words(against.outcome),
            first=against.first,
            second=against.second,
        ),
        shrunk=UNSET if shrunk is None else shrunk,
    )


def shrunk_from(first: Operation, found: Least, before: Shrunk | None = None) -> Shrunk:
    """How it was shrunk; an earlier shrinking of the same finding counts too. ORCL-SHRINK-4."""
    unit, size = measure(first)
    return Shrunk(
        unit=unit,
        before=size if before is None else max(size, before.before),
        after=measure(found.operation)[1],
        asked=found.asked + (0 if before is None else before.asked),
        minimal=found.minimal,
    )
