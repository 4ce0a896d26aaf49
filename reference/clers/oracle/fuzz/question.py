"""A request as a case: the reference says what is right to answer. Clause: ORCL-FUZZ-2."""

from collections.abc import Mapping
from typing import Final

import msgspec
from msgspec import UNSET, Raw

from clers.conformance import payloads as form
from clers.conformance.cases.case import Case, Origin
from clers.conformance.cases.identity import named
from clers.conformance.messages import OkReply, Operation, RejectReply, Roundtrip
from clers.conformance.serve import serve
from clers.conventions.clause import Clause
from clers.oracle.fuzz.requires import requires

CLAUSES: Final[Mapping[str, tuple[Clause, ...]]] = {
    "echo": (Clause.ORCL_OP_1,),
    "surface.classify": (Clause.CPLX_COMPONENT_1, Clause.CPLX_COMPONENT_3),
    "operator.apply": (Clause.OPER_FAMILY_2, Clause.OPER_FAMILY_3),
    "arithmetic.encode": (Clause.ORCL_OP_4,),
    "arithmetic.decode": (Clause.ORCL_OP_4,),
    "word.encode": (Clause.EB_DECODE_1, Clause.EB_ORDER_2),
    "word.decode": (Clause.EB_DECODE_1, Clause.EB_DECODE_2),
    "code.encode": (Clause.CODE_NAME_2,),
    "code.decode": (Clause.CODE_NAME_2,),
    "mesh.encode": (Clause.FILE_ROUND_1,),
    "mesh.decode": (Clause.FILE_ROUND_1,),
    "codec.roundtrip": (Clause.ORCL_OP_8,),
}
"""What an answer is judged by, where no clause is broken by the input."""


def name_of(operation: Operation) -> str:
    """The operation's name."""
    return str(type(operation).__struct_config__.tag)


def question(operation: Operation, origin: Origin = "shrunk") -> Case | None:
    """The request as a case with the reference's answer, or none where that has none.

    A mesh that went through a codec is compared with itself, up to names.
    Clauses: ORCL-FUZZ-2, ORCL-FIND-4.
    """
    name = name_of(operation)
    names, size = requires(operation)
    raw = Raw(msgspec.json.encode(operation.input))
    case = Case(
        id="unnamed-aaaaaaaa",
        op=name,
        clauses=tuple(map(str, CLAUSES[name])),
        origin=origin,
        requires=names,
        size=size,
        input=raw,
    )
    last = serve(msgspec.structs.replace(operation, trace="none"))[-1]
    match last:
        case OkReply(ok=ok):
            right = msgspec.structs.replace(case, ok=ok)
            if isinstance(operation, Roundtrip):
                same = Raw(msgspec.json.encode(_mesh(operation.input)))
                right = msgspec.structs.replace(case, ok=same, compare="isomorphic")
        case RejectReply(reject=rejection):
            cited = (rejection.clause,) if rejection.clause else case.clauses
            right = msgspec.structs.replace(case, reject=rejection, clauses=cited)
        case _:
            return None
    return named(f"found-{name.replace('.', '-')}", right)


def _mesh(given: form.MeshForm) -> form.MeshForm:
    """The mesh alone."""
    return form.MeshForm(faces=given.faces, vertices=given.vertices, positions=given.positions)


def kind_of(case: Case) -> str:
    """What kind of answer is right: a result, or the reason of a rejection. ORCL-SHRINK-1."""
    return "a result" if case.reject is UNSET else f"{case.reject.fault} {case.reject.reason}"
