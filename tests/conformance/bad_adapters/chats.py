"""Prints what it does on standard output."""

from good import Message, reply, say, serve


def spoil(_: int, request: Message) -> None:
    print("echoing…", flush=True)
    say(reply(request))


serve(spoil)
