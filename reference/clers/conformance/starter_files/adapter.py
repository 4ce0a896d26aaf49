"""An adapter to begin with: it does `echo`, and says so of nothing else.

One request a line comes on standard input, one reply a line goes to standard output; print anything
else to standard error. What the operations take and give: spec/09-conformance.md.
"""

import json
import sys

PROTOCOL = 1

HELLO: dict[str, object] = {
    "protocol": PROTOCOL,
    "name": "my mesh library",
    "version": "0.1",
    "language": "python",
    "ops": ["echo"],  # then "word.decode", …
    "caps": {
        "handles": False,
        "boundaries": "none",  # or "one", or "many"
        "components": False,
        "max_faces": 1000000,
        "max_symbols": 1000000,
    },
}


def answer(request: dict[str, object]) -> dict[str, object]:
    """One of ok, reject, unsupported, error."""
    operation = request["op"]
    if operation == "hello" and request["protocol"] != PROTOCOL:
        return {"unsupported": {"cap": "protocol"}}
    if operation == "hello":
        return {"ok": HELLO}
    if operation == "echo":
        return {"ok": request["in"]}
    # Here your operations join. Bad input is
    #   {"reject": {"class": "malformed", "reason": "…"}}    (or "invalid", "unsupported", "limit")
    return {"unsupported": {"cap": operation}}


def main() -> None:
    """Answer until bye or the end of input."""
    for line in sys.stdin.buffer:
        request = json.loads(line)
        if request["op"] == "bye":
            return
        reply = {"id": request["id"], **answer(request)}
        sys.stdout.write(f"{json.dumps(reply)}\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main()
