"""What other people's codes make of the same connectivity."""
