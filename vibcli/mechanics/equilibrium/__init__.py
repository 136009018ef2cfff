"""Equilibria: one, the nearest, all of them, and what is known about each."""
