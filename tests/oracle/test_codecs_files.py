"""Codecs that are two commands, which read and write files."""

import sys
from pathlib import Path

import pytest
from through_codecs import BARE, BESIDE, CLERS, COPY, kinds, mesh, of_files, served

from clers.conformance import payloads as form
from clers.conformance.judging.meshes import Differs, compare
from clers.conformance.messages import Failure, Rejection
from clers.meshfile.formats import Format
from clers.oracle.codecs.codec import Missing
from clers.oracle.codecs.files import files


@pytest.mark.parametrize("kind", [Format.PLY, Format.OFF, Format.OBJ])
def test_files_that_are_copied(kind: Format) -> None:
    """ORCL-CODEC-13: whatever the format can hold comes back."""
    codec = of_files(COPY, COPY, kind)
    dirty = mesh((0, 0, 1), (1, 2, 0), at=(0.5, 6.0, 7.0))
    assert kinds(codec, dirty) == []
    assert kinds(codec, BARE) == []
    assert (codec.name, codec.version, codec.language) == ("cp", "", "")
    assert codec.policy == {"encode": COPY, "decode": COPY, "format": str(kind)}


def test_format_that_cannot_hold_a_mesh() -> None:
    """ORCL-CODEC-13."""
    found = of_files(COPY, COPY, Format.STL).through(mesh(at=(5.0, 5.0, 5.0)))
    assert isinstance(found, Rejection)
    assert found.reason == "not-representable"
    assert found.detail.startswith("stl cannot hold it: ")


def test_own_codec_as_two_commands() -> None:
    """ORCL-CODEC-13: `clers encode` and `clers decode`; what is no surface is rejected."""
    codec = served(
        files(
            f"{CLERS} encode {{in}} -o {{out}}",
            f"{CLERS} decode {{in}} -o {{out}}",
            Format.PLY,
            ".clers",
            60.0,
        )
    )
    assert kinds(codec, mesh()) == []
    found = codec.through(mesh((0, 0, 1)))
    assert isinstance(found, Rejection)
    assert found.detail.startswith("the encoder ended with exit code 1: ")
    assert found.detail.endswith("[CPLX-REJECT-4]: (0, 0, 1)")


def test_draco_as_two_commands() -> None:
    """ORCL-CODEC-13: the programs that come with DracoPy."""
    codec = served(
        files(
            f"{BESIDE / 'draco_encoder'} -i {{in}} -o {{out}} -qp 0",
            f"{BESIDE / 'draco_decoder'} -i {{in}} -o {{out}}",
            Format.PLY,
            ".drc",
            60.0,
        )
    )
    assert kinds(codec, mesh()) == []
    assert kinds(codec, mesh(at=(5.0, 5.0, 5.0))) == [("lost-isolated-vertices", 1)]


def script(tmp_path: Path, text: str) -> str:
    """A command line of a Python program that is given the two files."""
    path = tmp_path / "program.py"
    path.write_text(f"import sys\nsource, target = sys.argv[1:]\n{text}\n")
    return f"{sys.executable} -S {path} {{in}} {{out}}"


def test_lossy_codec_is_found_out(tmp_path: Path) -> None:
    """ORCL-CODEC-13, ORCL-CODEC-6: a decoder that forgets the last face and moves a vertex."""
    lossy = script(
        tmp_path,
        "lines = open(source).read().splitlines()[:-1]\n"
        "lines[1] = '4 3 0'\n"
        "lines[5] = '0.0 0.0 1.5'\n"
        "open(target, 'w').write('\\n'.join(lines))",
    )
    given = mesh()
    back = of_files(COPY, lossy, Format.OFF).through(given)
    assert isinstance(back, form.MeshForm)
    found = compare(given, back, (0.0, 0.0, 0.5))
    assert isinstance(found, Differs)
    assert [(d.kind, d.count) for d in found.differences] == [("faces-lost", 1)]
    strict = compare(given, back, (0.25, 0.25, 0.25))
    assert isinstance(strict, Differs)
    assert [(d.kind, d.count, d.by, d.axis) for d in strict.differences] == [
        ("faces-lost", 1, 0.0, ""),
        ("position-moved", 1, 0.5, "z"),
    ]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("sys.exit(0)", "ended well and wrote no file: "),
        ("import os; os.kill(os.getpid(), 9)", "was ended by signal 9: "),
        ("import time; time.sleep(9)", "took more than 0.5 s"),
    ],
)
def test_commands_that_break(tmp_path: Path, text: str, said: str) -> None:
    """ORCL-CODEC-13: of the encoder and of the decoder it is an error."""
    bad = script(tmp_path, text)
    for codec in (
        of_files(bad, COPY, seconds=0.5 if "took" in said else 60.0),
        of_files(COPY, bad, seconds=0.5 if "took" in said else 60.0),
    ):
        assert codec.through(BARE) == Failure(f"{sys.executable} {said}")


def test_exit_codes(tmp_path: Path) -> None:
    """ORCL-CODEC-13: the encoder may refuse, the decoder may not."""
    bad = script(tmp_path, "print('also  this'); sys.exit('x' * 500 + ' not\\nthis mesh')")
    refused = of_files(bad, COPY).through(BARE)
    assert isinstance(refused, Rejection)
    start = "the encoder ended with exit code 1: "
    assert refused.detail.startswith(f"{start}xxx")
    assert refused.detail.endswith("xxx not this mesh also this")
    assert len(refused.detail) == len(start) + 400
    broken = of_files(COPY, bad).through(BARE)
    assert isinstance(broken, Failure)
    assert broken.message.startswith("the decoder ended with exit code 1: xxx")


def test_decoder_that_writes_no_mesh() -> None:
    """ORCL-CODEC-13."""
    found = of_files(COPY, f"cp {__file__} {{out}}{{in}}").through(BARE)
    assert isinstance(found, Failure)
    nothing = of_files(COPY, "sh -c 'echo no ply > $1' {in} {out}").through(BARE)
    assert isinstance(nothing, Failure)
    assert nothing.message.startswith("what the decoder wrote is no ply file: ")


def test_folders_are_removed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-CODEC-13."""
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    of_files(COPY, COPY).through(BARE)
    of_files("false {in} {out}", COPY).through(BARE)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("encode", "why"),
    [
        ("cp {in} 'x", "--encode: No closing quotation"),
        ("cp {in} x", "--encode: there is no {out} in 'cp {in} x'"),
        ("cp", "--encode: there is no {in} and no {out} in 'cp'"),
        ("", "--encode: there is no {in} and no {out} in ''"),
        ("no-such-thing {in} {out}", "--encode: no program 'no-such-thing' is found"),
    ],
)
def test_command_lines_that_are_none(encode: str, why: str) -> None:
    """ORCL-CODEC-10."""
    assert files(encode, COPY, Format.PLY) == Missing(why)
    assert files(COPY, encode, Format.PLY) == Missing(why.replace("--encode", "--decode"))
