"""Euler and handle operators on surfaces with boundary loops, and their inverses."""
