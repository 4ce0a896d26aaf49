"""Chapter 2: the arithmetic coder. Exact over fractions, and in 32 bits with renormalisation."""
