"""Fuzzing: random requests, what is right to answer, and failures made as small as they can be."""
