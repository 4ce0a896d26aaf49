"""The operations of the reference, each a pure function from its input to its result."""
