"""Rules on cover: each clause has code, and a law or test, and was read since it changed."""

from collections.abc import Iterator

from clers.specification.citation import Citation, Kind
from clers.specification.clause_text import ClauseText
from clers.specification.finding import Finding
from clers.specification.lock import LOCK, unread
from clers.specification.repository import Repository


def _by_clause(of: Repository) -> dict[str, list[Citation]]:
    sites: dict[str, list[Citation]] = {clause.clause: [] for clause in of.clauses}
    for site in of.citations:
        sites.setdefault(site.clause, []).append(site)
    return sites


def _at(rule: str, clause: ClauseText, text: str) -> Finding:
    return Finding(rule, clause.path, clause.line, clause.clause, text)


def implemented(of: Repository) -> Iterator[Finding]:
    """Every clause is cited by code. Clause: CONV-CLAUSE-2."""
    sites = _by_clause(of)
    for clause in of.clauses:
        if not any(site.kind is Kind.CODE for site in sites[clause.clause]):
            yield _at("no-code", clause, "no code cites it")


def judged(of: Repository) -> Iterator[Finding]:
    """Every clause has a law or a test, or says why none can reach it. Clause: CONV-CLAUSE-2."""
    sites = _by_clause(of)
    for clause in of.clauses:
        reason = clause.untestable
        tried = any(site.kind in (Kind.LAW, Kind.TEST) for site in sites[clause.clause])
        if reason == "":
            yield _at("no-reason", clause, "says `untestable:` and gives no reason")
        elif reason is None and not tried:
            yield _at("no-law", clause, "no law or test, and no reason after `untestable:`")


def read_again(of: Repository) -> Iterator[Finding]:
    """The lock has the text of every clause, and of no other. Clause: CONV-CLAUSE-4."""
    changed, sites, ids = unread(of.lock, of.clauses), _by_clause(of), of.ids
    for clause in of.clauses:
        if clause.clause not in changed:
            continue
        if clause.clause not in of.lock:
            yield _at("not-locked", clause, "has no lock: `clers spec lock`")
            continue
        places = "; ".join(site.place for site in sites[clause.clause]) or "no place cites it"
        yield _at("changed", clause, f"changed since it was locked; read again: {places}")
    for gone in sorted(changed - ids):
        yield Finding("lock-of-nothing", LOCK, 1, gone, "is locked and not stated any more")


def parses(of: Repository) -> Iterator[Finding]:
    """Every source file parses, so that no citation is overlooked. Clause: CONV-CLAUSE-2."""
    for module in of.modules:
        if module.fault is not None:
            line, text = module.fault
            yield Finding("syntax", module.path, line, "", f"does not parse: {text}")
