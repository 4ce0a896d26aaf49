"""The mistakes that the cases of this package bring to light. Clauses: ORCL-CASE-5, ORCL-FLAG-1."""

from typing import Final

from clers.oracle.suite.records import Flag

_SURFACES: Final = (
    (
        "empty-input",
        "nothing at all is taken for something",
        "an empty list is where the first element is read before its number is asked",
    ),
    (
        "index-off-by-one",
        "a vertex number equal to the number of vertices is let through",
        "the entry after the last of an array is read, or written: in C a hole, elsewhere a crash",
    ),
    (
        "negative-number",
        "a number below zero is taken for an index or a count",
        "it counts from the end in some languages, and is very large and positive in others",
    ),
    (
        "integer-wraps",
        "a number is cut to 8, 16, 32, 53 or 64 bits before it is compared with its limit",
        "what was far out of range comes back as a small good number, and every check after it "
        "passes",
    ),
    (
        "degenerate-face",
        "a face that names one vertex twice is dropped without a word, or walked over",
        "the number of faces changes under the caller's hands, or a gate leads to itself",
    ),
    (
        "duplicate-face",
        "a face that is there twice is dropped without a word, or kept",
        "its edges then have three or four faces, and which of them are neighbours is chance",
    ),
    (
        "two-sided-triangle",
        "a triangle and its mirror image are taken for a closed surface of two faces",
        "every edge has its opposite, so a check of edges alone is content; no complex is that",
    ),
    (
        "non-manifold-edge",
        "an edge with three faces is matched with whichever came last",
        "a table of opposite corners then is no involution, and the walk may never end",
    ),
    (
        "orientation-ignored",
        "neighbours that run their edge in one direction are matched all the same",
        "inside and outside change from face to face, and the decoder gives another surface",
    ),
    (
        "pinched-vertex",
        "two fans of faces that share a vertex are taken for one",
        "turning around the vertex finds only one fan; the other is lost, or numbered twice",
    ),
    (
        "isolated-vertex",
        "vertices that no face names are dropped without a word",
        "positions and attributes are then one too many, and all after the gap belong elsewhere",
    ),
)

_WORDS: Final = (
    (
        "unchecked-alphabet",
        "characters that are no symbols are skipped, or fall to the last branch of a switch",
        "an else that means S makes a surface of any text",
    ),
    (
        "end-of-word-not-checked",
        "the word ends before its stack is empty, or goes on after that",
        "a stack is popped that is empty, or symbols are lost in silence",
    ),
    (
        "components-not-counted",
        "more components with boundary are announced than there are, or fewer than none",
        "the counter decides which components have a first triangle P, and so how many faces",
    ),
    (
        "records-in-any-order",
        "records that do not rise by their S are taken as they come",
        "one surface then has many streams, and files that are equal differ",
    ),
    (
        "record-out-of-range-used",
        "a record names an S or a closing triangle that there is not",
        "the number is an index into what was decoded: the classic way into foreign memory",
    ),
    (
        "side-not-checked",
        "a record names a side that its closing triangle keeps open",
        "the edge is glued to the S and to the next triangle, and one of the two is lost",
    ),
    (
        "branch-not-checked",
        "a record closes an S by a triangle before it, or after its right branch",
        "no walk can have come that way; what is glued is some surface, of no mesh",
    ),
    (
        "edge-glued-twice",
        "one edge closes two S, or an S and a C",
        "opposite corners are no involution any more, and the first is silently undone",
    ),
    (
        "short-loop-glued",
        "a loop of two edges or one is closed, or taken for a curve",
        "it is the place where linked lists of edges point to themselves and walks do not end",
    ),
    (
        "open-loop-left",
        "edges are left that nothing closes, in a component that should be closed",
        "a surface with holes that no record announces is given as a good answer",
    ),
    (
        "handle-taken-for-curve",
        "a record says boundary where the loop that is cut off is no free curve",
        "vertices are numbered along the loop, which is not there: all numbers after are wrong",
    ),
    (
        "result-not-simplicial",
        "triangles are glued rightly, but two edges have the same ends or a face a vertex twice",
        "the glued surface exists, and as a list of faces it is another one, or none",
    ),
    (
        "decoder-knows-one-encoder",
        "a stream that keeps the grammar is refused, or decoded otherwise",
        "decoders tested on what one encoder writes for nice meshes know nothing of the rest",
    ),
)

_BITS: Final = (
    (
        "bits-not-compared",
        "bits after the message, or other bits than the encoder's, are not looked at",
        "one message then has many codes: signatures, caches and comparisons of files fail",
    ),
    (
        "bits-by-bytes",
        "the number of bits is rounded to whole bytes, or the bits are read by bytes",
        "a reader that has eight bits too many believes in symbols that nobody wrote",
    ),
    (
        "filling-bits-ignored",
        "the bits after the last one, up to the end of the byte, may be anything",
        "a place to hide bytes, and a second file with the same meaning",
    ),
    (
        "table-not-checked",
        "a table of frequencies or lengths is used that is no table",
        "a total of 0 is a division by zero, one that is too great an overflow at some message",
    ),
    (
        "symbol-not-checked",
        "a symbol that the model does not have is coded",
        "its interval is empty, or what stands after the table: the message cannot be decoded",
    ),
    (
        "word-not-checked",
        "a word is coded that has no bits in this code",
        "the bits decode to another word, and nobody notices until the mesh is looked at",
    ),
    (
        "code-not-for-all",
        "a code that is for some surfaces is applied to another one",
        "the assumption, here that the surface is a single sphere, is silent when it fails",
    ),
)

_FILES: Final = (
    (
        "magic-not-compared",
        "the first eight bytes are compared in part, or not at all",
        "a file of another kind is read as if it were one, and fails much later, if it does",
    ),
    (
        "text-mode",
        "the file went through a program that changes line ends or puts a mark first",
        "the magic has CR and LF so that this is seen in the first line, not in the coordinates",
    ),
    (
        "version-not-compared",
        "a file of another version is read by the rules of this one",
        "the day there is a version 2 old readers must say so, and not guess",
    ),
    (
        "read-past-the-end",
        "a file or a section that ends too soon is read on",
        "the bytes behind it belong to another section, to nobody, or to somebody else",
    ),
    (
        "bytes-left-unread",
        "what follows the last value is not looked at",
        "two files that differ mean the same, and what was appended goes unseen",
    ),
    (
        "seal-not-checked",
        "the checksum of a header or of a payload is not compared",
        "damage is decoded to a mesh that is nearly right, which is worse than none",
    ),
    (
        "sections-as-they-come",
        "sections may be missing, repeated, unknown or in another order",
        "of two that contradict each other one is taken, and readers differ in which",
    ),
    (
        "unknown-code-taken",
        "a number that names no code, or no position coding, is taken for one",
        "it is an index into a table of functions: the next entry is somebody else's",
    ),
    (
        "number-not-canonical",
        "a number of variable length is read in a longer form, or with too many bits",
        "one number then has many forms, and one more byte shifts what is kept beyond 32 bits",
    ),
    (
        "count-trusted",
        "a count in the head is believed, though the rest says otherwise",
        "whoever reserves by the count and fills by the word writes beyond what was reserved",
    ),
    (
        "size-trusted",
        "memory is reserved, or a loop begun, for a number that no byte stands behind",
        "fifty bytes then ask for gigabytes: the cheapest way to stop a server",
    ),
    (
        "reader-knows-one-writer",
        "a file put together by the tables of the specification is refused, or read otherwise",
        "what writer and reader of one program agree on by mistake no round trip can show",
    ),
    (
        "unchecked-word",
        "the bits of the word are good, and the word is none",
        "behind a good checksum stands what anybody may have written there",
    ),
    (
        "unchecked-record",
        "the handle data are good numbers, and no handles",
        "as for words; and here each number is an index",
    ),
)

_POSITIONS: Final = (
    (
        "positions-not-counted",
        "there are more or fewer coordinates than three for each vertex",
        "the last vertices take theirs from what stands behind in memory",
    ),
    (
        "numbers-not-checked",
        "an infinity, or what is no number, is taken for a coordinate",
        "it spreads: a box, a centre, a normal made with it is no number either",
    ),
    (
        "precision-lost",
        "a coordinate that is no single-precision number is stored as one",
        "exact was promised; rounding is quantisation that nobody asked for",
    ),
    (
        "lattice-not-checked",
        "an exponent, a number or a box is beyond what a lattice can have",
        "scaling overflows to infinity, or bits are lost that were promised to be kept",
    ),
    (
        "residual-not-checked",
        "residuals lead out of the box, or the box is larger than the points in it",
        "the first is a coordinate that nobody wrote, the second a second file for one mesh",
    ),
)

_SCRIPTS: Final = (
    (
        "script-read-loosely",
        "a text that is nearly a script is taken for one",
        "who sends a counterexample as text must know that the other side read the same",
    ),
    (
        "operator-not-checked",
        "an operator is applied where what it needs is not there",
        "what it leaves is no surface, and the numbers are wrong from some later step on",
    ),
)

FLAGS: Final = tuple(
    Flag(name=name, mistake=mistake, matters=matters)
    for group in (_SURFACES, _WORDS, _BITS, _FILES, _POSITIONS, _SCRIPTS)
    for name, mistake, matters in group
)
"""Each flag of this package. Clauses: ORCL-CASE-5, ORCL-FLAG-1."""
