"""Closes its output and goes on sleeping."""

import os
import time

from good import Message, serve


def spoil(_: int, __: Message) -> None:
    os.close(1)
    time.sleep(3600)


serve(spoil)
