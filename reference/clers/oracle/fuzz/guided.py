"""Fuzzing guided by coverage, of one decoder: `python -m clers.oracle.fuzz.guided --help`.

Needs the package atheris, the extra `fuzz`. Kernels are run interpreted, for machine code shows no
coverage. Exit code 0 if nothing was found; the input of a defect is printed in hexadecimal.
Clauses: CONV-RESULT-1, FILE-PARSE-2.
"""

import argparse
import os
import re
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final, NoReturn

CHILD: Final = "CLERS_GUIDED"
"""In the environment of the process that fuzzes: the name of its target."""

LONGEST: Final = 2048
"""Bytes of an input."""

PATIENCE: Final = 20
"""Seconds for one input."""


class DefectError(Exception):
    """A target said that something is wrong."""


def fuzz(name: str, arguments: list[str]) -> NoReturn:
    """Drive one target until the time is over or a defect shows."""
    import atheris

    with atheris.instrument_imports(include=["clers"]):
        from clers.oracle.fuzz.byte_targets import TARGETS

    target = TARGETS[name]

    def once(data: bytes) -> None:
        wrong = target.tried(bytes(data))
        if wrong is not None:
            raise DefectError(wrong)

    atheris.Setup([sys.argv[0], *arguments], once)
    atheris.Fuzz()
    sys.exit(0)


def campaign(name: str, seconds: int, seed: int) -> int:
    """Fuzz one target in a process of its own, and print one line of figures."""
    from clers.oracle.fuzz.byte_targets import TARGETS

    with TemporaryDirectory() as folder:
        corpus = Path(folder, "corpus")
        corpus.mkdir()
        for k, data in enumerate(TARGETS[name].seeds()):
            (corpus / f"seed-{k}").write_bytes(data)
        flags = [
            f"-max_total_time={seconds}", f"-seed={seed}", f"-max_len={LONGEST}",
            f"-timeout={PATIENCE}", "-rss_limit_mb=2048", "-print_final_stats=1",
            f"-artifact_prefix={folder}/found-", str(corpus),
        ]  # fmt: skip
        done = subprocess.run(
            [sys.executable, "-m", "clers.oracle.fuzz.guided", *flags],
            env={**os.environ, CHILD: name, "CLERS_KERNELS": "interpreted"},
            capture_output=True,
            text=True,
            errors="replace",
        )
        found = sorted(Path(folder).glob("found-*"))
        print(line(name, done.stderr, len(found)))
        for file in found:
            print(f"DEFECT {name} {file.name}: {file.read_bytes().hex()}")
        if found or done.returncode:
            print(done.stdout[-3000:] + done.stderr[-3000:])
            return 1
    return 0


def line(name: str, said: str, defects: int) -> str:
    """The figures of a run: executions, edges of the program reached, inputs kept, defects."""
    runs = re.findall(r"number_of_executed_units:\s*(\d+)", said)
    seen = re.findall(r"cov: (\d+) ft: \d+ corp: (\d+)", said)
    executed = runs[-1] if runs else "?"
    edges, kept = seen[-1] if seen else ("?", "?")
    return f"{name:9} {executed:>9} executions {edges:>6} edges {kept:>5} inputs {defects} defects"


def main() -> int:
    """Run a campaign on the targets that are named, or on all."""
    from clers.oracle.fuzz.byte_targets import TARGETS

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("targets", nargs="*", help=f"of {', '.join(TARGETS)}; else all")
    parser.add_argument("--seconds", type=int, default=60, help="for each target")
    parser.add_argument("--seed", type=int, default=1, help="which inputs")
    arguments = parser.parse_args()
    chosen = [str(name) for name in arguments.targets] or list(TARGETS)
    unknown = [name for name in chosen if name not in TARGETS]
    if unknown:
        parser.error(f"no target {', '.join(unknown)}")
    outcomes = [campaign(name, int(arguments.seconds), int(arguments.seed)) for name in chosen]
    return max(outcomes)


if __name__ == "__main__":
    if CHILD in os.environ:
        fuzz(os.environ[CHILD], sys.argv[1:])
    sys.exit(main())
