"""Points of a path of equilibria, and the steps between them."""

import numpy as np

from vibcli.base.named_tuple import NamedTuple


class PathPoint(NamedTuple):
    """An equilibrium of the path: y = (q, p) in units of the metric, {coordinate: float}, the tangent, the sign of
    det [K ∂r/∂p; tangent], how many eigenvalues of K are negative, K, how far Newton's method moved."""

    y: np.ndarray
    position: dict[str, float]
    tangent: np.ndarray
    sense: int
    unstable: int
    K: np.ndarray
    moved: float = 0.0


class PathStep(NamedTuple):
    """A step from one point to another. `branching`: do other paths cross it? `corner`: does it bend sharply, as
    forces do?"""

    start: PathPoint
    end: PathPoint
    step: float
    branching: bool
    corner: bool = False
