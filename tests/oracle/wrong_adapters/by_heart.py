"""Knows the answers to a small suite by heart; with `bit`, the last bit of one is wrong."""

import json
import sys

FACES = [[0, 1, 2], [3, 2, 1], [0, 3, 1], [2, 3, 0]]
INVALID = {"class": "invalid", "reason": "a-reason-of-its-own"}
HELLO = {
    "protocol": 1,
    "name": "heart",
    "version": "2",
    "language": "python",
    "ops": ["echo", "word.decode", "code.encode"],
    "caps": {
        "handles": False,
        "boundaries": "none",
        "components": False,
        "max_faces": 10,
        "max_symbols": 10,
        "codes": ["plain"],
    },
}
BITS = {"hex": "b8" if sys.argv[1:] == ["bit"] else "bc", "length": 6}

for line in sys.stdin:
    request = json.loads(line)
    answer: dict[str, object] = {"unsupported": {"cap": request["op"]}}
    match request["op"], request.get("in"):
        case "bye", _:
            break
        case "hello", _:
            answer = {"ok": HELLO}
        case "echo", given:
            answer = {"ok": given}
        case "word.decode", {"word": "CRE"}:
            answer = {"ok": {"faces": FACES, "vertices": 4}}
        case "word.decode", _:
            answer = {"reject": INVALID}
        case "code.encode", {"word": "CRE"}:
            answer = {"ok": BITS}
        case _:
            pass
    print(json.dumps({"id": request["id"], **answer}), flush=True)
