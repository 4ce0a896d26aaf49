"""Answers with the id of the request before."""

from good import Message, reply, say, serve


def spoil(number: int, request: Message) -> None:
    say({**reply(request), "id": number - 1})


serve(spoil)
