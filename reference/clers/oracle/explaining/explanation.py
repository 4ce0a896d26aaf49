"""An explanation as a value: what `clers explain --json` prints. Clause: ORCL-EXPLAIN-1."""

from msgspec import UNSET, Struct, UnsetType

from clers.conformance.cases.case import FaultForm
from clers.conformance.judging.judged import Judged


class Told(Struct, frozen=True, kw_only=True):
    """Something that has a name, and what is said of it: a clause or a flag."""

    name: str
    text: str


class Table(Struct, frozen=True, kw_only=True):
    """A part of the way to the answer: a title, the heads of columns, rows. ORCL-EXPLAIN-2."""

    title: str
    heads: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


class Heard(Struct, frozen=True, kw_only=True):
    """What an adapter said, how it is judged, and the request's line. Clause: ORCL-EXPLAIN-4."""

    adapter: str
    version: str
    command: tuple[str, ...]
    outcome: str
    judged: Judged
    request: str


class Explanation(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """All that is to be said of a case. Clauses: ORCL-EXPLAIN-1 … ORCL-EXPLAIN-4.

    `asks` and `answer` are the input and what is right, in short; `blamed` is the element that a
    rejection names, and `fault` what is wrong and how it is undone.
    """

    id: str
    op: str
    origin: str
    size: int
    requires: tuple[str, ...]
    comment: str
    asks: str
    answer: str
    compare: str
    clauses: tuple[Told, ...]
    flags: tuple[Told, ...]
    tables: tuple[Table, ...]
    blamed: str = ""
    fault: FaultForm | UnsetType = UNSET
    heard: Heard | UnsetType = UNSET
