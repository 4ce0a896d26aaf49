"""Reads a line and ends."""

import sys

sys.stdin.readline()
sys.exit(5)
