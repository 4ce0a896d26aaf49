"""`clers spec site`: the specification as pages to read and search. Clause: TOOL-SITE-1."""

from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

from clers.cli.options import AsJson, Root, repository_root
from clers.cli.output import Exit, json, line, note, progress, reject, stop
from clers.cli.reading import is_running, read_with_laws

if TYPE_CHECKING:
    from clers.site.build import Material

NEEDED: Final = ("latex2mathml", "mdit_py_plugins", "pygments")
"""What the extra `site` installs. Clause: TOOL-SITE-13."""


def _need() -> None:
    """One line and exit 2 without what the site is made with. Clause: TOOL-SITE-13."""
    for name in NEEDED:
        try:
            import_module(name)
        except ModuleNotFoundError:
            note(f"clers spec site needs the package {name}: pip install 'clers[site]'")
            stop(Exit.USAGE)


def _material(root: Path, *, as_json: bool) -> "Material":
    from clers.conventions.result import Rejected
    from clers.oracle.suite.by_clause import by_clause
    from clers.site.build import Material

    repository = read_with_laws(root)
    suite = root / "corpus" / "vectors"
    vectors = by_clause(suite) if suite.is_dir() else None
    if isinstance(vectors, Rejected):
        reject(str(suite), vectors, as_json=as_json)
    if not is_running(root):
        return Material(repository, (), vectors.value if vectors else {})
    from clers.laws import ALL

    return Material(repository, ALL, vectors.value if vectors else {})


def site(
    out: Annotated[
        Path | None, typer.Option("-o", metavar="FOLDER", help="Write it; else only check it.")
    ] = None,
    root: Root = None,
    as_json: AsJson = False,
) -> None:
    """Make pages of the specification to read and search, and check them.

    Clauses: TOOL-SITE-1, TOOL-SITE-8.
    """
    _need()
    from clers.conventions.result import Rejected
    from clers.site.build import STEPS, site
    from clers.site.folder import write_site

    folder = repository_root(root)
    with progress("site", STEPS) as step:
        step("specification")
        made, found = site(_material(folder, as_json=as_json), step)
    written = write_site(out, made.files) if out is not None and not found else None
    if isinstance(written, Rejected):
        reject(str(out), written, as_json=as_json)
    size = sum(map(len, made.files.values()))
    if as_json:
        json(
            {
                "folder": str(written.value) if written else None,
                "files": len(made.files),
                "bytes": size,
                "clauses": len(made.clauses),
                "findings": found,
            }
        )
    else:
        for finding in found:
            line(finding.sentence)
        state = f"written to {written.value}" if written else "not written"
        counts = f"{len(made.files)} files, {size} bytes, {len(made.clauses)} clauses"
        line(f"{counts}, {len(found)} findings, {state}")
    stop(Exit.NOT_CONFORMING if found else Exit.CONFORMING)
