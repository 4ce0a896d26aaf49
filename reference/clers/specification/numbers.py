"""The rule on numbers: a printed number with a name is that value rounded. Clause: CONV-PROSE-3."""

import re
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from typing import Final

from clers.specification.finding import Finding
from clers.specification.markdown import comments
from clers.specification.repository import Repository

Value = int | float | Fraction
Values = Mapping[str, Callable[[], Value]]

_NAMED: Final = re.compile(r"<!--=\s*(.*?)\s*-->", re.DOTALL)
_PRINTED: Final = re.compile(r"(?<![\w.,])([-−]?\d+(?:\.\d+|/\d+)?)[$*_`\s]*$")


def _printed(text: str) -> tuple[Fraction, Fraction]:
    """A printed number, and half a unit of its last digit (0 for whole fractions `a/b`)."""
    digits = text.replace("−", "-")
    places = len(digits.partition(".")[2])
    ulp = Fraction(0) if "/" in digits else Fraction(1, 2 * 10**places)
    return Fraction(digits), ulp


def agrees(printed: str, value: Value) -> bool:
    """Whether the value, rounded to the digits printed, is the number printed.

    A tie may be rounded either way. A number printed as `a/b` must agree exactly.
    """
    number, half = _printed(printed)
    return abs(Fraction(value) - number) <= half


def as_computed(values: Values) -> Callable[[Repository], Iterator[Finding]]:
    """The rule, for a registry of values: every named number of the pages is the value."""

    def rule(of: Repository) -> Iterator[Finding]:
        for page in of.pages:
            for comment in comments(page):
                named = _NAMED.search(comment.content)
                if named is None:
                    continue
                fault = _fault(values, named[1], comment.before)
                if fault:
                    yield Finding("number", page.path, comment.line, "", fault)

    return rule


def _fault(values: Values, name: str, before: str) -> str | None:
    printed = _PRINTED.search(before)
    if name not in values:
        return f"no value is named {name!r}"
    if printed is None:
        return f"no number stands before the name {name}"
    value = values[name]()
    if agrees(printed[1], value):
        return None
    return f"{name} is {value}, printed {printed[1]}"
