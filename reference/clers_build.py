"""How the kernels are compiled when the package is built, where there is a C compiler.

Named in pyproject.toml as the command that builds extensions. Nothing of this is installed.
"""

import re
import sys
from pathlib import Path
from typing import Final

from mypyc.build import mypycify
from setuptools import Extension
from setuptools.command.build_ext import build_ext
from typing_extensions import override

sys.path.insert(0, str(Path(__file__).parent))
from clers.kernels import STAMP, digest

KERNELS = Path("reference/clers/kernels")

TAKEN: Final = re.compile(r"(arg_\w+) = Vec(\w+)Api\.unbox\(obj_\w+\);(?!\s*VEC_)")
"""How an array is taken out of the Python object that a kernel is given."""


class BuildKernels(build_ext):
    """Translates the kernels by mypyc and compiles them; where that fails they stay as they are."""

    @override
    def finalize_options(self) -> None:
        """Put the translated kernels in the place of the one that is declared."""
        sources = sorted(str(path) for path in KERNELS.glob("*.py") if path.stem != "__init__")
        made = mypycify(sources, opt_level="3", group_name="clers_kernels")
        extensions = [extension for extension in made if isinstance(extension, Extension)]
        for extension in extensions:
            extension.optional = True
            extension.extra_compile_args += ["-fno-semantic-interposition"]
            for source in extension.sources:
                _borrow_arrays(Path(source))
        # setuptools names its class twice, and means the same.
        self.distribution.ext_modules = extensions  # type: ignore[assignment]
        super().finalize_options()

    @override
    def run(self) -> None:
        """Compile."""
        super().run()
        _stamp(Path(self.build_lib) / "clers" / "kernels")

    @override
    def copy_extensions_to_source(self) -> None:
        """For an editable installation: into the checkout."""
        super().copy_extensions_to_source()
        _stamp(KERNELS)


def _given_back(taken: re.Match[str]) -> str:
    """The same, and no reference kept.

    A kernel borrows what it is given. mypyc 2.4.1 counts a reference to an array all the same, and
    nobody gives it back: no array would ever be freed that Python has handed to a kernel.
    """
    return f"{taken[0]} VEC_{taken[2].upper()}_DECREF({taken[1]});"


def _borrow_arrays(source: Path) -> None:
    """Let the functions of a translated source keep no reference to the arrays they are given."""
    written = source.read_text("utf-8")
    borrowing = TAKEN.sub(_given_back, written)
    if borrowing != written:
        source.write_text(borrowing, "utf-8")


def _stamp(folder: Path) -> None:
    """Say beside machine code of which sources it was made."""
    if any(path.suffix in (".so", ".pyd") for path in folder.glob("table.*")):
        (folder / STAMP).write_text(f"{digest(KERNELS)}\n", "ascii")
