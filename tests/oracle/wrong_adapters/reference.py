"""The reference, served line by line, and hooks to spoil it: what all wrong adapters begin with."""

import sys
from collections.abc import Callable

import msgspec

from clers.conformance.adapter import answered
from clers.conformance.lines import line_of
from clers.conformance.messages import Bye, OkReply, Reply

Message = dict[str, object]
Spoil = Callable[[Message, Message], Message]


def as_message(reply: Reply) -> Message:
    return msgspec.json.decode(line_of(reply), type=Message)


def right(request: Message) -> Message:
    """What the reference says in its terminal reply."""
    found = answered(msgspec.json.encode(request))
    assert not isinstance(found, Bye)
    return as_message(found[-1])


def serve(spoil: Spoil, prepare: Callable[[Message], Message] = lambda request: request) -> None:
    """Answer as the reference does what `prepare` makes of a request, then spoil the result.

    `spoil` is given the request and the result, where there is one. No events.
    """
    for line in sys.stdin.buffer:
        request = msgspec.json.decode(line, type=Message)
        if request["op"] == "bye":
            return
        if request["op"] == "hello":
            sys.stdout.buffer.write(line_of(hello(line)))
        else:
            request.pop("trace", None)
            reply = right(prepare(request))
            if "ok" in reply:
                reply["ok"] = spoil(request, msgspec.convert(reply["ok"], Message))
            sys.stdout.buffer.write(msgspec.json.encode(reply) + b"\n")
        sys.stdout.buffer.flush()


def hello(line: bytes) -> Reply:
    found = answered(line)
    assert not isinstance(found, Bye)
    assert isinstance(found[-1], OkReply)
    return found[-1]


if __name__ == "__main__":
    serve(lambda _, result: result)
