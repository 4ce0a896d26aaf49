"""Laws of residuals and their bits."""

from typing import Final

from clers.arithmetic.bits import Bits, pack
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE, AtVertex
from clers.geometry import quantised
from clers.geometry.given import (
    CODINGS,
    LATTICE_MESHES,
    RESIDUALS,
    Coding,
    LatticeMesh,
)
from clers.geometry.laws_prediction import boxed_points
from clers.geometry.predict import (
    NONE,
    indices_from,
    parallelogram_corners,
    residuals,
)
from clers.geometry.quantised import Coded
from clers.geometry.residual import (
    INCREMENT,
    LIMIT,
    LONGEST,
    classes,
    fold,
    model,
    residuals_in,
    symbols,
    unfold,
)
from clers.information.adaptive import Adaptive, recount
from clers.information.model import differences, has_ended


def residuals_lead_back(given: LatticeMesh) -> Verdict:
    """indices_from (residuals q) is q."""
    found = boxed_points(given)
    differences_ = residuals(given.surface, found.box, found.indices)
    return same(Accepted(found.indices), indices_from(given.surface, found.box, differences_))


def outside_the_box_refused(given: LatticeMesh) -> Verdict:
    """A residual changed by the extent and one more leads out of the box, and is refused."""
    found = boxed_points(given)
    good = residuals(given.surface, found.box, found.indices)
    for i in (0, len(good) // 2, len(good) - 1):
        extent = found.box.extent[i % 3]
        for step in (-extent - 1, extent + 1):
            bad = (*good[:i], good[i] + step, *good[i + 1 :])
            refused = indices_from(given.surface, found.box, bad)
            expected = (Clause.GEOM_RESIDUAL_2, AtVertex(i // 3))
            if not isinstance(refused, Rejected):
                return Fails("a rejection", repr(refused.value), AtVertex(i // 3))
            if (refused.clause, refused.where) != expected:
                return Fails(repr(expected), refused.line(), refused.where)
    return Holds()


def folds(residual: int) -> Verdict:
    """0, −1, 1, −2, 2, … in this order, and back."""
    z = fold(residual)
    return every(
        same(residual, unfold(z)),
        same(abs(2 * residual + (residual < 0)), z),
        same((residual,), residuals_in(tuple(symbols((residual,))))),
    )


def message_fits_model(given: LatticeMesh) -> Verdict:
    """Three symbols a residual at most; the model allows each and ends after the last."""
    found = boxed_points(given)
    listed = residuals(given.surface, found.box, found.indices)
    message = tuple(symbols(listed))
    state = model(given.surface, found.box)
    for symbol in message:
        table = state.cumulative
        if symbol >= len(table) - 1 or table[symbol] == table[symbol + 1]:
            return Fails(f"below {len(table) - 1}", str(symbol), WHOLE)
        state = state.after(symbol)
    return every(
        same(True, has_ended(state)),
        same(listed, residuals_in(message)),
        same(True, len(message) <= LONGEST * len(listed)),
    )


def classes_learnt_apart(given: LatticeMesh) -> Verdict:
    """The frequencies that each residual's class meets, counted from the classes before it.

    Those of the same axis whose vertex is predicted in the same way, and no other.
    """
    found = boxed_points(given)
    corners = parallelogram_corners(given.surface)
    listed = residuals(given.surface, found.box, found.indices)
    history: dict[tuple[bool, int], list[int]] = {}
    state = model(given.surface, found.box)
    for i, residual in enumerate(listed):
        seen = history.setdefault((corners[i // 3] == NONE, i % 3), [])
        size = classes(found.box.extent[i % 3])
        start = Adaptive(tuple(range(size + 1)), INCREMENT, LIMIT)
        met = differences(state.cumulative)
        if recount(start, seen) != met:
            return Fails(str(recount(start, seen)), str(met), AtVertex(i // 3))
        for symbol in symbols((residual,)):
            state = state.after(symbol)
        seen.append(fold(residual).bit_length())
    return same(True, has_ended(state))


def coded_and_back(given: LatticeMesh) -> Verdict:
    """decode (encode q) is q."""
    match quantised.encode(given.surface, given.quantised):
        case Accepted(coded):
            return same(Accepted(given.quantised), quantised.decode(given.surface, coded))
        case Rejected() as rejected:
            return Fails("bits", rejected.line(), rejected.where)


def one_string_each(given: Coding) -> Verdict:
    """Whatever bits are accepted are those that encoding gives."""
    coded = Coded(0, given.box, given.bits)
    match quantised.decode(given.surface, coded):
        case Accepted(found):
            return same(Accepted(coded), quantised.encode(given.surface, found))
        case Rejected():
            return Holds()


def nothing_may_follow(given: LatticeMesh) -> Verdict:
    """A bit more or a bit less is refused."""
    match quantised.encode(given.surface, given.quantised):
        case Accepted(coded):
            values = coded.bits.values()
            others = (coded.bits.followed_by(Bits(b"\0", 1)), pack(values[:-1]))
            found = [
                quantised.decode(given.surface, Coded(coded.exponent, coded.box, bits))
                for bits in others
            ]
            return same([True, True], [isinstance(result, Rejected) for result in found])
        case Rejected() as rejected:
            return Fails("bits", rejected.line(), rejected.where)


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "residuals-lead-back",
        Clause.GEOM_RESIDUAL_1,
        "indices_from (residuals q) is q",
        LATTICE_MESHES,
        residuals_lead_back,
    ),
    Law(
        "residuals-outside-the-box",
        Clause.GEOM_RESIDUAL_2,
        "a residual that leads out of the box is refused at its vertex",
        LATTICE_MESHES,
        outside_the_box_refused,
    ),
    Law(
        "residuals-fold",
        Clause.GEOM_CODE_1,
        "unfold (fold r) is r, and the class and rest of a residual lead back to it",
        RESIDUALS,
        folds,
    ),
    Law(
        "residual-classes-learnt-apart",
        Clause.GEOM_CODE_2,
        "a class meets the frequencies of the classes before it on its axis and in its way",
        LATTICE_MESHES,
        classes_learnt_apart,
    ),
    Law(
        "residual-message-fits-model",
        Clause.GEOM_CODE_3,
        "the model allows every symbol of the message, three a residual at most, and then ends",
        LATTICE_MESHES,
        message_fits_model,
    ),
    Law(
        "quantised-positions-round-trip",
        Clause.GEOM_CODE_4,
        "decode (encode q) is q",
        LATTICE_MESHES,
        coded_and_back,
    ),
    Law(
        "quantised-positions-one-string",
        Clause.GEOM_CODE_5,
        "bits that are accepted are those that encoding gives",
        CODINGS,
        one_string_each,
    ),
    Law(
        "quantised-positions-whole",
        Clause.GEOM_CODE_5,
        "a bit more or a bit less is refused",
        LATTICE_MESHES,
        nothing_may_follow,
    ),
)
