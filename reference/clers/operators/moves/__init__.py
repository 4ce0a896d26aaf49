"""Moves in every dimension: collapses, stellar and bistellar moves, contractions."""
