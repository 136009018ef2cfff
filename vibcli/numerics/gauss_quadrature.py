"""Means over time of an output's square, exact to rounding: Gauss's rule on stretches shorter than any wave in it."""

import numpy as np

from vibcli.numerics.bracketed_newton import stretches

POINTS = 20


def mean_square(motion, output, start, end):
    """(1/(end − start)) ∫ y² dt."""
    pieces = motion.pieces(end)
    y = pieces.terms(output, 0)
    fastest = max((abs(node) for nodes in y.nodes() for node in nodes), default=0.0)
    cells = stretches(pieces.timeline, start, end)
    longest = (cells.late - cells.early).max()
    cells = cells.divided(max(1, int(np.ceil(fastest * longest / 8))))
    at, weights = np.polynomial.legendre.leggauss(POINTS)
    half = (cells.late - cells.early) / 2
    tau = (cells.early + half)[:, None] + half[:, None] * at
    values = y.at(np.repeat(cells.segment, POINTS), tau.ravel()).reshape(tau.shape)
    return float(half @ (values**2 @ weights)) / (end - start)
