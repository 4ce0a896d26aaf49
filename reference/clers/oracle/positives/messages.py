"""Messages for the three coders, with each kind of model and at the edges of what they take."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from random import Random
from typing import Final, get_args

from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.served import arithmetic
from clers.conventions.clause import Clause
from clers.conventions.result import Accepted
from clers.oracle.positives.asked import Asked

LARGEST: Final = 1 << 30
"""The greatest total of a table. Clause: INFO-MODEL-2."""

TUTORIAL: Final = (1, 1, 4, 3, 1)
IMAGE: Final = (1, 3, 2, 3, 3, 3, 0, 3, 3, 2, 3, 2)
LEARNT: Final = (*IMAGE, 2, 0, 0)
"""The tutorial's table of five colours, and its images of sections 3(a) and 3(c)."""


@dataclass(frozen=True, slots=True)
class Told:
    """A message with its model, and what is remarkable about it."""

    slug: str
    model: form.ModelForm
    symbols: tuple[int, ...]
    flags: tuple[str, ...] = ()
    comment: str = ""


def drawn(weights: Sequence[int], count: int, seed: int) -> tuple[int, ...]:
    """Symbols at random, by weights. Only `Random.random` is used."""
    draw = Random(seed).random
    ladder = [s for s, weight in enumerate(weights) for _ in range(weight)]
    return tuple(ladder[int(draw() * len(ladder))] for _ in range(count))


def _static(*frequencies: int) -> form.StaticForm:
    return form.StaticForm(frequencies=frequencies)


def _uniform(size: int) -> form.UniformForm:
    return form.UniformForm(size=size)


def _learning(frequencies: Sequence[int], increment: int, limit: int) -> form.AdaptiveForm:
    return form.AdaptiveForm(frequencies=tuple(frequencies), increment=increment, limit=limit)


def by_tables() -> Iterator[Told]:
    """Static models."""
    yield Told("tutorial-image", _static(*TUTORIAL), IMAGE, (), "section 3(a) of the tutorial")
    yield Told("empty-message", _static(1, 2, 1), (), ("empty-message",))
    yield Told("one-symbol-alphabet", _static(7), (0,) * 40, ("one-symbol",))
    yield Told("one-symbol-of-many", _static(0, 0, 9, 0), (2,) * 40, ("one-symbol", "never"))
    yield Told("never-in-between", _static(3, 0, 4, 0, 0, 1), drawn((3, 0, 4, 0, 0, 1), 60, 1),
        ("never",))  # fmt: skip
    for length in (1, 2, 3, 8, 40, 200):
        yield Told(f"fair-coin-{length}", _static(1, 1), drawn((1, 1), length, length))
    for length in (5, 33, 150):
        for last in (0, 2):
            run = (1,) * length
            slug = f"about-the-middle-{length}-then-{last}"
            yield Told(slug, _static(3, 2, 3), (*run, last), ("pending-bits",))
    yield Told("about-the-middle-to-the-end", _static(3, 2, 3), (1,) * 90, ("pending-bits",))
    rare = _static(1, LARGEST - 1)
    yield Told("largest-total-common", rare, (1,) * 50, ("largest-total",))
    yield Told("largest-total-rare", rare, (0,) * 12, ("largest-total",))
    yield Told("largest-total-mixed", rare, (0, 1, 1, 0, 1), ("largest-total",))
    odd = _static(LARGEST // 3, LARGEST // 3, LARGEST // 3)
    yield Told("largest-thirds", odd, drawn((1, 1, 1), 60, 3), ("largest-total",))
    steep = tuple(1 << k for k in range(20))
    yield Told("powers-of-two", _static(*steep), drawn((1,) * 20, 80, 4))
    primes = (2, 3, 5, 7, 11, 13, 17, 19, 23)
    yield Told("primes", _static(*primes), drawn(primes, 300, 5))
    yield Told("first-symbols", _static(*primes), (0,) * 100)
    yield Told("last-symbols", _static(*primes), (8,) * 100, ("carry",))
    yield Told("nearly-all-ones", _static(1, 255), (*(1,) * 300, 0), ("carry",))
    yield Told("clers-word", _static(8, 1, 2, 5, 1), drawn((8, 1, 2, 5, 1), 400, 6))


def by_size() -> Iterator[Told]:
    """Uniform models."""
    for size in (1, 2, 3, 5, 255, 256, 257, 65536, 65537, LARGEST - 1, LARGEST):
        flags = ("largest-total",) if size >= LARGEST - 1 else ("one-symbol",) if size == 1 else ()
        draw = Random(size).random
        ends = (0, size - 1, size - 1, 0, size // 2)
        symbols = (*ends, *(int(draw() * size) for _ in range(25)))
        yield Told(f"uniform-{size}", _uniform(size), symbols, flags)
    yield Told("uniform-empty", _uniform(LARGEST), (), ("empty-message", "largest-total"))


def by_learning() -> Iterator[Told]:
    """Adaptive models."""
    tutorial = _learning(TUTORIAL, 1, 1 << 16)
    yield Told("tutorial-learning", tutorial, LEARNT, (), "section 3(c) of the tutorial")
    yield Told("learning-nothing", _learning((1, 1), 1, 100), (), ("empty-message",))
    for limit in (8, 9, 16, 33):
        symbols = drawn((5, 1, 1), 120, limit)
        yield Told(f"halved-at-{limit}", _learning((1, 1, 1), 3, limit), symbols, ("halving",))
    yield Told("halved-each-time", _learning((1, 1), 6, 8), drawn((1, 1), 60, 7), ("halving",))
    zeros = _learning((0, 1, 0, 2), 2, 12)
    yield Told("never-learnt", zeros, drawn((0, 1, 0, 2), 80, 8), ("halving", "never"))
    classes = _learning((1,) * 31, 8, 1 << 13)
    yield Told("classes-of-residuals", classes, drawn(range(31), 500, 9), ("halving",))
    large = _learning((1, 1, 1), 1 << 28, LARGEST)
    yield Told("large-increment", large, drawn((1, 1, 1), 60, 10), ("halving", "largest-total"))
    full = _learning((LARGEST - 3, 1, 1), 1, LARGEST)
    yield Told("full-from-the-start", full, (1, 2, 0, 1, 2, 0, 0), ("halving", "largest-total"))
    yield Told("one-symbol-learnt", _learning((1,), 1, 4), (0,) * 30, ("halving", "one-symbol"))
    shifts = (*(0,) * 100, *(1,) * 100, *(2,) * 100)
    yield Told("changing-source", _learning((1, 1, 1), 8, 1 << 10), shifts, ("halving",))


def told() -> Iterator[Told]:
    """All messages."""
    yield from by_tables()
    yield from by_size()
    yield from by_learning()


_OF_MODEL: Final = {
    "static": (Clause.INFO_STATIC_1,),
    "uniform": (Clause.INFO_STATIC_2,),
    "adaptive": (Clause.INFO_ADAPT_1, Clause.INFO_ADAPT_2),
}
_TO_BITS: Final = {
    "arithmetic": (
        Clause.ARITH_BITS_1,
        Clause.ARITH_BITS_2,
        Clause.ARITH_NARROW_1,
        Clause.ARITH_SHIFT_1,
        Clause.ARITH_SHIFT_2,
        Clause.ARITH_END_1,
        Clause.ARITH_ENCODE_1,
    ),
    "range": (
        Clause.ARITH_RANGE_1,
        Clause.ARITH_RANGE_2,
        Clause.ARITH_RANGE_3,
        Clause.ARITH_RANGE_4,
        Clause.ARITH_RANGE_5,
    ),
    "rans": (Clause.ARITH_RANS_1, Clause.ARITH_RANS_2, Clause.ARITH_RANS_3),
}
_FROM_BITS: Final = {
    "arithmetic": (Clause.ARITH_DECODE_1, Clause.ARITH_DECODE_2, Clause.ARITH_DECODE_3),
    "range": (Clause.ARITH_RANGE_6, Clause.ARITH_RANGE_7),
    "rans": (Clause.ARITH_RANS_4, Clause.ARITH_RANS_5),
}


def kind_of(model: form.ModelForm) -> str:
    """The model's kind, as a message names it. Clause: ORCL-OP-4."""
    match model:
        case form.StaticForm():
            return "static"
        case form.UniformForm():
            return "uniform"
        case form.AdaptiveForm():
            return "adaptive"


def coded(coder: form.CoderName, tale: Told) -> Iterator[Asked]:
    """A message there and back."""
    given = form.ToCode(coder=coder, model=tale.model, symbols=tale.symbols)
    bits = arithmetic.encode(given)
    if not isinstance(bits, Accepted):
        raise AssertionError(f"{tale.slug}: {bits.line()}")
    of_model = (Clause.INFO_MODEL_1, *_OF_MODEL[kind_of(tale.model)])
    slug = f"{coder}-{tale.slug}"
    requires, size = (f"coder.{coder}",), len(tale.symbols)
    yield Asked(
        slug, "arithmetic.encode", message.ArithmeticEncode(id=0, input=given),
        (*_TO_BITS[coder], *of_model), "hand", requires, size, tale.flags, tale.comment,
    )  # fmt: skip
    back = form.Coded(coder=coder, model=tale.model, bits=bits.value, count=size)
    yield Asked(
        slug, "arithmetic.decode", message.ArithmeticDecode(id=0, input=back),
        (*_FROM_BITS[coder], *of_model), "hand", requires, size, tale.flags, tale.comment,
    )  # fmt: skip


def messages() -> Iterator[Asked]:
    """Each message with each coder, there and back."""
    for tale in told():
        for coder in get_args(form.CoderName):
            yield from coded(coder, tale)
