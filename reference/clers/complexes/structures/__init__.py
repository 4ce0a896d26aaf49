"""Data structures of surfaces as refinements of the complex: half-edges, compact half-edges."""
