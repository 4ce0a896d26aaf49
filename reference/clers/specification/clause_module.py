"""The generated module with one enumeration member for each clause. Clause: CONV-CLAUSE-9."""

import os
import tempfile
from collections.abc import Iterable
from pathlib import Path

from clers.specification.clause_text import ClauseText
from clers.specification.identifier import member

_HEAD = '''"""Generated from spec/ by `clers spec generate`; do not edit."""

from enum import StrEnum


class Clause(StrEnum):
    """Every clause of the specification, by id."""

'''


def clause_module(clauses: Iterable[ClauseText]) -> str:
    """The module's text: the clauses in the order of the chapters, an id stated twice once."""
    ids = dict.fromkeys(clause.clause for clause in clauses)
    return _HEAD + "".join(f'    {member(clause)} = "{clause}"\n' for clause in ids)


def replace_file(path: Path, text: str) -> None:
    """Write a text file in one step: a reader sees the old text or the new one, never a part."""
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    written = Path(name)
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
        written.chmod(0o644)
        written.replace(path)
    except BaseException:
        written.unlink(missing_ok=True)
        raise
