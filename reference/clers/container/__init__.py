"""Chapter 8: the container. A mesh as a file of sections, each layout declared once."""
