"""The id of a case: a few words for people, and a hash of what it asks and expects. ORCL-CASE-2."""

import json
from base64 import b32encode
from hashlib import sha256

import msgspec
from msgspec import UNSET, Raw

from clers.conformance.cases.case import Case

DIGITS = 8


def identity(slug: str, case: Case) -> str:
    """The id of a case under a slug of lowercase words with `-` between. Clause: ORCL-CASE-2.

    Of the input and the result their texts count, as they are in the case.
    """
    document = [case.op, case.input, case.ok, case.reject, case.compare, case.trace]
    kept = [part for part in document if part is not UNSET]
    digest = sha256(msgspec.json.encode(kept)).digest()
    return f"{slug}-{b32encode(digest).decode().lower()[:DIGITS]}"


def named(slug: str, case: Case) -> Case:
    """The case under its id, its input and result in the one text that they have.

    Clauses: ORCL-CASE-2, ORCL-CASE-8.
    """
    ok = case.ok if case.ok is UNSET else _plain(case.ok)
    plain = msgspec.structs.replace(case, input=_plain(case.input), ok=ok)
    return msgspec.structs.replace(plain, id=identity(slug, plain))


def _plain(value: Raw) -> Raw:
    """The text of a JSON value: no spaces, keys as they come, each number in its one form.

    Python's own writer is used, for its numbers have looked the same since version 3.1.
    """
    text = json.dumps(json.loads(bytes(value)), separators=(",", ":"), ensure_ascii=False)
    return Raw(text.encode())
