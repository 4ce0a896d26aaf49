"""Hypothesis profiles: `ci` is derandomised; `campaign` (CLERS_PROFILE=campaign) is long.

Tests marked `interpreted` see into the kernels, which machine code does not let them. Where the
kernels are compiled, such tests run in another process, in which they are not.
"""

import gc
import os

import pytest
from hypothesis import HealthCheck, settings

from clers.kernels import COMPILED
from elsewhere import outcome_of

settings.register_profile(
    "ci",
    derandomize=True,
    deadline=None,
    database=None,
    max_examples=30,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
settings.register_profile(
    "campaign", parent=settings.get_profile("ci"), derandomize=False, max_examples=5000
)
settings.load_profile(os.environ.get("CLERS_PROFILE", "ci"))


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "interpreted: runs where the kernels are interpreted")


def pytest_collection() -> None:
    """What is made while tests are collected stays: to look for garbage in it is lost time."""
    gc.disable()


def pytest_collection_finish() -> None:
    """All that is there now stays: what collects garbage, as timing does, need not look at it."""
    gc.freeze()
    gc.enable()


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> bool | None:
    """Take the outcome of a marked test from the process that it ran in."""
    if not COMPILED or pyfuncitem.get_closest_marker("interpreted") is None:
        return None
    said = outcome_of(pyfuncitem.path, pyfuncitem.name)
    if said:
        pytest.fail(said, pytrace=False)
    return True
