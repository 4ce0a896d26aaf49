"""Imports of a package from scratch, with one module's source exchanged."""

import sys
from collections.abc import Sequence
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from importlib.util import spec_from_file_location
from pathlib import Path
from types import ModuleType
from typing import Final

from typing_extensions import override

from clers.measure.mutation.outcome import Subject

_kept: Final[list[ModuleType]] = []
"""Modules taken out of the table of modules, for functions of theirs still run."""


class _Served(MetaPathFinder, Loader):
    """Finds one module, and gives it another source. No file is changed: TOOL-MUTATION-4."""

    def __init__(self, subject: Subject, source: str) -> None:
        self._subject, self._source = subject, source

    @override
    def find_spec(
        self,
        fullname: str,
        path: Sequence[str] | None = None,
        target: ModuleType | None = None,
    ) -> ModuleSpec | None:
        """The specification of the one module; others are found elsewhere."""
        if fullname != self._subject.module:
            return None
        package = self._subject.path.endswith("__init__.py")
        folders = [self._subject.path.rpartition("/")[0]] if package else None
        return spec_from_file_location(
            fullname, self._subject.path, loader=self, submodule_search_locations=folders
        )

    @override
    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        """The ordinary module object."""
        return None

    @override
    def exec_module(self, module: ModuleType) -> None:
        """Run the source that stands for the module's own."""
        exec(compile(self._source, self._subject.path, "exec"), module.__dict__)


def source_file(spec: ModuleSpec) -> Path | None:
    """The file of a module's source; where machine code was made of it, beside that."""
    if spec.origin is None:
        return None
    found = Path(spec.origin)
    name = spec.name.rpartition(".")[2]
    return found if found.suffix == ".py" else found.with_name(f"{name}.py")


def serve(subject: Subject, source: str) -> None:
    """From now on the module has this source."""
    sys.meta_path.insert(0, _Served(subject, source))


def forget(root: str) -> None:
    """Let the package be imported anew; what was imported stays alive."""
    for name in [n for n in sys.modules if n == root or n.startswith(f"{root}.")]:
        _kept.append(sys.modules.pop(name))
