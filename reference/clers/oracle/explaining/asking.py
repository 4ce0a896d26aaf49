"""What an adapter says to a case. Clause: ORCL-EXPLAIN-4."""

from clers.conformance.bounds import Bounds
from clers.conformance.cases.case import Case, operation_of
from clers.conformance.in_words import in_words
from clers.conformance.judging.judge import judge
from clers.conformance.lines import NoMessage
from clers.conformance.outcome import Erred, NoProcess, Outcome
from clers.conformance.session import Session, asked
from clers.oracle.explaining.explanation import Heard


def hear(
    case: Case, command: tuple[str, ...], bounds: Bounds, *, strict_reasons: bool = False
) -> tuple[Heard, Outcome] | NoProcess:
    """Start an adapter, ask it the case, with events if it traces the operation, and end it.

    Clause: ORCL-EXPLAIN-4.
    """
    with Session(command, bounds) as session:
        said = session.introduction()
        if isinstance(said, NoProcess):
            return said
        request = operation_of(case, "full" if case.op in said.caps.trace else "none")
        outcome: Outcome
        if isinstance(request, NoMessage):
            line, outcome = "", Erred(f"the case itself is none: {request.why}")
        else:
            question = asked(1, request)
            line, outcome = question.line.decode().rstrip("\n"), session.ask(question)
    heard = Heard(
        adapter=said.name,
        version=said.version,
        command=command,
        outcome=in_words(outcome),
        judged=judge(case, outcome, said, strict_reasons=strict_reasons),
        request=line,
    )
    return heard, outcome
