"""What the search writes is what the repository has; the impossible factors are taken as found."""

import json
from fractions import Fraction
from pathlib import Path

import pytest

from clers.codes import minimax_search
from clers.codes.certificates import breaches, rate
from clers.codes.minimax_search import ORDERS, automaton, certificate, main, module, record

ROOT = Path(__file__).parents[2]
TABLES = "reference/clers/codes/minimax_tables.py"


def file_of(root: Path, order: int) -> Path:
    """The file of a certificate."""
    return root / f"proofs_notes/certificates/minimax-{order}.json"


FACTORS = tuple(map(str, json.loads(file_of(ROOT, 8).read_text(encoding="utf-8"))["factors"]))


def test_the_tables_are_found_again() -> None:
    """CODE-MINIMAX-2, CODE-MINIMAX-3: to the letter, for no logarithm is in them."""
    found = {order: automaton(order, FACTORS) for order in ORDERS}
    text = module({order: (contexts, of) for order, (contexts, _, of) in found.items()})
    assert text == (ROOT / TABLES).read_text(encoding="utf-8")


@pytest.mark.parametrize("order", ORDERS)
def test_the_certificates_are_found_again(order: int) -> None:
    """CODE-CERTIFICATE-4: sound, and no worse than those of the files, but for rounding."""
    _, measure, of = automaton(order, FACTORS)
    found = certificate(measure, of)
    assert list(breaches(found, of)) == []
    kept = json.loads(file_of(ROOT, order).read_text(encoding="utf-8"))
    assert abs(rate(found) - Fraction(kept["rate"])) < Fraction(1, 10**6)
    again = json.loads(record(order, FACTORS, found, of))
    assert list(again) == list(kept)
    assert (again["code"], again["factors"]) == (kept["code"], kept["factors"])
    assert Fraction(again["symbol"]) == found.symbol
    assert len(again["potential"]) == len(kept["potential"])


def test_everything_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """CODE-CERTIFICATE-4: into the places where it is read; nine symbols are asked for."""
    asked: list[int] = []

    def found(longest: int) -> tuple[str, ...]:
        asked.append(longest)
        return FACTORS

    monkeypatch.setattr(minimax_search, "impossible_factors", found)
    (tmp_path / "proofs_notes").mkdir()
    (tmp_path / TABLES).parent.mkdir(parents=True)
    main(tmp_path)
    assert asked == [9]
    assert (tmp_path / TABLES).read_text(encoding="utf-8") == (ROOT / TABLES).read_text("utf-8")
    for order in ORDERS:
        written = json.loads(file_of(tmp_path, order).read_text(encoding="utf-8"))
        assert written["code"] == f"minimax-{order}"
        assert [len(f) <= order + 1 for f in written["factors"]] == [True] * len(written["factors"])
