"""A small repository that breaks no rule, written out by hand, for tests that break one."""

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Final

from clers.specification.check import check
from clers.specification.repository import read

CLAUSES: Final = MappingProxyType(
    {
        "TOY-RULE-1": "Toys are counted from 0.",
        "TOY-RULE-2": "Toys are kept. untestable: nobody looks.",
        "BOX-LID-1": "A box has one lid; it lies on top.",
        "BOX-LID-2": "A lid has no box.",
    }
)

FILES: Final[Mapping[str, str]] = MappingProxyType(
    {
        "spec/00-conventions.md": """# Conventions

| chapter | prefix | about |
|---|---|---|
| 0 | `TOY` | toys |
| 1 | `BOX` | boxes |

> **TOY-RULE-1.** Toys are counted from 0.

> **TOY-RULE-2.** Toys are kept. untestable: nobody looks.
""",
        "spec/01-boxes.md": """# Boxes

## What is a box?

Like [toys](00-conventions.md#conventions), boxes obey TOY-RULE-1.

> **BOX-LID-1.** A box has one lid;
> it lies on top.

> **BOX-LID-2.** A lid has no box.

It takes 1.7356<!--= golden.bits-per-triangle --> bits.

```python
>>> lids = 2
>>> lids + 1
3
```

See [why BOX-LID-2](../proofs_notes/lids.md).
""",
        "spec/README.md": "# Pages\n\n[Rules](00-conventions.md), [boxes](01-boxes.md#boxes).\n",
        "README.md": "# Toys\n\nSee [boxes](spec/01-boxes.md#what-is-a-box) and BOX-LID-1.\n",
        "proofs_notes/lids.md": """# Lids

By BOX-LID-1 to BOX-LID-2, no.

## Why not?

- **Theorem.** `no-lid-of-a-lid`
- **Clauses.** BOX-LID-2
- **Known by.** Coq `Clers.Lids.none`; z3 `smt/lids.py: none`; certificate `certificates/lids.json`;
  exhaustive to 3 lids (`tests/test_toys.py`); prose
- **Laws.** `tests/test_toys.py`
- **Assumes.** that lids are boxes
""",
        "proofs_notes/README.md": """# Proofs

<!-- theorems: written by `clers spec proofs --write` -->

Theorems: 1, in notes: 1, for clauses: 1. Known: 1 by certificate, 1 by coq, 1 by exhaustive, \
1 by prose, 1 by z3; by words alone: 0.

| theorem | known by | clauses | laws and tests |
|---|---|---|---|
| [`no-lid-of-a-lid`](lids.md#why-not) | Coq `Clers.Lids.none`; z3 `smt/lids.py: none`; \
certificate `certificates/lids.json`; exhaustive to 3 lids (`tests/test_toys.py`); prose | \
BOX-LID-2 | `tests/test_toys.py` |

<!-- end of theorems -->
""",
        "proofs_notes/coq/Lids.v": """(* No (* lid *)
Theorem lid. *)
Theorem none : True.
Proof. exact I. Qed.
""",
        "proofs_notes/smt/lids.py": 'LEMMAS = (Lemma("none", 1), Control("some", 2))\n',
        "proofs_notes/certificates/lids.json": "{}\n",
        "reference/clers/conventions/clause.py": '''\
"""Generated from spec/ by `clers spec generate`; do not edit."""

from enum import StrEnum


class Clause(StrEnum):
    """Every clause of the specification, by id."""

    TOY_RULE_1 = "TOY-RULE-1"
    TOY_RULE_2 = "TOY-RULE-2"
    BOX_LID_1 = "BOX-LID-1"
    BOX_LID_2 = "BOX-LID-2"
''',
        "reference/clers/toys.py": '''"""Toys. Clause: TOY-RULE-2."""


class Toy:
    """A toy."""

    def count(self) -> object:
        # by TOY-RULE-1
        return Clause.BOX_LID_1


def lid() -> None:
    """A lid. Clauses: BOX-LID-1 … BOX-LID-2."""
''',
        "reference/clers/boxes/laws.py": '''"""Laws of boxes."""

LAWS = (
    Law(
        "one-lid",
        Clause.BOX_LID_1,
        "A box has one lid.",
    ),
)
''',
        "tests/test_toys.py": '''"""Toys."""


def test_count() -> None:
    """Clause: TOY-RULE-1."""


def test_lid() -> None:
    assert Clause.BOX_LID_2
''',
    }
)


def lock(clauses: Mapping[str, str] = CLAUSES) -> str:
    """A lock file for clauses, as chapter 0 of the real specification words it."""
    return json.dumps(
        {id_: hashlib.sha256(text.encode()).hexdigest() for id_, text in clauses.items()}
    )


def write(root: Path, files: Mapping[str, str] = FILES) -> Path:
    """Write the repository, with a lock of its clauses unless one is given."""
    for path, text in {"spec/lock.json": lock(), **files}.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text, encoding="utf-8")
    return root


def edited(*edits: tuple[str, str, str]) -> dict[str, str]:
    """The files after edits (path, old text, new text), each at the one place it fits."""
    files = dict(FILES)
    for path, old, new in edits:
        assert files[path].count(old) == 1, (path, old)
        files[path] = files[path].replace(old, new)
    return files


def renamed(old: str, new: str) -> dict[str, str]:
    """The files after an id is renamed everywhere, the lock included."""
    ids = {old: new, old.replace("-", "_"): new.replace("-", "_")}
    files = {**FILES, "spec/lock.json": lock()}
    for before, after in ids.items():
        files = {path: text.replace(before, after) for path, text in files.items()}
    return files


def found(root: Path) -> list[tuple[str, str, int, str]]:
    """Rule, path, line and clause of each finding."""
    return [(f.rule, f.path, f.line, f.clause) for f in check(read(root))]
