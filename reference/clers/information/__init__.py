"""Chapter 1: information. Probability models as values, and what a message costs under one."""
