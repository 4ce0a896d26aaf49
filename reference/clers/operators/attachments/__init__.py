"""Attachments of simplices in every dimension: generic, Euler, manifold, handles."""
