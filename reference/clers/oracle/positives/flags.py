"""The mistakes that cases with a good input bring to light. Clause: ORCL-CASE-5."""

from typing import Final

from clers.oracle.suite.records import Flag

_NOTES: Final[tuple[tuple[str, str, str], ...]] = (
    (
        "shuffled-numbering",
        "vertices or faces are taken to be numbered in the order in which the walk meets them",
        "meshes from elsewhere are numbered anyhow; only the codec's own output passes such a test",
    ),
    (
        "handle-right",
        "the record of a handle whose left gate is closed by the right edge of an R or E",
        "with the two sides confused the surface is glued to another one, or not at all",
    ),
    (
        "handle-left",
        "the record of a handle whose left gate is closed by the left edge of an L or E",
        "the rarer side: code that only ever saw the other one looks right for long",
    ),
    (
        "curve-right",
        "the record of a boundary curve that is closed by a right edge",
        "a curve is reached from an S too, and its left gate may be met again from either side",
    ),
    (
        "curve-left",
        "the record of a boundary curve that is closed by a left edge",
        "the rarer side of the records of curves",
    ),
    (
        "closed-by-e",
        "a record that is closed by an E, which has both sides, so that only the record says which",
        "who takes the side from the symbol has none here",
    ),
    (
        "shared-closer",
        "one triangle closes two records, one with each side",
        "a table from triangles to records that holds one for each loses the other",
    ),
    (
        "late-curve",
        "a boundary curve that is reached in the last part of the word",
        "its vertices are numbered when it is reached, after many others, and not at the start",
    ),
    (
        "boundary-first",
        "a component with boundary that is listed after a closed one, and walked before it",
        "components do not come in the order of their lowest faces: those with boundary are first",
    ),
    (
        "many-components",
        "three components or more",
        "what is not reset between components shows in the second, what adds up in the third",
    ),
    (
        "lone-triangle",
        "a component that is one triangle, with the word E",
        "the smallest surface there is: its first symbol is its last",
    ),
    (
        "deep-stack",
        "at least eight gates wait at once",
        "recursion, or a stack of fixed size, ends here or at the next larger mesh",
    ),
    (
        "long-run",
        "sixteen times C or more without another symbol",
        "fans of high degree: whatever walks around a vertex for each triangle is quadratic",
    ),
    (
        "high-genus",
        "four handles or more: records that nest, cross and follow each other",
        "with one handle most wrong ways of pairing records pair them right",
    ),
    (
        "idle-operator",
        "an operator that cannot do what it says does something else, or is rejected",
        "total operators leave the mesh as it is and say why; scripts of tests depend on it",
    ),
    (
        "empty-message",
        "no symbols, which still have a code of their own",
        "an encoder that sends nothing, or a decoder that reads a symbol first, fails here only",
    ),
    (
        "one-symbol",
        "every symbol is certain, so that nothing is sent for it",
        "intervals that do not narrow, and loops that wait for a bit which never comes",
    ),
    (
        "never",
        "symbols of frequency 0 between the others",
        "a search among equal cumulative counts that stops at the wrong one of them",
    ),
    (
        "pending-bits",
        "many central halves in a row, so that many bits wait for the one that decides them",
        "a counter that is not reset, or a carry that is lost; rare in messages from real meshes",
    ),
    (
        "carry",
        "a carry through many bytes that are sent already, or held",
        "in random messages a carry through three bytes comes once in sixteen million",
    ),
    (
        "largest-total",
        "tables whose total is 2^30 or next to it",
        "products have up to 62 bits: in 32 bits, or in doubles, they are wrong here first",
    ),
    (
        "halving",
        "counts that pass their limit and are halved, rounded up",
        "halved one symbol too early, or rounded down, everything after it is another message",
    ),
    (
        "no-positions",
        "a mesh without positions",
        "a writer that always writes that section, or a reader that always expects it",
    ),
    (
        "negative-zero",
        "zeros with a sign, whose bytes differ and whose values do not",
        "exact coding keeps the sign; on a lattice there is one zero",
    ),
    (
        "subnormal",
        "numbers below the least normal one",
        "flushed to zero by some processors' modes, and missed by scaling with a power of two",
    ),
    (
        "greatest",
        "the greatest finite numbers",
        "the difference of two of them is infinite, and so is a box computed in doubles",
    ),
    (
        "shortest-digits",
        "fractions that have no short binary form",
        "a reader or writer of JSON that loses a bit shows here",
    ),
    (
        "no-extent",
        "all vertices have one coordinate, or one place",
        "a box of extent 0: a division by it, or a model with no classes",
    ),
    (
        "ties",
        "coordinates exactly between two points of the lattice",
        "the greater one is right; languages round to even, or away from zero",
    ),
    (
        "wide-box",
        "an extent of 2^30 - 1, the greatest that there is",
        "residuals and predictions that do not fit into 32 bits with a sign",
    ),
)

FLAGS: Final = tuple(
    Flag(name=name, mistake=mistake, matters=matters) for name, mistake, matters in _NOTES
)
"""Each flag of the positives, explained once. Clause: ORCL-CASE-5."""
