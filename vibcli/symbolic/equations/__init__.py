"""Equations in free symbols, solved."""
