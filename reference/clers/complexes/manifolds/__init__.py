"""Manifolds: decided through links; orientation; the classification of surfaces."""
