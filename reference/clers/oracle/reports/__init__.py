"""What a run of the oracle came to, for people: as Markdown and as one HTML file."""
