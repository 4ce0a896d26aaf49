"""Campaigns: one task over many items, on this machine or on a cluster, in order."""
