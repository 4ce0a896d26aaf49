"""Codecs of other people through their adapters, and the same without them."""

import math
import subprocess
import sys
from functools import partial
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Final

import DracoPy
import msgspec
import numpy as np
import pytest
from typer.testing import CliRunner

from clers.cli.main import app
from clers.cli.output import Exit
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.adapter import answered
from clers.conformance.cases.case import Case
from clers.conformance.doctor import examine
from clers.conformance.judging.meshes import Differs, Same, compare
from clers.conformance.judging.needs import declared, needs
from clers.conformance.lines import line_of
from clers.conformance.messages import Failure, Lacking, Rejection, Reply
from clers.conformance.outcome import NoProcess
from clers.conventions.reason import Fault
from clers.meshfile.formats import Format
from clers.oracle.codecs import draco as draco_module
from clers.oracle.codecs import meshopt as meshoptimizer_module
from clers.oracle.codecs import prepared as prepared_module
from clers.oracle.codecs.codec import Answer, Codec, Missing
from clers.oracle.codecs.draco import draco, promise
from clers.oracle.codecs.files import files
from clers.oracle.codecs.meshopt import meshoptimizer
from clers.oracle.codecs.serving import introduction, serve

CORNERS: Final = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
SOLID: Final = ((0, 1, 2), (3, 2, 1), (0, 3, 1), (2, 3, 0))
CLERS: Final = f"{sys.executable} -c 'from clers.cli.main import main; main()'"
BESIDE: Final = Path(sys.executable).parent


def mesh(
    *more: tuple[int, int, int],
    at: tuple[float, ...] = (),
    f64: bool = False,
    error: tuple[float, float, float] | msgspec.UnsetType = msgspec.UNSET,
) -> form.ThroughForm:
    """A tetrahedron, with more faces and more vertices."""
    places = form.Places(precision="f64" if f64 else "f32", coordinates=CORNERS + at)
    return form.ThroughForm(
        faces=SOLID + more, vertices=4 + len(at) // 3, positions=places, error=error
    )


BARE: Final = form.ThroughForm(faces=SOLID, vertices=4)
STRAY: Final = form.ThroughForm(faces=((0, 1, 4),), vertices=4)


def served(codec: Codec | Missing) -> Codec:
    assert isinstance(codec, Codec), codec.why
    return codec


def through(codec: Codec | Missing, given: form.ThroughForm) -> Answer:
    return served(codec).through(given)


def kinds(codec: Codec | Missing, given: form.ThroughForm) -> list[tuple[str, int]]:
    """The differences that a codec makes, by name."""
    back = through(codec, given)
    assert isinstance(back, form.MeshForm), back
    found = compare(given, back)
    return [(d.kind, d.count) for d in found.differences] if isinstance(found, Differs) else []


# Draco

STANDARD: Final = draco("edgebreaker-standard", None)
VALENCE: Final = draco("edgebreaker-valence", None)
SEQUENTIAL: Final = draco("sequential", None)


def test_draco_says_what_it_is() -> None:
    """ORCL-CODEC-9."""
    codec = served(draco("sequential", 11))
    assert (codec.name, codec.language) == ("draco", "c++")
    assert codec.version == f"DracoPy {version('DracoPy')}"
    assert codec.policy == {"method": "sequential", "bits": "11"}
    assert served(STANDARD).policy == {"method": "edgebreaker-standard", "bits": "from the error"}


@pytest.mark.parametrize("codec", [STANDARD, VALENCE, SEQUENTIAL])
def test_draco_gives_a_tetrahedron_back(codec: Codec) -> None:
    """ORCL-CODEC-11: nothing is quantised where no error is allowed."""
    assert kinds(codec, mesh()) == []
    assert kinds(codec, BARE) == []
    back = codec.through(BARE)
    assert isinstance(back, form.MeshForm)
    assert back.positions is msgspec.UNSET


def test_differences_of_draco() -> None:
    """ORCL-CODEC-11: what Edgebreaker drops and splits, the sequential method keeps."""
    isolated = mesh(at=(5.0, 5.0, 5.0))
    thin = mesh((0, 0, 1))
    twice = mesh((1, 2, 0))
    assert kinds(STANDARD, isolated) == [("lost-isolated-vertices", 1)]
    assert kinds(STANDARD, thin) == [("dropped-degenerate-faces", 1)]
    assert kinds(STANDARD, twice) == [("vertices-split", 3)]
    assert kinds(VALENCE, isolated) == [("lost-isolated-vertices", 1)]
    assert [kinds(SEQUENTIAL, each) for each in (isolated, thin, twice)] == [[], [], []]
    touching = mesh((4, 5, 6), at=(0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 3.0, 3.0))
    assert kinds(SEQUENTIAL, touching) == [("vertices-merged", 1)]


def test_draco_without_the_adapter() -> None:
    """The same findings by DracoPy alone: they are not the adapter's. Clause: ORCL-CODEC-11."""
    places = np.array([*CORNERS, 5, 5, 5], dtype=np.float32).reshape(-1, 3)
    faces = np.array(SOLID, dtype=np.uint32)
    for level, vertices in ((5, 4), (7, 4), (0, 5)):
        data = DracoPy.encode(places, faces, quantization_bits=0, compression_level=level)
        assert len(DracoPy.decode(data).points) == vertices
    for more, shape in (((0, 0, 1), (4, 4)), ((1, 2, 0), (7, 5))):
        faces = np.array((*SOLID, more), dtype=np.uint32)
        data = DracoPy.encode(places[:4], faces, quantization_bits=0, compression_level=5)
        found = DracoPy.decode(data)
        assert (len(found.points), len(found.faces)) == shape


@pytest.mark.parametrize(("method", "coded"), [("sequential", 0), ("edgebreaker-standard", 1)])
def test_method_of_draco(method: str, coded: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-CODEC-11: byte 8 of a Draco file names the method."""
    written: list[bytes] = []
    encode = DracoPy.encode

    def seen(*given: object, **named: object) -> bytes:
        written.append(bytes(encode(*given, **named)))
        return written[-1]

    monkeypatch.setattr(DracoPy, "encode", seen)
    assert kinds(draco(method, None), mesh()) == []
    assert [data[8] for data in written] == [coded]


def test_valence_method_of_draco() -> None:
    """ORCL-CODEC-11: the level at which Draco takes valences, from 1000 faces on."""
    assert draco_module.LEVELS["edgebreaker-valence"] == 7


@pytest.mark.parametrize("bits", [1, 4, 11, 20])
def test_promise_of_draco(bits: int) -> None:
    """ORCL-CODEC-11: no coordinate moves further than half a step, and a little for rounding."""
    places = [((i * 37) % 101 / 7, (i * 53) % 97 / 3, i / 11) for i in range(60)]
    singles = tuple(float(np.float32(x)) for place in places for x in place)
    strip = tuple((i, i + 1, i + 2) for i in range(58))
    bound = promise(np.array(singles).reshape(-1, 3), bits)
    extent = max(max(singles[k::3]) - min(singles[k::3]) for k in range(3))
    most = max(map(abs, singles))
    assert bound == pytest.approx(extent / (2**bits - 1) / 2 + most / 2**22)
    at = form.Places(precision="f32", coordinates=singles)
    given = form.ThroughForm(faces=strip, vertices=60, positions=at)
    back = through(draco("sequential", bits), given)
    assert isinstance(back, form.MeshForm)
    assert isinstance(back.positions, form.Places)
    moved = [abs(x - y) for x, y in zip(singles, back.positions.coordinates, strict=True)]
    assert max(moved) <= bound
    assert max(moved) > bound / 3


@pytest.mark.parametrize(("room", "bits"), [(0.5, 1), (0.26, 2), (0.1, 3), (0.0, 0), (1e-12, 0)])
def test_bits_from_the_error(room: float, bits: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-CODEC-11: the fewest bits whose half step is small enough; none if none are."""
    asked: list[object] = []
    encode = DracoPy.encode

    def seen(*given: object, quantization_bits: int, compression_level: int) -> bytes:
        asked.append(quantization_bits)
        return bytes(
            encode(*given, quantization_bits=quantization_bits, compression_level=compression_level)
        )

    monkeypatch.setattr(DracoPy, "encode", seen)
    given = mesh(error=(1.0, room * 1.000001, 1.0))
    back = through(STANDARD, given)
    assert isinstance(back, form.MeshForm)
    assert asked == [bits]
    assert isinstance(compare(given, back, (1.0, room * 1.000001, 1.0)), Same)


def test_draco_knows_binary32_alone() -> None:
    """ORCL-CODEC-1, ORCL-CODEC-11: what rounding moves too far is not supported."""
    fine = mesh((0, 1, 4), at=(0.1, 0.0, 0.0), f64=True)
    assert through(SEQUENTIAL, fine) == Lacking("error")
    off = abs(float(np.float32(0.1)) - 0.1)
    wide = mesh((0, 1, 4), at=(0.1, 0.0, 0.0), f64=True, error=(off, 0.0, 0.0))
    assert isinstance(through(SEQUENTIAL, wide), form.MeshForm)
    tight = mesh((0, 1, 4), at=(0.1, 0.0, 0.0), f64=True, error=(off / 2, 9.0, 9.0))
    assert through(SEQUENTIAL, tight) == Lacking("error")
    assert isinstance(through(draco("sequential", 20), fine), form.MeshForm)


def test_draco_refuses() -> None:
    """ORCL-CODEC-11: all faces degenerate, or nothing at all; faces alone may be none."""
    thin = form.ThroughForm(faces=((0, 0, 1),), vertices=2)
    assert through(STANDARD, thin) == Rejection(
        Fault.INVALID, detail="DracoPy: EncodingFailedException: Invalid mesh"
    )
    nothing = through(SEQUENTIAL, form.ThroughForm(faces=(), vertices=0))
    assert isinstance(nothing, Rejection)
    assert nothing.detail.startswith("DracoPy: ValueError: ")
    cloud = through(SEQUENTIAL, form.ThroughForm(faces=(), vertices=3))
    assert cloud == form.MeshForm(faces=(), vertices=3)


# meshoptimizer


@pytest.mark.parametrize("method", ["triangles", "sequence"])
@pytest.mark.parametrize("f64", [False, True])
def test_meshoptimizer_keeps_everything(method: str, f64: bool) -> None:
    """ORCL-CODEC-12: dirty or not, in binary32 or binary64."""
    codec = meshoptimizer(method)
    fine = (0.1, 0.2, 0.3) if f64 else (5.0, 6.0, 7.0)
    for given in (mesh(), mesh((0, 0, 1), (1, 2, 0), at=fine, f64=f64), BARE):
        assert kinds(codec, given) == []
    back = through(codec, mesh(f64=f64))
    assert isinstance(back, form.MeshForm)
    assert isinstance(back.positions, form.Places)
    assert back.positions.precision == ("f64" if f64 else "f32")
    assert served(codec).policy == {"method": method}
    assert served(codec).version == version("meshoptimizer")


def test_methods_of_meshoptimizer_differ() -> None:
    """ORCL-CODEC-12: the triangle codec turns faces, the sequence codec does not."""
    assert through(meshoptimizer("sequence"), BARE) == form.MeshForm(faces=SOLID, vertices=4)
    turned = through(meshoptimizer("triangles"), BARE)
    assert isinstance(turned, form.MeshForm)
    assert turned.faces != SOLID


def test_meshoptimizer_refuses(monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-CODEC-12."""
    codec = meshoptimizer("triangles")
    found = through(codec, mesh(at=(0.1, 0.0, 0.0)))
    assert found == Rejection(
        Fault.INVALID, "not-representable", detail="a coordinate is no binary32 value"
    )
    import meshoptimizer as library

    def fails(*_: object) -> bytes:
        raise RuntimeError("no room")

    monkeypatch.setattr(library, "encode_index_buffer", fails)
    assert through(codec, BARE) == Rejection(
        Fault.INVALID, detail="meshoptimizer: RuntimeError: no room"
    )


# what no codec is asked


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


# files


def of_files(encode: str, decode: str, kind: Format = Format.PLY, **named: float) -> Codec:
    return served(files(encode, decode, kind, seconds=named.get("seconds", 60.0)))


COPY: Final = "cp {in} {out}"


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


# the adapter


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
