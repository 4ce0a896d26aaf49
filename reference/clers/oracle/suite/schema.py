"""The JSON Schema of the files of a suite, made from their records. Clause: ORCL-CASE-7."""

import msgspec

from clers.conformance.results import RESULTS
from clers.oracle.suite.records import Canaries, Flags, Manifest, Part, RetiredList


def vectors_schema() -> dict[str, object]:
    """Any file of a suite; under `operations` the input and the result of each. ORCL-CASE-7."""
    named = [(name, asked, kind) for name, (asked, kind) in RESULTS.items()]
    kinds = [dict[str, object] if kind is None else kind for _, _, kind in named]
    found, parts = msgspec.json.schema_components(
        [Manifest, Part, Flags, RetiredList, Canaries, *(asked for _, asked, _ in named), *kinds],
        ref_template="#/$defs/{name}",
        schema_hook=lambda _: {"description": "any value"},
    )
    files, rest = found[:5], found[5:]
    asks, gives = rest[: len(named)], rest[len(named) :]
    operations = {
        name: {"request": ask, "ok": give}
        for (name, _, _), ask, give in zip(named, asks, gives, strict=True)
    }
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "The files of a suite of vectors: manifest, cases, flags, retired and canaries",
        "anyOf": list(files),
        "operations": operations,
        "$defs": parts,
    }
