"""Sections of a scene file that name quantities, one to a file; a test compares this list with the folder."""

NAMES = ("answer", "choose", "find")
