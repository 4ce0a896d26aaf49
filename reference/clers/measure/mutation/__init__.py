"""Mutants: is each part of the code such that some test notices when it is changed?

Why not one of the tools that exist. mutmut 3.8 puts a switch before each function, so it changes
bodies of functions only: no tables, no fields of classes, no properties; it finds sources at the
root, in `src` or in `source` only; and it runs the tests that call a function rather than those
that execute a line. cosmic-ray writes each mutant into the working tree, and starts the test
command anew for each, with all tests. Neither draws a sample by a seed.
"""
