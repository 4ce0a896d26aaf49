"""Answers operations it does not know with an error."""

from good import Message, reply, say, serve


def spoil(_: int, request: Message) -> None:
    if request["op"] == "echo":
        say(reply(request))
    else:
        say({"id": request["id"], "error": {"message": "what?"}})


serve(spoil)
