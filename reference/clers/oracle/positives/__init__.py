"""Cases with a good input, by families: asked here, answered by the reference."""
