"""Chapter 0: clauses, results, verdicts and laws; what every other chapter is written in."""
