"""Does not end when it should."""

import time

from good import reply, say, serve

serve(lambda _, request: say(reply(request)))
time.sleep(3600)
