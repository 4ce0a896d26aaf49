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


def test_the_launcher_is_quick_and_alone() -> None:
    """ORCL-RUN-7: it imports nothing of the package."""
    from clers.conformance import launcher

    text = Path(launcher.__file__).read_text()
    assert "clers" not in text.partition('"""\n\nimport')[2]
