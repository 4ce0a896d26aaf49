"""Kernels: the loops that all time goes into, over flat integers, compiled where that can be done.

A kernel is the one copy of its algorithm. It runs interpreted as it stands; `mypyc` makes machine
code of the same file. Integers are of 64 bits there and wrap without a word, so each kernel says
why its own cannot.
"""
