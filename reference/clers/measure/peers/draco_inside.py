"""Draco's coding of connectivity alone, timed inside the calls of DracoPy.

A call of DracoPy also makes a mesh of arrays, merges vertices, codes positions. Connectivity is
coded by one virtual method of its encoder and one of its decoder. While this watches, their slots
in the two tables of virtual methods hold functions that read the clocks, call the methods and read
the clocks again. That works where methods are called as functions of C are, and for the version
whose methods these are.
"""

import ctypes
import mmap
import platform
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib.metadata import PackageNotFoundError, version
from typing import Final

from clers.measure.clock import Spent, now

KNOWN: Final = "2.2.0"
"""The version of DracoPy whose methods are called as is said here."""

ENCODER: Final = "_ZTVN5draco22MeshEdgebreakerEncoderE"
DECODER: Final = "_ZTVN5draco22MeshEdgebreakerDecoderE"
ENCODE: Final = "_ZN5draco22MeshEdgebreakerEncoder18EncodeConnectivityEv"
DECODE: Final = "_ZN5draco22MeshEdgebreakerDecoder18DecodeConnectivityEv"
SLOTS: Final = 32
"""Both tables are longer than this, and the methods stand before it."""

READ_AND_WRITE: Final = 3

RETURNS_OBJECT: Final = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p)
"""Where the answer goes, and the encoder."""

RETURNS_BOOL: Final = ctypes.CFUNCTYPE(ctypes.c_bool, ctypes.c_void_p)


class Watch:
    """What the last call spent on connectivity; none, if it has not been seen."""

    __slots__ = ("spent",)

    def __init__(self) -> None:
        self.spent: Spent | None = None


@contextmanager
def watched() -> Iterator[Watch]:
    """Watch all calls of DracoPy in the body. Clause: TOOL-SPEED-4.

    Where it cannot be done nothing is seen.
    """
    watch = Watch()
    if not _possible():
        yield watch
        return
    import DracoPy

    library = ctypes.CDLL(DracoPy.__file__)
    encode = RETURNS_OBJECT(_address(library, ENCODE))
    decode = RETURNS_BOOL(_address(library, DECODE))

    def timed_encode(answer: int, encoder: int) -> int:
        return _timed(watch, lambda: encode(answer, encoder))

    def timed_decode(decoder: int) -> bool:
        return bool(_timed(watch, lambda: decode(decoder)))

    ours = RETURNS_OBJECT(timed_encode), RETURNS_BOOL(timed_decode)
    put = [ctypes.cast(function, ctypes.c_void_p).value or 0 for function in ours]
    theirs = [_address(library, ENCODE), _address(library, DECODE)]
    tables = [_address(library, ENCODER), _address(library, DECODER)]
    for table, old, new in zip(tables, theirs, put, strict=True):
        _replace(table, old, new)
    try:
        yield watch
    finally:
        for table, old, new in zip(tables, theirs, put, strict=True):
            _replace(table, new, old)


def _possible() -> bool:
    """Whether methods are called as C functions are, and are those of the known version."""
    try:
        found = version("DracoPy")
    except PackageNotFoundError:
        return False
    return (sys.platform, platform.machine(), found) == ("linux", "x86_64", KNOWN)


def _timed(watch: Watch, call: Callable[[], int]) -> int:
    start = now()
    answer = call()
    watch.spent = now() - start
    return answer


def _address(library: ctypes.CDLL, name: str) -> int:
    """Where a symbol of a library stands in memory."""
    return ctypes.addressof(ctypes.c_byte.in_dll(library, name))


def _replace(table: int, old: int, new: int) -> None:
    """Put another method where a table has this one; nothing, where it has it not."""
    slots = (ctypes.c_void_p * SLOTS).from_address(table)
    page = table - table % mmap.PAGESIZE
    length = table + ctypes.sizeof(slots) - page
    if ctypes.CDLL(None).mprotect(ctypes.c_void_p(page), ctypes.c_size_t(length), READ_AND_WRITE):
        return
    for k in range(SLOTS):
        if slots[k] == old:
            slots[k] = new
