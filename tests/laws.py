"""How tests run laws: as many examples as the profile says, each failure with its evidence."""

from hypothesis import given

from clers.conventions.law import AnyLaw
from clers.conventions.verdict import Holds
from clers.generate.domains import strategy_for


def run(law: AnyLaw) -> None:
    """Check a law on examples of its domain."""
    strategy = strategy_for(law.domain)
    assert strategy is not None, f"no generator for {law.domain}"

    @given(strategy)
    def holds(example: object) -> None:
        verdict = law.check(example)
        assert isinstance(verdict, Holds), f"{law.name} [{law.clause}]: {verdict}"

    holds()
