"""Gives the result of the request before, of the same operation: right, but of another case."""

from reference import Message, serve

BEFORE: dict[object, Message] = {}


def spoil(request: Message, result: Message) -> Message:
    before = BEFORE.get(request["op"], result)
    BEFORE[request["op"]] = result
    return before


serve(spoil)
