"""The oracle: vectors, runs, findings, and the evidence that it finds what it should."""
