"""Writes for ever."""

import sys

from good import Message, serve


def spoil(_: int, __: Message) -> None:
    while True:
        sys.stdout.write("x" * 65536)


serve(spoil)
