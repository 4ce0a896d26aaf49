"""What children do: run the tests, on the source as it is or on a mutant."""

import os
import signal
import sys
import time
from collections.abc import Generator, Mapping, Sequence
from pathlib import Path
from types import FrameType
from typing import Final

import coverage
import msgspec
import pytest

from clers.measure.mutation.outcome import ON_IMPORT, Baseline, Fate, Subject, Trial
from clers.measure.mutation.served import forget, serve

QUIET: Final = ("-q", "-x", "-p", "no:cacheprovider", "--import-mode=prepend")
IMPORT: Final = "import"


def _no_shrinking() -> None:
    """Let Hypothesis stop at the first failing example: which is the least does not matter."""
    if "hypothesis" in sys.modules:
        from hypothesis import Phase, settings

        settings.register_profile("mutation", phases=[Phase.explicit, Phase.generate])
        settings.load_profile("mutation")


class _Recorder:
    """Notes of each test whether it passes, how long it takes, and which lines it executes."""

    def __init__(self, traced: coverage.Coverage) -> None:
        self._traced = traced
        self.seconds: dict[str, float] = {}
        self.failed: dict[str, None] = {}

    def pytest_configure(self) -> None:
        _no_shrinking()

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Generator[None, object, object]:
        self._traced.stop()  # and begin anew, for a test may have put another tracer in its place
        self._traced.start()
        self._traced.switch_context(item.nodeid)
        start = time.process_time()
        done = yield
        self.seconds[item.nodeid] = time.process_time() - start
        self._traced.switch_context("")
        return done

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if not report.passed:
            self.failed[report.nodeid] = None


def baseline(subjects: Sequence[Subject], root: str, tests: Sequence[str]) -> bytes:
    """Run the tests once on the source as it is. Clauses: TOOL-MUTATION-3, TOOL-MUTATION-4."""
    before = set(sys.modules)
    forget(root)
    files = [subject.path for subject in subjects]
    traced = coverage.Coverage(data_file=None, config_file=False, include=files)
    traced.start()
    recorder = _Recorder(traced)
    pytest.main([*(option for option in QUIET if option != "-x"), *tests], plugins=[recorder])
    traced.stop()
    passed = {n: s for n, s in recorder.seconds.items() if n not in recorder.failed}
    number = {name: i for i, name in enumerate(passed)} | {"": ON_IMPORT}
    data = traced.get_data()
    lines = {
        path: {
            line: tuple(sorted(number[name] for name in names if name in number))
            for line, names in data.contexts_by_lineno(path).items()
        }
        for path in data.measured_files()
    }
    loaded = tuple(
        sorted(
            name
            for name in sys.modules.keys() - before
            if name.split(".")[0] != root and "." not in name and _installed(name)
        )
    )
    return msgspec.json.encode(Baseline(passed, tuple(recorder.failed), lines, loaded))


def _installed(name: str) -> bool:
    """Does a module come from where libraries are installed? Tests are imported anew."""
    path = getattr(sys.modules[name], "__file__", None)
    return isinstance(path, str) and "site-packages" in Path(path).parts


class _Chosen:
    """Runs chosen tests in the given order, each within its time, until one fails."""

    def __init__(self, seconds: Mapping[str, float], write: int) -> None:
        self._seconds, self._write = seconds, write
        self._now = IMPORT
        self.killer = ""

    def pytest_configure(self) -> None:
        _no_shrinking()

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        found = {item.nodeid: item for item in items}
        items[:] = [found[name] for name in self._seconds if name in found]

    def pytest_runtest_logstart(self, nodeid: str) -> None:
        self._now = nodeid
        signal.setitimer(signal.ITIMER_PROF, self._seconds[nodeid])

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if report.failed:
            self.killer = report.nodeid

    def over(self, _signal: int, _frame: FrameType | None) -> None:
        """Say that the time is over, and end at once."""
        os.write(self._write, msgspec.json.encode(Trial(Fate.TIMED_OUT, self._now)))
        os._exit(0)


def trial(
    subject: Subject, source: str, root: str, seconds: Mapping[str, float], write: int
) -> bytes:
    """Run tests, in the order of `seconds`, on another source. Clause: TOOL-MUTATION-3."""
    forget(root)
    serve(subject, source)
    chosen = _Chosen(seconds, write)
    signal.signal(signal.SIGPROF, chosen.over)
    signal.setitimer(signal.ITIMER_PROF, 60)
    files = dict.fromkeys(name.split("::")[0] for name in seconds)
    code = pytest.main([*QUIET, *files], plugins=[chosen])
    signal.setitimer(signal.ITIMER_PROF, 0)
    # Where the mutant makes parameters of tests, none of those may be left: nothing fails then.
    if code in (pytest.ExitCode.OK, pytest.ExitCode.NO_TESTS_COLLECTED):
        return msgspec.json.encode(Trial(Fate.SURVIVED))
    return msgspec.json.encode(Trial(Fate.KILLED, chosen.killer or IMPORT))
