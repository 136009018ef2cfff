"""Sections of a scene file that are no element, one to a file; a test compares this list with the folder."""

NAMES = ("coordinates", "equilibrium", "initial", "parameter", "record")
