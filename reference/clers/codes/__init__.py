"""Chapter 6: codes. Words to bits and back, with what is guaranteed."""
