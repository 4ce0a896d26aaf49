"""What every adapter of a codec says, and what no codec is asked."""

import math
import subprocess
import sys
from functools import partial
from importlib.metadata import PackageNotFoundError, version
from typing import Final

import msgspec
import pytest
from through_codecs import (
    BARE,
    COPY,
    CORNERS,
    STANDARD,
    STRAY,
    mesh,
    served,
)
from typer.testing import CliRunner

from clers.cli.main import app
from clers.cli.output import Exit
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.adapter import answered
from clers.conformance.cases.case import Case
from clers.conformance.doctor import examine
from clers.conformance.judging.needs import declared, needs
from clers.conformance.lines import line_of
from clers.conformance.messages import Failure, Lacking, Rejection, Reply
from clers.conformance.outcome import NoProcess
from clers.conventions.reason import Fault
from clers.meshfile.formats import Format
from clers.oracle.codecs import draco as draco_module
from clers.oracle.codecs import meshopt as meshoptimizer_module
from clers.oracle.codecs import prepared as prepared_module
from clers.oracle.codecs.codec import Answer, Codec
from clers.oracle.codecs.files import files
from clers.oracle.codecs.meshopt import meshoptimizer
from clers.oracle.codecs.serving import introduction, serve


@pytest.mark.parametrize("codec", [STANDARD, meshoptimizer("sequence")])
def test_bad_meshes_are_not_handed_on(codec: Codec) -> None:
    """ORCL-CODEC-9."""
    assert codec.through(STRAY) == Rejection(
        Fault.INVALID, "index-out-of-range", detail="face 0 is (0, 1, 4), there are 4 vertices"
    )
    below = form.ThroughForm(faces=((0, 1, 2), (0, -1, 2)), vertices=3)
    assert codec.through(below) == Rejection(
        Fault.INVALID, "index-out-of-range", detail="face 1 is (0, -1, 2), there are 3 vertices"
    )
    few = form.ThroughForm(
        faces=(), vertices=2, positions=form.Places(precision="f32", coordinates=CORNERS[:5])
    )
    assert codec.through(few) == Rejection(
        Fault.INVALID, "count-mismatch", detail="5 coordinates for 2 vertices"
    )
    many = form.ThroughForm(faces=(), vertices=(1 << 26) + 1)
    assert codec.through(many) == Rejection(
        Fault.LIMIT,
        "too-many-vertices",
        detail="67108865 vertices, at most 67108864 are handed on",
    )


def test_places_for_a_mesh_without() -> None:
    """ORCL-CODEC-9."""
    found = prepared_module.prepared(form.ThroughForm(faces=(), vertices=4098))
    assert isinstance(found, prepared_module.Prepared)
    assert found.places[[0, 1, 4095, 4096, 4097]].tolist() == [
        [0, 0, 0], [1, 0, 0], [4095, 0, 0], [0, 1, 0], [1, 1, 0],
    ]  # fmt: skip


def told(answer: Answer, _: form.ThroughForm) -> Answer:
    return answer


HELLO: Final = message.Hello(0, 1, "1.0", "")


def one(reply: tuple[Reply, ...]) -> Reply:
    assert len(reply) == 1
    return reply[0]


def test_adapter_of_a_codec() -> None:
    """ORCL-CODEC-9."""
    codec = served(meshoptimizer("sequence"))
    hello = one(serve(codec, HELLO))
    assert isinstance(hello, message.OkReply)
    said = msgspec.json.decode(hello.ok, type=message.Introduction)
    assert said.ops == ("echo", "codec.roundtrip")
    assert said.caps == message.Caps(
        handles=True, boundaries="many", components=True, max_faces=1 << 26, max_symbols=0
    )
    assert (said.name, said.version, said.language, said.protocol) == (
        "meshoptimizer", version("meshoptimizer"), "c++", 1,
    )  # fmt: skip
    assert said.policy == {"method": "sequence"}
    other = one(serve(codec, message.Hello(0, 2, "1.0", "")))
    assert other == message.UnsupportedReply(0, Lacking("protocol"))
    echo = one(serve(codec, message.Echo(id=5, input={"a": [1]})))
    assert echo == message.OkReply(5, msgspec.Raw(b'{"a":[1]}'))
    word = one(serve(codec, message.Classify(id=6, input=BARE)))
    assert word == message.UnsupportedReply(6, Lacking("surface.classify"))
    back = one(serve(codec, message.Roundtrip(id=7, input=BARE)))
    assert isinstance(back, message.OkReply)
    assert back.id == 7
    assert serve(codec, message.Bye()) == ()


def test_precisions_are_declared() -> None:
    """ORCL-CODEC-16: Draco keeps binary32 alone, so that cases in binary64 are skipped."""
    said: dict[str, message.Introduction] = {}
    for codec in (STANDARD, meshoptimizer("sequence"), files(COPY, COPY, Format.PLY)):
        said[served(codec).name] = introduction(served(codec))
    assert {name: each.caps.positions for name, each in said.items()} == {
        "draco": ("f32",), "meshoptimizer": ("f32", "f64"), "cp": ("f32", "f64"),
    }  # fmt: skip
    for given, lacking in ((mesh(), None), (mesh(f64=True), "positions.f64"), (BARE, None)):
        case = Case(
            id="x-aaaaaaaa", op="codec.roundtrip", clauses=(), origin="hand",
            input=msgspec.Raw(msgspec.json.encode(given)),
        )  # fmt: skip
        assert needs(case, said["draco"]) == lacking
        assert needs(case, said["meshoptimizer"]) is None
        word = msgspec.structs.replace(case, op="echo")
        assert needs(word, said["draco"]) is None
    assert declared("positions.f32", said["draco"].caps)
    old = msgspec.json.decode(
        b'{"handles":true,"boundaries":"many","components":true,"max_faces":1,"max_symbols":1}',
        type=message.Caps,
    )
    assert old.positions == ("f32", "f64")


def test_every_answer_of_a_codec_has_its_reply() -> None:
    """ORCL-CODEC-9, ORCL-CODEC-2."""
    far = form.Places(precision="f32", coordinates=(math.inf, 0.0, 0.0))
    for answer, reply in (
        (Lacking("error"), message.UnsupportedReply(3, Lacking("error"))),
        (Rejection(Fault.INVALID), message.RejectReply(3, Rejection(Fault.INVALID))),
        (Failure("broken"), message.ErrorReply(3, Failure("broken"))),
        (
            form.MeshForm(faces=(), vertices=1, positions=far),
            message.ErrorReply(3, Failure("a coordinate that came back is no finite number")),
        ),
    ):
        codec = Codec("x", "1", "c", partial(told, answer))
        assert one(serve(codec, message.Roundtrip(id=3, input=BARE))) == reply


def test_error_in_a_request() -> None:
    """ORCL-CODEC-1: three numbers, none negative."""
    line = b'{"op":"codec.roundtrip","id":4,"in":{"faces":[],"vertices":1,"error":[%b]}}'
    codec = served(meshoptimizer("sequence"))
    for error, good in ((b"0,1,0.5", True), (b"0,-1,0", False), (b"0,0", False)):
        replies = answered(line % error, lambda request: serve(codec, request))
        assert not isinstance(replies, message.Bye)
        assert isinstance(one(replies), message.OkReply) == good


@pytest.mark.parametrize(
    "arguments",
    [
        ["draco", "--method", "sequential", "--quantization", "12"],
        ["files", "--encode", COPY, "--decode", COPY, "--format", "off"],
    ],
)
def test_doctor_passes_codecs(arguments: list[str]) -> None:
    """ORCL-CODEC-9, ORCL-DOCTOR-1."""
    code = "from clers.cli.main import main; main()"
    found = examine((sys.executable, "-c", code, "adapter", *arguments))
    assert not isinstance(found, NoProcess)
    assert [finding for finding in found if not finding.passed] == []


def test_what_is_missing_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-CODEC-10: one line, exit code 3."""
    ran = CliRunner().invoke(app, ["adapter", "files", "--encode", "x", "--decode", COPY])
    assert (ran.exit_code, ran.stdout) == (Exit.ADAPTER, "")
    assert ran.stderr == "--encode: there is no {in} and no {out} in 'x'\n"

    def none(_: str) -> str:
        raise PackageNotFoundError

    for module, name in ((draco_module, "draco"), (meshoptimizer_module, "meshoptimizer")):
        monkeypatch.setattr(module, "version", none)
        ran = CliRunner().invoke(app, ["adapter", name])
        assert ran.exit_code == Exit.ADAPTER
        assert ran.stderr.endswith(" is not installed: pip install 'clers[peers]'\n")
        assert ran.stderr.count("\n") == 1


@pytest.mark.parametrize(
    "arguments",
    [
        ["draco", "--method", "x"],
        ["meshoptimizer", "--method", "x"],
        ["files", "--encode", COPY, "--decode", COPY, "--format", "x"],
        ["draco", "--quantization", "31"],
    ],
)
def test_options_that_are_none(arguments: list[str]) -> None:
    """TOOL-EXIT-1."""
    assert CliRunner().invoke(app, ["adapter", *arguments]).exit_code == Exit.USAGE


NOISY: Final = """
import os, sys, DracoPy
real = DracoPy.encode
def noisy(*given, **named):
    os.write(1, b"encoding\\n")
    print("encoding")
    return real(*given, **named)
DracoPy.encode = noisy
from clers.cli.main import main
main()
"""


def test_library_that_prints_does_no_harm() -> None:
    """ORCL-CODEC-9, ORCL-LINE-1; and by default the method is what the option's help says."""
    hello = line_of(HELLO)
    ask = line_of(message.Roundtrip(id=1, input=mesh()))
    ran = subprocess.run(
        [sys.executable, "-P", "-c", NOISY, "adapter", "draco"],
        input=hello + ask + b'{"op":"bye"}\n',
        capture_output=True,
        check=True,
    )
    said, back = ran.stdout.splitlines()
    assert msgspec.json.decode(said)["ok"]["policy"]["method"] == "edgebreaker-standard"
    assert msgspec.json.decode(back)["ok"]["vertices"] == 4
    assert ran.stderr.count(b"encoding") == 2
