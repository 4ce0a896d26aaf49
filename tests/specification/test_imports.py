"""Imports go one way: the rule, seen to fail on small repositories, and the order it goes by."""

from pathlib import Path

import pytest
from toy_repository import FILES, found, write

import clers
from clers.specification.imports import ORDER, earlier_only
from clers.specification.repository import read

WALK = "reference/clers/edgebreaker/walk.py"
SPEED = "reference/clers/measure/speed.py"


def faults(root: Path) -> list[str]:
    return [fault.sentence for fault in earlier_only(read(root))]


@pytest.mark.parametrize(
    ("path", "source"),
    [
        (WALK, "from clers.codes import golden\n"),
        (WALK, "def late() -> None:\n    import clers.codes.golden\n"),
        (SPEED, "if TYPE_CHECKING:\n    from clers.cli.output import line\n"),
        ("reference/clers/laws.py", "from clers.cli import output\n"),
    ],
)
def test_a_later_package(tmp_path: Path, path: str, source: str) -> None:
    """Clause: TOOL-BUILD-8: at the head, within a function, for types alone."""
    root = write(tmp_path, {**FILES, path: source})
    ((rule, place, line, _),) = found(root)
    assert (rule, place) == ("import", path)
    assert line == source.count("\n")
    assert "of a later package" in faults(root)[0]


@pytest.mark.parametrize(
    "source",
    [
        "from clers.edgebreaker import table\nfrom clers.complexes.surface import Surface\n",
        "import clers\nimport numpy.linalg\nfrom other.codes import golden\n",
    ],
)
def test_what_may_be_imported(tmp_path: Path, source: str) -> None:
    """Clause: TOOL-BUILD-8: the own package, earlier ones, and what is not of the reference."""
    assert found(write(tmp_path, {**FILES, WALK: source})) == []


def test_a_circle(tmp_path: Path) -> None:
    """Clause: TOOL-BUILD-8: also within a package, and in packages that have no place."""
    files = {
        "reference/clers/boxes/a.py": "from clers.boxes import b\n",
        "reference/clers/boxes/b.py": "def f() -> None:\n    from clers.boxes.c import x\n",
        "reference/clers/boxes/c.py": "import clers.boxes.a\n",
    }
    root = write(tmp_path, {**FILES, **files})
    assert faults(root) == [
        "reference/clers/boxes/a.py:1: imports go in a circle: "
        "clers.boxes.a → clers.boxes.b → clers.boxes.c → clers.boxes.a [import]"
    ]


def test_every_package_has_its_place() -> None:
    """Clause: TOOL-BUILD-8."""
    here = Path(clers.__file__).parent
    names = {path.stem for path in here.iterdir() if path.suffix == ".py" or path.is_dir()}
    assert names - {"__init__", "__pycache__"} == set(ORDER)
    assert len(set(ORDER)) == len(ORDER)
