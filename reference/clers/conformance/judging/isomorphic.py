"""Where meshes part whose labels and orders are free. Clause: ORCL-JUDGE-3."""

from clers.complexes.isomorphism import Different, isomorphism
from clers.conformance import payloads as form
from clers.conformance.judging.judged import Divergence
from clers.conformance.served.forms import surface_of
from clers.conventions.result import Rejected


def of_isomorphic(right: form.Faces, got: form.Faces) -> Divergence | None:
    """Why there is no isomorphism between two surfaces, if there is none. Clause: ORCL-JUDGE-3."""
    one, other = surface_of(right), surface_of(got)
    if isinstance(one, Rejected) or isinstance(other, Rejected):
        said = [r.line() if isinstance(r, Rejected) else "a surface" for r in (one, other)]
        return _at("surface", said[0], said[1])
    found = isomorphism(one.value, other.value)
    if isinstance(found, Different):
        return _at(str(found.what), "the same surface", found.detail)
    return None


def _at(kind: str, expected: str, got: str) -> Divergence:
    return Divergence(kind=kind, place="the mesh", expected=expected, got=got)
