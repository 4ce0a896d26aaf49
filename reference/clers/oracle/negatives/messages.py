"""Messages in bits: models that are none, symbols that there are not, bits that nobody writes.

The good bits are computed by the definition (ARITH-CARRY-1) for the coder of chapter 2; the others
have no definition beside their own, and are asked of the reference.
"""

from collections.abc import Iterator, Sequence
from typing import Final

import msgspec
from msgspec import UnsetType

from clers.arithmetic.bits import pack
from clers.conformance import payloads as form
from clers.conformance.cases.case import Edit
from clers.conformance.cases.edits import replaced
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.oracle.negatives import pencil
from clers.oracle.negatives.draft import Draft, Slip, bad, good

C = Clause
R = Reason

STATIC: Final = form.StaticForm(frequencies=(1, 2, 1))
FLAT: Final = form.UniformForm(size=5)
LEARNING: Final = form.AdaptiveForm(frequencies=(1, 1, 1), increment=2, limit=16)
HOLES: Final = form.StaticForm(frequencies=(3, 0, 5))
LARGE: Final = form.StaticForm(frequencies=((1 << 30) - 1, 1))
"""A table of the greatest total. Clause: INFO-MODEL-2."""

MESSAGES: Final[tuple[tuple[str, form.ModelForm, tuple[int, ...]], ...]] = (
    ("static", STATIC, (1, 0, 2)),
    ("uniform", FLAT, (4, 0, 2, 3)),
    ("adaptive", LEARNING, (2, 2, 0, 1, 2, 2, 2)),
    ("with-a-hole", HOLES, (0, 2, 2, 0)),
    ("largest-total", LARGE, (0, 1, 0)),
    ("carries", STATIC, (1,) * 40 + (2,)),
    ("pending-to-the-end", STATIC, (1,) * 40),
    ("empty", STATIC, ()),
)

CODERS: Final[tuple[form.CoderName, ...]] = ("arithmetic", "range", "rans")
STRICT: Final = "bits-not-compared"


def _slots(model: form.ModelForm, symbols: Sequence[int]) -> Iterator[pencil.Slot]:
    """The slots of a message, from the model's definition."""
    match model:
        case form.UniformForm(size=int(size)):
            yield from ((s, s + 1, size) for s in symbols)
        case form.StaticForm(frequencies=table):
            counts = pencil.Counts([int(f) for f in table], 0, 1 << 30)
            yield from map(counts.slot, symbols)
        case form.AdaptiveForm(frequencies=table, increment=step, limit=limit):
            counts = pencil.Counts([int(f) for f in table], int(step), int(limit))
            yield from map(counts.slot, symbols)
        case _:
            raise Slip(f"{model}")


def string(digits: str) -> form.BitString:
    """Bits as a message has them. Clause: ORCL-VALUE-2."""
    bits = pack(map(int, digits))
    return form.BitString(hex=bits.data.hex(), length=bits.length)


def encoding(
    coder: form.CoderName, name: str, model: form.ModelForm, symbols: Sequence[int]
) -> Draft:
    """The case of a message to encode."""
    return good(
        f"{coder}-{name}", "arithmetic.encode",
        form.ToCode(coder=coder, model=model, symbols=tuple(symbols)),
        (C.ARITH_ENCODE_1 if coder == "arithmetic" else C.ARITH_BYTES_1,),
        requires=(f"coder.{coder}",), size=len(symbols),
    )  # fmt: skip


def decoding(
    coder: form.CoderName, name: str, model: form.ModelForm, symbols: Sequence[int], digits: str
) -> Draft:
    """The case of bits to decode."""
    return good(
        f"{coder}-{name}", "arithmetic.decode",
        form.Coded(coder=coder, model=model, bits=string(digits), count=len(symbols)),
        (C.ARITH_STRICT_1 if coder == "arithmetic" else C.ARITH_BYTES_2,),
        requires=(f"coder.{coder}",), size=len(symbols),
    )  # fmt: skip


def digits_of(draft: Draft) -> str:
    """The bits that are the result of a case."""
    ok = draft.case.ok
    if isinstance(ok, UnsetType):
        raise Slip(draft.slug)
    found = msgspec.json.decode(ok, type=form.BitString)
    return "".join(f"{byte:08b}" for byte in bytes.fromhex(found.hex))[: found.length]


def drafts() -> Iterator[Draft]:
    """Messages in each coder, and what is wrong with them. Clause: ORCL-OP-4."""
    for coder in CODERS:
        for name, model, symbols in MESSAGES:
            asked = encoding(coder, name, model, symbols)
            digits = digits_of(asked)
            if coder == "arithmetic" and digits != pencil.long_addition(_slots(model, symbols)):
                raise Slip(f"{name}: {digits}")
            given = decoding(coder, name, model, symbols, digits)
            yield asked
            yield given
            yield from cut(given, digits, coder)
            yield from packed(given, digits)
            if name in MODELS:
                for draft in (asked, given):
                    yield from bad_models(draft, name)
            if name in STRANGERS:
                yield from strangers(asked, name, len(symbols))


def bit_edits(old: str, new: str) -> tuple[Edit, Edit]:
    """Other bits, and their number."""
    one, two = string(old), string(new)
    return replaced("/bits/hex", 0, one.hex, two.hex), replaced(
        "/bits/length", 0, one.length, two.length
    )


def cut(given: Draft, digits: str, coder: form.CoderName) -> Iterator[Draft]:
    """Bits missing and too many. Clauses: ARITH-STRICT-2 … -4, ARITH-BYTES-2, ARITH-RANS-5."""
    bits = coder == "arithmetic"
    short = C.ARITH_STRICT_2 if bits else C.ARITH_BYTES_2
    more = C.ARITH_STRICT_3 if bits else C.ARITH_BYTES_2
    unit = 1 if bits else 8
    for kind, new, reason, clause in (
        ("one-bit-more", digits + "0", R.TRAILING_BITS, more),
        ("one-bit-set-more", digits + "1", R.TRAILING_BITS, more),
        ("eight-bits-more", digits + "0" * 8, R.TRAILING_BITS, more),
        ("no-bits", "", R.TRUNCATED_BITS, short),
        ("last-unit-missing", digits[:-unit], R.TRUNCATED_BITS, short),
    ):
        yield bad(given, kind, bit_edits(digits, new), reason, clause, flags=(STRICT,))
    turned = digits[:-1] + str(1 - int(digits[-1]))
    reason, clause = R.NOT_CANONICAL, C.ARITH_STRICT_4 if bits else C.ARITH_BYTES_2
    if given.slug == "arithmetic-adaptive":  # these bits begin a longer message
        reason, clause = R.TRUNCATED_BITS, short
    yield bad(given, "last-bit-turned", bit_edits(digits, turned), reason, clause, flags=(STRICT,))
    if coder == "rans":
        low = "0" * 8 + digits[8:]
        yield bad(
            given, "state-too-low", bit_edits(digits, low), R.NOT_CANONICAL, C.ARITH_RANS_5,
            flags=(STRICT,),
        )  # fmt: skip


def packed(given: Draft, digits: str) -> Iterator[Draft]:
    """Bytes that do not hold so many bits. Clause: ARITH-BITS-3."""
    here = string(digits)
    clause, flag = C.ARITH_BITS_3, ("filling-bits-ignored",)
    end = len(here.hex)
    byte = replaced("/bits/hex", end, "", "00")
    yield bad(given, "zero-byte-more", (byte,), R.TRAILING_BITS, clause, flags=flag)
    length = replaced("/bits/length", 0, here.length, end * 4 + 1)
    yield bad(given, "length-over-bytes", (length,), R.TRUNCATED_BITS, clause, flags=flag)
    huge = replaced("/bits/length", 0, here.length, 1 << 53)
    yield bad(given, "length-2-53", (huge,), R.TRUNCATED_BITS, clause, flags=("size-trusted",))
    if here.length % 8:
        old = here.hex[-1]
        odd = replaced("/bits/hex", end - 1, old, f"{int(old, 16) | 1:x}")
        yield bad(given, "last-filling-bit-set", (odd,), R.TRAILING_BITS, clause, flags=flag)


MODELS: Final = ("static", "uniform", "adaptive")
STRANGERS: Final = ("static", "with-a-hole")


def bad_models(draft: Draft, name: str) -> Iterator[Draft]:
    """Tables that are no tables. Clauses: INFO-STATIC-3, INFO-ADAPT-3."""
    static, adaptive = C.INFO_STATIC_3, C.INFO_ADAPT_3
    top = 1 << 30
    table = "/model/frequencies"
    rows: dict[str, tuple[tuple[str, Edit, C], ...]] = {
        "static": (
            ("no-symbols", replaced(table, 0, [1, 2, 1], []), static),
            ("all-zero", replaced(table, 0, [1, 2, 1], [0, 0, 0]), static),
            ("negative-frequency", replaced(table, 1, [2], [-2]), static),
            ("total-one-over", replaced(table, 0, [1, 2, 1], [1, 2, top - 2]), static),
            ("total-wraps-at-32-bits", replaced(table, 1, [2], [(1 << 32) + 2]), static),
            ("total-wraps-at-64-bits", replaced(table, 1, [2], [str((1 << 64) + 2)]), static),
            ("sum-wraps", replaced(table, 0, [1, 2, 1], [1 << 31, 1 << 31, 4]), static),
        ),
        "uniform": (
            ("of-none", replaced("/model/size", 0, 5, 0), static),
            ("negative-size", replaced("/model/size", 0, 5, -5), static),
            ("size-one-over", replaced("/model/size", 0, 5, top + 1), static),
            ("size-wraps-at-32-bits", replaced("/model/size", 0, 5, (1 << 32) + 5), static),
            ("size-wraps-at-64-bits", replaced("/model/size", 0, 5, str((1 << 64) + 5)), static),
        ),
        "adaptive": (
            ("increment-zero", replaced("/model/increment", 0, 2, 0), adaptive),
            ("increment-negative", replaced("/model/increment", 0, 2, -2), adaptive),
            ("limit-under-what-halving-leaves", replaced("/model/limit", 0, 16, 4), adaptive),
            ("limit-under-total", replaced(table, 0, [1, 1, 1], [1, 16, 1]), adaptive),
            ("limit-over-all", replaced("/model/limit", 0, 16, top + 1), adaptive),
            ("starts-with-nothing", replaced(table, 0, [1, 1, 1], [0, 0, 0]), static),
            ("starts-below-nothing", replaced(table, 1, [1], [-1]), static),
        ),
    }
    for kind, edit, clause in rows[name]:
        yield bad(draft, kind, (edit,), R.BAD_TABLE, clause, flags=("table-not-checked",))


def strangers(asked: Draft, name: str, count: int) -> Iterator[Draft]:
    """Symbols that the model does not allow. Clause: INFO-MODEL-5."""
    given = msgspec.json.decode(asked.case.input, type=form.ToCode)
    for kind, at, new in (
        ("symbol-too-great", count - 1, 3),
        ("symbol-negative", 0, -1),
        ("symbol-wraps-at-8-bits", 0, 256),
        ("symbol-wraps-at-32-bits", 1, 1 << 32),
        ("symbol-wraps-at-64-bits", 1, str(1 << 64)),
        *((("symbol-of-frequency-zero", 1, 1),) if name == "with-a-hole" else ()),
    ):
        edit = replaced("/symbols", at, [given.symbols[at]], [new])
        yield bad(
            asked, kind, (edit,), R.NOT_IN_ALPHABET, C.INFO_MODEL_5, flags=("symbol-not-checked",)
        )
