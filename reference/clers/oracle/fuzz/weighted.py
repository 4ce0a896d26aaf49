"""One of several strategies, with weights."""

from typing import TypeVar

from hypothesis import strategies as st

T = TypeVar("T")


def weighted(*each: st.SearchStrategy[T]) -> st.SearchStrategy[T]:
    """One of these, each as likely as often as it stands there; the first is the simplest.

    `one_of` takes the alternatives of its alternatives, and equal ones once.
    """
    return st.sampled_from(each).flatmap(lambda chosen: chosen)
