"""Means over time of an output's square, exact to rounding: Gauss's rule on stretches shorter than any wave in it."""

import numpy as np

from vibcli.analyses.transient.isolating_intervals import fastest, stretches

POINTS = 20


def mean_square(motion, output, start, end):
    """(1/(end − start)) ∫ y² dt."""
    pieces = motion.pieces(end)
    y = pieces.terms(output, 0)
    cells = stretches(pieces.timeline, start, end)
    cells = cells.divided(max(1, int(np.ceil(fastest(y.nodes()) * cells.width.max() / 8))))
    at, weights = np.polynomial.legendre.leggauss(POINTS)
    half = cells.width / 2
    tau = (cells.early + half)[:, None] + half[:, None] * at
    values = y.at(np.repeat(cells.segment, POINTS), tau.ravel()).reshape(tau.shape)
    return float(half @ (values**2 @ weights)) / (end - start)
