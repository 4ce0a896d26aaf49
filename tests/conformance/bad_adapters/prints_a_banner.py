"""Greets the world on standard output."""

from good import reply, say, serve

print("Welcome to FastMesh 0.3!", flush=True)
serve(lambda _, request: say(reply(request)))
