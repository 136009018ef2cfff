"""Energies, Lagrange's equations and their linearisation."""
