"""Takes all the memory there is."""

from good import Message, serve

held: list[bytearray] = []


def spoil(_: int, __: Message) -> None:
    while True:
        held.append(bytearray(16 << 20))


serve(spoil)
