"""Rejects whatever it is given, but for what echo gives."""

from good import HELLO, Message, reply, say, serve

HELLO["ops"] = ["echo", "word.decode", "mesh.decode"]


def spoil(_: int, request: Message) -> None:
    if request["op"] == "echo":
        say(reply(request))
    else:
        say({"id": request["id"], "reject": {"class": "invalid"}})


serve(spoil)
