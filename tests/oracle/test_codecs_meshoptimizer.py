"""meshoptimizer through its adapter."""

from importlib.metadata import version

import pytest
from through_codecs import BARE, SOLID, kinds, mesh, served, through

from clers.conformance import payloads as form
from clers.conformance.messages import Rejection
from clers.conventions.reason import Fault
from clers.oracle.codecs.meshopt import meshoptimizer


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
