"""Answers the second request only after a while, whatever else is asked."""

import sys
import time

from good import Message, reply, say, serve


def spoil(number: int, request: Message) -> None:
    if number == 2:
        time.sleep(float(sys.argv[1]) if len(sys.argv) > 1 else 3600)
    say(reply(request))


serve(spoil)
