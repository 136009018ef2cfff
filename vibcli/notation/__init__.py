"""Expressions and numbers as they are written: text, LaTeX, MathML, scene language."""
