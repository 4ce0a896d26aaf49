"""Bits of connectivity: each code of chapter 6 beside peers, entropies and the limit."""
