"""Pieces of a module's source, by the places that `ast` gives."""

import ast
import re
from dataclasses import dataclass

Place = tuple[int, int, int, int]


@dataclass(frozen=True, slots=True)
class Text:
    """A source, cut into lines of bytes, for `ast` counts columns in bytes."""

    lines: tuple[bytes, ...]

    def cut(self, place: Place) -> str:
        """The text between two places."""
        line, column, end_line, end_column = place
        if line == end_line:
            return self.lines[line - 1][column:end_column].decode()
        middle = self.lines[line : end_line - 1]
        pieces = (self.lines[line - 1][column:], *middle, self.lines[end_line - 1][:end_column])
        return b"".join(pieces).decode()

    def of(self, node: ast.expr | ast.stmt) -> str:
        """The text of a node, without the parentheses around it."""
        return self.cut(whole(node))

    def within(self, node: ast.expr) -> str:
        """The text of a node, in parentheses where it may need them to stand elsewhere."""
        alone = ast.Name | ast.Attribute | ast.Call | ast.Subscript | ast.List
        return self.of(node) if isinstance(node, alone) else f"({self.of(node)})"

    def token(self, left: Place, right: Place, sign: str) -> Place | None:
        """Where a sign stands between two nodes on one line, or None."""
        between = self.cut((left[2], left[3], right[0], right[1]))
        pattern = r"\s+".join(map(re.escape, sign.split()))
        found = re.search(rf"\b{pattern}\b" if sign[0].isalpha() else pattern, between)
        if found is None:
            return None
        head = between[: found.start()].encode()
        line = left[2] + head.count(b"\n")
        start = len(head) - head.rfind(b"\n") - 1 if b"\n" in head else left[3] + len(head)
        return line, start, line, start + len(found.group().encode())


def text(source: str) -> Text:
    """The source, cut into lines."""
    return Text(tuple(source.encode().splitlines(keepends=True)))


def whole(node: ast.expr | ast.stmt) -> Place:
    """Where a node begins and ends."""
    end_line, end_column = node.end_lineno, node.end_col_offset
    assert end_line is not None, "ast.parse gives all places"
    assert end_column is not None, "ast.parse gives all places"
    return node.lineno, node.col_offset, end_line, end_column
