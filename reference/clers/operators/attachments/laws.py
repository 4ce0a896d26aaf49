"""The laws of attachments."""

from typing import Final

from clers.complexes.homology import Field, betti, boundary_rows, rank
from clers.complexes.simplicial import (
    Complex,
    closure,
    dimension,
    euler,
    is_pure,
    of_dimension,
)
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE
from clers.operators.attachments.apply import NOTHING, apply, run
from clers.operators.attachments.attachment import added, attach, attachment, malformed
from clers.operators.attachments.classes import growth, handles
from clers.operators.attachments.examples import build
from clers.operators.attachments.given import (
    GLUABLE,
    OPERATOR_STEPS,
    SCRIPTS,
    SMALL_COMPLEXES,
    UNNAMED,
    AnyScript,
    Gluable,
    OperatorStep,
    Unnamed,
)
from clers.operators.attachments.gluing import fits, named, quotient_is_complex
from clers.operators.attachments.laws_curves import LAWS as CURVES
from clers.operators.attachments.laws_manifolds import LAWS as MANIFOLDS
from clers.operators.attachments.laws_simplex import LAWS as SIMPLEX
from clers.operators.attachments.operator import Undo, inverse, parts
from clers.operators.attachments.text import read, write


def _attached(given: Gluable) -> Verdict:
    """K' = K ∪ σ̄ where A = K ∩ σ̄ and σ is new, and a complex; else a rejection."""
    k, glued = given.before, given.glued
    result = attach(k, glued)
    whole = closure([glued.simplex])
    fits_here = (
        closure(glued.along).simplices == k.simplices & whole.simplices
        and frozenset(glued.simplex) not in k.simplices
    )
    if not fits_here:
        return same(True, isinstance(result, Rejected))
    union = closure([*k.simplices, glued.simplex])
    return same(Accepted(union), result)


def _led_back(step: OperatorStep) -> Verdict:
    """What an operator did, its inverse undoes."""
    after = apply(step.operator, step.before)
    if isinstance(after, Rejected):
        return Holds()
    return same(Accepted(step.before), apply(inverse(step.operator), after.value))


def _undone_exactly(step: OperatorStep) -> Verdict:
    """An operator can be undone exactly if it leads here from a complex."""
    done = step.operator.done if isinstance(step.operator, Undo) else step.operator
    glued = parts(done)
    if any(malformed(part) is not None for part in glued):
        return same(True, isinstance(apply(Undo(done), step.before), Rejected))
    rest = Complex(step.before.simplices - frozenset(s for part in glued for s in added(part)))
    leads_here = closure(rest.simplices) == rest and apply(done, rest) == Accepted(step.before)
    return same(leads_here, isinstance(apply(Undo(done), step.before), Accepted))


def _grown(given: Gluable) -> Verdict:
    """The numbers of simplices and χ change as the formulas say."""
    after = attach(given.before, given.glued)
    if isinstance(after, Rejected):
        return Holds()
    foreseen = growth(given.glued)
    counted = tuple(
        len(of_dimension(after.value, k)) - len(of_dimension(given.before, k))
        for k in range(len(given.glued.simplex))
    )
    return every(
        same(foreseen.counts, counted),
        same(foreseen.euler, euler(after.value) - euler(given.before)),
    )


def _relative(given: Gluable) -> Verdict:
    """The homology of K' relative to K has dimension h_k in degree k."""
    after = attach(given.before, given.glued)
    if isinstance(after, Rejected):
        return Holds()
    m = len(given.glued.simplex) - 1
    new = Complex(after.value.simplices - given.before.simplices)
    cells = [of_dimension(new, k) for k in range(m + 2)]
    ranks = [0, *(rank(boundary_rows(cells[k - 1], cells[k]), Field.GF2) for k in range(1, m + 2))]
    found = tuple(len(cells[k]) - ranks[k] - ranks[k + 1] for k in range(m + 1))
    return same(handles(given.glued), found)


def _handles_act(given: Gluable) -> Verdict:
    """Each k-handle makes a cycle of dimension k or fills one of dimension k − 1."""
    after = attach(given.before, given.glued)
    if isinstance(after, Rejected):
        return Holds()
    top = max(dimension(after.value), 0) + 2
    old, new = ((*betti(k, Field.GF2), *[0] * top)[:top] for k in (given.before, after.value))
    h = (*handles(given.glued), *[0] * top)
    filling = 0  # of the handles of this index, those that fill a cycle of the dimension below
    verdicts: list[Verdict] = []
    for k in range(top):
        making = h[k] - filling
        filling = making - (new[k] - old[k])
        if not (0 <= making <= h[k] and 0 <= filling <= h[k + 1]):
            verdicts.append(Fails(f"handles {h[:top]}", f"{old} → {new}", WHOLE))
    return every(*verdicts, same(0, filling))


def _built(k: Complex) -> Verdict:
    """A script of attachments builds the complex, and its inverses take it apart."""
    script = build(k)
    back = tuple(inverse(operator) for operator in reversed(script))
    last: Accepted[Complex] | Rejected = (Accepted(NOTHING), *run(script))[-1]
    apart = and_then(last, lambda whole: (Accepted(whole), *run(back, whole))[-1])
    return every(same(Accepted(k), last), same(Accepted(NOTHING), apart))


def _written(given: AnyScript) -> Verdict:
    return same(Accepted(given.script), read(write(given.script)))


def _run(given: AnyScript) -> Verdict:
    """Each step is the operator on what the one before left; nothing follows a rejection."""
    k = NOTHING
    steps = run(given.script)
    for operator, step in zip(given.script, steps, strict=False):
        if apply(operator, k) != step:
            return Fails(repr(apply(operator, k)), repr(step), WHOLE)
        k = step.value if isinstance(step, Accepted) else k
    stopped = [i for i, step in enumerate(steps) if isinstance(step, Rejected)]
    full = len(given.script) if not stopped else stopped[0] + 1
    return same(full, len(steps))


def _named(given: Unnamed) -> Verdict:
    """A gluing that fits is an attachment exactly if what comes of it is a complex."""
    k, gluing = given.before, given.gluing
    result = named(k, gluing)
    if fits(k, gluing) is not None:
        return same(fits(k, gluing), result)
    if isinstance(result, Rejected):
        return same(False, quotient_is_complex(k, gluing))
    after = attach(k, result.value)
    new = 2 ** len(gluing.place) - 1 - len(gluing.identified)
    if isinstance(after, Rejected):
        return Fails(repr(result), after.line(), after.where)
    return every(
        same(True, quotient_is_complex(k, gluing)),
        same(result.value, attachment(k, result.value.simplex)),
        same(
            len(k.simplices) + new,
            len(after.value.simplices if isinstance(after, Accepted) else ()),
        ),
    )


def _pure(given: Gluable) -> Verdict:
    """A pure complex stays pure. Clause: OPER-SIMPLEX-4."""
    after = attach(given.before, given.glued)
    m = len(given.glued.simplex) - 1
    if isinstance(after, Rejected) or dimension(given.before) != m or not is_pure(given.before):
        return Holds()
    return same((m, True), (dimension(after.value), is_pure(after.value)))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "attachment-adds-a-closure",
        Clause.OPER_ATTACH_2,
        "Where the frontier meets K in A, the result is K and the closed simplex; else rejected.",
        GLUABLE,
        _attached,
    ),
    Law(
        "attachment-led-back",
        Clause.OPER_ATTACH_3,
        "The inverse of an operator that applied leads back.",
        OPERATOR_STEPS,
        _led_back,
    ),
    Law(
        "attachment-undone-exactly",
        Clause.OPER_ATTACH_3,
        "An operator can be undone exactly if it leads here from a complex.",
        OPERATOR_STEPS,
        _undone_exactly,
    ),
    Law(
        "attachment-growth",
        Clause.OPER_ATTACH_5,
        "#k changes by binom(m+1, k+1) − #k(A), and χ by 1 − χ(A).",
        GLUABLE,
        _grown,
    ),
    Law(
        "attachment-relative-homology",
        Clause.OPER_ATTACH_6,
        "The homology of K' relative to K is the reduced homology of A, one dimension higher.",
        GLUABLE,
        _relative,
    ),
    Law(
        "attachment-handles-act",
        Clause.OPER_ATTACH_6,
        "Each k-handle makes a k-cycle or fills a (k−1)-cycle.",
        GLUABLE,
        _handles_act,
    ),
    Law(
        "complex-built-by-attachments",
        Clause.OPER_ATTACH_7,
        "A script of attachments builds every complex, and its inverses take it apart.",
        SMALL_COMPLEXES,
        _built,
    ),
    Law(
        "attachment-script-steps",
        Clause.OPER_ATTACH_7,
        "Each step is the operator on what the one before left, up to the first rejection.",
        SCRIPTS,
        _run,
    ),
    Law(
        "attachment-script-as-text",
        Clause.OPER_ATTACH_8,
        "Reading what was written gives the script back.",
        SCRIPTS,
        _written,
    ),
    Law(
        "gluing-named",
        Clause.OPER_ATTACH_9,
        "A gluing that fits is an attachment exactly if what comes of it is a complex.",
        UNNAMED,
        _named,
    ),
    Law(
        "attachment-keeps-purity",
        Clause.OPER_SIMPLEX_4,
        "A pure complex of the dimension of the simplex stays pure.",
        GLUABLE,
        _pure,
    ),
    *SIMPLEX,
    *MANIFOLDS,
    *CURVES,
)
