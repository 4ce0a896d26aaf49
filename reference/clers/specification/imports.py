"""The rule on imports: they go one way. Clause: TOOL-BUILD-8."""

from collections.abc import Iterator, Mapping
from graphlib import CycleError, TopologicalSorter
from pathlib import PurePosixPath
from typing import Final

from clers.specification.finding import Finding
from clers.specification.python_sites import Module
from clers.specification.repository import Repository

REFERENCE: Final = "reference/"

ORDER: Final = (
    "conventions", "kernels", "information", "arithmetic", "complexes", "operators", "edgebreaker",
    "codes", "geometry", "container", "meshfile", "corpus", "pictures", "specification", "site",
    "conformance", "generate", "measure", "oracle", "laws", "cli", "__main__",
)  # fmt: skip
"""The packages of the reference: chapters 0 to 8, then what serves all of them. TOOL-BUILD-8."""

RULE: Final = "import"


def earlier_only(of: Repository) -> Iterator[Finding]:
    """Each import goes to the module's own package or an earlier one; none goes in a circle.

    Of packages that are not in the order only circles are found. Clause: TOOL-BUILD-8.
    """
    modules = {_name(module): module for module in of.modules if module.path.startswith(REFERENCE)}
    for name, module in modules.items():
        own = _rank(name)
        for imported, line in module.imports:
            rank = _rank(imported)
            if own is not None and rank is not None and rank > own:
                text = f"{ORDER[own]} imports {imported}, of a later package"
                yield Finding(RULE, module.path, line, "", text)
    circle = _circle(modules)
    if circle:
        text = f"imports go in a circle: {' → '.join(circle)}"
        yield Finding(RULE, modules[circle[0]].path, 1, "", text)


def _name(module: Module) -> str:
    """The dotted name of a module of the reference; of a package that of its folder."""
    path = PurePosixPath(module.path.removeprefix(REFERENCE))
    return ".".join(path.parent.parts if path.stem == "__init__" else path.with_suffix("").parts)


def _rank(name: str) -> int | None:
    """The place of a module's package in the order, if it has one."""
    top, _, rest = name.partition(".")
    package = rest.partition(".")[0]
    return ORDER.index(package) if top == "clers" and package in ORDER else None


def _circle(modules: Mapping[str, Module]) -> tuple[str, ...]:
    """Modules each of which imports the next, from the least of them around to itself; or none."""
    graph: dict[str, set[str]] = {name: set() for name in modules}
    for name, module in modules.items():
        for imported, _ in module.imports:
            whole = imported if imported in modules else imported.rpartition(".")[0]
            if whole in modules and whole != name:
                graph[name].add(whole)
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        found: list[str] = error.args[1][:0:-1]  # each is imported by the next
        least = found.index(min(found))
        return (*found[least:], *found[: least + 1])
    return ()
