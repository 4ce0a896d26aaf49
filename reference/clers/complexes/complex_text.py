"""Complexes as text: the facets, in JSON."""

import json
from typing import Final

import msgspec

from clers.complexes.facets import facets, from_facets
from clers.complexes.simplicial import Complex
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected

_ROWS: Final = msgspec.json.Decoder(list[list[int]])


def write_complex(k: Complex) -> str:
    """The text of a complex: one for each. Clause: CPLX-FACET-4."""
    return json.dumps(facets(k), separators=(",", ":")) + "\n"


def read_complex(text: str) -> Accepted[Complex] | Rejected:
    """The complex that a text says; `unreadable-file` where it says none. Clause: CPLX-FACET-4."""
    try:
        rows = _ROWS.decode(text)
    except (msgspec.DecodeError, UnicodeError) as error:
        return Rejected(Reason.UNREADABLE_FILE, Clause.CPLX_FACET_4, detail=str(error))
    return from_facets(rows)
