"""A second reply, a moment after the first."""

import time

from good import Message, reply, say, serve


def spoil(_: int, request: Message) -> None:
    say(reply(request))
    time.sleep(0.05)
    say(reply(request))


serve(spoil)
