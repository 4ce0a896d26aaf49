"""Mixing probabilities by their logits, in integers: tables, and one step of learning.

A logit is a number of 1/256 nats from -2047 to 2047; a probability is a number of 65536ths.
"""

from typing import Final

from clers.kernels.foretelling import LAST, OFTEN, UNIT

# fmt: off
CURVE: Final = (
    22, 36, 60, 98, 162, 267, 439, 720, 1179, 1921, 3108, 4971, 7812, 11955, 17625, 24743, 32768,
    40793, 47911, 53581, 57724, 60565, 62428, 63615, 64357, 64816, 65097, 65269, 65374, 65438,
    65476, 65500, 65514,
)
# fmt: on
"""The logistic curve at the logits -2048, -1920, …, 2048. Clause: CODE-CONTEXT-6."""


def squash(logit: int) -> int:
    """The probability of a logit, straight between the points of the curve. CODE-CONTEXT-6."""
    place = logit + 2048
    i, w = place >> 7, place & 127
    return (CURVE[i] * (128 - w) + CURVE[i + 1] * w + 64) >> 7


SQUASH: Final = tuple(map(squash, range(-LAST, LAST + 1)))
"""The probability of the logit -2047 and of those after it. Clause: CODE-CONTEXT-6."""


def _stretched() -> tuple[int, ...]:
    """For each v the least logit whose probability is 16·v or more, or the greatest logit."""
    highest = [p >> 4 for p in SQUASH]
    found: list[int] = []
    for logit, most in enumerate(highest, -LAST):
        found += [logit] * (most + 1 - len(found))
    return tuple(found + [LAST] * (4096 - len(found)))


STRETCH: Final = _stretched()
"""The logit of a probability p is the entry p >> 4 of 4096. Clause: CODE-CONTEXT-6."""

RATE: Final = tuple(2 * UNIT // (2 * k + 3) for k in range(OFTEN + 1))
"""What a slot that was met k times learns, in 65536ths. Clause: CODE-CONTEXT-5."""
