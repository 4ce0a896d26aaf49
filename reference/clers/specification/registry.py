"""The rule on the registry: what a chapter writes down, it has. Clause: CONV-LAW-3."""

from collections import Counter
from collections.abc import Iterator
from typing import Final

from clers.specification.finding import Finding
from clers.specification.repository import Repository

REGISTRY: Final = "reference/clers/laws.py"


def registered(of: Repository) -> Iterator[Finding]:
    """Every law that a `laws.py` writes out is in the registry, under one name.

    Only the running program's own registry can be asked; of other repositories nothing is said.
    """
    if isinstance(of.registry, str):
        yield Finding("registry", REGISTRY, 1, "", f"cannot be imported: {of.registry}")
    elif of.registry:
        yield from _compared(of, of.registry)


def _compared(of: Repository, registry: tuple[str, ...]) -> Iterator[Finding]:
    for name, count in sorted(Counter(registry).items()):
        if count > 1:
            yield Finding("law-twice", REGISTRY, 1, "", f"two laws are registered as {name}")
    for module in of.modules:
        for law in module.laws:
            if law.name not in registry:
                text = f"law {law.name} is not in {REGISTRY}"
                yield Finding("registry", module.path, law.first, "", text)
