"""A linear system as independent blocks."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.transient.modal_block import ModalBlock, apart
from vibcli.analyses.transient.static_condensation import whole
from vibcli.base.errors import PhysicsError
from vibcli.numerics.components import components

if TYPE_CHECKING:
    from vibcli.analyses.modal.undamped import Mode

COUPLED, EPSILON = 1e-14, 2.0**-52
FLAT = 0.1


def spectrum(M: np.ndarray, C: np.ndarray, K: np.ndarray, modes: "Sequence[Mode] | None" = None,
             system: Any = None, rigid: np.ndarray | None = None) -> list[ModalBlock]:
    """The Blocks of M q̈ + C q̇ + K q = f: of each set of coordinates that nothing couples to others.

    modes: undamped modes that replace those of the matrices where damping does not couple them. system: the Condensed
    of coordinates that have no inertia, or None where all have one. rigid: columns of what moves freely, K being
    symmetric.
    """
    check_inertia(M, np.flatnonzero(M.diagonal()) if system is not None else range(len(M)))
    if system is not None:
        rigid = None if rigid is None else system.places @ rigid
        return [whole(block, system) for block in _blocks(system.M, system.C, system.K, rigid)]
    if modes is not None:
        found = modal(M, C, modes)
        if found:
            return found
    return _blocks(M, C, K, rigid)


def _blocks(M: np.ndarray, C: np.ndarray, K: np.ndarray, rigid: np.ndarray | None = None) -> list[ModalBlock]:
    sets = components((M != 0) | (C != 0) | (K != 0) | ((M != 0) | (C != 0) | (K != 0)).T)
    return [apart(block, places, len(M)) for places in sets
            for block in _coupled(*(matrix[np.ix_(places, places)] for matrix in (M, C, K)),
                                  None if rigid is None else rigid[places])]


def check_inertia(M: np.ndarray, heavy: Any) -> None:
    """Refuses an M that is not positive definite over the coordinates `heavy`: q̈ is not determined then."""
    if not len(heavy):
        return
    M = M[np.ix_(heavy, heavy)]
    diagonal = np.diagonal(M)
    weak = int(np.argmin(diagonal))
    if diagonal[weak] > 0:
        unit = np.ldexp(1.0, -(np.frexp(diagonal)[1] // 2))
        values, vectors = np.linalg.eigh(unit[:, None] * M * unit)
        if values[0] > len(M) * EPSILON * values[-1]:
            return
        weak = int(np.argmax(np.abs(vectors[:, 0])))
    weak = int(heavy[weak])
    raise PhysicsError(f"no positive inertia moves with coordinate {weak + 1}: its motion in time is not determined",
                       hint="give what it moves a mass or inertia")


def _coupled(M: np.ndarray, C: np.ndarray, K: np.ndarray, rigid: np.ndarray | None) -> list[ModalBlock]:
    if len(M) == 1:
        from vibcli.analyses.transient.single_degree import one_degree

        return [one_degree(M[0, 0], C[0, 0], K[0, 0])]
    from vibcli.analyses.transient.complex_modes import general

    return general(M, C, K, rigid)


def modal(M: np.ndarray, C: np.ndarray, modes: "Sequence[Mode]") -> list[ModalBlock]:
    """The Blocks of undamped modes with φᵀMφ = 1, one each; None where φᵀCφ is not diagonal."""
    shapes = np.array([[float(x) for x in mode.shape] for mode in modes]).T
    damping = shapes.T @ C @ shapes
    own = np.sqrt(np.abs(damping.diagonal()))
    np.fill_diagonal(coupling := np.abs(damping), 0.0)
    if (coupling > COUPLED * np.multiply.outer(own, own)).any():
        return None
    return [_mode(mode, c, shape, shape @ M) for mode, c, shape in
            zip(modes, damping.diagonal().tolist(), shapes.T, strict=True)]


def _mode(mode: "Mode", c: float, shape: np.ndarray, momentum: np.ndarray) -> ModalBlock:
    from vibcli.analyses.transient.single_degree import pair, poles_of_mode

    slow, fast = poles_of_mode(float(mode.omega or 0.0), float(mode.growth_rate or 0.0), c / 2)
    if abs(slow.imag) <= FLAT * abs(slow):
        return pair(slow, fast, shape, momentum, shape)._replace(accuracy=float(mode.error))
    gap = slow - fast
    return ModalBlock(X=2 * shape[:, None].astype(complex), B=np.array([[slow]]), P=-fast * momentum[None] / gap,
                 R=momentum[None] / gap, W=shape[None] / gap, half=True,
                      accuracy=float(mode.error))
