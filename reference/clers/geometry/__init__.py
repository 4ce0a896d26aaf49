"""Chapter 7: positions. Exact and quantised coordinates, vertex order, prediction, residuals."""
