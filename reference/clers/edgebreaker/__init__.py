"""Chapter 5: Edgebreaker. Surfaces to words and handle data, and back."""
