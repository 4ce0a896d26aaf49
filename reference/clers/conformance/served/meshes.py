"""`mesh.encode`, `mesh.decode` and `codec.roundtrip`."""

from typing import assert_never

from clers.codes.registry import CodeName
from clers.conformance import payloads as form
from clers.conformance.served.forms import mesh_form, mesh_of
from clers.container.file import decode as decode_file
from clers.container.file import encode as encode_file
from clers.container.options import Accuracy, Exact, InBits, OnLattice, Options, WithinError
from clers.conventions.result import Accepted, Rejected, and_then
from clers.geometry.mesh import Mesh


def encode(code: CodeName, given: form.ToFile) -> Accepted[form.FileForm] | Rejected:
    """A mesh to the bytes of its file. Clause: ORCL-OP-7."""
    options = Options(code, _accuracy(given.accuracy))
    data = and_then(mesh_of(given), lambda m: encode_file(m.surface, m.positions, options))
    return and_then(data, lambda b: Accepted(form.FileForm(hex=b.hex())))


def _accuracy(given: form.AccuracyForm) -> Accuracy:
    match given:
        case form.ExactForm():
            return Exact()
        case form.LatticeForm(exponent=exponent):
            return OnLattice(exponent)
        case form.BitsForm(bits=bits):
            return InBits(bits)
        case form.ErrorForm(bound=bound):
            return WithinError(bound)
        case _:
            assert_never(given)


def decode(given: form.FileForm) -> Accepted[form.MeshForm] | Rejected:
    """The bytes of a file to its mesh. Clause: ORCL-OP-7."""
    return and_then(decode_file(bytes.fromhex(given.hex)), lambda m: Accepted(mesh_form(m)))


def roundtrip(given: form.MeshForm) -> Accepted[form.MeshForm] | Rejected:
    """A mesh through a file with every bit of its positions. Clause: ORCL-OP-8."""

    def there_and_back(mesh: Mesh) -> Accepted[Mesh] | Rejected:
        return and_then(encode_file(mesh.surface, mesh.positions), decode_file)

    return and_then(and_then(mesh_of(given), there_and_back), lambda m: Accepted(mesh_form(m)))
