"""A survey as a page of the repository. Clause: ORCL-CODEC-15."""

from collections import Counter
from collections.abc import Iterator, Sequence

from clers.conformance import payloads as form
from clers.oracle.codecs.asking import QUIET, Became
from clers.oracle.codecs.made import LOOSE_NAME
from clers.oracle.codecs.remarks import remark
from clers.oracle.codecs.survey import Row, Shown, Survey

SAME = "="


def page(of: Survey, command: str) -> str:
    """The page, and the command that makes it anew. Pure. Clause: ORCL-CODEC-15."""
    return "\n".join((*_head(of, command), *_table(of), *_findings(of), *_left_out(of)))


def _head(of: Survey, command: str) -> Iterator[str]:
    packages = ", ".join(f"{name} {number}" for name, number in of.packages.items())
    yield "# What comes back from other codecs"
    yield ""
    yield (
        "Meshes sent through codecs of other people, and what came back compared with what was "
        "sent. When two meshes are the same, and what the differences are called, is said in "
        "[the chapter on codecs](../spec/09-codecs.md). Not every difference is a fault: many are "
        "what the codec's authors chose and say, and this is noted with each. This page was "
        "printed by"
    )
    yield ""
    yield f"    {command}"
    yield ""
    yield f"clers {of.clers}; {packages}."
    yield ""
    yield from _listed([("column", "adapter"), *zip(of.settings, _code(of.commands), strict=True)])
    if of.missing:
        yield f"Not installed, so not asked: {', '.join(of.missing)}."
        yield ""
    yield (
        "Positions are rounded to binary32 first. Without quantisation no coordinate may move; "
        "with 11 bits none may move further than half a step. Files stand first; then small "
        "meshes made for this. Dirty files and small meshes are sent as they are, surfaces or not."
    )
    yield ""


def _code(words: Sequence[str]) -> list[str]:
    return [f"`{word}`" for word in words]


def _listed(rows: Sequence[Sequence[str]]) -> Iterator[str]:
    """A table whose first row is its head."""
    yield _piped(rows[0])
    yield _piped(["---"] * len(rows[0]))
    yield from map(_piped, rows[1:])
    yield ""


def _piped(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"


def _table(of: Survey) -> Iterator[str]:
    yield "## Meshes"
    yield ""
    yield f"`{SAME}` is the same mesh. A number is how often a difference is there."
    yield ""
    single = [row for row in of.rows if not row.mesh.startswith(LOOSE_NAME)]
    loose = [row for row in of.rows if row.mesh.startswith(LOOSE_NAME)]
    heads = ("mesh", "vertices", "faces", *of.settings)
    rows = [cells(row) for row in single]
    yield from _listed([heads, *rows, *_together(loose, len(of.settings))])


def cells(row: Row) -> list[str]:
    """A row of the table: the mesh, and what became of it."""
    return [row.mesh, str(row.vertices), str(row.faces), *map(_cell, row.became)]


def _cell(became: Became) -> str:
    if became.word == "same":
        return SAME
    return ", ".join(f"{d.kind} {d.count}" for d in became.differences) or became.word


def _together(loose: Sequence[Row], settings: int) -> Iterator[list[str]]:
    """Meshes of loose triples in one row: how many came to what."""
    if not loose:
        return
    counted = [Counter(row.became[k].word for row in loose) for k in range(settings)]
    words = [", ".join(f"{word} {n}" for word, n in sorted(c.items())) for c in counted]
    yield [f"{len(loose)} meshes of loose triples", "", "", *words]


def _findings(of: Survey) -> Iterator[str]:
    yield "## Differences, each on a mesh as small as it can be"
    yield ""
    yield (
        "From these meshes no face, and no vertex, can be taken away, and no two vertices can be "
        "made one, without a change in what is found. A vertex is written with its place."
    )
    yield ""
    clean = [name for name in of.settings if all(shown.setting != name for shown in of.shown)]
    if clean:
        yield f"None was found on {' and '.join(_code(clean))}."
        yield ""
    for alike in _alike(of.shown):
        yield from _finding(alike, of)


def _alike(shown: Sequence[Shown]) -> list[list[Shown]]:
    """Findings of several settings that show on one mesh, and of which the same is said."""
    groups: dict[tuple[str, form.MeshForm, frozenset[str], str], list[Shown]] = {}
    for one in shown:
        said = remark(one.setting, one.finding)
        key = (one.finding, one.smallest, one.became.findings, said)
        groups.setdefault(key, []).append(one)
    return list(groups.values())


def _finding(alike: Sequence[Shown], of: Survey) -> Iterator[str]:
    first = alike[0]
    yield f"### `{first.finding}`: {', '.join(one.setting for one in alike)}"
    yield ""
    many = " or ".join(map(str, sorted({len(one.meshes) for one in alike})))
    yield f"On {many} of {len(of.rows)} meshes. {remark(first.setting, first.finding)}"
    yield ""
    yield "```"
    yield "sent"
    yield from _literal(first.smallest)
    yield f"through {first.setting}"
    if first.became.came is None:
        yield f"  {first.became.why}"
    else:
        yield from _literal(first.became.came)
    for difference in first.became.differences:
        yield difference.line()
    yield "```"
    yield ""


def _literal(mesh: form.MeshForm) -> Iterator[str]:
    """Vertices with their places, then faces."""
    at = mesh.positions.coordinates if isinstance(mesh.positions, form.Places) else ()
    words = [f"{x:.9g}" for x in at]
    for v, place in enumerate(zip(words[0::3], words[1::3], words[2::3], strict=True)):
        yield f"  vertex {v}  ({', '.join(place)})"
    for t, face in enumerate(mesh.faces):
        yield f"  face {t}    {' '.join(map(str, face))}"


def _left_out(of: Survey) -> Iterator[str]:
    refused = _refused(of)
    if refused:
        yield "## Refused"
        yield ""
        yield (
            "To refuse is a codec's right, and no difference. A face that names a vertex that is "
            "not there is refused by the adapter; no codec is asked about it (ORCL-CODEC-9)."
        )
        yield ""
        yield from _listed([("why", "meshes", "columns"), *refused])
    if of.left_out:
        yield "## Left out"
        yield ""
        yield "Files that cannot be read as triangles, or whose coordinates no message can name."
        yield ""
        yield from _listed([("file", "why"), *of.left_out])


def _refused(of: Survey) -> list[tuple[str, str, str]]:
    """What was refused: why, which meshes, in which columns."""
    meshes: dict[tuple[str, str], list[str]] = {}
    for row in of.rows:
        for setting, became in zip(of.settings, row.became, strict=True):
            if became.word in QUIET and became.why:
                meshes.setdefault((became.why, setting), []).append(row.mesh)
    columns: dict[tuple[str, tuple[str, ...]], list[str]] = {}
    for (why, setting), some in meshes.items():
        columns.setdefault((why, tuple(some)), []).append(setting)
    return [
        (why, f"{len(some)}, the first {some[0]}", ", ".join(settings))
        for (why, some), settings in columns.items()
    ]
