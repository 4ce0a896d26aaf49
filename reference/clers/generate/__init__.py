"""Random and regular meshes: Hypothesis strategies for every law, and plain functions."""
