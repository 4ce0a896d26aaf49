"""The corpus that is kept here: what is stated of it is so."""

import re
from collections import Counter
from functools import cache
from pathlib import Path

import pytest

import clers
from clers.cli.output import where_record
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.corpus.fetch import verify
from clers.corpus.manifest import (
    DIRTY,
    LARGER,
    SMALL,
    Counts,
    Dirty,
    DirtyManifest,
    Entry,
    Manifest,
    dirty_manifest,
    manifest,
)
from clers.meshfile import RawMesh, read, write
from clers.meshfile.laws import renumbered, seen
from clers.meshfile.mesh import judged

ROOT = Path(clers.__file__).parents[2]
MESHES = (ROOT / SMALL).parent
FAULTS = (ROOT / DIRTY).parent


def stated(path: Path) -> Manifest:
    result = manifest(ROOT / path)
    assert isinstance(result, Accepted), result
    return result.value


def stated_faults() -> DirtyManifest:
    result = dirty_manifest(ROOT / DIRTY)
    assert isinstance(result, Accepted), result
    return result.value


SMALL_ONES = stated(SMALL).meshes
LARGER_ONES = stated(LARGER).meshes
DIRTY_ONES = stated_faults().meshes


@cache
def raw(file: str) -> RawMesh:
    result = read(MESHES / file)
    assert isinstance(result, Accepted), result
    return result.value


def counted(mesh: RawMesh) -> Counts:
    result = judged(mesh)
    assert isinstance(result, Accepted), result
    surface = result.value.surface
    parts = components(surface)
    return Counts(
        vertices=surface.vertices,
        faces=surface.faces,
        components=len(parts),
        closed=sum(part.curves == 0 for part in parts),
        handles=sum(part.genus for part in parts),
        curves=sum(part.curves for part in parts),
    )


@pytest.mark.parametrize("entry", SMALL_ONES, ids=lambda entry: entry.name)
def test_each_mesh_is_as_stated(entry: Entry) -> None:
    """Clauses: TOOL-CORPUS-1, TOOL-CORPUS-5."""
    assert verify(entry, MESHES) == Accepted(MESHES / entry.file)
    assert (MESHES / entry.file).stat().st_size == entry.bytes
    assert counted(raw(entry.file)) == entry.counts


def test_the_manifest_names_the_files_that_are_there() -> None:
    """Clauses: TOOL-CORPUS-1, TOOL-CORPUS-4."""
    for folder, meshes in ((MESHES, SMALL_ONES), (FAULTS, DIRTY_ONES)):
        there = sorted(path.name for path in folder.iterdir() if path.is_file())
        assert there == sorted(["manifest.json", *(entry.file for entry in meshes)])
    names = [entry.name for entry in (*SMALL_ONES, *LARGER_ONES)]
    assert max(Counter(names).values()) == 1
    files = [entry.file for entry in (*SMALL_ONES, *LARGER_ONES)]
    assert max(Counter(files).values()) == 1


def test_each_mesh_has_a_source_and_a_licence() -> None:
    """Clause: TOOL-CORPUS-1."""
    for path in (SMALL, LARGER):
        of = stated(path)
        assert {entry.licence for entry in of.meshes} == set(of.licences)
        for entry in of.meshes:
            assert re.fullmatch("[0-9a-f]{64}", entry.sha256)
            assert re.fullmatch("[0-9a-f]{64}", entry.source.sha256)
            assert entry.source.package
            assert entry.source.version
            assert entry.source.path
            assert entry.author
            assert (entry.counts is None) != (entry.rejected is None)
        for licence in of.licences.values():
            assert licence.spdx
            assert licence.sentence
            assert licence.document
    for entry in SMALL_ONES:
        if stated(SMALL).licences[entry.licence].spdx == "BSD-3-Clause":
            assert "Redistribution" in (MESHES / "licences" / "assimp.txt").read_text("utf-8")


def test_files_with_the_suffix_of_their_source_are_its_bytes() -> None:
    """Clause: TOOL-CORPUS-2."""
    for entry in (*SMALL_ONES, *LARGER_ONES):
        kept = Path(entry.file).suffix == Path(entry.source.file).suffix
        assert (entry.sha256 == entry.source.sha256) == kept


def test_the_classes_spanned() -> None:
    """Clause: TOOL-CORPUS-3."""
    counts = {entry.name: entry.counts for entry in SMALL_ONES if entry.counts is not None}
    one = [of for of in counts.values() if of.components == 1]
    assert {min(of.handles, 2) for of in one if of.closed} == {0, 1, 2}
    assert {min(of.curves, 2) for of in one if not of.closed} == {1, 2}
    assert any(of.handles and of.curves for of in one)
    assert max(of.components for of in counts.values()) > 100
    assert any(of.components > 20 and of.closed == of.components for of in counts.values())
    assert any(0 < of.closed < of.components for of in counts.values())


def test_the_formats_spanned() -> None:
    """Clause: TOOL-CORPUS-3."""
    heads = [(Path(e.file).suffix, (MESHES / e.file).read_bytes()[:40]) for e in SMALL_ONES]
    kinds = {(suffix, b"ascii" in head or head.startswith(b"solid")) for suffix, head in heads}
    assert kinds >= {(".ply", True), (".ply", False), (".stl", True), (".stl", False)}
    assert {suffix for suffix, _ in kinds} == {".ply", ".off", ".obj", ".stl"}


def test_the_size() -> None:
    """Clause: TOOL-CORPUS-3."""
    assert sum(path.stat().st_size for path in MESHES.rglob("*") if path.is_file()) <= 1 << 22


@pytest.mark.parametrize("entry", DIRTY_ONES, ids=lambda entry: entry.name)
def test_each_fault_is_found(entry: Dirty) -> None:
    """Clauses: TOOL-CORPUS-4, CONV-RESULT-2."""
    result = and_then(read(FAULTS / entry.file), judged)
    assert isinstance(result, Rejected)
    got = (str(result.reason), str(result.clause), where_record(result.where))
    assert got == (entry.rejected.reason, entry.rejected.clause, entry.rejected.at)


def test_the_faults_spanned() -> None:
    """Clause: TOOL-CORPUS-4."""
    clauses = Counter(entry.rejected.clause for entry in DIRTY_ONES)
    assert set(clauses) == {
        *(f"CPLX-REJECT-{n}" for n in (1, 3, 4, 5, 6, 7, 8, 9)),
        "GEOM-POSITION-3",
        *(f"TOOL-READ-{n}" for n in (1, 4, 5, 6)),
    }
    limits = {e.rejected.reason for e in DIRTY_ONES if e.rejected.clause == "TOOL-READ-6"}
    assert limits == {"too-many-faces", "too-many-vertices"}
    cut = {Path(e.file).suffix for e in DIRTY_ONES if e.rejected.clause == "TOOL-READ-5"}
    assert cut == {".ply", ".off", ".obj", ".stl"}
    assert any("half a twist" in entry.about for entry in DIRTY_ONES)


@pytest.mark.parametrize("suffix", [".ply", ".off", ".obj", ".stl"])
def test_each_mesh_comes_back_in_each_format(suffix: str, tmp_path: Path) -> None:
    """Clauses: TOOL-WRITE-1, TOOL-WRITE-3: to the last bit, or STL refuses."""
    refused = []
    for entry in SMALL_ONES:
        mesh = raw(entry.file)
        path = tmp_path / f"{entry.name}{suffix}"
        written = write(path, mesh)
        if isinstance(written, Rejected):
            assert (written.reason, written.clause) == (
                Reason.NOT_REPRESENTABLE,
                Clause.TOOL_WRITE_3,
            )
            refused.append(entry.name)
            continue
        again = read(path)
        assert isinstance(again, Accepted)
        assert seen(again.value) == seen(renumbered(mesh) if suffix == ".stl" else mesh)
    kept = {entry.name for entry in SMALL_ONES} - set(refused)
    assert kept >= ({"cube", "ring", "sphere-facets"} if suffix == ".stl" else set())
    assert suffix == ".stl" or not refused


def test_damaged_meshes_have_an_answer() -> None:
    """Clause: TOOL-READ-5: a byte changed, a stretch cut out, at places spread over each file."""
    from clers.meshfile.formats import format_of
    from clers.meshfile.reading import parse

    for entry in SMALL_ONES:
        known = format_of(Path(entry.file))
        assert isinstance(known, Accepted)
        data = (MESHES / entry.file).read_bytes()[:20_000]
        for i in range(24):
            at = (i * 2654435761) % len(data)
            byte = bytes([(i * 97 + 13) % 256])
            for damaged in (data[:at] + byte + data[at + 1 :], data[: at // 2] + data[at:]):
                assert isinstance(parse(known.value, damaged), Accepted | Rejected)


def test_what_verify_finds(tmp_path: Path) -> None:
    """Clause: TOOL-CORPUS-5."""
    entry = SMALL_ONES[0]
    missing = verify(entry, tmp_path)
    assert isinstance(missing, Rejected)
    assert missing.reason is Reason.UNREADABLE_FILE
    data = (MESHES / entry.file).read_bytes()
    (tmp_path / entry.file).write_bytes(data[:-1] + bytes([data[-1] ^ 1]))
    changed = verify(entry, tmp_path)
    assert isinstance(changed, Rejected)
    assert (changed.reason, changed.clause) == (Reason.BAD_CHECKSUM, Clause.TOOL_CORPUS_5)
    assert entry.sha256 in changed.detail


@pytest.mark.parametrize(
    "text", ["", "{", "[]", '{"about": "x", "licences": {}}', '{"x":' + "[" * 100_000]
)
def test_what_is_no_manifest(text: str, tmp_path: Path) -> None:
    """Clauses: TOOL-CORPUS-1, TOOL-READ-5."""
    path = tmp_path / "manifest.json"
    path.write_text(text)
    for result in (manifest(path), dirty_manifest(path)):
        assert isinstance(result, Rejected)
        assert result.reason is Reason.UNREADABLE_FILE
