"""Never answers anything but hello."""

import time

from good import Message, serve


def spoil(_: int, __: Message) -> None:
    time.sleep(3600)


serve(spoil)
