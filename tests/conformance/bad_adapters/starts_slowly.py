"""Needs a moment before it reads its first line."""

import sys
import time

from good import reply, say, serve

time.sleep(float(sys.argv[1]) if len(sys.argv) > 1 else 0.2)
serve(lambda _, request: say(reply(request)))
