"""A suite against an adapter: what is asked, what came of it, and what was known before."""
