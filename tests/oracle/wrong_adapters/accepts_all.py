"""Declares all that the reference declares, and has one good answer for each operation."""

import sys

import msgspec
from reference import Message, hello, right

from clers.conformance.lines import line_of
from clers.conformance.samples import SAMPLES

for line in sys.stdin.buffer:
    request = msgspec.json.decode(line, type=Message)
    if request["op"] == "bye":
        break
    if request["op"] == "hello":
        answer = line_of(hello(line))
    else:
        sample = msgspec.json.decode(line_of(SAMPLES[str(request["op"])]), type=Message)
        answer = msgspec.json.encode({**right(sample), "id": request["id"]}) + b"\n"
    sys.stdout.buffer.write(answer)
    sys.stdout.buffer.flush()
