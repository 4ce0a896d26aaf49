"""The specification read by machine: clauses, who cites them, and what is wrong with that."""
