"""Two terminal replies for each request."""

import sys
from json import dumps

from good import Message, reply, serve


def spoil(_: int, request: Message) -> None:
    sys.stdout.write(2 * f"{dumps(reply(request))}\n")
    sys.stdout.flush()


serve(spoil)
