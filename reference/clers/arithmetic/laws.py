"""The laws of chapter 2; those of a coder take it as an argument."""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Final

from clers.arithmetic import exact
from clers.arithmetic.bits import Bits, pack
from clers.arithmetic.coder import REFERENCE, Coder
from clers.arithmetic.exact import number_of
from clers.arithmetic.given import ATTEMPT, JOINED, Attempt, Joined
from clers.arithmetic.laws_automaton import LAWS_OF_AUTOMATA
from clers.arithmetic.laws_byte_steps import LAWS_OF_BYTE_STEPS
from clers.arithmetic.laws_bytewise import LAWS_OF_BYTEWISE
from clers.arithmetic.laws_exact import LAWS_OF_EXACT
from clers.arithmetic.laws_steps import LAWS_OF_STEPS
from clers.arithmetic.steps import ending, places
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import WHOLE, AtSymbol
from clers.information.given import ANY_MESSAGE, MESSAGE, SMALL, Message, Small
from clers.information.laws_measure import all_messages, along
from clers.information.model import Slot, has_ended, slots

Q: Final = 2**30


@dataclass(frozen=True, slots=True)
class _Of:
    """The laws of one coder, as functions of an example."""

    coder: Coder

    def coded(self, given: Message, judge: Callable[[Bits, tuple[Slot, ...]], Verdict]) -> Verdict:
        """Judge the bits of an allowed message."""
        bits, found = (
            self.coder.encode(given.model, given.symbols),
            slots(given.model, given.symbols),
        )
        if isinstance(bits, Rejected) or isinstance(found, Rejected):
            return Fails("bits", f"{bits}, {found}", WHOLE)
        return judge(bits.value, found.value)

    def round_trip(self, given: Message) -> Verdict:
        """Clauses: ARITH-ENCODE-1, ARITH-DECODE-2."""
        count = len(given.symbols)
        return self.coded(
            given,
            lambda bits, _: same(
                Accepted(given.symbols), self.coder.decode(given.model, bits, count)
            ),
        )

    def followed_by_anything(self, given: Joined) -> Verdict:
        """Clauses: ARITH-END-2, ARITH-DECODE-4."""

        def judge(bits: Bits, _: tuple[Slot, ...]) -> Verdict:
            read = self.coder.read(given.model, bits.followed_by(given.tail), len(given.symbols))
            if isinstance(read, Rejected):
                return Fails("a reading", read.line(), WHOLE)
            got = (read.value.symbols, read.value.length, read.value.canonical)
            return same((given.symbols, bits.length, True), got)

        return self.coded(Message(given.model, given.symbols), judge)

    def carried_sum(self, given: Message) -> Verdict:
        """Clauses: ARITH-CARRY-1, ARITH-SHIFT-2, ARITH-END-1."""

        def judge(bits: Bits, found: tuple[Slot, ...]) -> Verdict:
            last = places(found)[-1]
            return every(
                same(last.shifts + 2, bits.length),
                same(ending(last).digits(), bits.digits()),
            )

        return self.coded(given, judge)

    def rejects_as_models_do(self, given: Message) -> Verdict:
        """Clauses: ARITH-ENCODE-1, INFO-MODEL-5, INFO-MODEL-6."""
        got, found = (
            self.coder.encode(given.model, given.symbols),
            slots(given.model, given.symbols),
        )
        other = exact.encode(given.model, given.symbols)
        if isinstance(found, Rejected):
            return every(same(found, got), same(found, other))
        return same((True, True), (isinstance(got, Accepted), isinstance(other, Accepted)))

    def length_above(self, given: Message) -> Verdict:
        """Clause: ARITH-LENGTH-1."""

        def judge(bits: Bits, found: tuple[Slot, ...]) -> Verdict:
            worst = Fraction(1)
            for slot in found:
                loss = Fraction(slot.total - 1, (Q + 2) * slot.frequency)
                worst *= Fraction(slot.frequency, slot.total) * (1 - loss)
            return same(True, Fraction(2**bits.length, 4) * worst <= 1)

        return self.coded(given, judge)

    def length_below(self, given: Message) -> Verdict:
        """Clause: ARITH-LENGTH-2."""

        def judge(bits: Bits, found: tuple[Slot, ...]) -> Verdict:
            best = Fraction(1)
            for slot in found:
                gain = Fraction(slot.total - 1, (Q + 2) * slot.frequency)
                best *= Fraction(slot.frequency, slot.total) * (1 + gain)
            return same(True, 2**bits.length * best > 1)

        return self.coded(given, judge)

    def kraft(self, given: Small) -> Verdict:
        """Clauses: ARITH-LENGTH-3, ARITH-END-2."""
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

    def reads_anything(self, given: Attempt) -> Verdict:
        """Clauses: ARITH-DECODE-1, ARITH-DECODE-2, ARITH-DECODE-3."""
        read = self.coder.read(given.model, given.bits, given.count)
        zeros = given.bits.followed_by(pack(bytes(40)))
        if isinstance(read, Rejected):
            return Fails("a reading", read.line(), WHOLE)
        found = slots(given.model, read.value.symbols)
        if isinstance(found, Rejected):
            return Fails("symbols of the model", found.line(), WHOLE)
        last = along(given.model, read.value.symbols)[-1]
        stopped = len(found.value) == max(given.count, 0) or has_ended(last)
        number = number_of(given.bits)
        inside = []
        for place in places(found.value):
            value = int(number * 2 ** (32 + place.shifts)) - place.base
            inside.append(place.state.low <= value <= place.state.high)
        return every(
            same((True, True), (stopped, all(inside))),
            same(read, self.coder.read(given.model, zeros, given.count)),
        )

    def strict(self, given: Attempt) -> Verdict:
        """Clauses: ARITH-STRICT-1, ARITH-STRICT-2, ARITH-STRICT-3, ARITH-STRICT-4."""
        read = self.coder.read(given.model, given.bits, given.count)
        got = self.coder.decode(given.model, given.bits, given.count)
        if isinstance(read, Rejected):
            return same(read, got)
        symbols = read.value.symbols
        again = self.coder.encode(given.model, symbols)
        if isinstance(again, Rejected):
            return Fails("bits", again.line(), WHOLE)
        if again.value == given.bits:
            return same(Accepted(symbols), got)
        if isinstance(got, Accepted):
            return Fails(f"rejected, the bits are {again.value.digits()}", repr(got), WHOLE)
        if again.value.length < given.bits.length:
            return same((Reason.TRAILING_BITS, WHOLE), (got.reason, got.where))
        if again.value.length == given.bits.length:
            return same((Reason.NOT_CANONICAL, WHOLE), (got.reason, got.where))
        first = 0
        while first < len(symbols) and self.fits(given, first + 1):
            first += 1
        return same((Reason.TRUNCATED_BITS, AtSymbol(first)), (got.reason, got.where))

    def fits(self, given: Attempt, count: int) -> bool:
        """The code of the first symbols that the bits decode to is no longer than the bits."""
        read = self.coder.read(given.model, given.bits, count)
        return isinstance(read, Accepted) and read.value.length <= given.bits.length


def laws_of(coder: Coder) -> tuple[AnyLaw, ...]:
    """The laws of a 32-bit coder."""
    of = _Of(coder)
    return (
        Law(
            "coder-round-trip",
            Clause.ARITH_ENCODE_1,
            "the bits of a message decode to the message",
            MESSAGE,
            of.round_trip,
        ),
        Law(
            "coder-followed-by-anything",
            Clause.ARITH_END_2,
            "with any bits after them they read as the same symbols, and their length is seen",
            JOINED,
            of.followed_by_anything,
        ),
        Law(
            "coder-bits-are-the-carried-sum",
            Clause.ARITH_CARRY_1,
            "pending bits print the digits of one long number, shifts + 2 of them",
            MESSAGE,
            of.carried_sum,
        ),
        Law(
            "coder-rejects-as-models-do",
            Clause.ARITH_ENCODE_1,
            "exact and 32-bit encoder reject a message exactly if the model does, and alike",
            ANY_MESSAGE,
            of.rejects_as_models_do,
        ),
        Law(
            "coder-length-bounded-above",
            Clause.ARITH_LENGTH_1,
            "L ≤ I + 2 - Σ log2(1 - ε), as an inequality of fractions",
            MESSAGE,
            of.length_above,
        ),
        Law(
            "coder-length-bounded-below",
            Clause.ARITH_LENGTH_2,
            "L > I - Σ log2(1 + ε), as an inequality of fractions",
            MESSAGE,
            of.length_below,
        ),
        Law(
            "coder-is-free-of-prefixes",
            Clause.ARITH_LENGTH_3,
            "no code of n symbols begins another, and the 2^-L sum to 1 at most",
            SMALL,
            of.kraft,
        ),
        Law(
            "coder-reads-anything",
            Clause.ARITH_DECODE_3,
            "any bits read as symbols whose interval holds them, zeros following the bits",
            ATTEMPT,
            of.reads_anything,
        ),
        Law(
            "coder-accepts-one-code-each",
            Clause.ARITH_STRICT_1,
            "bits are accepted exactly if encoding what they read as gives them again",
            ATTEMPT,
            of.strict,
        ),
    )


LAWS: Final[tuple[AnyLaw, ...]] = (
    *LAWS_OF_EXACT,
    *LAWS_OF_STEPS,
    *laws_of(REFERENCE),
    *LAWS_OF_AUTOMATA,
    *LAWS_OF_BYTE_STEPS,
    *LAWS_OF_BYTEWISE,
)
