"""Quantities that answers and conditions name, with their values."""
