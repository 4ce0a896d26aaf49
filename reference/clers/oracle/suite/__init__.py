"""The suite of golden vectors: its files, what must hold of them, and how it changes."""
