"""The context code: the page's worked example, its tables, faults planted, enemies' bits."""

from dataclasses import replace
from math import exp, floor
from random import Random

import pytest
from librt.vecs import vec
from mypy_extensions import i64

from clers.arithmetic import coder
from clers.arithmetic.bits import Bits, pack
from clers.codes import context, context_definition, logistic
from clers.codes.closings import Closing, closings
from clers.codes.code import Shape
from clers.codes.context import DECISIONS, ORDER, foretelling, most_symbols
from clers.codes.context_definition import Told, Undone
from clers.codes.laws_context import LAWS
from clers.codes.registry import CodeName, decode, encode
from clers.complexes.corner_table import surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds
from clers.conventions.where import AtSymbol
from clers.edgebreaker.encode import encode as encode_surface
from clers.edgebreaker.examples import ANNULUS, CUBE, TETRAHEDRON, TORUS, TRIANGLE
from clers.edgebreaker.stream import Kind, Side, Stream
from clers.generate.irregular import irregular_sphere

CLOSED = Shape("C")


def decisions(undone: str) -> list[int]:
    """Those of symbols in the order in which they are undone."""
    return [bit for symbol in undone for bit in DECISIONS[symbol]]


def bits_of(symbols: str, shape: Shape) -> Bits:
    found = context.encode(symbols, shape)
    assert isinstance(found, Accepted), found
    return found.value


def test_the_curve_is_the_logistic_function() -> None:
    """CODE-CONTEXT-6: the numbers nearest to it, and the probabilities of some logits by hand."""
    curve = [65536 / (1 + exp(-(i - 16) / 2)) for i in range(33)]
    assert tuple(floor(y + 0.5) for y in curve) == logistic.CURVE
    by_hand = {0: 32768, 104: 39288, 416: 54617, -2047: 22, 2047: 65514, 128: 40793}
    for squash in (logistic.squash, context_definition.squash):
        assert {t: squash(t) for t in by_hand} == by_hand
    assert [logistic.SQUASH[t + 2047] for t in by_hand] == list(by_hand.values())


def test_logits_undo_probabilities() -> None:
    """CODE-CONTEXT-6: the least logit that is enough, for all probabilities, in both readings."""
    for v in range(4096):
        t = logistic.STRETCH[v]
        assert t == context_definition.stretch(16 * v)
        assert logistic.squash(t) // 16 >= v or t == 2047
        assert t == -2047 or logistic.squash(t - 1) // 16 < v
    assert (logistic.STRETCH[2048], logistic.STRETCH[54612 >> 4]) == (0, 416)
    assert (logistic.STRETCH[0], logistic.STRETCH[4095]) == (-2047, 2047)


def test_rates() -> None:
    """CODE-CONTEXT-5: 131072 / (2k + 3), rounded down."""
    assert logistic.RATE[:3] == (43690, 26214, 18724)
    assert (len(logistic.RATE), logistic.RATE[255]) == (256, 255)


def foretold(undone: str) -> list[int]:
    """The probabilities of all decisions of these symbols, and of the first one after them."""
    by = foretelling(CLOSED)
    found: list[int] = []
    for symbol in undone + "C":
        if by.loops.height:
            by.look()
        for decision, yes in enumerate(DECISIONS[symbol]):
            sure = by.certain(decision)
            found.append(by.probability(decision) if sure < 0 else sure)
            if sure < 0:
                by.learn(decision, bool(yes), found[-1])
        by.undo(ORDER.index(symbol))
    return found


def test_the_cube_by_hand() -> None:
    """CODE-CONTEXT-1 … CODE-CONTEXT-7: the probabilities of the page's worked example."""
    assert foretold("ERRCR") == [0, 0, 0, 65536, 0, *[32768] * 6, 39288]
    # no: the slot and the weight of the page; then R and C, and the same slot 32767 says 0.
    model: object = Told(10, Undone(()))
    for bit in [*decisions("ERRCR"), 0]:
        assert isinstance(model, Told)
        model = model.after(bit)
    assert isinstance(model, Told)
    assert model.slots[(0, (3, 1, 5), 0)] == (32767, 2)
    # Used once: no takes 32768 · 43690 / 65536 away, yes adds ⌊32767 · 43690 / 65536⌋.
    assert {p for p, k in model.slots.values() if k == 1} == {10923, 54612}
    assert model.weights[0] == (15885, 16384, 16384, 16384, 16384)


@pytest.mark.parametrize("example", [TETRAHEDRON, CUBE, TORUS, ANNULUS, TRIANGLE])
def test_both_readings_of_the_examples(example: object) -> None:
    """CODE-CONTEXT-2 … CODE-CONTEXT-7."""
    assert LAWS[0].check(example) == Holds()


def test_more_contexts_than_there_is_room_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """CODE-CONTEXT-4, CODE-CONTEXT-5: those of twelve symbols keep their slots as they get more.

    Where no symbols are expected, there is room for fewer than these are.
    """
    monkeypatch.setattr(context, "EXPECTED", 0)
    made = surface(irregular_sphere(1200, 1))
    assert isinstance(made, Accepted)
    assert LAWS[0].check(made.value) == Holds()


def test_the_law_can_fail(monkeypatch: pytest.MonkeyPatch) -> None:
    """CODE-CONTEXT-2: tables that are one place off are found on the torus."""
    for table in ("_RATE", "_SQUASH", "_STRETCH"):
        with monkeypatch.context() as planted:
            entries = list(getattr(context, table))
            planted.setattr(context, table, vec[i64]([*entries[1:], entries[-1]]))
            assert isinstance(LAWS[0].check(TORUS), Fails), table


@pytest.mark.parametrize(
    ("symbols", "index"),
    [
        ("R", 0),  # no gate: only E
        ("CE", 0),  # a loop of three edges
        ("SE", 0),  # no gate below
        ("CRSE", 2),
        ("CCRRE", 0),  # a loop of five, then four, then three
        ("CRXE", 2),
    ],
)
def test_symbols_that_no_loop_allows(symbols: str, index: int) -> None:
    """CODE-CONTEXT-1, CODE-CONTEXT-3: the symbol is blamed, counted in the coded part."""
    symbols = symbols.replace("CCRRE", "CCCRRE")
    refused = context.encode(symbols, Shape())
    assert isinstance(refused, Rejected)
    assert (refused.reason, refused.where) == (Reason.NOT_IN_ALPHABET, AtSymbol(index))
    named = Clause.CODE_CONTEXT_1 if "X" in symbols else Clause.CODE_CONTEXT_3
    assert refused.clause is named


H = Kind.HANDLE


@pytest.mark.parametrize(
    ("symbols", "closing", "allowed"),
    [
        # E alone: gate 0, right 1, left 2. Its neighbours cannot be closed.
        ("SE", Closing(0, H, Side.RIGHT, 0), False),
        ("SE", Closing(0, H, Side.LEFT, 0), False),
        # E, R: the right edge of E is two after the gate, its left edge just before.
        ("SRE", Closing(0, H, Side.RIGHT, 1), True),
        ("SRE", Closing(0, H, Side.RIGHT, 0), False),
        ("SRE", Closing(0, H, Side.LEFT, 0), False),
        ("SRE", Closing(0, H, Side.RIGHT, 2), False),  # there are two right edges
        ("SRRE", Closing(0, H, Side.LEFT, 0), False),
        ("SRRE", Closing(0, H, Side.RIGHT, 1), True),
        # two E: an edge of the other loop
        ("SEE", Closing(0, H, Side.RIGHT, 1), True),
        # E, R, R, C: C glues the left edge of E, which is in no loop any more
        ("SCRRE", Closing(0, H, Side.LEFT, 0), False),
    ],
)
def test_where_a_recorded_s_can_be(symbols: str, closing: Closing, allowed: bool) -> None:
    """CODE-CONTEXT-3: the closing edge is in a loop, and leaves something of it."""
    found = context.encode(symbols, Shape("", (closing,)))
    assert isinstance(found, Accepted) == allowed
    told = coder.encode(
        Told(len(symbols), Undone((closing,))), decisions("".join(reversed(symbols)))
    )
    assert isinstance(told, Accepted) == allowed
    if isinstance(found, Accepted):
        assert told == found
        assert context.decode(found.value, len(symbols), Shape("", (closing,))) == Accepted(symbols)


def test_bits_of_enemies_are_words_or_rejected() -> None:
    """CODE-CONTEXT-3, CODE-CONTEXT-8: any bits, any closings; what is read is written the same."""
    random = Random(6)
    words = 0
    for _ in range(400):
        bits = pack(random.randrange(2) for _ in range(random.randrange(2, 60)))
        seen = tuple(
            Closing(
                random.randrange(3),
                random.choice(tuple(Kind)),
                random.choice(tuple(Side)),
                random.randrange(6),
            )
            for _ in range(random.randrange(5))
        )
        shape = Shape("C", seen)
        # The number of symbols for which these bits are right, if there is one.
        for count in range(40):
            found = context.decode(bits, count, shape)
            if isinstance(found, Accepted):
                words += 1
                assert len(found.value) == count
                assert context.encode(found.value, shape) == Accepted(bits)
                told = coder.encode(Told(count, Undone(seen)), decisions(found.value[::-1]))
                assert told == Accepted(bits)
    assert words > 50


def test_truncated_and_trailing_bits() -> None:
    """CODE-CONTEXT-8, ARITH-STRICT-2, ARITH-STRICT-3."""
    stream = encode_surface(CUBE).stream
    bits = bits_of(stream.word[1:], CLOSED)
    fewer = context.decode(pack(bits.values()[:-1]), 10, CLOSED)
    more = context.decode(bits.followed_by(pack([0])), 10, CLOSED)
    assert isinstance(fewer, Rejected)
    assert fewer.reason in (Reason.TRUNCATED_BITS, Reason.NOT_CANONICAL)
    assert isinstance(more, Rejected)
    assert more.reason is Reason.TRAILING_BITS


def test_the_records_are_used() -> None:
    """CODE-CONTEXT-3: the torus is decoded with its closings, and not without."""
    stream = encode_surface(TORUS).stream
    seen = closings(stream)
    assert isinstance(seen, Accepted)
    bits = encode(CodeName.CONTEXT, stream)
    assert isinstance(bits, Accepted)
    assert decode(CodeName.CONTEXT, bits.value, 17, 0, seen.value) == Accepted(stream.word)
    assert decode(CodeName.CONTEXT, bits.value, 17, 0) != Accepted(stream.word)
    assert encode(CodeName.CONTEXT, replace(stream, records=())) != bits


def test_a_run_costs_no_less_than_a_reader_believes() -> None:
    """CODE-NAME-3, CODE-CONTEXT-8: a strip that turns one way, the cheapest symbols of all."""
    word = "R" * 20000 + "E"
    bits = encode(CodeName.CONTEXT, Stream(word, (), 1))
    assert isinstance(bits, Accepted)
    assert bits.value.length < 300
    assert len(word) <= most_symbols(bits.value.length) == 2070 * bits.value.length + 2
