"""Plots of responses, frequency responses, eigenvalues and mode shapes: data, for the terminal, as files, as SVG."""
