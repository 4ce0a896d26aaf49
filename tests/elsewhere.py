"""Tests of a file in another process, whose kernels are interpreted."""

import os
import subprocess
import sys
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from xml.etree import ElementTree


def outcome_of(file: Path, test: str) -> str:
    """What a test said there when it failed; nothing if it passed."""
    return _outcomes(file).get(test, f"{test} did not run in another process")


@cache
def _outcomes(file: Path) -> Mapping[str, str]:
    """What each test of a file said; nothing of those that passed."""
    inherited = {key: value for key, value in os.environ.items() if not key.startswith("PYTEST_")}
    with TemporaryDirectory() as folder:
        report = Path(folder) / "report.xml"
        subprocess.run(
            [sys.executable, "-m", "pytest", f"--junitxml={report}", str(file)],
            env={
                **inherited,
                "CLERS_KERNELS": "interpreted",
                "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",  # loading them takes long
            },
            cwd=Path(__file__).parents[1],
            capture_output=True,
            check=False,
        )
        if not report.exists():
            return {}
        cases = ElementTree.parse(report).iter("testcase")
        return {case.get("name", ""): _said(case) for case in cases}


def _said(case: ElementTree.Element) -> str:
    """A test that was left out has not passed."""
    return "\n".join(f"{found.tag}: {found.text or found.get('message')}" for found in case)
