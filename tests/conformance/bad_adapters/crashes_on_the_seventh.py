"""Ends in the middle of the seventh request, and complains."""

import sys

from good import Message, reply, say, serve


def spoil(number: int, request: Message) -> None:
    if number == 7:
        sys.exit("out of luck")
    say(reply(request))


serve(spoil)
