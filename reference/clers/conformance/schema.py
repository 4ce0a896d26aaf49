"""The JSON Schema of the protocol, made from the records of its messages. Clause: ORCL-LINE-3."""

import msgspec

from clers.conformance.messages import Hello, Introduction, Request
from clers.conformance.results import REPLIES, RESULTS


def protocol_schema() -> dict[str, object]:
    """Requests and replies; under `operations` the input and the result of each. ORCL-LINE-3."""
    named = [(name, asked, kind) for name, (asked, kind) in RESULTS.items()]
    count = len(named)
    kinds = [dict[str, object] if kind is None else kind for _, _, kind in named]
    (request, hello, introduction, *rest), parts = msgspec.json.schema_components(
        [Request, Hello, Introduction, *(asked for _, asked, _ in named), *kinds, *REPLIES],
        ref_template="#/$defs/{name}",
        schema_hook=lambda _: {"description": "any value"},  # of `object`
    )
    asks, gives, replies = rest[:count], rest[count : 2 * count], rest[2 * count :]
    operations = {"hello": {"request": hello, "ok": introduction}}
    for (name, _, _), ask, give in zip(named, asks, gives, strict=True):
        operations[name] = {"request": ask, "ok": give}
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "The protocol of adapters: a line is a request or a reply",
        "anyOf": [{"$ref": "#/$defs/Request"}, {"$ref": "#/$defs/Reply"}],
        "operations": operations,
        "$defs": {"Request": request, "Reply": {"anyOf": list(replies)}, **parts},
    }
