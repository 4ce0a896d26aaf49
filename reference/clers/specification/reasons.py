"""The rule on reasons: a clause that rejections name says in its text why. Clause: CONV-RESULT-6.

Only calls that write both out are seen, `Rejected(Reason.X, Clause.Y, …)`; where a function is told
one of them, the cases of the suite show whether it was told right.
"""

from collections.abc import Iterator

from clers.specification.finding import Finding
from clers.specification.repository import Repository


def said(text: str, reason: str) -> bool:
    """Has a clause's text this reason, in code type? Clause: CONV-RESULT-6."""
    return f"`{reason}`" in text


def reasons_said(of: Repository) -> Iterator[Finding]:
    """Each reason that code gives with a clause stands in that clause. Clause: CONV-RESULT-6."""
    texts = {clause.clause: clause for clause in of.clauses}
    for module in of.modules:
        for rejection in module.rejections:
            clause = texts.get(rejection.clause)
            if clause is not None and not said(clause.text, rejection.reason):
                text = f"rejects as `{rejection.reason}`, which {clause.path}:{clause.line} has not"
                yield Finding("reason", module.path, rejection.line, clause.clause, text)
