"""The front door, `clers` and `python -m clers`: nothing is read that is not needed.

The reference as an adapter has no options. Neither Typer nor any command is read for it, for a run
starts it again for each piece. Clauses: TOOL-START-2, TOOL-EXIT-2.
"""

import sys

INTERRUPTED = 130
"""Clause: TOOL-EXIT-1."""


def main() -> None:
    """Run the program; an interrupt ends it with one line and code 130. Clause: TOOL-EXIT-2."""
    try:
        if sys.argv[1:] == ["adapter", "reference"]:
            from clers.conformance.adapter import loop

            loop(sys.stdin.buffer, sys.stdout.buffer)
        else:
            from clers.cli.main import main

            main()
    except KeyboardInterrupt:
        sys.stderr.write("clers: interrupted\n")
        sys.exit(INTERRUPTED)


if __name__ == "__main__":
    main()
