"""The best code: selectors by hand, codes that are chosen, other selectors refused."""

import pytest

from clers.arithmetic.bits import Bits, pack
from clers.codes import best
from clers.codes.code import Shape
from clers.codes.laws_best import LAWS
from clers.codes.registry import CODES, CodeName, decode, encode, most_symbols
from clers.complexes.corner_table import surface
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds
from clers.conventions.where import WHOLE
from clers.edgebreaker.encode import encode as encode_surface
from clers.edgebreaker.examples import ANNULUS, CUBE, TETRAHEDRON, TORUS
from clers.edgebreaker.stream import Stream
from clers.generate.families import grid_sphere

SELECTORS = {
    "0": "context",
    "100": "enumerative",
    "101": "golden",
    "110": "king-rossignac",
    "111": "plain",
}


def bits_of(code: CodeName, stream: Stream) -> Bits:
    found = encode(code, stream)
    assert isinstance(found, Accepted), found
    return found.value


def test_the_selectors() -> None:
    """CODE-BEST-1: each says which code follows."""
    assert [c.selector for c in best.CANDIDATES] == list(SELECTORS)
    for candidate in best.CANDIDATES:
        assert candidate.code is CODES[CodeName(SELECTORS[candidate.selector])]


def test_the_tetrahedron_by_hand() -> None:
    """CODE-BEST-1: 0 and 101 in context; the enumerative code's 01 and its selector are longer.

    Golden takes 101 and 11000, plain 111 and 101111.
    """
    assert bits_of(CodeName.BEST, encode_surface(TETRAHEDRON).stream).digits() == "0101"
    assert bits_of(CodeName.ENUMERATIVE, encode_surface(TETRAHEDRON).stream).digits() == "01"


@pytest.mark.parametrize(
    ("word", "boundary", "selector"),
    [
        # Strips of one triangle, or two that turn one way: context knows them.
        ("E", 1, "0"),
        ("RE", 1, "0"),
        ("R" * 50 + "E", 1, "0"),
        # No loop allows these; golden has no CE, and plain takes all.
        ("CCE", 0, "111"),
        ("CRSE", 0, "101"),
    ],
)
def test_which_code_is_the_shortest(word: str, boundary: int, selector: str) -> None:
    """CODE-BEST-1."""
    stream = Stream(word, (), boundary)
    bits = bits_of(CodeName.BEST, stream)
    assert bits.digits().startswith(selector)
    rest = bits_of(CodeName(SELECTORS[selector]), stream)
    assert bits.digits() == selector + rest.digits()
    assert decode(CodeName.BEST, bits, len(word), boundary) == Accepted(word)


def test_no_other_selector_is_taken() -> None:
    """CODE-BEST-2: the same word in the other codes is not canonical."""
    for example in (TETRAHEDRON, CUBE):
        stream = encode_surface(example).stream
        chosen = bits_of(CodeName.BEST, stream)
        others = 0
        for selector, name in SELECTORS.items():
            rest = bits_of(CodeName(name), stream)
            bits = pack(map(int, selector)).followed_by(rest)
            found = decode(CodeName.BEST, bits, len(stream.word), 0)
            if bits == chosen:
                assert found == Accepted(stream.word)
                continue
            others += 1
            assert isinstance(found, Rejected)
            assert (found.reason, found.clause) == (Reason.NOT_CANONICAL, Clause.CODE_BEST_2)
        assert others == 4


def test_bits_without_a_selector() -> None:
    """CODE-BEST-2; what the code refuses is refused as it says."""
    for values in ([], [1], [1, 1]):
        refused = decode(CodeName.BEST, pack(values), 3, 0)
        assert isinstance(refused, Rejected)
        assert (refused.reason, refused.clause) == (Reason.TRUNCATED_BITS, Clause.CODE_BEST_2)
        assert refused.where == WHOLE
    refused = decode(CodeName.BEST, pack([1, 1, 1]), 3, 0)
    assert isinstance(refused, Rejected)
    assert refused.clause is Clause.CODE_PLAIN_2


def test_strangers_are_refused() -> None:
    """CODE-BEST-1: a symbol that no code has."""
    refused = encode(CodeName.BEST, Stream("CRXE"))
    assert isinstance(refused, Rejected)
    assert refused.reason is Reason.NOT_IN_ALPHABET


def test_what_a_reader_believes() -> None:
    """CODE-NAME-3: context's number after one bit; the enumerative code's where it is greater."""
    assert [most_symbols(CodeName.BEST, n) for n in (0, 1, 2, 11)] == [3, 3, 2072, 20702]


@pytest.mark.parametrize("example", [TETRAHEDRON, CUBE, TORUS, ANNULUS])
def test_the_cheap_numbers_are_not_above_the_true_ones(example: Surface) -> None:
    """CODE-BEST-1: so no run that could win is left out."""
    _judge(example)


def test_the_cheap_numbers_are_close() -> None:
    """CODE-BEST-1: within one part in a thousand and six bits, so that few runs are in vain."""
    built = surface(grid_sphere(12))
    assert isinstance(built, Accepted)
    for least, true in _judge(built.value):
        assert true - 6 - true / 1000 <= least


@pytest.mark.parametrize("word", ["C" * 20, "CR" * 10, "CS" * 10, "L" * 20, "E" * 20, "RE" * 10])
def test_nor_where_symbols_cost_least(word: str) -> None:
    """CODE-BEST-1: the numbers that are cheapest to know, of words that come near them."""
    for candidate in best.CANDIDATES[2:]:
        for shape in (Shape(""), Shape("C")):
            bits = candidate.code.encode(word, shape)
            if isinstance(bits, Accepted):
                numbers = [least(word, shape, word.count("C")) for least in candidate.least]
                assert max(numbers) <= bits.value.length


def _judge(example: Surface) -> list[tuple[int, int]]:
    stream = encode_surface(example).stream
    shape = Shape("" if stream.components_with_boundary else "C")
    symbols = stream.word[len(shape.head) :]
    found: list[tuple[int, int]] = []
    for candidate in best.CANDIDATES:
        bits = encode(CodeName(SELECTORS[candidate.selector]), stream)
        if isinstance(bits, Accepted):
            numbers = [least(symbols, shape, symbols.count("C")) for least in candidate.least]
            assert all(number <= bits.value.length for number in numbers)
            found += [(numbers[-1], bits.value.length)] if numbers else []
    return found


def test_the_laws_can_fail(monkeypatch: pytest.MonkeyPatch) -> None:
    """CODE-BEST-1, CODE-BEST-3: plain tried alone, and a bound of plain."""
    shortest, on_spheres, _ = LAWS
    assert (shortest.check(CUBE), on_spheres.check(CUBE)) == (Holds(), Holds())
    with monkeypatch.context() as planted:
        real = best.chosen
        planted.setattr(
            best,
            "chosen",
            lambda symbols, shape, known: real(symbols, shape, {"0": pack([0] * 99)}),
        )
        assert isinstance(shortest.check(TORUS), Fails)
    with monkeypatch.context() as planted:
        planted.setattr(best, "CANDIDATES", best.CANDIDATES[-1:])
        assert isinstance(on_spheres.check(_grid(8)), Fails)


def _grid(size: int) -> Surface:
    built = surface(grid_sphere(size))
    assert isinstance(built, Accepted)
    return built.value
