"""An adapter that writes words in the plain code, with the fault that is named, if any.

It needs nothing but Python, so that it starts quickly.
"""

import json
import os
import sys
import time

CODEWORDS = {"C": "0", "S": "100", "R": "101", "L": "110", "E": "111"}
FAULT = sys.argv[1] if len(sys.argv) > 1 else ""
CAPS = {
    "handles": True, "boundaries": "many", "components": True,
    "max_faces": 10000, "max_symbols": 10000, "codes": ["plain"],
}  # fmt: skip
HELLO = {
    "protocol": 1, "name": "plain-coder", "version": "2", "language": "python",
    "ops": ["echo", "code.encode"], "caps": CAPS,
}  # fmt: skip


def bits(word: str, boundary: int) -> dict[str, object]:
    """The word in the plain code, packed."""
    digits = "".join(CODEWORDS[x] for x in (word if boundary else word[1:]))
    if FAULT == "forgets-a-bit":
        digits = digits[:-1]
    whole = digits + "0" * (-len(digits) % 8)
    data = bytes(int(whole[k : k + 8], 2) for k in range(0, len(whole), 8))
    return {"hex": data.hex(), "length": len(digits)}


def misbehave(word: str, records: int) -> None:
    """Crash at an S, or hang where there are two components."""
    if FAULT == "crashes-at-s" and "S" in word:
        os._exit(3)
    if FAULT == "hangs-on-two" and word.count("E") - word.count("S") + records > 1:
        time.sleep(3600)


def main() -> None:
    for line in sys.stdin:
        request = json.loads(line)
        if request["op"] == "bye":
            return
        given = request.get("in", {})
        reply: dict[str, object] = {"id": request["id"]}
        match request["op"]:
            case "hello":
                reply["ok"] = HELLO
            case "echo":
                reply["ok"] = given
            case "code.encode":
                misbehave(given["word"], len(given["handles"]))
                reply["ok"] = bits(given["word"], given["components_with_boundary"])
            case other:
                reply["unsupported"] = {"cap": other}
        print(json.dumps(reply), flush=True)


if __name__ == "__main__":
    main()
