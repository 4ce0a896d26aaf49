"""The reference with a mistake, as an adapter.

python -m clers.oracle.mutants.adapter               no mistake
python -m clers.oracle.mutants.adapter NAME          a mutant made by hand
python -m clers.oracle.mutants.adapter MODULE FILE   any module, its source read from a file
"""

import sys
from collections.abc import Sequence
from importlib.util import find_spec
from os import environ
from pathlib import Path
from typing import Final

from clers.measure.mutation.outcome import Subject
from clers.measure.mutation.served import serve, source_file
from clers.oracle.mutants.every import BY_NAME
from clers.oracle.mutants.mutant import changed

KERNELS: Final = "clers.kernels."
"""Machine code of one calls that of others: it must not run where one is changed."""


def main(words: Sequence[str]) -> str | None:
    """Serve until bye; or what is wrong with the words. Clause: ORCL-MUTANT-2.

    No file is changed: the import of this process alone finds the other source.
    """
    fault = _exchange(words)
    if fault is not None:
        return fault
    # Imported only now, so that the import finds the other source.
    from clers.conformance.adapter import loop

    loop(sys.stdin.buffer, sys.stdout.buffer)
    return None


def _exchange(words: Sequence[str]) -> str | None:
    """Give a module its other source; or say why that cannot be."""
    match words:
        case []:
            return None
        case [name]:
            if name not in BY_NAME:
                return f"{name}: no such mutant"
            mutant = BY_NAME[name]
            subject = _subject(mutant.module)
            source = None if subject is None else changed(mutant, subject.source)
        case [module, file]:
            subject = _subject(module)
            source = Path(file).read_text(encoding="utf-8")
        case _:
            return "one or two words: NAME or MODULE FILE"
    if subject is None:
        return f"{words[0]}: its module is not there, or is in use already"
    if source is None:
        return f"{words[0]}: its place is not in {subject.module}, or not once"
    serve(subject, source)
    return None


def _subject(module: str) -> Subject | None:
    """A module to be changed. Of a kernel that means that all run as their text stands."""
    if f"{module}.".startswith(KERNELS):
        environ["CLERS_KERNELS"] = "interpreted"
    spec = None if module in sys.modules else find_spec(module)
    file = None if spec is None else source_file(spec)
    if file is None:
        return None
    return Subject(module, str(file), file.read_text(encoding="utf-8"))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
