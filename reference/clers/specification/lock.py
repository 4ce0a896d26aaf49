"""The lock: the hash of each clause's text as it was last read. Clause: CONV-CLAUSE-4."""

from collections.abc import Iterable, Mapping
from typing import Final

import msgspec

from clers.specification.clause_text import ClauseText
from clers.specification.identifier import order

LOCK: Final = "spec/lock.json"
Lock = Mapping[str, str]


def read_lock(text: str) -> Lock:
    """The entries of a lock file: id to hash. A text that is no lock has no entries."""
    try:
        return msgspec.json.decode(text, type=dict[str, str])
    except msgspec.DecodeError:
        return {}


def write_lock(lock: Lock) -> str:
    """The lock file's text: sorted, one entry a line."""
    ordered = {clause: lock[clause] for clause in sorted(lock, key=order)}
    return msgspec.json.format(msgspec.json.encode(ordered), indent=2).decode() + "\n"


def locked(lock: Lock, clauses: Iterable[ClauseText], again: frozenset[str]) -> Lock:
    """The lock after the ids `again` were read again; those that are gone are dropped."""
    kept = {clause: text for clause, text in lock.items() if clause not in again}
    return kept | {clause.clause: clause.hash for clause in clauses if clause.clause in again}


def unread(lock: Lock, clauses: Iterable[ClauseText]) -> frozenset[str]:
    """The ids whose text is not the locked one, or gone, or not locked yet."""
    now = {clause.clause: clause.hash for clause in clauses}
    return frozenset(
        clause for clause in {*now, *lock} if now.get(clause, "") != lock.get(clause, "")
    )
