"""Where two results of one operation part: each kind of result has its own module."""

from clers.conformance import payloads as form
from clers.conformance.cases.case import Comparison
from clers.conformance.judging.bits import of_bits
from clers.conformance.judging.faces import of_mesh
from clers.conformance.judging.files import of_file
from clers.conformance.judging.isomorphic import Undecidable, of_isomorphic
from clers.conformance.judging.judged import Divergence
from clers.conformance.judging.known import Known
from clers.conformance.judging.surfaces import of_components, of_stages
from clers.conformance.judging.symbols import of_symbols
from clers.conformance.judging.values import of_value
from clers.conformance.judging.words import of_encoding, of_word
from clers.conformance.results import Result


def of_results(
    right: Result, got: Result, compare: Comparison, known: Known
) -> Divergence | Undecidable | None:
    """The first place where a result is not as it should be, if there is one. Total.

    Clauses: ORCL-JUDGE-2, ORCL-JUDGE-3, ORCL-JUDGE-4, ORCL-DIVERGE-1 … ORCL-DIVERGE-12.
    """
    match right, got:
        case form.Classified(), form.Classified():
            return of_components(right, got)
        case form.Stages(), form.Stages():
            return of_stages(right, got)
        case form.BitString(), form.BitString():
            return of_bits(right, got, known.groups)
        case form.Symbols(), form.Symbols():
            return of_symbols(right, got)
        case form.WordForm(), form.WordForm():
            return of_encoding(right, got, known.walk)
        case form.JustWord(), form.JustWord():
            return of_word(right.word, got.word)
        case form.FileForm(), form.FileForm():
            return of_file(right, got)
        case form.Faces(), form.Faces() if compare == "isomorphic":
            return of_isomorphic(right, got, known.request)
        case form.Faces(), form.Faces():
            return of_mesh(right, got, known.walk)
        case dict(), dict():
            return of_value(right, got)
        case _:
            return Divergence(
                kind="form",
                place="the form of the result",
                expected=type(right).__name__,
                got=type(got).__name__,
            )
