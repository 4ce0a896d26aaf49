"""Judging: an outcome beside what was right, and where the two part."""
