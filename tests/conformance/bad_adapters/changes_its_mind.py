"""Is called otherwise each time it is started."""

import os

from good import HELLO, reply, say, serve

HELLO["name"] = f"bad {os.getpid()}"
serve(lambda _, request: say(reply(request)))
