"""Examples of a strategy outside a test: the same seed and versions give the same ones."""

from typing import TypeVar

from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st

T = TypeVar("T")


def sample(strategy: st.SearchStrategy[T], examples: int, number: int) -> tuple[T, ...]:
    """So many examples of a strategy; `number` is the seed."""
    found: list[T] = []

    @seed(number)
    @settings(
        max_examples=examples,
        database=None,
        deadline=None,
        derandomize=False,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(strategy)
    def record(example: T) -> None:
        found.append(example)

    record()
    return tuple(found)
