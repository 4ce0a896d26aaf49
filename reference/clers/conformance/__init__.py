"""Chapter 9: the protocol of adapters, the reference as one, and processes within bounds."""
