"""Uniform pieces of bars, shafts, strings and beams: their exact dynamic stiffness, and what follows from it."""
