"""What a run came to, for people at a terminal and for other programs."""
