"""Every place of the tutorial: what the page that compares it with the clauses must speak of.

Read off the tutorial once, by its own headings; no table of the page is made from this.
Clause: TOOL-PAGE-4.
"""

from typing import Final

PARAGRAPHS: Final[tuple[tuple[str, str], ...]] = (
    ("1", "Introduction"),
    ("2(a)", "Source and codes; Enumeration; Coder performance"),
    ("2(b)", "Entropy; Huffman coder; Entropy coder"),
    ("2(c)", "Levels of Information"),
    ("3(a)", "Arithmetic Coder; Example"),
    ("3(b)", "Decoding algorithm; Renormalisation; Encoding algorithm"),
    ("3(c)", "Statistical Modelling; Adaptive models; Order; Contexts; Limits; Prediction"),
    ("4", "Compression"),
    ("4(a)", "Compaction"),
    ("4(b)", "Direct Compression"),
    ("4(c)", "Progressive Compression"),
    ("5", "Meshes and Geometry"),
    ("5(a)", "Simplicial Complexes and Polytopes; Simplex; Incidence; Complex"),
    ("5(a)", "Euler–Poincaré characteristic; Skeleton; Connected components; Link; Star"),
    ("5(a)", "Dimension; Pure complexes; Boundary; Manifolds; Orientability; Surfaces"),
    ("5(a)", "Polytopes"),
    ("6", "Combinatorial Operators"),
    ("6(a)", "Generic Euler operators for surfaces; Low-level Euler operators"),
    ("6(a)", "Euler attachment; Manifold Euler operators"),
    ("6(b)", "Generic attachment; Manifold Handle operators; Handle operators for surfaces"),
    ("7", "Connectivity–Driven Compression"),
    ("7(a)", "Principles"),
    ("7(b)", "Primal and dual graphs; Tree encoding; Remainders"),
    ("7(c)", "Topology of the remainders; Remainder of topological spheres; Morse edges"),
    ("8", "The Edgebreaker example"),
    ("8(a)", "Gate based compression; Right-first traversal; CLERS codes; Original compression"),
    ("8(b)", "Wrap&Zip decompression; Fast Zip"),
    ("8(c)", "Handle Sh symbols; Example; First bounding curve; Boundary Sb symbols"),
    ("8(c)", "Multiple components"),
    ("8(d)", "Compression algorithms"),
    ("8(e)", "Decompression algorithms"),
    ("9", "Performances"),
    ("9(a)", "Compression Rates"),
    ("9(b)", "Good and bad cases; Topology-dependent applications; Regular connectivity"),
    ("9(b)", "Regular geometry; Geometry prediction; Low resource applications"),
    ("10", "Next steps; Non-simplicial meshes; Non-manifold meshes; Higher dimensions"),
    ("10", "Robustness; Deformable meshes"),
)
"""Sections, and the headings of their paragraphs."""

THEOREMS: Final = (
    "Shannon's source coding",
    "classification of surfaces",
    "Jordan curve",
    "least extra information in higher dimensions",
)
"""What the tutorial takes from others and says of what it does."""

ALGORITHMS: Final = 10
FIGURES: Final = 26
TABLES: Final = 3

PLACES: Final[tuple[str, ...]] = (
    *(f"{at} {name}" for at, names in PARAGRAPHS for name in names.split("; ")),
    *(f"Theorem: {name}" for name in THEOREMS),
    *(f"Algorithm {k + 1}" for k in range(ALGORITHMS)),
    *(f"Figure {k + 1}" for k in range(FIGURES)),
    *(f"Table {k + 1}" for k in range(TABLES)),
    "Notation",
)
"""The first cells of the page's rows."""
