"""An interrupt from the keyboard leaves no process behind."""

import signal
import subprocess
import sys
import time
from pathlib import Path

from bad_commands import bad, is_gone, runs

WAITING = """
import sys
from clers.conformance.messages import Echo
from clers.conformance.session import Session, asked
with Session(sys.argv[1:]) as session:
    session.introduction()
    print(session.pid, flush=True)
    session.ask(asked(1, Echo(id=0, input={})))
"""


def test_an_interrupt_ends_every_child() -> None:
    """Clauses: ORCL-RUN-9, TOOL-EXIT-2."""
    command = (sys.executable, "-c", WAITING, *bad("hangs"))
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as oracle:
        assert oracle.stdout is not None
        adapter = int(oracle.stdout.readline())
        assert runs(adapter)
        time.sleep(0.2)
        oracle.send_signal(signal.SIGINT)
        assert oracle.wait(20) != 0
    assert is_gone(adapter)


def test_an_interrupted_doctor(tmp_path: Path) -> None:
    """Clauses: ORCL-RUN-9, TOOL-EXIT-2: one line, code 130, and nobody left."""
    number = tmp_path / "pid"
    hangs = " ".join(bad("hangs"))
    shell = f"sh -c 'echo $$ > {number}; exec {hangs}'"
    main = "from clers.cli.main import main; main()"
    command = (sys.executable, "-c", main, "adapter", "doctor", "-a", shell, "--seconds", "60")
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as oracle:
        deadline = time.monotonic() + 60
        while not (number.exists() and number.read_text().endswith("\n")):
            assert time.monotonic() < deadline
            time.sleep(0.02)
        adapter = int(number.read_text())
        time.sleep(0.3)
        oracle.send_signal(signal.SIGINT)
        out, errors = oracle.communicate(timeout=30)
    assert (oracle.returncode, out, errors) == (130, b"", b"clers: interrupted\n")
    assert is_gone(adapter)


def test_the_launcher_is_quick_and_alone() -> None:
    """ORCL-RUN-7: it imports nothing of the package."""
    from clers.conformance import launcher

    text = Path(launcher.__file__).read_text()
    assert "clers" not in text.partition('"""\n\nimport')[2]
