"""The laws of chapter 9, and that each of them can fail."""

from collections.abc import Callable

import pytest

from clers.conformance.laws import LAWS, Wanted
from clers.conformance.lines import NoMessage
from clers.conformance.messages import (
    ErrorReply,
    EventReply,
    Failure,
    Lacking,
    Step,
    UnsupportedReply,
)
from clers.conformance.samples import SAMPLES
from clers.conventions.law import AnyLaw
from clers.conventions.verdict import Fails, Holds
from laws import run


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_law(law: AnyLaw) -> None:
    """Clauses: ORCL-LINE-1, ORCL-LINE-3, ORCL-REPLY-1, ORCL-REPLY-4, ORCL-VALUE-1."""
    run(law)


EVENT = EventReply(0, Step(0, "C"))
END = UnsupportedReply(0, Lacking("x"))
SAMPLE = Wanted(SAMPLES["word.decode"])
SILENT = Wanted(SAMPLES["surface.classify"])
NUMBER = 1 << 53
LAW = {law.name: law for law in LAWS}


@pytest.mark.parametrize(
    ("law", "example", "part", "fault"),
    [
        ("requests-come-back-from-lines", SAMPLE, "request_in", lambda _: NoMessage("")),
        ("requests-come-back-from-lines", SAMPLE, "line_of", lambda _: b"\n\n"),
        ("one-terminal-reply", SAMPLE, "serve", lambda _: (END, EVENT)),
        ("one-terminal-reply", SAMPLE, "serve", lambda _: (END, END)),
        ("one-terminal-reply", SAMPLE, "serve", lambda _: (UnsupportedReply(1, Lacking("x")),)),
        ("one-terminal-reply", SILENT, "serve", lambda _: (EVENT, END)),
        ("replies-are-read-by-the-oracle", SAMPLE, "reply_in", lambda _: NoMessage("")),
        ("replies-are-read-by-the-oracle", SAMPLE, "result_in", lambda _, __: NoMessage("")),
        ("every-line-is-answered", b"x", "answered", lambda _: (END, END)),
        ("every-line-is-answered", b"x", "answered", lambda _: (EVENT,)),
        (
            "every-line-is-answered",
            b'{"op":"echo","id":7,"in":{}}',
            "answered",
            lambda _: (ErrorReply(None, Failure("")),),
        ),
        ("integers-come-back-from-messages", NUMBER, "to_wire", str),
        ("integers-come-back-from-messages", NUMBER, "from_wire", lambda _: 0),
    ],
)
def test_a_law_can_fail(
    law: str,
    example: object,
    part: str,
    fault: Callable[[object], object],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """CONV-LAW-4: each law, with one thing it looks at exchanged."""
    assert LAW[law].check(example) == Holds()
    monkeypatch.setattr(f"clers.conformance.laws.{part}", fault)
    assert isinstance(LAW[law].check(example), Fails)
