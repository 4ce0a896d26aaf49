"""What the suite asks: that all is there, and is what it says it is."""

import json
from collections import Counter

import pytest
from msgspec import UNSET, Raw, UnsetType
from tampered import whole

from clers.codes.registry import CodeName
from clers.complexes.topology import components
from clers.conformance.cases.case import PROFILES, Case, operation_of
from clers.conformance.lines import NoMessage
from clers.conformance.messages import OkReply
from clers.conformance.results import RESULTS
from clers.conformance.serve import serve
from clers.oracle.positives.asked import TRACED
from clers.oracle.positives.exhaustive import COUNTS, sphere, sphere_words
from clers.oracle.suite.files import DEFAULT


def of_op(op: str) -> list[Case]:
    return [case for case in whole().cases if case.op == op]


def value(raw: Raw | UnsetType) -> dict[str, object]:
    assert not isinstance(raw, UnsetType)
    found: dict[str, object] = json.loads(bytes(raw))
    return found


def test_how_much_there_is() -> None:
    """ORCL-SUITE-3: every profile and operation has cases; all fit into 20 MB."""
    assert len(whole().cases) >= 3000
    assert sum(file.stat().st_size for file in DEFAULT.rglob("*.json")) < 20_000_000
    assert {case.op for case in whole().cases} == set(RESULTS)
    assert {part.profile for part in whole().parts} == set(PROFILES)
    assert len({case.id for case in whole().cases}) == len(whole().cases)


def test_all_small_spheres_are_asked() -> None:
    """EB-GRAMMAR-10: 2(4m+1)!/((m+1)!(3m+2)!) with m = V − 3, each word once."""
    asked = [case for case in of_op("word.decode") if case.origin == "exhaustive"]
    words = {str(value(case.input)["word"]) for case in asked}
    assert len(words) == len(asked) == 3014
    of_length = Counter(len(word) for word in words)
    assert of_length == {2 * v - 5: n for v, n in zip(range(4, 10), COUNTED, strict=True)}
    assert dict(zip(range(4, 10), COUNTED, strict=True)) == COUNTS


COUNTED = (1, 3, 13, 68, 399, 2530)
"""By Tutte's formula."""


def test_spheres_of_few_vertices() -> None:
    """EB-GRAMMAR-10, EB-COUNT-1: of five vertices all have two C, and CCSEE is impossible."""
    assert sphere_words(4) == ("CRE",)
    assert sphere_words(5) == ("CCRLE", "CCRRE", "CRCRE")
    assert components(sphere("CRE"))[0].euler == 2


def test_a_case_needs_nothing_else() -> None:
    """ORCL-CASE-3: each of these lines is a case that can be asked and answered by itself."""
    for entry in whole().manifest.files:
        text = (DEFAULT / entry.path).read_text()
        line = text.splitlines()[1].rstrip(",")
        fields = json.loads(line)
        trace = "full" if "trace" in fields else "none"
        asked = {"op": fields["op"], "id": 1, "in": fields["in"], "trace": trace}
        request = operation_of(
            Case(
                id=fields["id"],
                op=asked["op"],
                clauses=(),
                origin="hand",
                input=Raw(json.dumps(asked["in"]).encode()),
            )
        )
        assert not isinstance(request, NoMessage)
        reply = serve(request)[-1]
        assert isinstance(reply, OkReply) == ("ok" in fields)


def test_where_cases_come_from() -> None:
    """ORCL-CASE-6."""
    origins = Counter(case.origin for case in whole().cases)
    assert origins["exhaustive"] > 3000
    assert all(origins[origin] for origin in ("grammar", "generated", "real", "hand"))
    real = [case for case in whole().cases if case.origin == "real" and case.comment]
    assert all("corpus/meshes/" in case.comment for case in real)
    assert len({case.comment for case in real}) > 15


def test_what_is_traced() -> None:
    """ORCL-CASE-1: walks over few faces, with an entry for each face."""
    traced = [case for case in whole().cases if case.trace]
    assert {case.op for case in traced} == {"word.encode", "word.decode"}
    assert all(len(case.trace) == case.size <= TRACED for case in traced)
    assert len(traced) > 1000


def test_every_code_and_coder_is_asked() -> None:
    """CODE-NAME-1, ORCL-OP-4: by what they require."""
    for op in ("code.encode", "code.decode"):
        codes = Counter(name for case in of_op(op) for name in case.requires if "code." in name)
        assert set(codes) == {f"code.{code}" for code in CodeName}
        assert min(codes.values()) > 50
    for op in ("arithmetic.encode", "arithmetic.decode"):
        coders = {name for case in of_op(op) for name in case.requires}
        assert coders == {"coder.arithmetic", "coder.range", "coder.rans"}


@pytest.mark.parametrize("kind", ["exact", "lattice", "bits", "error"])
def test_every_accuracy_is_asked(kind: str) -> None:
    """FILE-OPTION-1."""
    kinds = []
    for case in of_op("mesh.encode"):
        accuracy = value(case.input)["accuracy"]
        assert isinstance(accuracy, dict)
        kinds.append(accuracy["kind"])
    assert kinds.count(kind) >= 5


def test_every_topology_is_asked() -> None:
    """CPLX-COMPONENT-3: genus up to five, with up to four curves, as a classification says."""
    met = set()
    for case in of_op("surface.classify"):
        if isinstance(case.reject, UnsetType):
            parts = value(case.ok)["components"]
            assert isinstance(parts, list)
            met.add((len(parts), sum(p["genus"] for p in parts), sum(p["curves"] for p in parts)))
    assert {(1, genus, curves) for genus in range(6) for curves in range(5)} <= met
    assert {(parts, genus, 1) for parts in (2, 3) for genus in range(3)} <= met


@pytest.mark.parametrize(
    "names",
    [
        [f"EB-TRAVERSE-{n}" for n in range(1, 8)],
        [f"EB-HANDLE-{n}" for n in range(1, 6)],
        [f"EB-COMPONENT-{n}" for n in (1, 2, 4)],
        [f"EB-ORDER-{n}" for n in (1, 2, 3)],
        [f"OPER-REFINE-{n}" for n in range(1, 5)],
        [f"OPER-BORDER-{n}" for n in range(1, 8)],
        [f"OPER-TUBE-{n}" for n in range(2, 6)],
        [f"GEOM-CODE-{n}" for n in range(1, 5)],
    ],
)
def test_clauses_are_asked(names: list[str]) -> None:
    """ORCL-CASE-1: by a case that is answered with a result."""
    asked = {name for case in whole().cases if case.ok is not UNSET for name in case.clauses}
    assert set(names) <= asked
