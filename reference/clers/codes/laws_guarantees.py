"""The laws of codes with guarantees: counts, what three codes take together, what spheres cost."""

from itertools import pairwise
from typing import Final

from clers.codes import king_rossignac, minimax
from clers.codes.code import Shape
from clers.codes.counts import counts_of, counts_of_word
from clers.codes.implied import implied
from clers.complexes.given import SPHERES, SURFACES
from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, at_most, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.edgebreaker.encode import encode as encode_surface


def counts_from_surface(surface: Surface) -> Verdict:
    """The counts of the word are those of the surface."""
    word = encode_surface(surface).stream.word
    return same(counts_of(components(surface)), counts_of_word(word))


def pairs_after_c(surface: Surface) -> Verdict:
    """#CC + #CR + #CS = #C."""
    word = encode_surface(surface).stream.word
    after = [x for before, x in pairwise(word) if before == "C"]
    return same(word.count("C"), sum(x in "CRS" for x in after))


def three_codes_of_word(surface: Surface) -> Verdict:
    """I + II + III = 8n − 5#C + #S − #E − #CS, all symbols coded."""
    word = encode_surface(surface).stream.word
    counts = counts_of_word(word)
    expected = 8 * counts.symbols - 5 * counts.created + counts.split - word.count("CS")
    return same(expected, sum(king_rossignac.lengths(word, "")))


def three_codes_of_surface(surface: Surface) -> Verdict:
    """The sum is that of T, B, g and b, less #CS."""
    word, expected = encode_surface(surface).stream.word, 0
    for part in components(surface):
        t, e, g, b = part.faces, part.boundary_edges, part.genus, part.curves
        expected += (11 * t + 5 * e) // 2 - 12 + 12 * g + 6 * b if b else 11 * t // 2 - 4 + 12 * g
    return same(expected - word.count("CS"), sum(king_rossignac.lengths(word, "")))


def shortest_of_three(surface: Surface) -> Verdict:
    """The bits are the shortest of three and two more, within the bound."""
    stream = encode_surface(surface).stream
    head = implied(stream.components_with_boundary)
    rest = stream.word[len(head) :]
    match king_rossignac.encode(rest, Shape(head)):
        case Accepted(bits):
            most = king_rossignac.bound(components(surface), stream.word.count("CS"))
            return every(
                same(2 + min(king_rossignac.lengths(rest, head)), bits.length),
                at_most(most, bits.length, "bits"),
            )
        case Rejected() as rejected:
            return Fails("bits", rejected.line(), rejected.where)


def eleven_sixths(surface: Surface) -> Verdict:
    """A sphere takes at most 11T/6 − 1 − #CS/3 bits, in whole numbers."""
    word = encode_surface(surface).stream.word
    taken = 2 + min(king_rossignac.lengths(word[1:], "C"))
    return at_most(11 * surface.faces - 6 - 2 * word.count("CS"), 6 * taken, "six times the bits")


def spheres_in_minimax(surface: Surface) -> Verdict:
    """Every sphere has bits, no more than the rate and constant say."""
    word = encode_surface(surface).stream.word
    verdicts: list[Verdict] = []
    for of in minimax.ALL:
        match minimax.encode(of, word[1:], Shape("C")):
            case Accepted(bits):
                most = of.rate * surface.faces + of.constant
                verdicts.append(at_most(float(most), bits.length, f"bits in minimax-{of.order}"))
            case Rejected() as rejected:
                verdicts.append(Fails("bits", rejected.line(), rejected.where))
    return every(*verdicts)


def refused_where_not_known(surface: Surface) -> Verdict:
    """Refused are only surfaces that are no spheres, where the tables have the frequency 0."""
    stream = encode_surface(surface).stream
    head = implied(stream.components_with_boundary)
    spheres = all(not part.genus and not part.curves for part in components(surface))
    verdicts: list[Verdict] = []
    for of in minimax.ALL:
        found = minimax.encode(of, stream.word[len(head) :], Shape(head))
        if isinstance(found, Rejected):
            verdicts += [same(False, spheres), same(Reason.NOT_REPRESENTABLE, found.reason)]
    return every(*verdicts)


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "counts-from-surface",
        Clause.CODE_COUNT_1,
        "n, #C and #S − #E are what T, B, g and b give",
        SURFACES,
        counts_from_surface,
    ),
    Law(
        "pairs-after-c",
        Clause.CODE_COUNT_2,
        "each C is followed by C, R or S",
        SURFACES,
        pairs_after_c,
    ),
    Law(
        "king-rossignac-sum-of-word",
        Clause.CODE_KR_4,
        "the three codes take 8n − 5#C + #S − #E − #CS bits together",
        SURFACES,
        three_codes_of_word,
    ),
    Law(
        "king-rossignac-sum-of-surface",
        Clause.CODE_KR_5,
        "that is 11T/2−4+12g−#CS, or 11T/2+5B/2−12+12g+6b−#CS with boundary",
        SURFACES,
        three_codes_of_surface,
    ),
    Law(
        "king-rossignac-shortest",
        Clause.CODE_KR_2,
        "the bits are those of the shortest code and two, at most a third of the sum and two",
        SURFACES,
        shortest_of_three,
    ),
    Law(
        "king-rossignac-on-spheres",
        Clause.CODE_KR_6,
        "a sphere takes at most 11T/6 − 1 − #CS/3 bits",
        SPHERES,
        eleven_sixths,
    ),
    Law(
        "minimax-on-spheres",
        Clause.CODE_MINIMAX_6,
        "a sphere takes at most 1.70696·T − 0.98 and 1.67613·T − 0.30 bits",
        SPHERES,
        spheres_in_minimax,
    ),
    Law(
        "minimax-refusals",
        Clause.CODE_MINIMAX_5,
        "what is refused is no sphere, and is refused as not representable",
        SURFACES,
        refused_where_not_known,
    ),
)
