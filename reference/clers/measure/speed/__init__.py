"""How fast the path is, beside peers, in one run."""
