"""How commands read a repository: of the running program's own, the laws that it has too."""

from pathlib import Path
from typing import TYPE_CHECKING, Final

import clers

if TYPE_CHECKING:
    from clers.specification.repository import Repository

BROKEN: Final = (ImportError, AttributeError, NameError, SyntaxError, TypeError)
"""What importing it raises while somebody is at work on it."""


def is_running(root: Path) -> bool:
    """Whether this is the repository that the program runs from."""
    from clers.specification.registry import REGISTRY

    return (root / REGISTRY).resolve() == Path(clers.__file__).with_name("laws.py").resolve()


def registry_of(root: Path) -> tuple[str, ...] | str:
    """The names of the registered laws, or why they cannot be had. Clause: CONV-LAW-3."""
    if not is_running(root):
        return ()
    try:
        from clers.laws import ALL
    except BROKEN as error:
        return str(error) or type(error).__name__
    return tuple(law.name for law in ALL)


def read_with_laws(root: Path) -> "Repository":
    """Everything that the checks look at, the registered laws among it. Clause: CONV-LAW-3."""
    from clers.specification.repository import read

    return read(root, registry_of(root))
