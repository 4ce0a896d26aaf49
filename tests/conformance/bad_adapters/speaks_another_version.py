"""Speaks protocol 2."""

from good import HELLO, reply, say, serve

HELLO["protocol"] = 2
serve(lambda _, request: say(reply(request)))
