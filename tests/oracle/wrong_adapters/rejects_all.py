"""Declares all that the reference declares, and rejects all of it, with the class it is given."""

import sys

import msgspec
from reference import Message, hello

from clers.conformance.lines import line_of

for line in sys.stdin.buffer:
    request = msgspec.json.decode(line, type=Message)
    if request["op"] == "bye":
        break
    reject = {"id": request["id"], "reject": {"class": sys.argv[1], "reason": "it-is-bad"}}
    asked = request["op"] == "hello"
    sys.stdout.buffer.write(line_of(hello(line)) if asked else msgspec.json.encode(reject) + b"\n")
    sys.stdout.buffer.flush()
