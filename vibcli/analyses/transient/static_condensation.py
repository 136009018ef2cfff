"""Systems in which some coordinates have no inertia: what follows at once is condensed, what a damper holds back stays.

    M a'' + C_aa a' + C_az z' + K_a· q = f_a        C_za a' + C_zz z' + K_z· q = f_z        K_s· q = f_s

a: coordinates with inertia; z: directions without, whose dampers C_zz resist; s: those that no damper resists. They
follow statically, q = T (a, z) + F f with F = U (Uᵀ K U)⁻¹ Uᵀ over the directions U of s. What is left is of second
order in a and of first order in z: a start has places of a and z and velocities of a alone.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.transient.modal_block import ModalBlock

EPSILON = 2.0**-52
NOTHING = 1e-13


class Condensed(NamedTuple):
    """M, C, K of (a, z), a first. T: columns that give q from them; left: columns along which the equations are taken;
    places: rows that give (a, z) of q; follow: F."""

    M: np.ndarray
    C: np.ndarray
    K: np.ndarray
    T: np.ndarray
    left: np.ndarray
    places: np.ndarray
    follow: np.ndarray


def condensed(M: np.ndarray, C: np.ndarray, K: np.ndarray) -> Condensed | None:
    """The Condensed of a system; None where every coordinate has inertia."""
    bare = np.flatnonzero(M.diagonal() == 0)
    if not len(bare) or M[bare].any() or M[:, bare].any():
        return None
    n, heavy = len(M), np.flatnonzero(M.diagonal() != 0)
    held, loose = _directions(C[np.ix_(bare, bare)])
    columns = np.eye(n)
    places = np.concatenate([columns[heavy], held.T @ columns[bare]])
    U = columns[:, bare] @ loose
    _check_undamped(C, U)
    T, left, follow = places.T, places.T, np.zeros((n, n))
    if U.shape[1]:
        inverse = _inverse(U.T @ K @ U)
        T, left = T - U @ (inverse @ (U.T @ K @ T)), left - U @ (inverse.T @ (U.T @ K.T @ left))
        follow = U @ inverse @ U.T
    M, C, K = (left.T @ matrix @ T for matrix in (M, C, K))
    return Condensed(M, C, K, T, left, places, follow)


def _directions(C: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Columns of the directions that dampers resist, and of those that they do not."""
    touched = np.flatnonzero(C.any(axis=0) | C.any(axis=1))
    free = np.setdiff1d(np.arange(len(C)), touched)
    columns = np.eye(len(C))
    inner = C[np.ix_(touched, touched)]
    if not np.array_equal(inner, inner.T):
        raise PhysicsError("the damping of coordinates without inertia is not symmetric",
                           hint="a coordinate that no inertia moves cannot turn or be driven by velocities")
    if not len(touched):
        return columns[:, :0], columns
    unit = np.exp2(-np.round(np.log2(np.maximum(inner.diagonal(), np.finfo(float).tiny)) / 2))
    values, vectors = np.linalg.eigh(unit[:, None] * inner * unit)
    none = np.abs(values) <= 16 * len(values) * EPSILON * np.abs(values).max()
    if not none.any():
        return columns[:, touched], columns[:, free]
    slack, _ = np.linalg.qr(unit[:, None] * vectors[:, none])
    held = np.linalg.svd(slack)[0][:, slack.shape[1]:]
    return columns[:, touched] @ held, np.concatenate([columns[:, touched] @ slack, columns[:, free]], axis=1)


def _check_undamped(C: np.ndarray, U: np.ndarray) -> None:
    """Directions without inertia and damper may only follow: velocities must not drive them, nor they anything."""
    if U.size and max(np.abs(C @ U).max(), np.abs(C.T @ U).max()) > NOTHING * np.abs(C).max(initial=0.0):
        raise PhysicsError("a coordinate without inertia is driven by velocities, and no damper of its own resists it",
                           hint="give it an inertia, or a damper")


def _inverse(K: np.ndarray) -> np.ndarray:
    """K⁻¹ of what follows statically; refused where nothing holds it."""
    unit = np.exp2(-np.round(np.log2(np.maximum(np.abs(K).max(axis=1), np.finfo(float).tiny)) / 2))
    scaled = unit[:, None] * K * unit
    sizes = np.linalg.svd(scaled, compute_uv=False)
    if sizes[-1] <= 16 * len(K) * EPSILON * sizes[0]:
        raise PhysicsError("neither inertia, damper nor spring holds a coordinate: its motion in time is not "
                           "determined", hint="give what it moves a mass, a damper or a spring")
    found: np.ndarray = unit[:, None] * np.linalg.inv(scaled) * unit
    return found


def whole(block: "ModalBlock", system: Condensed) -> "ModalBlock":
    """A Block of (a, z) as one of all coordinates."""
    return block._replace(X=system.T @ block.X, P=block.P @ system.places, R=block.R @ system.places,
                          W=block.W @ system.left.T)


def leading(M: np.ndarray, C: np.ndarray) -> tuple[int, np.ndarray]:
    """(h, L): the first h coordinates have inertia, and L (ż, ä) is what the forces leave for the highest rates."""
    h = int(np.count_nonzero(M.diagonal()))
    return h, np.concatenate([C[:, h:], M[:, :h]], axis=1)
