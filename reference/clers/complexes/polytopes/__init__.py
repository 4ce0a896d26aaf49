"""Polytopes: polygonal and polyhedral cell complexes, duals, triangulation."""
