"""Every law of the registry has a strategy, and a name that no law has gives none."""

import importlib
from pathlib import Path

import pytest

from clers import generate
from clers.generate.domains import DOMAINS, strategy_for
from clers.laws import ALL

NAMED = sorted({law.domain for law in ALL})


@pytest.mark.parametrize("domain", NAMED)
def test_laws_have_strategies(domain: str) -> None:
    """CONV-LAW-2."""
    assert strategy_for(domain) is DOMAINS[domain]


def test_unknown_domain() -> None:
    """CONV-LAW-2."""
    assert strategy_for("no-such-domain") is None


def test_no_name_is_given_twice() -> None:
    """CONV-LAW-2: a module would hide another's strategy without a word."""
    modules = Path(generate.__file__).parent.glob("*.py")
    names: list[str] = []
    for module in modules:
        if module.stem != "domains" and "\nDOMAINS: " in module.read_text("utf-8"):
            names += importlib.import_module(f"clers.generate.{module.stem}").DOMAINS
    assert sorted(names) == sorted(DOMAINS)
