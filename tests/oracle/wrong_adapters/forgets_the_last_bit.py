"""Bits without the last one, as if the coder were not flushed."""

from reference import Message, serve


def spoil(request: Message, result: Message) -> Message:
    length, digits = result.get("length"), result.get("hex")
    if not isinstance(length, int) or not isinstance(digits, str) or length == 0:
        return result
    data = bytearray.fromhex(digits)
    if length % 8 == 1:
        data.pop()
    else:
        data[-1] &= 0xFF << (9 - length % 8 if length % 8 else 1)
    return {"hex": data.hex(), "length": length - 1}


serve(spoil)
