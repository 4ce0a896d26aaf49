"""Which lines of the reference each case executes: python -m clers.oracle.mutants.reached FOLDER.

A process of its own, so that the lines that importing executes are seen too.
"""

import importlib
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from os import environ
from pathlib import Path
from typing import Final

import msgspec

from clers.conformance.cases.case import operation_of
from clers.conformance.lines import NoMessage
from clers.conformance.session import asked
from clers.conventions.result import Rejected
from clers.measure.mutation.outcome import ON_IMPORT
from clers.oracle.suite.files import read_suite

PACKAGES: Final = (
    "clers.arithmetic",
    "clers.codes",
    "clers.complexes",
    "clers.container",
    "clers.edgebreaker",
    "clers.geometry",
    "clers.information",
    "clers.kernels",
    "clers.operators",
)
"""The packages that know how to compress meshes, and what meshes are. Clause: ORCL-MUTANT-7."""

Lines = Mapping[int, tuple[int, ...]]
"""By line the numbers of the cases that execute it; ON_IMPORT if importing does."""


@dataclass(frozen=True, slots=True)
class Reached:
    """By module what serving the cases of a suite executes of it. Clause: ORCL-MUTANT-7.

    A module of which importing alone executes anything is not there.
    """

    modules: dict[str, dict[int, tuple[int, ...]]]


def reached(folder: Path) -> Reached | str:
    """What the cases of a suite execute; or why that cannot be said. Clause: ORCL-MUTANT-7."""
    command = (sys.executable, "-m", "clers.oracle.mutants.reached", str(folder))
    done = subprocess.run(command, capture_output=True, check=False)
    if done.returncode:
        return done.stderr.decode(errors="replace").strip().rpartition("\n")[2]
    return msgspec.json.decode(done.stdout, type=Reached)


def measured(folder: Path) -> Reached | str:
    """Serve every case in this process, whose lines are noted; nothing of it may be imported."""
    suite = read_suite(folder)
    if isinstance(suite, Rejected):
        return suite.line()
    try:
        import coverage
    except ImportError:
        return "the package coverage is needed: pip install 'clers[test]'"
    environ["CLERS_KERNELS"] = "interpreted"  # machine code has no lines
    roots = [Path(importlib.import_module(name).__path__[0]) for name in PACKAGES]
    traced = coverage.Coverage(
        data_file=None,
        config_file=False,
        include=[f"{root}/*" for root in roots],
        omit=[f"{root}/__init__.py" for root in roots],
    )
    traced.start()
    from clers.conformance.adapter import answered

    for number, case in enumerate(suite.value.cases):
        request = operation_of(case, "full" if case.trace else "none")
        if not isinstance(request, NoMessage):
            traced.switch_context(str(number))
            answered(asked(1, request).line)
    traced.stop()
    data = traced.get_data()
    found: dict[str, dict[int, tuple[int, ...]]] = {}
    for name, module in sorted(sys.modules.items()):
        path = getattr(module, "__file__", None)
        if isinstance(path, str) and path in data.measured_files():
            lines = {
                line: tuple(sorted(ON_IMPORT if by == "" else int(by) for by in names))
                for line, names in sorted(data.contexts_by_lineno(path).items())
            }
            if any(by != (ON_IMPORT,) for by in lines.values()):
                found[name] = lines
    return Reached(found)


if __name__ == "__main__":
    answer = measured(Path(sys.argv[1]))
    if isinstance(answer, str):
        sys.exit(answer)
    sys.stdout.buffer.write(msgspec.json.encode(answer))
