"""Residual ratios of what was found, as LAPACK's tests have them: what is up to 20 is rounding; of motions the balance
of their energies.

    ‖λ² M φ + λ (C + G) φ + K φ‖ / ((|λ|² ‖M‖ + |λ| ‖C + G‖ + ‖K‖) ‖φ‖ n ε),   ‖ΦᴴMΦ − I‖ / (n ε)

in floats on assembled matrices, in coordinates scaled to m_ii = 1, so that units do not matter: Anderson et al., LAPACK
Users' Guide (1999), section 4.7. ‖K‖ is that of the terms which entries are added from: rounding is relative to these.
They tell that values and shapes belong together, which the bounds of both do not.
"""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np

    from vibcli.results.problem import Problem

EPSILON = 2.0**-52
ROUNDING = 20           # residual ratios up to this are rounding
ENERGY = "energy balance"


def certificate(problem: "Problem") -> dict[str, float]:
    """{what: its ratio} of the equilibrium and of the modes of lumped bodies, and {energy balance: what it is off by,
    relative} of a motion that was followed, of stages that were computed alone; nothing of a scene in letters, or one
    that is refused."""
    if problem.numeric.has_free_symbols:
        return {}
    try:
        return _found(problem)
    except PhysicsError:
        return {}


def _found(problem: "Problem") -> dict[str, float]:
    found = {}
    if "equilibrium" in problem.timings:
        found["force balance"] = problem.configuration.equilibrium.residual / EPSILON
    if {"modes", "damped"} & problem.timings.keys() and not (problem.modal.many or problem.scene.pieces):
        found |= _of_modes(problem)
    balance = _of_motion(problem) if "response" in problem.timings else None
    return found if balance is None else found | {ENERGY: balance}


def _of_motion(problem: "Problem") -> float | None:
    """What the energy balance of a motion is off by; None of kinds of motion that have none."""
    motion = problem.response
    if motion.KIND == "full" and motion.integrated:
        found: float | None = motion.trajectory().balance.error
        return found
    if motion.KIND != "small" or not motion.is_followed:        # of what is kept up alone no motion is needed
        return None
    from vibcli.results.energy_balance import energy_balance

    return energy_balance(motion.alone, float(motion.until))


def _of_modes(problem: "Problem") -> dict[str, float]:
    import numpy as np

    found, configuration = {}, problem.configuration
    elements = configuration.element_data
    scale, (M, C, G, K) = _scaled(elements.arrays())
    terms = np.zeros_like(K)
    for (i, j), size in (elements.K_size or {}).items():
        terms[i, j] = size * scale[i] * scale[j]
    of_terms = max(_norm(K), _norm(terms))
    if "modes" in problem.timings and len(problem.modal.modes):
        modes = [(complex(mode.growth_rate or 0.0, mode.omega or 0.0), mode.shape / scale)
                 for mode in problem.modal.modes]
        found["modes"] = residual_ratio(M, G, K, modes, of_terms)
        if not G.any() and (K == K.T).all() and len(modes) == len(M):
            found["orthogonality"] = orthogonality(M, np.array([shape for _, shape in modes]).T)
    if "damped" in problem.timings and problem.modal.damped:
        found["damped modes"] = residual_ratio(M, C + G, K, [(complex(mode.eigenvalue), mode.shape / scale)
                                                             for mode in problem.modal.damped], of_terms)
    return found


def residual_ratio(M: Any, C: Any, K: Any, modes: "Sequence[tuple[complex, Any]]", of_terms: float) -> float:
    """The largest one of modes (λ, φ); of_terms: ‖K‖ of what its entries are added from."""
    import numpy as np

    sizes = _norm(M), _norm(C), of_terms
    worst = 0.0
    for rate, shape in modes:
        left = np.abs(rate * rate * (M @ shape) + rate * (C @ shape) + K @ shape).sum()
        size = (abs(rate) ** 2 * sizes[0] + abs(rate) * sizes[1] + sizes[2]) * np.abs(shape).sum()
        worst = max(worst, float(left / size)) if size else worst
    return worst / (len(M) * EPSILON)


def _norm(matrix: "np.ndarray") -> float:
    """The largest sum of the sizes of a column."""
    return float(abs(matrix).sum(axis=0).max())


def orthogonality(M: Any, shapes: Any) -> float:
    """‖ΦᴴMΦ − I‖ / (n ε)."""
    import numpy as np

    off = shapes.conj().T @ M @ shapes - np.eye(shapes.shape[1])
    return float(np.abs(off).sum(axis=0).max() / (len(M) * EPSILON))


def _scaled(matrices: "Sequence[np.ndarray]") -> "tuple[np.ndarray, list[np.ndarray]]":
    """(the unit of each coordinate in which m_ii = 1, the matrices in these)."""
    import numpy as np

    M, K = matrices[0], matrices[3]
    diagonal = np.where(M.diagonal() > 0, M.diagonal(), np.where(K.diagonal() != 0, abs(K.diagonal()), 1.0))
    unit = 1 / np.sqrt(diagonal)
    return unit, [unit[:, None] * matrix * unit for matrix in matrices]
