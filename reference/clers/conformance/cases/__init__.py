"""Cases: one request each, and what is right to answer."""
