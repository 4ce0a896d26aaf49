"""Results as they come, one a line. Clause: ORCL-REPORT-5."""

from pathlib import Path
from types import TracebackType

import msgspec

from clers.conformance.judging.judged import Judged


class Lines:
    """Files that get each result at once; what is in them stays. Clause: ORCL-REPORT-5."""

    def __init__(self, paths: tuple[Path, ...]) -> None:
        """OSError if a file cannot be opened."""
        self._files = [path.open("wb", buffering=0) for path in paths]

    def __enter__(self) -> "Lines":
        """The files are open already."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        """Whatever happened, what was written is kept."""
        for file in self._files:
            file.close()

    def add(self, judged: Judged) -> None:
        """One more line, on its way to the disk when this returns."""
        line = msgspec.json.encode(judged) + b"\n"
        for file in self._files:
            file.write(line)
