"""All cases with one fault: each is what it says, and none is missing that can be."""

from collections import Counter

import msgspec
import pytest
from msgspec import UnsetType
from negative_cases import accepted, made, rejected, suite

from clers.conformance.cases.case import PROFILES, Case
from clers.conformance.cases.faults import fault_in
from clers.conformance.cases.identity import identity
from clers.conventions.clause import Clause
from clers.conventions.reason import Fault, Reason
from clers.oracle.negatives import FLAGS, negatives
from clers.oracle.negatives.reasons import NOT_GIVEN
from clers.oracle.suite.profiles import LIMITS, profile_of

replace = msgspec.structs.replace


def test_each_has_one_fault_that_can_be_undone() -> None:
    """Clauses: ORCL-FAULT-1, ORCL-FAULT-2, ORCL-FAULT-4."""
    found = {case.id: why for case in suite().values() if (why := fault_in(case, suite()))}
    assert found == {}
    assert all(not isinstance(case.fault, UnsetType) for case in rejected())


def test_there_are_enough_of_each_operation() -> None:
    """Clause: ORCL-FAULT-5."""
    bad = Counter(case.op for case in rejected())
    assert min(bad.values()) >= 20
    assert set(bad) == {
        "surface.classify", "operator.apply", "arithmetic.encode", "arithmetic.decode",
        "word.encode", "word.decode", "code.encode", "code.decode", "mesh.encode", "mesh.decode",
    }  # fmt: skip
    assert bad["word.decode"] >= 300
    assert bad["mesh.decode"] >= 300


def test_every_reason_that_can_be_given_is() -> None:
    """Clause: ORCL-FAULT-5."""
    given = {case.reject.reason for case in rejected() if not isinstance(case.reject, UnsetType)}
    missing = {str(reason) for reason in Reason} - given
    assert missing == {str(reason) for reason in NOT_GIVEN}
    assert all(NOT_GIVEN.values())


SPOKEN_OF = (
    "CPLX-REJECT-1", "CPLX-REJECT-2", "CPLX-REJECT-3", "CPLX-REJECT-4", "CPLX-REJECT-5",
    "CPLX-REJECT-6", "CPLX-REJECT-7", "CPLX-REJECT-8", "CPLX-REJECT-9",
    "EB-GRAMMAR-1", "EB-GRAMMAR-2", "EB-GRAMMAR-3", "EB-GRAMMAR-4", "EB-GRAMMAR-5",
    "EB-GRAMMAR-6", "EB-GRAMMAR-7", "EB-GRAMMAR-8", "EB-GRAMMAR-9",
    "INFO-STATIC-3", "INFO-ADAPT-3", "INFO-MODEL-5", "INFO-KRAFT-2", "INFO-PREFIX-3",
    "ARITH-BITS-3", "ARITH-STRICT-2", "ARITH-STRICT-3", "ARITH-STRICT-4", "ARITH-BYTES-2",
    "ARITH-RANS-5",
    "CODE-IMPLIED-2", "CODE-HAND-2", "CODE-HAND-3", "CODE-PLAIN-1", "CODE-PLAIN-2",
    "CODE-GOLDEN-1", "CODE-HUFFMAN-1", "CODE-HUFFMAN-3", "CODE-KR-1", "CODE-KR-3",
    "CODE-ADAPTIVE-1", "CODE-MINIMAX-4", "CODE-MINIMAX-5", "CODE-ENUM-1", "CODE-TREE-6",
    "CODE-CONTEXT-1", "CODE-CONTEXT-3", "CODE-BEST-1", "CODE-BEST-2",
    "GEOM-POSITION-2", "GEOM-POSITION-3", "GEOM-POSITION-4", "GEOM-EXACT-2", "GEOM-LATTICE-1",
    "GEOM-LATTICE-3", "GEOM-CHOICE-1", "GEOM-CHOICE-2", "GEOM-BOX-2", "GEOM-RESIDUAL-2",
    "FILE-LAYOUT-2", "FILE-LAYOUT-3", "FILE-NUMBER-3", "FILE-NUMBER-5", "FILE-MAGIC-1",
    "FILE-MAGIC-2", "FILE-SECTION-2", "FILE-SECTION-3", "FILE-SECTION-4", "FILE-SECTION-5",
    "FILE-LIMIT-2", "FILE-COUNT-1", "FILE-COUNT-2", "FILE-COUNT-3",
    "OPER-SCRIPT-6", "OPER-BUILD-5", "OPER-MOVE-2", "OPER-MOVE-8", "OPER-ATTACH-1",
    "OPER-ATTACH-2", "OPER-ATTACH-3", "OPER-ATTACH-8", "OPER-SURFACE-1", "OPER-SURFACE-2",
    "OPER-SURFACE-3", "OPER-SURFACE-4", "OPER-SURFACE-5", "OPER-SURFACE-6", "OPER-SURFACE-7",
    "OPER-EULER-1", "OPER-EULER-2", "OPER-EULER-3", "OPER-EULER-5", "OPER-SIMPLEX-1",
    "OPER-SIMPLEX-5", "OPER-CURVE-1", "OPER-CURVE-4", "OPER-CURVE-5", "OPER-SOLID-1",
    "OPER-SOLID-2", "OPER-COLLAPSE-1", "OPER-COLLAPSE-3", "OPER-STELLAR-1", "OPER-STELLAR-2",
    "OPER-BISTELLAR-1", "OPER-CONTRACT-1", "OPER-CONTRACT-4",
    "OPER-CONTRACT-5",
)  # fmt: skip
"""The clauses by which an operation rejects, from the chapters."""


@pytest.mark.parametrize("clause", SPOKEN_OF)
def test_every_clause_that_rejects_has_a_case(clause: str) -> None:
    """Clause: ORCL-FAULT-5."""
    found = [case for case in rejected() if case.clauses == (clause,)]
    assert found
    assert Clause(clause)


REASONS = {str(reason): reason for reason in Reason}


def test_a_rejection_is_under_its_own_clause_and_without_words() -> None:
    """Clause: ORCL-FAULT-4."""
    for case in rejected():
        assert not isinstance(case.reject, UnsetType)
        assert case.clauses == (case.reject.clause,)
        assert case.reject.detail == ""
        assert REASONS[case.reject.reason].fault is case.reject.fault
        assert case.trace == ()


def test_ids_are_hashes_under_the_slug() -> None:
    """Clause: ORCL-CASE-2."""
    assert len(suite()) == len(made())
    for _, slug, case in made():
        assert case.id == identity(slug, case)
    asked = Counter((case.op, bytes(case.input)) for case in suite().values())
    assert set(asked.values()) == {1}


def test_profiles() -> None:
    """Clauses: ORCL-SUITE-3, ORCL-LIMIT-1."""
    for profile, _, case in made():
        assert profile in PROFILES
        if profile != LIMITS:
            assert profile == profile_of(case)
        over = not isinstance(case.reject, UnsetType) and case.reject.fault is Fault.LIMIT
        assert profile == LIMITS or not over


def test_flags_are_those_that_are_explained() -> None:
    """Clauses: ORCL-CASE-5, ORCL-FLAG-1."""
    names = [flag.name for flag in FLAGS]
    assert len(names) == len(set(names))
    assert {flag for case in suite().values() for flag in case.flags} == set(names)
    assert all(flag.mistake and flag.matters for flag in FLAGS)
    assert all(case.flags for case in rejected())


def test_capabilities_are_in_the_spelling_of_the_protocol() -> None:
    """Clause: ORCL-CASE-4."""
    plain = {"handles", "boundaries.one", "boundaries.many", "components"}
    for case in suite().values():
        assert len(set(case.requires)) == len(case.requires)
        for name in case.requires:
            assert name in plain or name.startswith(("code.", "coder."))


def test_a_case_that_is_there_already_stands_in_for_ours() -> None:
    """A parent of the suite keeps its own id, and is not asked twice. ORCL-CASE-2, ORCL-FAULT-1."""
    ours = next(case for case in accepted() if case.id.startswith("tetrahedron-"))
    children = [c for c in rejected() if not isinstance(c.fault, UnsetType)]
    mine = [c for c in children if _parent(c) == ours.id]
    spaced = msgspec.Raw(bytes(ours.input).replace(b",", b", "))
    theirs = replace(ours, id="their-ball-aaaaaaaa", input=spaced)
    found = negatives({"any name": theirs})
    assert ours.id not in {case.id for _, _, case in found}
    assert theirs.id not in {case.id for _, _, case in found}
    again = [case for _, _, case in found if _parent(case) == theirs.id]
    assert [c.id for c in again] == [c.id for c in mine]
    assert all(_parent(case) != ours.id for _, _, case in found)
    assert len(found) == len(made()) - 1
    whole = {case.id: case for _, _, case in found} | {theirs.id: theirs}
    assert [fault_in(case, whole) for case in again] == [""] * len(again)
    assert mine


def _parent(case: Case) -> str:
    return "" if isinstance(case.fault, UnsetType) else case.fault.parent
