"""Every reason a rejection can have, each with its class of fault. Clause: CONV-RESULT-3."""

from enum import StrEnum


class Fault(StrEnum):
    """The four classes a decoder must tell apart. Clause: CONV-RESULT-3."""

    MALFORMED = "malformed"
    INVALID = "invalid"
    UNSUPPORTED = "unsupported"
    LIMIT = "limit"


class Reason(StrEnum):
    """Names of what can be wrong; each is used by one clause or by a few that share it."""

    fault: Fault

    def __new__(cls, name: str, fault: Fault) -> "Reason":
        """Tie the printed name to its class of fault."""
        member = str.__new__(cls, name)
        member._value_ = name
        member.fault = fault
        return member

    # surfaces (chapter 3)
    EMPTY_MESH = "empty-mesh", Fault.INVALID
    INDEX_OUT_OF_RANGE = "index-out-of-range", Fault.INVALID
    REPEATED_INDEX = "repeated-index", Fault.INVALID
    DUPLICATE_FACE = "duplicate-face", Fault.INVALID
    EDGE_WITH_THREE_FACES = "edge-with-three-faces", Fault.INVALID
    EDGE_TWICE_IN_ONE_DIRECTION = "edge-twice-in-one-direction", Fault.INVALID
    PINCHED_VERTEX = "pinched-vertex", Fault.INVALID
    ISOLATED_VERTEX = "isolated-vertex", Fault.INVALID
    NON_ORIENTABLE = "non-orientable", Fault.INVALID
    NON_FINITE_COORDINATE = "non-finite-coordinate", Fault.INVALID
    EMPTY_SIMPLEX = "empty-simplex", Fault.INVALID
    SHARED_VERTEX = "shared-vertex", Fault.INVALID
    NOT_PURE = "not-pure", Fault.INVALID
    MISSING_FACE = "missing-face", Fault.INVALID
    DEGENERATE_SIMPLEX = "degenerate-simplex", Fault.INVALID
    SIMPLICES_OVERLAP = "simplices-overlap", Fault.INVALID
    UNSUPPORTED_DIMENSION = "unsupported-dimension", Fault.UNSUPPORTED
    BAD_FRONTIER = "bad-frontier", Fault.INVALID
    INCOHERENT_CELLS = "incoherent-cells", Fault.INVALID
    NOT_A_MANIFOLD = "not-a-manifold", Fault.INVALID
    HAS_BOUNDARY = "has-boundary", Fault.INVALID
    BROKEN_INVARIANT = "broken-invariant", Fault.INVALID
    TOO_MANY_FACES = "too-many-faces", Fault.LIMIT
    TOO_MANY_VERTICES = "too-many-vertices", Fault.LIMIT
    # operators (chapter 4)
    OPERATOR_NOT_APPLICABLE = "operator-not-applicable", Fault.INVALID
    UNKNOWN_OPERATOR = "unknown-operator", Fault.MALFORMED
    BAD_OPERAND = "bad-operand", Fault.MALFORMED
    MISSING_SIMPLEX = "missing-simplex", Fault.INVALID
    PRESENT_SIMPLEX = "present-simplex", Fault.INVALID
    NOT_FREE = "not-free", Fault.INVALID
    WRONG_LINK = "wrong-link", Fault.INVALID
    LINK_CONDITION = "link-condition", Fault.INVALID
    # words and handle data (chapter 5)
    UNKNOWN_SYMBOL = "unknown-symbol", Fault.INVALID
    EMPTY_WORD = "empty-word", Fault.INVALID
    UNFINISHED_WORD = "unfinished-word", Fault.INVALID
    TOO_FEW_COMPONENTS = "too-few-components", Fault.INVALID
    RECORD_ORDER = "record-order", Fault.INVALID
    RECORD_OUT_OF_RANGE = "record-out-of-range", Fault.INVALID
    RECORD_SIDE = "record-side", Fault.INVALID
    RECORD_OUTSIDE_BRANCH = "record-outside-branch", Fault.INVALID
    EDGE_CLOSED_TWICE = "edge-closed-twice", Fault.INVALID
    LOOP_TOO_SHORT = "loop-too-short", Fault.INVALID
    LOOP_NOT_CLOSED = "loop-not-closed", Fault.INVALID
    NOT_A_CURVE = "not-a-curve", Fault.INVALID
    REPEATED_VERTEX = "repeated-vertex", Fault.INVALID
    DOUBLE_EDGE = "double-edge", Fault.INVALID
    # coders (chapters 1, 2 and 6)
    BAD_TABLE = "bad-table", Fault.INVALID
    NOT_IN_ALPHABET = "not-in-alphabet", Fault.INVALID
    TRAILING_BITS = "trailing-bits", Fault.MALFORMED
    TRUNCATED_BITS = "truncated-bits", Fault.MALFORMED
    NOT_CANONICAL = "not-canonical", Fault.MALFORMED
    # positions (chapter 7)
    COUNT_MISMATCH = "count-mismatch", Fault.INVALID
    NOT_REPRESENTABLE = "not-representable", Fault.INVALID
    BAD_LATTICE = "bad-lattice", Fault.INVALID
    BAD_RESIDUAL = "bad-residual", Fault.INVALID
    # files (chapter 8)
    BAD_MAGIC = "bad-magic", Fault.MALFORMED
    TRUNCATED_FILE = "truncated-file", Fault.MALFORMED
    TRAILING_BYTES = "trailing-bytes", Fault.MALFORMED
    BAD_CHECKSUM = "bad-checksum", Fault.MALFORMED
    BAD_NUMBER = "bad-number", Fault.MALFORMED
    BAD_SECTION = "bad-section", Fault.MALFORMED
    IMPOSSIBLE_COUNT = "impossible-count", Fault.MALFORMED
    UNKNOWN_VERSION = "unknown-version", Fault.UNSUPPORTED
    UNKNOWN_SECTION = "unknown-section", Fault.UNSUPPORTED
    UNKNOWN_CODE = "unknown-code", Fault.UNSUPPORTED
    TOO_MANY_BYTES = "too-many-bytes", Fault.LIMIT
    # mesh files and the command line (chapter 10)
    UNREADABLE_FILE = "unreadable-file", Fault.MALFORMED
    UNKNOWN_FORMAT = "unknown-format", Fault.UNSUPPORTED
    NOT_TRIANGLES = "not-triangles", Fault.UNSUPPORTED
    CAME_BACK_CHANGED = "came-back-changed", Fault.INVALID
    UNWRITABLE_FILE = "unwritable-file", Fault.INVALID
    NOT_OBTAINABLE = "not-obtainable", Fault.UNSUPPORTED
    NOT_DRAWABLE = "not-drawable", Fault.UNSUPPORTED
    NO_SUCH_STEP = "no-such-step", Fault.INVALID
