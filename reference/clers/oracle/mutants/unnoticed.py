"""Why changes that a tool makes are noticed by nothing, where somebody read them. ORCL-MUTANT-9."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Final


class Kind(StrEnum):
    """What a survivor is, as under ORCL-MUTANT-7."""

    EQUIVALENT = "equivalent"
    ADVICE = "advice"
    RANGE = "range"
    MISSED = "missed"


@dataclass(frozen=True, slots=True)
class Why:
    """What kind of survivor it is, and how that is known."""

    kind: Kind
    because: str


def why(module: str, difference: str) -> Why | None:
    """What is known of a change of a module, given by lines. Clause: ORCL-MUTANT-9."""
    return READ.get((module, " ".join(difference.split())))


READ: Final[Mapping[tuple[str, str], Why]] = {
    (
        "clers.information.numbers",
        "- long = (parameter - 1).bit_length() + long = (parameter - 0).bit_length()",
    ): Why(
        Kind.EQUIVALENT,
        "they differ for powers of two alone; there a digit more is read at once, which the short "
        "form read next, and what is short of digits is so at the same place",
    ),
    (
        "clers.information.prefix",
        "- longest = max(known, default=0) + longest = max(known, default=1)",
    ): Why(Kind.EQUIVALENT, "of no lengths the sum is 0 over any power of two"),
    (
        "clers.arithmetic.coder",
        "- numbers = decoded(automaton.tables, automaton.context, max(count, 0), longest, of) "
        "+ numbers = decoded(automaton.tables, automaton.context, max(count, (-1)), longest, of)",
    ): Why(Kind.EQUIVALENT, "the kernel counts up to it, and begins with 0"),
    (
        "clers.complexes.corner_table",
        "- if 0 < given.faces <= limits.faces and given.vertices <= limits.vertices: "
        "+ if 0 <= given.faces <= limits.faces and given.vertices <= limits.vertices:",
    ): Why(
        Kind.EQUIVALENT,
        "of no faces the kernels give no surface, as more vertices than corners are none, and the "
        "clauses say why",
    ),
    (
        "clers.complexes.structures.half_edge_definition",
        "- links = chain(of.next, of.previous, of.twin, of.of_vertex, of.of_face) "
        "+ links = chain(of.next, of.twin, of.previous, of.of_vertex, of.of_face)",
    ): Why(Kind.EQUIVALENT, "what is chained becomes a set"),
    (
        "clers.operators.attachments.operator",
        "- return (_edge(one, other, new_end=False),) + return (_edge(other, one, new_end=False),)",
    ): Why(Kind.EQUIVALENT, "the ends of an edge without a new vertex are put in order"),
    (
        "clers.arithmetic.coder",
        "- if tables is None or bits.length < SHORTEST: "
        "+ if tables is None or bits.length <= SHORTEST:",
    ): Why(Kind.EQUIVALENT, "both ways read the same; this says only which is taken, by length"),
    (
        "clers.edgebreaker.examples",
        "- (0, 3, 4), (0, 4, 1), (1, 4, 5), (1, 5, 2), (2, 5, 3), (2, 3, 0), "
        "+ (0, 3, 4), (0, 4, 1), (1, 4, 5), (1, 5, 2), ((2, 3, 0)), ((2, 5, 3)),",
    ): Why(
        Kind.EQUIVALENT,
        "an example's faces in another order are the same surface, and as the first face stays, so "
        "do the walk and the word",
    ),
    (
        "clers.container.contents",
        '- nothing = Accepted(Bits(b"", 0)) + nothing = Accepted(Bits(b"", 1))',
    ): Why(Kind.EQUIVALENT, "bits of handle data are looked at only if there are records"),
    (
        "clers.container.trip",
        "- corners = [Corner(0)] * len(surface.vertex) "
        "+ corners = [Corner((-1))] * len(surface.vertex)",
    ): Why(Kind.EQUIVALENT, "each corner is one of a face, so that each entry is written"),
    (
        "clers.container.contents",
        '- nothing = Accepted(Bits(b"", 0)) + nothing = Accepted(Bits((0), (b"")))',
    ): Why(Kind.EQUIVALENT, "bits of handle data are looked at only if there are records"),
    (
        "clers.geometry.order",
        "- inverse = [0] * len(order) + inverse = [1] * len(order)",
    ): Why(Kind.EQUIVALENT, "the order has every vertex, so that each entry is written"),
    (
        "clers.codes.minimax_search",
        "- best, step = _slope(of, *at), 2.0**-10 + best, step = _slope(of, *at), 1.0**-10",
    ): Why(
        Kind.EQUIVALENT,
        "with greater steps the search for a certificate begins further off, and ends at the same; "
        "whatever it finds is checked in exact numbers",
    ),
    (
        "clers.kernels.foretelling",
        "- return -1 + return -2",
    ): Why(Kind.EQUIVALENT, "whoever calls it asks only whether it is a place, from 0 on"),
    (
        "clers.kernels.gluing",
        "- self.where: i64 = 0 + self.where: i64 = (-1)",
    ): Why(Kind.EQUIVALENT, "it is read only after a fault, which says where it is"),
    (
        "clers.kernels.tree",
        "- zeros_at = vec[i64]([0]) + zeros_at = vec[i64]([(-1)])",
    ): Why(Kind.EQUIVALENT, "zeros are not counted at the root, where the first is a fault"),
    (
        "clers.codes.context_definition",
        "- step = floor((65535 * symbol - p) * floor(65536 / (k + 1.5)) / 65536) "
        "+ step = floor((65535 * symbol - p) * floor(65535 / (k + 1.5)) / 65536)",
    ): Why(
        Kind.EQUIVALENT,
        "131072 and 131070 have the same quotient by 2k + 3, as 131071 is a prime and 131072 a "
        "power of two",
    ),
    (
        "clers.codes.handle_data",
        "- longest = 4 + 2 * (sizes(symbols) // CHUNK + 1) "
        "+ longest = 4 + 2 * (sizes(symbols) * CHUNK + 1)",
    ): Why(Kind.EQUIVALENT, "the model ends by itself: no bound above is ever reached"),
    (
        "clers.kernels.table",
        "- v: i64 = 0 + v: i64 = (-1)",
    ): Why(Kind.EQUIVALENT, "-1 names the last entry, which counts nothing, and is 0 before, too"),
    (
        "clers.kernels.tree",
        "- while self.height > 1 and end != LEAF: + while self.height > 0 and end != LEAF:",
    ): Why(
        Kind.EQUIVALENT,
        "-1 names the last place; to take a side off there is one above it whose end is no leaf, "
        "so that none but such a side was last there",
    ),
    (
        "clers.kernels.walk",
        "- self.visited = flags(corners // 3) + self.visited = flags(corners // 2)",
    ): Why(Kind.EQUIVALENT, "there are places for more faces than there are; none looks at them"),
}
"""By module and change, with single spaces. Clause: ORCL-MUTANT-9."""
