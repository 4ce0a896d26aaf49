"""What has to come back as it went: objects of every kind that JSON has. Clause: ORCL-OP-1."""

from collections.abc import Iterator, Mapping
from typing import Final

from clers.conformance import messages as message
from clers.conventions.clause import Clause
from clers.oracle.positives.asked import Asked

SAID: Final[Mapping[str, dict[str, object]]] = {
    "nothing": {},
    "one-key": {"a": 1},
    "empty-key": {"": ""},
    "literals": {"yes": True, "no": False, "none": None},
    "nested": {"a": [[], {}, [[{"b": [1, [2, [3]]]}]]]},
    "deep": {"a": [[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]},
    "letters": {"ä": "ß", "жук": "甲虫", "🦀": "𝕊²"},
    "escapes": {"quotes": '"\\/', "lines": "a\nb\r\tc", "controls": "\u0000\u0001\u001f\u007f"},
    "separators": {"lines": "\u2028\u2029", "space": "\u00a0", "joiner": "a\u200db"},
    "largest-safe-integers": {"most": 1 << 53, "least": -(1 << 53), "zero": 0},
    "long-integers": {"googol": str(10**100), "less": str(-(10**30)), "edge": str((1 << 53) + 1)},
    "fractions": {"tenth": 0.1, "third": 1 / 3, "tiny": 5e-324, "huge": 1.7976931348623157e308},
    "many": {"numbers": list(range(-300, 300))},
    "long-text": {"text": "CLERS" * 2000},
    "like-a-reply": {"id": 3, "ok": {"op": "bye"}, "reject": {"class": "limit"}, "ev": {}},
}
"""Objects by what is in them."""


def echoes() -> Iterator[Asked]:
    """Each of them to be said again."""
    for word, said in SAID.items():
        yield Asked(
            word, "echo", message.Echo(id=0, input=said),
            (Clause.ORCL_OP_1, Clause.ORCL_LINE_1, Clause.ORCL_VALUE_1), "hand",
        )  # fmt: skip
