"""What was found out about speed as tables for people, and as a page of the repository."""

from collections.abc import Iterator, Sequence

from clers.measure.bits.tables import Table, piped
from clers.measure.clock import Spread
from clers.measure.speed.contender import Kind, Way
from clers.measure.speed.ours import CODES
from clers.measure.speed.rates import Rate
from clers.measure.speed.report import Machine, OnMesh, Speed

NOTHING = "–"


def tables(of: Speed) -> Iterator[Table]:
    """For each mesh speeds, ratios and steps; then memory and growth. Clause: TOOL-SPEED-7."""
    for mesh in of.meshes:
        yield _speeds(mesh)
        yield _ratios(mesh)
        yield _steps(mesh)
    yield _memory(of.meshes)
    yield _growth(of)


def names(of: OnMesh, kind: Kind) -> tuple[str, ...]:
    """The names of a kind, each once, in their order."""
    return tuple(dict.fromkeys(rate.name for rate in of.rates if rate.kind is kind))


def _speeds(of: OnMesh) -> Table:
    heads = (
        "coder", "bytes/vertex", "encode", "least … most", "by the wall",
        "decode", "least … most", "by the wall",
    )  # fmt: skip
    rows = tuple(
        (
            name,
            _number(of.bytes_per_vertex(name), 3),
            *_speed(of.find(name, Way.ENCODE), of.faces),
            *_speed(of.find(name, Way.DECODE), of.faces),
        )
        for kind in (Kind.CODE, Kind.PEER)
        for name in names(of, kind)
    )
    title = f"{of.mesh}: million triangles a second ({of.faces} triangles)"
    return Table(title, heads, rows)


def _speed(of: Rate | None, faces: int) -> tuple[str, str, str]:
    if of is None:
        return NOTHING, NOTHING, NOTHING
    speed = of.triangles_per_second
    by_wall = faces / of.wall.median if of.wall.median > 0 else None
    return (
        _number(speed.median / 1e6, 2),
        f"{speed.least / 1e6:.2f} … {speed.most / 1e6:.2f}",
        _number(by_wall and by_wall / 1e6, 2),
    )


def _ratios(of: OnMesh) -> Table:
    columns = [(str(code), way) for code in CODES for way in Way]
    found = {(r.code, r.way, r.peer): r.ratio for r in of.ratios}
    rows = tuple(
        (peer, *(_number(found.get((code, way, peer)), 2) for code, way in columns))
        for peer in names(of, Kind.PEER)
    )
    heads = ("peer", *(f"{code}, {way}" for code, way in columns))
    return Table(f"{of.mesh}: a peer's time divided by ours", heads, rows)


def _steps(of: OnMesh) -> Table:
    def cells(spent: Spread) -> tuple[str, str]:
        least, most = (1e6 * value / of.faces for value in (spent.least, spent.most))
        return _number(1e6 * spent.median / of.faces, 3), f"{least:.3f} … {most:.3f}"

    rows = tuple(
        (rate.name, *cells(rate.cpu), _number(1e6 * rate.wall.median / of.faces, 3))
        for rate in of.rates
        if rate.kind is Kind.STEP
    )
    heads = ("step", "processor", "least … most", "wall")
    return Table(f"{of.mesh}: microseconds a triangle, step by step", heads, rows)


def _memory(meshes: Sequence[OnMesh]) -> Table:
    rows = tuple(
        (mesh.mesh, each.code, *(f"{x:.0f}" for x in (each.index_list, each.encode, each.decode)))
        for mesh in meshes
        for each in mesh.memory
    )
    heads = ("mesh", "code", "index list", "encode, beside it", "decode, with the surface")
    return Table("bytes a triangle at the peak", heads, rows)


def _growth(of: Speed) -> Table:
    rows = tuple(
        (
            each.family,
            each.name,
            str(each.way),
            *(_number(1e6 * t, 3) for t in each.seconds_per_triangle),
            _number(each.slope, 3),
            _number(each.ratio, 2),
            _number(each.worst, 2),
        )
        for each in of.slopes
    )
    sizes = tuple(f"at {faces}" for faces in of.slopes[0].faces) if of.slopes else ()
    heads = ("family", "code", "way", *sizes, "slope", "last / first", "at worst")
    return Table("microseconds a triangle as meshes grow", heads, rows)


def _number(value: float | None, digits: int) -> str:
    return NOTHING if value is None else f"{value:.{digits}f}"


def made_by(of: Machine, rounds: int) -> str:
    """Versions, machine and day in words. Clause: TOOL-SPEED-7."""
    packages = ", ".join(f"{name} {number}" for name, number in of.packages.items())
    loads = " and ".join(f"{load:.2f}" for load in of.load) or "not said"
    return (
        f"clers {of.clers}, kernels {of.kernels}; Python {of.python}; {of.processor}, "
        f"{of.cores} cores, {of.system}; {of.day}; rounds: {rounds}; "
        f"load at begin and end: {loads}; {packages}"
    )


def refused_lines(of: Speed) -> list[str]:
    """Who could not code what, and why. Clause: TOOL-SPEED-4."""
    return [
        f"{mesh.mesh}: {name}: {why}" for mesh in of.meshes for name, why in mesh.refused.items()
    ]


def page(of: Speed, command: str) -> str:
    """The tables as a page, with the command that made it. Clause: TOOL-SPEED-8."""
    lines = [
        "# Speed, measured",
        "",
        "What is timed, and how, is said in [the chapter on tools](../spec/10-speed.md). "
        "This page was printed by",
        "",
        f"    {command}",
        "",
        f"{made_by(of.machine, of.rounds)}.",
        "",
        "Speeds and ratios are by processor time, medians over the rounds; growth is by the least. "
        "A ratio above 1 says that ours is faster.",
        "",
    ]
    for table in tables(of):
        lines += [f"## {table.title[0].upper()}{table.title[1:]}", ""]
        lines += [piped(table.heads), piped(("---", *["---:"] * (len(table.heads) - 1)))]
        lines += [*map(piped, table.rows), ""]
    if refused := refused_lines(of):
        lines += ["## Not measured", "", *(f"- {each}" for each in refused), ""]
    return "\n".join(lines)
