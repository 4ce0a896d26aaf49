"""How a suite is made, and how it may change: nothing goes without a word."""

from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest
from msgspec import UNSET, Raw
from msgspec.structs import replace
from tampered import base, first, whole, write, written

from clers.conformance.cases.case import Case
from clers.conformance.cases.identity import named
from clers.conformance.messages import Rejection
from clers.conventions.reason import Fault, Reason
from clers.conventions.result import Accepted, Rejected
from clers.oracle.positives.all_families import FAMILIES
from clers.oracle.positives.asked import Asked
from clers.oracle.positives.echoes import echoes
from clers.oracle.suite import generated
from clers.oracle.suite.adding import FILE, add, shrunk
from clers.oracle.suite.files import Suite, read_suite
from clers.oracle.suite.generated import STEPS, all_flags, before, generate, inputs_of
from clers.oracle.suite.records import Retired, Score
from clers.oracle.suite.retiring import Reused, Unretired, retire, slug_in
from clers.oracle.suite.written import write_suite


def case(name: str, op: str = "echo") -> Case:
    return replace(first("word.decode", "ok"), id=name, op=op)


def test_nothing_is_gone() -> None:
    """ORCL-SUITE-6: what was retired before stays so, and needs no reason again."""
    gone = (Retired(id="old-aaaaaaaa", reason="wrong"),)
    a, b = case("a-aaaaaaaa"), case("b-aaaaaaaa")
    assert retire([a], [b, a], gone, "") == gone
    assert retire([], [a], (), "") == ()


def test_what_is_gone_is_named() -> None:
    """ORCL-SUITE-6."""
    a, b, c = (case(f"{name}-aaaaaaaa") for name in "abc")
    assert retire([c, a, b], [b], (), "") == Unretired((c.id, a.id))


def test_what_is_gone_is_retired() -> None:
    """ORCL-SUITE-6: with a successor of the same slug and operation, if that is new."""
    old = [case("a-aaaaaaaa"), case("b-aaaaaaaa"), case("c-aaaaaaaa"), case("c-bbbbbbbb")]
    new = [case("a-zzzzzzzz"), case("b-zzzzzzzz", "word.encode"), case("c-bbbbbbbb")]
    earlier = Retired(id="x-aaaaaaaa", reason="long ago")
    assert retire(old, new, [earlier], "it was wrong") == (
        earlier,
        Retired(id="a-aaaaaaaa", reason="it was wrong", successor="a-zzzzzzzz"),
        Retired(id="b-aaaaaaaa", reason="it was wrong"),
        Retired(id="c-aaaaaaaa", reason="it was wrong"),
    )


def test_an_id_is_not_used_again() -> None:
    """ORCL-SUITE-6: even if a reason is given."""
    gone = [Retired(id=f"{name}-aaaaaaaa", reason="wrong") for name in "ba"]
    new = [case("a-aaaaaaaa"), case("b-aaaaaaaa"), case("c-aaaaaaaa")]
    assert retire([], new, gone, "why") == Reused(("a-aaaaaaaa", "b-aaaaaaaa"))


def test_the_slug_in_an_id() -> None:
    """ORCL-CASE-2."""
    assert slug_in("two-holes-a7k3f2zz") == "two-holes"


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two families: one of the positives, one with faults."""

    def said_twice(_: Mapping[str, bytes]) -> Iterator[Asked]:
        yield from echoes()
        yield from echoes()

    drafts = tuple(
        (part.profile, slug_in(one.id), one)
        for part in base().parts
        if part.op == "word.decode"
        for one in part.cases
    )
    monkeypatch.setattr(generated, "FAMILIES", {"echoes": said_twice})
    monkeypatch.setattr(generated, "negatives", lambda parents: drafts if parents else ())


def made(inputs: Mapping[str, bytes], old: Suite | None, reason: str = "") -> dict[str, bytes]:
    files = generate(inputs, old, reason)
    assert isinstance(files, dict), files
    return files


def read(folder: Path) -> Suite:
    found = read_suite(folder)
    assert isinstance(found, Accepted), found
    return found.value


@pytest.mark.usefixtures("few")
def test_a_suite_is_made(tmp_path: Path) -> None:
    """ORCL-SUITE-5: positives and negatives, each id once, with flags and canaries."""
    said: list[str] = []
    files = generate({"inputs/solids.json": b"{}"}, None, "", said.append)
    assert isinstance(files, dict)
    assert said == ["echoes", "negatives"]
    assert len(FAMILIES) + len(said) - 1 == STEPS
    write(tmp_path, files)
    suite = read(tmp_path)
    assert [(part.profile, part.op) for part in suite.parts] == [
        ("core", "echo"),
        ("components", "word.decode"),
    ]
    assert len(suite.parts[0].cases) == len(list(echoes()))
    assert suite.parts[1].cases == next(p for p in base().parts if p.op == "word.decode").cases
    assert {flag.name for flag in suite.flags} == {flag.name for flag in all_flags()}
    assert suite.canaries == whole().canaries
    assert suite.retired == ()
    assert (tmp_path / "inputs" / "solids.json").read_bytes() == b"{}"
    assert made({"inputs/solids.json": b"{}"}, suite) == files


@pytest.mark.usefixtures("few")
def test_what_is_kept(tmp_path: Path) -> None:
    """ORCL-SUITE-5: the mutation score, and what is retired."""
    gone = [Retired(id="old-aaaaaaaa", reason="wrong")]
    score = Score(suite="else", mutants=3, killed=2)
    decoded = [part for part in base().parts if part.op == "word.decode"]
    old = read(written(tmp_path, decoded, retired=gone, mutation=score))
    write(tmp_path / "new", made({}, old))
    new = read(tmp_path / "new")
    assert new.retired == tuple(gone)
    assert new.manifest.mutation == score


@pytest.mark.usefixtures("few")
def test_what_may_not_be_gone(tmp_path: Path) -> None:
    """ORCL-SUITE-6."""
    old = read(written(tmp_path))
    lost = tuple(one.id for one in old.cases if one.op != "word.decode")
    assert generate({}, old) == Unretired(lost)
    write(tmp_path / "new", made({}, old, "not wanted"))
    new = read(tmp_path / "new")
    assert [entry.id for entry in new.retired] == sorted(lost)
    assert {entry.reason for entry in new.retired} == {"not wanted"}
    back = replace(new.retired[0], id=new.cases[0].id)
    again = Suite(new.manifest, new.parts, new.flags, (back,), new.canaries)
    assert generate({}, again, "whatever") == Reused((new.cases[0].id,))


@pytest.mark.usefixtures("few")
def test_without_a_checkout(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-SUITE-5: the corpus is needed."""
    monkeypatch.setattr(generated, "MESHES", tmp_path / "none")
    found = generate({}, None)
    assert isinstance(found, Rejected)
    assert found.reason is Reason.UNREADABLE_FILE
    assert found.detail == f"{tmp_path / 'none'}: not there: a checkout is needed"


def test_every_flag_is_explained_once() -> None:
    """ORCL-CASE-5."""
    names = [flag.name for flag in all_flags()]
    assert len(set(names)) == len(names) > 40
    assert all(flag.mistake and flag.matters for flag in all_flags())


def test_what_a_folder_has(tmp_path: Path) -> None:
    """ORCL-SUITE-5: the inputs alone, and the suite if there is one."""
    assert before(tmp_path) == Accepted(None)
    assert inputs_of(tmp_path) == Accepted({})
    write(written(tmp_path), {"inputs/b.json": b"2", "inputs/a/a.json": b"1", "other.json": b"3"})
    assert inputs_of(tmp_path) == Accepted({"inputs/a/a.json": b"1", "inputs/b.json": b"2"})
    found = before(tmp_path)
    assert isinstance(found, Accepted)
    assert found.value is not None
    assert found.value.parts == base().parts
    (tmp_path / "flags.json").write_bytes(b"")
    assert isinstance(before(tmp_path), Rejected)


def found_case() -> Case:
    """A case that the suite has not: two triangles side by side, another way round."""
    word = Raw(b'{"word":"EE","handles":[],"components_with_boundary":2}')
    faces = Raw(b'{"faces":[[2,0,1],[5,3,4]],"vertices":6}')
    return named(
        "found-word-decode",
        Case(
            id="",
            op="word.decode",
            clauses=("EB-DECODE-1",),
            origin="shrunk",
            requires=("boundaries.many", "components"),
            size=2,
            input=word,
            ok=faces,
        ),
    )


def refused(found: Accepted[tuple[Case, bytes]] | Rejected) -> str:
    assert isinstance(found, Rejected)
    assert found.reason is Reason.NOT_REPRESENTABLE
    return found.detail


KNOWN = {one.id: one for one in base().cases}


def test_a_finding_is_added() -> None:
    """ORCL-SUITE-11."""
    added = add(found_case(), "two-alone", KNOWN, ())
    assert isinstance(added, Accepted)
    new, data = added.value
    assert slug_in(new.id) == "two-alone"
    assert replace(new, id="") == replace(found_case(), id="")
    kept = shrunk({FILE: data})
    assert isinstance(kept, Accepted)
    assert [(one.profile, one.case) for one in kept.value] == [("mixed", new)]
    assert refused(add(found_case(), "again", KNOWN, kept.value)) == f"{new.id} asks that already"


def test_findings_are_in_order() -> None:
    """ORCL-SUITE-11: the smaller first, and among those of one size the lesser id."""
    first_one = add(found_case(), "b", KNOWN, ())
    assert isinstance(first_one, Accepted)
    kept = shrunk({FILE: first_one.value[1]})
    assert isinstance(kept, Accepted)
    three = Raw(b'{"word":"EEE","handles":[],"components_with_boundary":3}')
    faces = Raw(b'{"faces":[[2,0,1],[5,3,4],[8,6,7]],"vertices":9}')
    other = replace(found_case(), input=three, ok=faces, size=1)
    second = add(other, "a", KNOWN, kept.value)
    assert isinstance(second, Accepted)
    both = shrunk({FILE: second.value[1]})
    assert isinstance(both, Accepted)
    assert [slug_in(one.case.id) for one in both.value] == ["a", "b"]


def test_what_is_not_added() -> None:
    """ORCL-SUITE-11."""
    there = first("word.decode", "ok")
    assert refused(add(there, "new", KNOWN, ())) == f"{there.id} asks that already"
    assert refused(add(found_case(), "No Slug", KNOWN, ())) == "'No Slug' is no slug"
    assert refused(add(found_case(), "-a", KNOWN, ())) == "'-a' is no slug"
    bare = replace(found_case(), clauses=())
    assert refused(add(bare, "bare", KNOWN, ())) == "it names no clause"
    wrong = replace(found_case(), ok=Raw(b'{"faces":[[2,0,1],[5,3,4]],"vertices":7}'))
    assert refused(add(wrong, "wrong", KNOWN, ())).startswith(
        "the reference does not answer it so: "
    )
    bad = replace(
        found_case(),
        requires=(),
        input=Raw(b'{"word":"X","handles":[],"components_with_boundary":0}'),
        ok=UNSET,
        reject=Rejection(Fault.INVALID, "unknown-symbol", {"symbol": 0}, "EB-GRAMMAR-1"),
    )
    assert refused(add(bad, "bad", KNOWN, ())) == "it names no fault"


@pytest.mark.usefixtures("few")
def test_a_finding_becomes_a_case(tmp_path: Path) -> None:
    """ORCL-SUITE-11."""
    added = add(found_case(), "two-alone", KNOWN, ())
    assert isinstance(added, Accepted)
    new, data = added.value
    written_files = write_suite(tmp_path, made({FILE: data}, None))
    assert isinstance(written_files, Accepted)
    suite = read(tmp_path)
    assert new in suite.cases
    assert [part.profile for part in suite.parts if new in part.cases] == ["mixed"]


@pytest.mark.usefixtures("few")
def test_findings_that_cannot_be_read() -> None:
    """ORCL-SUITE-11."""
    found = generate({FILE: b"{}"}, None)
    assert isinstance(found, Rejected)
    assert found.detail == f"{FILE}: Object missing required field `found`"
    assert shrunk({}) == Accepted(())
