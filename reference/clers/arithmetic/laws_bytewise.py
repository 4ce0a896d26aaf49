"""Laws of coders that work in bytes; each takes the coder as an argument."""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Final

from clers.arithmetic.bits import Bits, pack
from clers.arithmetic.coder import Coder
from clers.arithmetic.given import ATTEMPT, JOINED, Attempt, Joined
from clers.arithmetic.range_coder import RANGE_CODER
from clers.arithmetic.rans import RANS
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import WHOLE, AtSymbol
from clers.information.given import ANY_MESSAGE, MESSAGE, SMALL, Message, Small
from clers.information.laws_measure import all_messages, along
from clers.information.model import Slot, has_ended, slots

Bound = Callable[[int, tuple[Slot, ...]], bool]
"""A claim about the length of a code in bits, and the slots of its message."""


@dataclass(frozen=True, slots=True)
class _Of:
    """The laws of one coder, as functions of an example."""

    coder: Coder
    bound: Bound

    def coded(self, given: Message, judge: Callable[[Bits, tuple[Slot, ...]], Verdict]) -> Verdict:
        """Judge the bits of an allowed message."""
        bits = self.coder.encode(given.model, given.symbols)
        found = slots(given.model, given.symbols)
        if isinstance(bits, Rejected) or isinstance(found, Rejected):
            return Fails("bits", f"{bits}, {found}", WHOLE)
        return judge(bits.value, found.value)

    def round_trip(self, given: Joined) -> Verdict:
        """Clauses: ARITH-BYTES-2, ARITH-BYTES-3."""

        def judge(bits: Bits, _: tuple[Slot, ...]) -> Verdict:
            count = len(given.symbols)
            read = self.coder.read(given.model, bits.followed_by(given.tail), count)
            if isinstance(read, Rejected):
                return Fails("a reading", read.line(), WHOLE)
            got = (read.value.symbols, read.value.length, read.value.canonical)
            return every(
                same(0, bits.length % 8),
                same(Accepted(given.symbols), self.coder.decode(given.model, bits, count)),
                same((given.symbols, bits.length, True), got),
            )

        return self.coded(Message(given.model, given.symbols), judge)

    def rejects_as_models_do(self, given: Message) -> Verdict:
        """Clause: ARITH-BYTES-1."""
        got, found = (
            self.coder.encode(given.model, given.symbols),
            slots(given.model, given.symbols),
        )
        if isinstance(found, Rejected):
            return same(found, got)
        return same(True, isinstance(got, Accepted))

    def kraft(self, given: Small) -> Verdict:
        """Clause: ARITH-BYTES-3."""
        codes: list[str] = []
        for symbols in all_messages(given):
            bits = self.coder.encode(given.model, symbols)
            if isinstance(bits, Rejected):
                return Fails("bits", bits.line(), WHOLE)
            codes.append(bits.value.digits())
        codes.sort()
        clash = any(b.startswith(a) for a, b in pairwise(codes))
        total = sum((Fraction(1, 2 ** len(code)) for code in codes), Fraction(0))
        return same((True, False), (total <= 1, clash))

    def length(self, given: Message) -> Verdict:
        """Clauses: ARITH-BYTES-4, ARITH-BYTES-5."""
        return self.coded(given, lambda bits, found: same(True, self.bound(bits.length, found)))

    def reads_anything(self, given: Attempt) -> Verdict:
        """Clauses: ARITH-BYTES-1, ARITH-RANS-5: any bits read, zeros following them."""
        read = self.coder.read(given.model, given.bits, given.count)
        if isinstance(read, Rejected):
            again = self.coder.decode(given.model, given.bits, given.count)
            head = int(given.bits.digits()[:8] or "0", 2)
            allowed = head == 0 or given.bits.length < 56
            return every(same(read, again), same(True, allowed))
        found = slots(given.model, read.value.symbols)
        if isinstance(found, Rejected):
            return Fails("symbols of the model", found.line(), WHOLE)
        last = along(given.model, read.value.symbols)[-1]
        zeros = given.bits.followed_by(pack(bytes(40)))
        return every(
            same(True, len(found.value) == max(given.count, 0) or has_ended(last)),
            same(read, self.coder.read(given.model, zeros, given.count)),
        )

    def strict(self, given: Attempt) -> Verdict:
        """Clause: ARITH-BYTES-2."""
        read = self.coder.read(given.model, given.bits, given.count)
        got = self.coder.decode(given.model, given.bits, given.count)
        if isinstance(read, Rejected):
            return same(read, got)
        symbols, length = read.value.symbols, read.value.length
        again = self.coder.encode(given.model, symbols)
        if isinstance(again, Rejected):
            return Fails("bits", again.line(), WHOLE)
        if again.value == given.bits:
            return same(Accepted(symbols), got)
        if isinstance(got, Accepted):
            return Fails(f"rejected, the bits are {again.value.digits()}", repr(got), WHOLE)
        if length < given.bits.length:
            return same((Reason.TRAILING_BITS, WHOLE), (got.reason, got.where))
        if length == given.bits.length:
            return same((Reason.NOT_CANONICAL, WHOLE), (got.reason, got.where))
        first = 0
        while first < len(symbols) and self.fits(given, first + 1):
            first += 1
        return same((Reason.TRUNCATED_BITS, AtSymbol(first)), (got.reason, got.where))

    def fits(self, given: Attempt, count: int) -> bool:
        """What is read for the first symbols is no longer than the bits."""
        read = self.coder.read(given.model, given.bits, count)
        return isinstance(read, Accepted) and read.value.length <= given.bits.length


def laws_of(name: str, coder: Coder, clause: Clause, bound: Bound) -> tuple[AnyLaw, ...]:
    """The laws of a coder in bytes, each called after the coder; `clause` states the bound."""
    of = _Of(coder, bound)
    return (
        Law(
            f"{name}-round-trip",
            Clause.ARITH_BYTES_3,
            "the bytes of a message, with any bits after them or none, decode to it",
            JOINED,
            of.round_trip,
        ),
        Law(
            f"{name}-rejects-as-models-do",
            Clause.ARITH_BYTES_1,
            "a message is rejected exactly if the model does, and alike",
            ANY_MESSAGE,
            of.rejects_as_models_do,
        ),
        Law(
            f"{name}-is-free-of-prefixes",
            Clause.ARITH_BYTES_3,
            "no code of n symbols begins another, and the 2^-L sum to 1 at most",
            SMALL,
            of.kraft,
        ),
        Law(
            f"{name}-length-is-near-the-content",
            clause,
            "the length is within the stated bounds, as inequalities of fractions",
            MESSAGE,
            of.length,
        ),
        Law(
            f"{name}-reads-anything",
            Clause.ARITH_BYTES_1,
            "any bits read as symbols of the model, zeros following them, or have no first state",
            ATTEMPT,
            of.reads_anything,
        ),
        Law(
            f"{name}-accepts-one-code-each",
            Clause.ARITH_BYTES_2,
            "bits are accepted exactly if encoding what they read as gives them again",
            ATTEMPT,
            of.strict,
        ),
    )


def range_bound(length: int, found: tuple[Slot, ...]) -> bool:
    """ARITH-BYTES-4, both sides."""
    chance, less, more = Fraction(1), Fraction(1), Fraction(1)
    for slot in found:
        chance *= Fraction(slot.frequency, slot.total)
        less *= 1 - Fraction(slot.total - 1, 2**48)
        if slot.upto == slot.total:
            more *= 1 + Fraction(slot.below * (slot.total - 1), slot.frequency * 2**48)
    whole = (1 << length) * chance
    return whole * less <= 2**16 and whole * more > 2**8


def rans_bound(length: int, found: tuple[Slot, ...]) -> bool:
    """ARITH-BYTES-5, both sides."""
    chance, less, more = Fraction(1), Fraction(1), Fraction(1)
    for slot in found:
        chance *= Fraction(slot.frequency, slot.total)
        loss = Fraction(slot.total - 1, 2**30 * slot.frequency)
        less, more = less * (1 - loss), more * (1 + loss)
    up, down = Fraction(2**18 + 1, 2**18) ** len(found), Fraction(2**18 - 1, 2**18) ** len(found)
    whole = (1 << length) * chance
    return whole * less <= 2**56 * up and whole * more * up / down > 2**48


LAWS_OF_BYTEWISE: Final[tuple[AnyLaw, ...]] = (
    *laws_of("range-coder", RANGE_CODER, Clause.ARITH_BYTES_4, range_bound),
    *laws_of("rans", RANS, Clause.ARITH_BYTES_5, rans_bound),
)
