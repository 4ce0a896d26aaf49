"""What a case asks, how its answer comes about, and where another answer goes astray."""
