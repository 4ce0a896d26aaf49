"""What all bad adapters begin with: an adapter that echoes, and hooks to spoil it."""

import json
import sys
from collections.abc import Callable, Iterator

Message = dict[str, object]

HELLO: Message = {
    "protocol": 1,
    "name": "bad",
    "version": "1",
    "language": "python",
    "ops": ["echo"],
    "caps": {
        "handles": False,
        "boundaries": "none",
        "components": False,
        "max_faces": 0,
        "max_symbols": 0,
    },
}


def say(message: Message) -> None:
    print(json.dumps(message), flush=True)


def reply(request: Message) -> Message:
    """The right reply."""
    number = request["id"]
    match request["op"]:
        case "hello" if request["protocol"] == 1:
            return {"id": number, "ok": HELLO}
        case "hello":
            return {"id": number, "unsupported": {"cap": "protocol"}}
        case "echo":
            return {"id": number, "ok": request["in"]}
        case other:
            return {"id": number, "unsupported": {"cap": other}}


def requests() -> Iterator[Message]:
    """The requests, until bye."""
    for line in sys.stdin:
        request: Message = json.loads(line)
        if request["op"] == "bye":
            return
        yield request


def serve(spoil: Callable[[int, Message], None]) -> None:
    """Answer each request; after hello, `spoil` is called with its number, from 1, instead."""
    for number, request in enumerate(requests()):
        if request["op"] == "hello":
            say(reply(request))
        else:
            spoil(number, request)


if __name__ == "__main__":
    serve(lambda _, request: say(reply(request)))
