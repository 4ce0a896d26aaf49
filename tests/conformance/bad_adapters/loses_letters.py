"""Keeps ASCII only, and rounds numbers as binary32."""

import struct

from good import Message, reply, say, serve


def lossy(value: object) -> object:
    match value:
        case str():
            return value.encode("ascii", "replace").decode()
        case float():
            return struct.unpack("f", struct.pack("f", value))[0] if abs(value) < 1e38 else value
        case list():
            return [lossy(item) for item in value]
        case dict():
            return {key: lossy(item) for key, item in value.items()}
        case _:
            return value


def spoil(_: int, request: Message) -> None:
    answer = reply(request)
    say({key: lossy(value) if key == "ok" else value for key, value in answer.items()})


serve(spoil)
