"""The id of a case: a few words for people, and a hash of what it asks and expects. ORCL-CASE-2."""

from base64 import b32encode
from hashlib import sha256

import msgspec

from clers.conformance.cases.case import Case

DIGITS = 8


def identity(slug: str, case: Case) -> str:
    """The id of a case under a slug of lowercase words with `-` between. Clause: ORCL-CASE-2."""
    document = [case.op, case.input, case.ok, case.reject, case.compare, case.trace]
    kept = [part for part in document if part is not msgspec.UNSET]
    digest = sha256(msgspec.json.encode(kept, order="sorted")).digest()
    return f"{slug}-{b32encode(digest).decode().lower()[:DIGITS]}"


def named(slug: str, case: Case) -> Case:
    """The case under its id. Clause: ORCL-CASE-2."""
    return msgspec.structs.replace(case, id=identity(slug, case))
