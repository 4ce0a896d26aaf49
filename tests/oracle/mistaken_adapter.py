"""The reference as an adapter with the mistakes that are named as arguments; all of them without.

python mistaken_adapter.py letters handles bits faces positions classes crash
"""

import json
import os
import sys
from collections.abc import Callable

from clers.conformance.adapter import answered
from clers.conformance.lines import line_of
from clers.conformance.messages import Bye, OkReply, RejectReply

Result = dict[str, object]


def letters(ok: Result) -> None:
    """R and L exchanged."""
    word = ok.get("word")
    if isinstance(word, str):
        ok["word"] = word.translate(str.maketrans("RL", "LR"))


def handles(ok: Result) -> None:
    """Each record one closer later."""
    records = ok.get("handles")
    if isinstance(records, list):
        ok["handles"] = [{**record, "at": record["at"] + 1} for record in records]


def bits(ok: Result) -> None:
    """The last bit forgotten."""
    if isinstance(ok.get("hex"), str) and isinstance(ok.get("length"), int):
        data, length = bytes.fromhex(str(ok["hex"])), int(str(ok["length"])) - 1
        digits = "".join(f"{byte:08b}" for byte in data)[: max(length, 0)]
        filled = digits + "0" * (-len(digits) % 8)
        packed = bytes(int(filled[i : i + 8], 2) for i in range(0, len(filled), 8))
        ok["hex"], ok["length"] = packed.hex(), max(length, 0)


def faces(ok: Result) -> None:
    """From the seventh face on, each turned over."""
    found = ok.get("faces")
    if isinstance(found, list):
        ok["faces"] = [[a, b, c] if i < 6 else [a, c, b] for i, (a, b, c) in enumerate(found)]


def turned(ok: Result) -> None:
    """Each face begins one corner later."""
    found = ok.get("faces")
    if isinstance(found, list):
        ok["faces"] = [[b, c, a] for a, b, c in found]


def positions(ok: Result) -> None:
    """The last coordinate is doubled, and one more."""
    places = ok.get("positions")
    if isinstance(places, dict) and places["coordinates"]:
        places["coordinates"][-1] = 2 * places["coordinates"][-1] + 1


MISTAKES: dict[str, Callable[[Result], None]] = {
    "letters": letters,
    "handles": handles,
    "bits": bits,
    "faces": faces,
    "positions": positions,
    "turned": turned,
}


def main(names: list[str]) -> None:
    """Serve. `classes`: rejections are `malformed`; `crash`: a script ends it; `hang`: silence."""
    for line in sys.stdin.buffer:
        if "crash" in names and b'"op":"operator.apply"' in line:
            os.abort()
        if "hang" in names and b'"op":"hello"' not in line:
            continue
        replies = answered(line)
        if isinstance(replies, Bye):
            return
        for reply in replies:
            document = json.loads(line_of(reply))
            if isinstance(reply, OkReply) and reply.id:
                for name in MISTAKES.keys() & names:
                    MISTAKES[name](document["ok"])
            elif isinstance(reply, OkReply):
                document["ok"]["caps"]["trace"] = []
            if isinstance(reply, RejectReply) and "classes" in names:
                document["reject"]["class"] = "malformed"
            sys.stdout.write(json.dumps(document) + "\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main(sys.argv[1:] or [*MISTAKES, "classes", "crash"])
