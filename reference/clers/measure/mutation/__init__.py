"""Mutants: is each part of the code such that some test notices when it is changed?

Why not one of the tools that exist. mutmut 3 renames functions and puts a switch before each, so
it changes bodies of functions only: neither tables, nor defaults, nor anything of a class that is
decorated, as all sum types here are; it draws no sample, and runs what tests call a function
rather than what tests run a line. cosmic-ray writes each mutant into the working tree, and starts
a fresh pytest for each, with all tests.
"""
