"""The rule on the registry: what a chapter writes down, it has. Clause: CONV-LAW-3."""

from collections.abc import Iterator
from pathlib import Path
from typing import Final

import clers
from clers.specification.finding import Finding
from clers.specification.repository import Repository

REGISTRY: Final = "reference/clers/laws.py"

BROKEN: Final = (ImportError, AttributeError, NameError, SyntaxError, TypeError)
"""What importing it raises while somebody is at work on it."""


def is_running(of: Repository) -> bool:
    """Whether the repository read is the one this program runs from."""
    return (of.root / REGISTRY).resolve() == Path(clers.__file__).with_name("laws.py").resolve()


def registered(of: Repository) -> Iterator[Finding]:
    """Every law that a `laws.py` writes out is in the registry, under one name.

    Only the running program's own registry can be asked; of other repositories nothing is said.
    """
    if not is_running(of):
        return
    try:
        from clers.laws import ALL, names_given_twice
    except BROKEN as error:
        yield Finding("registry", REGISTRY, 1, "", f"cannot be imported: {error}")
        return
    known = {law.name for law in ALL}
    for name in names_given_twice(ALL):
        yield Finding("law-twice", REGISTRY, 1, "", f"two laws are registered as {name}")
    for module in of.modules:
        for law in module.laws:
            if law.name not in known:
                text = f"law {law.name} is not in {REGISTRY}"
                yield Finding("registry", module.path, law.first, "", text)
