"""Files put together by hand: bytes and a CRC-32 of the test's own, from the spec alone."""

MAGIC = bytes.fromhex("89 43 4c 45 52 53 0d 0a")
VERSION = b"\x01"


def crc(data: bytes) -> bytes:
    """FILE-SECTION-2, bit by bit, lowest byte first."""
    register = 0xFFFFFFFF
    for byte in data:
        register ^= byte
        for _ in range(8):
            register = (register >> 1) ^ (0xEDB88320 if register & 1 else 0)
    return (register ^ 0xFFFFFFFF).to_bytes(4, "little")


def section(tag: str, payload: bytes) -> bytes:
    """FILE-SECTION-1."""
    header = tag.encode() + len(payload).to_bytes(4, "little")
    return header + crc(header) + payload + crc(payload)


def file(*sections: tuple[str, str]) -> bytes:
    """A file of sections, payloads in hexadecimal."""
    body = b"".join(section(tag, bytes.fromhex(payload)) for tag, payload in sections)
    return MAGIC + VERSION + body


HEAD = "01 01 04 04 00 03 00"
"""plain, no positions, 4 faces, 4 vertices, no boundary, 3 symbols, no records."""

WORD = "06 bc"
"""CRE with its C implied: R is 101, E is 111, so 101111 in six bits, filled to 10111100."""

TETRAHEDRON = file(("HEAD", HEAD), ("WORD", WORD))
