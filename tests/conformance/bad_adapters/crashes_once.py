"""Ends at its first request, but only the first time; the file it is given remembers."""

import sys
from pathlib import Path

from good import Message, reply, say, serve


def spoil(_: int, request: Message) -> None:
    done = Path(sys.argv[1])
    if not done.exists():
        done.touch()
        sys.exit(4)
    say(reply(request))


serve(spoil)
