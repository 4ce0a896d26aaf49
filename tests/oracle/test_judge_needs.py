"""What a case needs of an adapter. Clauses: ORCL-JUDGE-6, ORCL-JUDGE-8, ORCL-CASE-4."""

import msgspec
import pytest

from clers.conformance.cases.case import Case
from clers.conformance.judging.judge import judge, skipped
from clers.conformance.judging.judged import Status
from clers.conformance.judging.needs import declared, needs
from clers.conformance.messages import Caps, Introduction
from clers.conformance.outcome import Unsupported
from clers.conformance.results import RESULTS

NOTHING = Caps(handles=False, boundaries="none", components=False, max_faces=10, max_symbols=20)
POOR = Introduction(1, "poor", "0", "c", tuple(RESULTS), NOTHING)


def _case(op: str, size: int = 0, requires: tuple[str, ...] = ()) -> Case:
    return Case(
        id="a-case-aaaaaaaa", op=op, clauses=(), origin="hand", input=msgspec.Raw(b"{}"),
        size=size, requires=requires,
    )  # fmt: skip


def _with(**changes: object) -> Caps:
    return msgspec.structs.replace(NOTHING, **changes)


@pytest.mark.parametrize(
    ("name", "caps"),
    [
        ("handles", _with(handles=True)),
        ("components", _with(components=True)),
        ("boundaries.one", _with(boundaries="one")),
        ("boundaries.one", _with(boundaries="many")),
        ("boundaries.many", _with(boundaries="many")),
        ("code.king-rossignac", _with(codes=("plain", "king-rossignac"))),
        ("code.with.dots", _with(codes=("with.dots",))),
        ("coder.rans", _with(coders=("rans",))),
    ],
)
def test_a_capability_is_there_or_not(name: str, caps: Caps) -> None:
    """Clause: ORCL-CASE-4."""
    assert declared(name, caps)
    assert not declared(name, NOTHING)


def test_one_boundary_is_not_many() -> None:
    """Clause: ORCL-CASE-4."""
    assert not declared("boundaries.many", _with(boundaries="one"))


@pytest.mark.parametrize("name", ["", "wings", "boundaries", "boundaries.two", "handles.many"])
def test_what_has_no_such_name_is_never_declared(name: str) -> None:
    """Clause: ORCL-CASE-4."""
    rich = _with(handles=True, boundaries="many", components=True, codes=("",), coders=("",))
    assert not declared(name, rich)


@pytest.mark.parametrize(
    ("op", "bound", "cap"),
    [
        ("surface.classify", 10, "max_faces"),
        ("operator.apply", 10, "max_faces"),
        ("codec.roundtrip", 10, "max_faces"),
        ("word.encode", 10, "max_faces"),
        ("mesh.decode", 10, "max_faces"),
        ("arithmetic.encode", 20, "max_symbols"),
        ("code.decode", 20, "max_symbols"),
    ],
)
def test_sizes_are_borne_up_to_their_bound(op: str, bound: int, cap: str) -> None:
    """Clause: ORCL-JUDGE-8."""
    assert needs(_case(op, bound), POOR) is None
    assert needs(_case(op, bound + 1), POOR) == cap


@pytest.mark.parametrize("op", ["word.decode", "mesh.encode"])
def test_words_and_files_are_bounded_by_their_faces(op: str) -> None:
    """Clause: ORCL-JUDGE-8."""
    said = msgspec.structs.replace(POOR, caps=_with(max_faces=99, max_symbols=9))
    assert needs(_case(op, 99), said) is None
    assert needs(_case(op, 100), said) == "max_faces"


def test_an_echo_has_no_size() -> None:
    """Clause: ORCL-JUDGE-8."""
    assert needs(_case("echo", 1000), POOR) is None


def test_the_operation_comes_first_then_what_is_required_then_the_size() -> None:
    """Clauses: ORCL-JUDGE-6, ORCL-JUDGE-8."""
    case = _case("word.decode", 99, ("components", "handles"))
    assert needs(case, msgspec.structs.replace(POOR, ops=("echo",))) == "word.decode"
    assert needs(case, POOR) == "components"
    assert needs(case, msgspec.structs.replace(POOR, caps=_with(components=True))) == "handles"


def test_unsupported_is_excused_only_for_what_is_not_declared() -> None:
    """Clause: ORCL-JUDGE-6."""
    excused = judge(_case("word.decode", 1, ("handles",)), Unsupported("handles"), POOR)
    assert excused == skipped(_case("word.decode"), "handles")
    assert (excused.status, excused.why) == (Status.SKIP, "handles is not declared")
    owed = judge(_case("word.decode", 1), Unsupported("handles"), POOR)
    assert owed.status is Status.FAIL
    assert owed.signature == "word.decode fail unsupported though declared"
    assert owed.why == (
        "the capabilities: expected an answer: all that is needed was declared at hello, "
        "got unsupported: handles"
    )
