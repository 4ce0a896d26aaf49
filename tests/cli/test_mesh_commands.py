"""The commands on meshes, run as a user runs them: TOOL-ENCODE, -INFO, -WORD, -ROUND, -REPAIR."""

import json
from pathlib import Path
from typing import Final

import jsonschema
import pytest
from typer.testing import CliRunner, Result

from clers.cli.main import app
from clers.cli.output import Exit
from clers.codes.registry import CodeName

MESHES: Final = Path(__file__).parents[2] / "corpus" / "meshes"
SCHEMAS: Final = Path(__file__).parents[2] / "spec" / "schemas"
RING: Final = str(MESHES / "ring.off")


def clers(*arguments: str) -> Result:
    return CliRunner().invoke(app, list(arguments))


def test_word_of_the_ring() -> None:
    """TOOL-WORD-1: the annulus of six triangles, from its first face."""
    done = clers("word", RING, "--json")
    assert done.exit_code == Exit.CONFORMING
    document = json.loads(done.stdout)
    jsonschema.validate(document, json.loads((SCHEMAS / "word.schema.json").read_text()))
    assert document["components_with_boundary"] == 1
    assert [record["kind"] for record in document["handles"]] == ["boundary"]
    assert sorted(document["vertex_order"]) == list(range(6))


def test_info_of_a_mesh_with_handles_and_curves() -> None:
    """TOOL-INFO-1: the counts that the corpus' manifest states."""
    done = clers("info", str(MESHES / "elephant-with-holes.off"), "--json")
    document = json.loads(done.stdout)
    jsonschema.validate(document, json.loads((SCHEMAS / "info.schema.json").read_text()))
    entries = json.loads((MESHES / "manifest.json").read_text())["meshes"]
    stated = next(e for e in entries if e["file"] == "elephant-with-holes.off")["counts"]
    assert (document["vertices"], document["faces"]) == (stated["vertices"], stated["faces"])
    assert sum(c["curves"] for c in document["components"]) == stated["curves"]
    assert sum(c["genus"] for c in document["components"]) == stated["handles"]


@pytest.mark.parametrize("name", ["info", "word"])
def test_the_published_schemas_are_those_of_the_records(name: str) -> None:
    """TOOL-SCHEMA-1."""
    published = (SCHEMAS / f"{name}.schema.json").read_text()
    assert json.loads(clers("schema", name).stdout) == json.loads(published)


@pytest.mark.parametrize("code", [code for code in CodeName if code != "enumerative"])
@pytest.mark.parametrize("positions", ["exact", "q12"])
def test_encode_decode_info(tmp_path: Path, code: str, positions: str) -> None:
    """TOOL-ENCODE-1, TOOL-ENCODE-2, TOOL-INFO-1."""
    packed, out = tmp_path / "ring.clers", tmp_path / "ring.ply"
    options = ("--code", code, "--positions", positions)
    assert clers("encode", RING, "-o", str(packed), *options).exit_code == Exit.CONFORMING
    said = json.loads(clers("info", str(packed), "--json").stdout)
    jsonschema.validate(said, json.loads((SCHEMAS / "info.schema.json").read_text()))
    assert said["file"]["code"] == code
    assert said["file"]["bytes"] == packed.stat().st_size
    assert clers("decode", str(packed), "-o", str(out)).exit_code == Exit.CONFORMING
    first = json.loads(clers("info", RING, "--json").stdout)
    assert json.loads(clers("info", str(out), "--json").stdout) == first
    assert [p.name for p in sorted(tmp_path.iterdir())] == ["ring.clers", "ring.ply"]


def test_a_file_without_positions_makes_no_mesh_file(tmp_path: Path) -> None:
    """TOOL-ENCODE-2: said as wrong usage, and nothing is written."""
    packed, out = tmp_path / "ring.clers", tmp_path / "ring.ply"
    clers("encode", RING, "-o", str(packed), "--positions", "none")
    assert clers("decode", str(packed), "-o", str(out)).exit_code == Exit.USAGE
    assert not out.exists()


@pytest.mark.parametrize(
    "options", [("--code", "golder"), ("--positions", "q31"), ("--positions", "q0")]
)
def test_wrong_options_are_wrong_usage(tmp_path: Path, options: tuple[str, str]) -> None:
    """TOOL-ENCODE-2, TOOL-EXIT-1."""
    out = tmp_path / "x.clers"
    assert clers("encode", RING, "-o", str(out), *options).exit_code == Exit.USAGE
    assert not out.exists()


def test_a_failed_write_says_so_in_one_line_and_leaves_the_old_file(tmp_path: Path) -> None:
    """TOOL-ENCODE-1."""
    done = clers("encode", RING, "-o", str(tmp_path / "nowhere" / "x.clers"))
    assert done.exit_code == Exit.NOT_CONFORMING
    assert done.stderr.count("\n") == 1
    assert "unwritable-file" in done.stderr
    old = tmp_path / "old.clers"
    old.write_bytes(b"old")
    broken = tmp_path / "broken.off"
    broken.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n")
    assert clers("encode", str(broken), "-o", str(old)).exit_code == Exit.NOT_CONFORMING
    assert old.read_bytes() == b"old"


def test_a_damaged_file_is_refused_in_one_line(tmp_path: Path) -> None:
    """TOOL-OUTPUT-2: the file's name, class, reason, byte and clause."""
    packed = tmp_path / "ring.clers"
    clers("encode", RING, "-o", str(packed))
    data = bytearray(packed.read_bytes())
    data[-6] ^= 1
    packed.write_bytes(bytes(data))
    done = clers("decode", str(packed), "-o", str(tmp_path / "ring.ply"))
    assert done.exit_code == Exit.NOT_CONFORMING
    assert done.stderr.startswith(f"{packed}: malformed: bad-checksum")
    assert done.stderr.count("\n") == 1


def test_the_trace_in_text_json_and_operators() -> None:
    """EB-TRACE-1, EB-FOLD-1: as many entries as faces."""
    text = clers("trace", RING).stdout.splitlines()
    assert len(text) == 1 + 6
    entries = json.loads(clers("trace", RING, "--json").stdout)
    assert "".join(entry["symbol"] for entry in entries) == "SRLLRE"
    operators = clers("trace", RING, "--operators").stdout.splitlines()
    assert "OneHandle" in operators[1]
    assert operators[-1].split()[-4:] == ["2", "0", "0", "1"]


def test_roundtrip_of_files_and_random_meshes() -> None:
    """TOOL-ROUND-1."""
    done = clers("roundtrip", RING, "--random", "6", "--seed", "1")
    assert done.exit_code == Exit.CONFORMING
    assert "7 of 7 meshes came back" in done.stdout


def test_roundtrip_names_what_it_rejects() -> None:
    """TOOL-ROUND-1: exit code 1, and the mesh with its rejection."""
    pinched = next((MESHES / "dirty").glob("*pinched*"))
    done = clers("roundtrip", RING, str(pinched), "--json")
    assert done.exit_code == Exit.NOT_CONFORMING
    ring, other = json.loads(done.stdout)
    assert ring["rejected"] == ""
    assert "pinched-vertex" in other["rejected"]
    assert clers("roundtrip").exit_code == Exit.USAGE


def test_repair_does_what_is_asked_and_says_it(tmp_path: Path) -> None:
    """TOOL-REPAIR-1."""
    pinched = next((MESHES / "dirty").glob("*pinched*"))
    out = tmp_path / "mended.off"
    assert clers("repair", str(pinched), "-o", str(out)).exit_code == Exit.USAGE
    done = clers("repair", str(pinched), "-o", str(out), "--split-pinched")
    assert done.exit_code == Exit.CONFORMING
    assert "copied as" in done.stdout
    assert clers("info", str(out)).exit_code == Exit.CONFORMING


@pytest.mark.parametrize(("name", "starts"), [("w.svg", b"<svg"), ("w.png", b"\x89PNG")])
def test_the_walk_is_drawn_into_a_file(tmp_path: Path, name: str, starts: bytes) -> None:
    """TOOL-PICTURE-1: by the suffix; TOOL-PICTURE-10: the steps asked for."""
    out = tmp_path / name
    assert clers("trace", RING, "-o", str(out), "--steps", "0,3-5").exit_code == Exit.CONFORMING
    assert starts in out.read_bytes()[:200]
    assert clers("trace", RING, "-o", str(tmp_path / "w.gif")).exit_code == Exit.USAGE
    assert clers("trace", RING, "-o", str(out), "--layout", "round").exit_code == Exit.USAGE
    assert clers("trace", RING, "-o", str(out), "--steps", "9-7").exit_code == Exit.NOT_CONFORMING


@pytest.mark.parametrize(
    ("code", "text", "bits"),
    [
        # The ring has six triangles, no interior vertex: three bits a symbol.
        ("plain", "2T - 2 bits on spheres; by its counts on every surface", 18),
        ("context", "no bound for the worst case", None),
    ],
)
def test_info_says_what_is_guaranteed(
    tmp_path: Path, code: str, text: str, bits: int | None
) -> None:
    """TOOL-INFO-1, CODE-NAME-4."""
    packed = tmp_path / "ring.clers"
    clers("encode", RING, "-o", str(packed), "--code", code)
    said = json.loads(clers("info", str(packed), "--json").stdout)["file"]
    assert (said["guarantee"], said["most_bits"]) == (text, bits)
    line = f"guarantee of {code}: {text}; " + (
        f"{bits} bits here" if bits else "does not apply here"
    )
    assert line in clers("info", str(packed)).stdout.replace("\n", " ").replace("  ", " ")


def test_best_is_the_default(tmp_path: Path) -> None:
    """TOOL-ENCODE-2."""
    packed = tmp_path / "ring.clers"
    clers("encode", RING, "-o", str(packed))
    assert json.loads(clers("info", str(packed), "--json").stdout)["file"]["code"] == "best"


def test_a_code_for_spheres(tmp_path: Path) -> None:
    """TOOL-ENCODE-2, CODE-NAME-5: the enumerative code takes the cube and refuses the ring."""
    packed = tmp_path / "x.clers"
    options = ("-o", str(packed), "--code", "enumerative")
    assert clers("encode", RING, *options).exit_code == Exit.NOT_CONFORMING
    assert not packed.exists()
    assert clers("encode", str(MESHES / "cube.ply"), *options).exit_code == Exit.CONFORMING
    assert "enumerative" in clers("info", str(packed)).stdout
