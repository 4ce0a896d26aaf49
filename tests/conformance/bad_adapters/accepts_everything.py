"""Has an empty mesh for every word and every file, and events that nobody wants."""

from good import HELLO, Message, reply, say, serve

HELLO["ops"] = ["echo", "word.decode", "mesh.decode"]


def spoil(_: int, request: Message) -> None:
    if str(request["op"]).endswith(".decode"):
        say({"id": request["id"], "ok": {"faces": [], "vertices": 0}})
    else:
        say(reply(request))


serve(spoil)
