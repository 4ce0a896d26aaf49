"""Shrinking: from an input that fails to a smaller one that fails alike, until none is left."""
