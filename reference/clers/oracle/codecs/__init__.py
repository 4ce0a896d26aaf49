"""Codecs of other people as adapters, and what the oracle finds on them."""
