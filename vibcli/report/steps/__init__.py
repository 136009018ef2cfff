"""The worked solution of a scene: one line a thought, letters first, then the numbers put in.

A line is a WorkedLine: what it settles, the lines that it follows from, its expression and value. Lines come from the
terms of the scene, which keep their element; what they add up to is held against the engine before any is told.
"""
