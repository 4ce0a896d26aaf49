"""The members of each enumeration of a package, read from its sources without running them."""

import ast
from collections.abc import Mapping, Sequence
from pathlib import Path

Vocabulary = Mapping[str, Sequence[str]]


def vocabulary(root: Path) -> Vocabulary:
    """By the name of each enumeration under a folder its members, in order."""
    found: dict[str, tuple[str, ...]] = {}
    for path in sorted(root.rglob("*.py")):
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.ClassDef) and any(map(_is_enum, node.bases)):
                found[node.name] = _members(node)
    return found


def next_member(members: Sequence[str], member: str) -> str | None:
    """The next member, cyclically, among those of the same first word if there are others.

    So a clause becomes another of its chapter. None: it is no member, or the only one.
    """
    if member not in members:
        return None
    kin = [other for other in members if other.split("_")[0] == member.split("_")[0]]
    among = kin if len(kin) > 1 else list(members)
    after = among[(among.index(member) + 1) % len(among)]
    return None if after == member else after


def _is_enum(base: ast.expr) -> bool:
    return ast.unparse(base).split(".")[-1] in {"Enum", "IntEnum", "StrEnum", "Flag", "IntFlag"}


def _members(node: ast.ClassDef) -> tuple[str, ...]:
    return tuple(
        target.id
        for statement in node.body
        if isinstance(statement, ast.Assign)
        for target in statement.targets
        if isinstance(target, ast.Name) and not target.id.startswith("_")
    )
