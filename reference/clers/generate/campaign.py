"""A long run of tampered files through the reader: `python -m clers.generate.campaign --help`.

Exit code 1 if any file raises an exception, takes too long, is accepted though it is not what its
mesh encodes to, or makes the reader use more memory than its length and its faces justify.
"""

import argparse
import signal
import sys
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from random import Random
from resource import RUSAGE_SELF, getrusage
from time import perf_counter
from tracemalloc import get_traced_memory, reset_peak, start, stop
from types import FrameType
from typing import Final

from clers.codes.registry import CodeName
from clers.container.file import decode, inspect
from clers.container.laws_file import file_again
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails
from clers.generate.files import pool
from clers.generate.tamper import tampered

PATIENCE: Final = 10.0
"""Seconds for one file; the files are of a kilobyte."""

BYTES_OF_MEMORY: Final = 4096
"""For each byte of a file; a golden word has up to 12 symbols in a byte. Clause: FILE-COUNT-4."""

ALLOWANCE: Final = 1 << 18
"""For what any reader needs, in bytes."""

TABLES: Final[Mapping[CodeName, int]] = {CodeName.CONTEXT: 1 << 22, CodeName.BEST: 1 << 22}
"""What a code needs beside it, whatever the file: `context` begins with 3 MB."""

MEASURED: Final = 50
"""One file in so many has its memory measured, which is slow."""


class TooLongError(Exception):
    """A file took more than the patience there is."""


@dataclass(frozen=True, slots=True)
class Tried:
    """One file: how it was tampered with, what came of it, and whether that is a defect."""

    way: str
    outcome: str
    defect: bool = False
    memory: int = 0


def _out_of_time(number: int, frame: FrameType | None) -> None:
    del number, frame
    raise TooLongError


def _outcome(way: str, data: bytes) -> Tried:
    """Decode once, and if that is accepted encode again."""
    signal.setitimer(signal.ITIMER_REAL, PATIENCE)
    try:
        match decode(data):
            case Accepted(_):
                verdict = file_again(data)
                if isinstance(verdict, Fails):
                    return Tried(way, "ACCEPTED BUT NOT CANONICAL", defect=True)
                return Tried(way, "accepted")
            case Rejected(reason, _, _, _):
                return Tried(way, f"{reason.fault}: {reason}")
    except TooLongError:
        return Tried(way, "TOO LONG", defect=True)
    except Exception as error:
        return Tried(way, f"RAISED {type(error).__name__}", defect=True)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)


def _memory(data: bytes) -> int:
    """The most that decoding has allocated at one time, in bytes."""
    start()
    reset_peak()
    try:
        decode(data)
        return get_traced_memory()[1]
    finally:
        stop()


def _allowed(data: bytes) -> int:
    """The bytes of memory that a reader may take for a file. Clause: FILE-COUNT-4."""
    found = inspect(data)
    tables = TABLES.get(found.value.head.code, 0) if isinstance(found, Accepted) else 0
    return ALLOWANCE + tables + BYTES_OF_MEMORY * len(data)


def campaign(files: int, seed: int) -> Iterator[tuple[bytes, Tried]]:
    """So many tampered files, one after another. Clauses: FILE-PARSE-2, FILE-COUNT-4."""
    random = Random(seed)
    sound = pool(seed)
    for index in range(files):
        way, data = tampered(sound, random)
        tried = _outcome(way, data)
        if index % MEASURED == 0 and not tried.defect:
            used = _memory(data)
            if used > _allowed(data):
                tried = Tried(way, f"MEMORY {used} BYTES FOR {len(data)}", defect=True)
            tried = replace(tried, memory=used)
        yield data, tried


def main() -> int:
    """Run a campaign and print its counts."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--files", type=int, default=100_000, help="how many files to try")
    parser.add_argument("--seed", type=int, default=0, help="which files")
    arguments = parser.parse_args()
    files, seed = int(arguments.files), int(arguments.seed)
    signal.signal(signal.SIGALRM, _out_of_time)
    begun = perf_counter()
    outcomes: Counter[str] = Counter()
    ways: Counter[str] = Counter()
    defects: list[tuple[bytes, Tried]] = []
    most = 0
    for data, tried in campaign(files, seed):
        outcomes[tried.outcome] += 1
        ways[tried.way] += 1
        most = max(most, tried.memory)
        if tried.defect:
            defects.append((data, tried))
    for name, count in sorted(outcomes.items(), key=lambda item: (-item[1], item[0])):
        print(f"{count:9d}  {name}")
    print(f"{files:9d}  files in {perf_counter() - begun:.0f} s, tampered with by:")
    for name, count in sorted(ways.items()):
        print(f"{count:9d}  {name}")
    print(f"peak memory of one decoding {most // 1024} KB (one file in {MEASURED} measured)")
    print(f"peak memory of the process {getrusage(RUSAGE_SELF).ru_maxrss // 1024} MB")
    for data, tried in defects[:20]:
        print(f"DEFECT {tried.way}: {tried.outcome}: {data.hex()}")
    print(f"{len(defects)} defects")
    return 1 if defects else 0


if __name__ == "__main__":
    sys.exit(main())
