"""Mistakes in files."""

from typing import Final

from clers.conventions.clause import Clause
from clers.oracle.mutants.mutant import Mutant

CONTENTS: Final = "clers.container.contents"
SECTION: Final = "clers.container.section"
NUMBERS: Final = "clers.container.numbers"
HEAD: Final = "clers.container.head"

MUTANTS: Final = (
    Mutant(
        "magic-half-read",
        Clause.FILE_MAGIC_1,
        CONTENTS,
        "if magic != MAGIC:",
        "if magic[:6] != MAGIC[:6]:",
        "The line end in the magic number, which tells damaged transfers, is not compared.",
    ),
    Mutant(
        "later-version-accepted",
        Clause.FILE_MAGIC_2,
        CONTENTS,
        "if version != VERSION:",
        "if version < VERSION:",
        "Files of later versions are read as if they were of this one.",
    ),
    Mutant(
        "seal-unchecked",
        Clause.FILE_SECTION_2,
        SECTION,
        "if seal.value.value != computed:",
        "if seal.value.value < 0:",
        "Checksums are read and not compared.",
    ),
    Mutant(
        "seal-not-inverted",
        Clause.FILE_SECTION_2,
        SECTION,
        "return data + write(U32, crc32(data))",
        "return data + write(U32, crc32(data) ^ 0xFFFFFFFF)",
        "The checksum is not inverted at its end.",
    ),
    Mutant(
        "trailing-bytes-in-section",
        Clause.FILE_LAYOUT_2,
        "clers.container.layout",
        "if offset == window.stop:",
        "if offset <= window.stop:",
        "Bytes after the last value of a section are ignored.",
    ),
    Mutant(
        "superfluous-section",
        Clause.FILE_SECTION_5,
        CONTENTS,
        "if got != wanted:",
        "if not set(wanted) <= set(got):",
        "Sections that HEAD does not ask for are passed over.",
    ),
    Mutant(
        "unknown-section-skipped",
        Clause.FILE_SECTION_3,
        SECTION,
        """\
            where, detail = window.at(offset), f"tag {tag!r}"
            return Rejected(Reason.UNKNOWN_SECTION, Clause.FILE_SECTION_3, where, detail)
""",
        """\
            skipped = SECTION.read(Window(data, len(data), tag), offset)
            if isinstance(skipped, Rejected):
                return skipped
            offset = skipped.value.offset
            continue
""",
        "Sections of unknown tags are passed over.",
    ),
    Mutant(
        "sections-swapped",
        Clause.FILE_SECTION_4,
        CONTENTS,
        """\
    if stream.records:
        payloads.append(("HAND", write(BITS, handles)))
    payloads.append(("WORD", write(BITS, word)))
""",
        """\
    payloads.append(("WORD", write(BITS, word)))
    if stream.records:
        payloads.append(("HAND", write(BITS, handles)))
""",
        "The handle data is written after the word.",
    ),
    Mutant(
        "handle-section-always",
        Clause.FILE_SECTION_5,
        CONTENTS,
        "    if stream.records:\n        payloads",
        "    if True:\n        payloads",
        "There is a section of handle data though there are no records.",
    ),
    Mutant(
        "long-number-accepted",
        Clause.FILE_NUMBER_3,
        NUMBERS,
        "if byte == 0 and at > offset + 1:",
        "if byte == 0 and at > offset + 5:",
        "Numbers need not be in their shortest form.",
    ),
    Mutant(
        "sign-and-magnitude",
        Clause.FILE_NUMBER_4,
        NUMBERS,
        "lambda n: 2 * n if n >= 0 else -2 * n - 1,",
        "lambda n: 2 * abs(n) + (n < 0),",
        "Negative numbers are written by sign and magnitude.",
    ),
    Mutant(
        "places-from-0",
        Clause.FILE_NUMBER_5,
        NUMBERS,
        "members.index(member) + 1",
        "members.index(member)",
        "Codes are numbered from 0.",
    ),
    Mutant(
        "code-0-accepted",
        Clause.FILE_NUMBER_5,
        NUMBERS,
        "if 1 <= byte <= len(members):",
        "if 0 <= byte <= len(members):",
        "Number 0 names the last of a list.",
    ),
    Mutant(
        "highest-byte-first",
        Clause.FILE_NUMBER_2,
        NUMBERS,
        'value.to_bytes(size, "little")',
        'value.to_bytes(size, "big")',
        "Numbers of fixed width are written with the highest byte first.",
    ),
    Mutant(
        "bits-by-the-byte",
        Clause.FILE_BITS_1,
        "clers.container.places",
        "lambda bits: (bits.length, bits.data),",
        "lambda bits: (8 * len(bits.data), bits.data),",
        "Bits are counted by whole bytes.",
    ),
    Mutant(
        "codes-in-order-of-age",
        Clause.FILE_HEAD_2,
        HEAD,
        """\
    CodeName.PLAIN,
    CodeName.GOLDEN,
""",
        """\
    CodeName.GOLDEN,
    CodeName.PLAIN,
""",
        "The numbers of two codes are swapped.",
    ),
    Mutant(
        "limits-unchecked",
        Clause.FILE_LIMIT_2,
        HEAD,
        "if max(head.faces, head.symbols) > limits.faces:",
        "if max(head.faces, head.symbols) > 64 * limits.faces:",
        "Declared faces are not compared with the limit.",
    ),
    Mutant(
        "room-for-what-is-declared",
        Clause.FILE_COUNT_4,
        HEAD,
        "    if max(head.faces, head.symbols) > limits.faces:\n",
        "    room = bytes(8 * max(head.faces, head.symbols))\n"
        "    if len(room) > 512 * limits.faces:\n",
        "Memory is taken for as many faces as are declared.",
    ),
    Mutant(
        "vertices-unlimited",
        Clause.FILE_LIMIT_2,
        HEAD,
        "if head.vertices > limits.vertices:",
        "if head.vertices > 64 * limits.vertices:",
        "Declared vertices are not compared with the limit.",
    ),
    Mutant(
        "vertices-not-counted",
        Clause.FILE_COUNT_3,
        "clers.container.file",
        "if (surface.faces, surface.vertices) != (contents.faces, contents.vertices):",
        "if surface.faces != contents.faces:",
        "The number of vertices in HEAD is not compared with the surface.",
    ),
    Mutant(
        "faces-not-counted",
        Clause.FILE_COUNT_3,
        "clers.container.file",
        "if (surface.faces, surface.vertices) != (contents.faces, contents.vertices):",
        "if surface.vertices != contents.vertices:",
        "The number of faces in HEAD is not compared with the surface.",
    ),
    Mutant(
        "version-is-damage",
        Clause.CONV_RESULT_3,
        "clers.conventions.reason",
        'UNKNOWN_VERSION = "unknown-version", Fault.UNSUPPORTED',
        'UNKNOWN_VERSION = "unknown-version", Fault.MALFORMED',
        "A file of another version is called damaged.",
    ),
    Mutant(
        "limit-is-invalid",
        Clause.CONV_RESULT_3,
        "clers.conventions.reason",
        'TOO_MANY_FACES = "too-many-faces", Fault.LIMIT',
        'TOO_MANY_FACES = "too-many-faces", Fault.INVALID',
        "A mesh over the limit is called invalid.",
    ),
    Mutant(
        "noncanonical-is-invalid",
        Clause.CONV_RESULT_3,
        "clers.conventions.reason",
        'NOT_CANONICAL = "not-canonical", Fault.MALFORMED',
        'NOT_CANONICAL = "not-canonical", Fault.INVALID',
        "Bits that no encoder writes are called invalid.",
    ),
)
