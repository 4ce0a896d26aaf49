"""Laws that the note on information proves, on all examples of a small size and not on some."""

from itertools import combinations_with_replacement, product

from clers.conventions.verdict import Holds
from clers.information.given_codes import Few
from clers.information.given_counting import Ranked
from clers.information.given_learning import Counted
from clers.laws import ALL

LAWS = {law.name: law for law in ALL}


def test_ranks_of_all_short_words() -> None:
    """Clauses: INFO-ENUM-1, INFO-ENUM-2, INFO-ENUM-3, INFO-ENUM-5, INFO-ENUM-6."""
    words = [
        Ranked(size, word)
        for size, most in ((2, 6), (3, 4))
        for length in range(most + 1)
        for word in product(range(size), repeat=length)
    ]
    names = (
        "ranks-count-what-is-before",
        "binary-ranks-are-sums-of-binomials",
        "rearrangements-are-near-entropy",
        "urns-give-all-words-alike",
    )
    for name in names:
        assert [word for word in words if LAWS[name].check(word) != Holds()] == []


def test_huffman_on_all_small_tables() -> None:
    """Among the best the flattest: by trying all lengths. Clauses: INFO-HUFFMAN-3, -4."""
    tables = [
        Few(row)
        for symbols, most in ((1, 4), (2, 9), (3, 8), (4, 6), (5, 5), (6, 4))
        for row in combinations_with_replacement(range(1, most + 1), symbols)
    ]
    for name in ("huffman-is-optimal", "huffman-loses-less-than-a-bit"):
        assert [table for table in tables if LAWS[name].check(table) != Holds()] == []


def test_learning_on_all_short_messages() -> None:
    """The order of symbols is no matter. Clauses: INFO-LEARN-2, INFO-LEARN-3, INFO-LEARN-4."""
    messages = [
        Counted(size, word)
        for size in range(1, 6)
        for length in range(10)
        for word in combinations_with_replacement(range(size), length)
    ]
    assert len(messages) > 1000
    for name in ("add-half-loses-little", "adding-one-counts-rearrangements"):
        assert [message for message in messages if LAWS[name].check(message) != Holds()] == []
