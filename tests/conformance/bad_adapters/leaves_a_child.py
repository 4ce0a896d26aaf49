"""Starts a child that outlives it and holds its pipes."""

import subprocess
import sys

from good import reply, say, serve

child = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(3600)"])
print(child.pid, file=sys.stderr, flush=True)
serve(lambda _, request: say(reply(request)))
