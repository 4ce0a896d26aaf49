"""Sources to begin an adapter with, one a language. Clauses: ORCL-STARTER-1, ORCL-STARTER-2."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final


@dataclass(frozen=True, slots=True)
class Starter:
    """A file of source, the command that compiles it (or none), and the one that runs it."""

    file: str
    build: tuple[str, ...]
    run: tuple[str, ...]

    @property
    def commands(self) -> tuple[str, ...]:
        """What to type to have it examined."""
        build = (" ".join(self.build),) if self.build else ()
        return (*build, f'clers adapter doctor -a "{" ".join(self.run)}"')


STARTERS: Final[Mapping[str, Starter]] = {
    "python": Starter("adapter.py", (), ("python3", "adapter.py")),
    "javascript": Starter("adapter.js", (), ("node", "adapter.js")),
    "c": Starter("adapter.c", ("cc", "-O2", "-o", "adapter", "adapter.c"), ("./adapter",)),
    "rust": Starter("adapter.rs", ("rustc", "-O", "adapter.rs"), ("./adapter",)),
    "go": Starter("adapter.go", ("go", "build", "-o", "adapter", "adapter.go"), ("./adapter",)),
}
"""By language. Clause: ORCL-STARTER-1."""


def source(starter: Starter) -> str:
    """The text of a starter."""
    folder = Path(__file__).with_name("starter_files")
    return (folder / starter.file).read_text(encoding="utf-8")
