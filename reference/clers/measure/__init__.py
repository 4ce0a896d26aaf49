"""What things cost: benchmarks that print ratios."""
