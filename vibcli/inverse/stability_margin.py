"""How far a scene is from flutter and divergence: a number that passes through zero at the limit of stability.

With C, or loads that follow velocities: −max Re λ. Without: of the μ = −λ² the least one, or the least (μᵢ − μⱼ)²,
which is negative where two have met and left the real axis (flutter).
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import FactoredSystem

ZERO, FREE = 1e-9, 1e-13


def margin(elements: Any, free: int) -> tuple[float, float] | None:
    """(margin, its size), `free` roots that are always zero left out; None of a conservative system without gyroscopic
    terms."""
    damped = bool(elements.dampers) or any(elements.C.values()) or any(elements.drag.values())
    pushed = any(elements.C.values()) or any(elements.drag.values()) or any(c < 0 for c, _ in elements.dampers)
    if not (elements.circulatory or pushed or any(elements.G.values())):
        return None
    roots = sorted(_eigenvalues(elements, damped), key=abs)
    size, moving = abs(roots[-1]), roots[free:]
    if damped:
        return -max((root.real for root in moving), default=0.0), size
    squares = [-root * root for root in moving if root.imag > 0 or (root.imag == 0 and root.real > 0)]
    size = max(map(abs, squares), default=size * size)
    real = [x.real for x in squares if abs(x.imag) <= ZERO * size]
    apart = [((x - y) * (x - y)).real / size for i, x in enumerate(squares) for y in squares[:i]
             if abs((x - y).real * (x - y).imag) <= ZERO * size * size]
    return min(real + apart, default=size), size


def free_roots(elements: Any) -> int:
    """The number of roots λ = 0 of motion that nothing holds: K v = 0, twice where (C + G) v = 0 too."""
    import numpy as np

    _, C, G, K = elements.arrays()
    if not K.size:
        return 0
    values, directions = np.linalg.svd(K)[1:]
    along = directions[values <= FREE * values.max()].T
    resisted = np.linalg.svd((C + G) @ along)[1] if along.size else np.array([])
    size = max(abs(C + G).max(), 1e-300)
    return 2 * int(along.shape[1]) - int((resisted > FREE * size).sum())


def _eigenvalues(elements: "FactoredSystem", damped: bool) -> list[complex]:
    """All λ of λ²M + λ(C + G) + K, in floats."""
    import numpy as np

    from vibcli.numerics.state_space import first_order

    M, C, G, K = elements.arrays()
    if not damped and not G.any():
        roots = np.sqrt(-np.linalg.eigvals(np.linalg.solve(M, K)).astype(complex))
        return [complex(sign * root) for root in roots for sign in (1, -1)]
    A = first_order(np.linalg.solve(M, K), np.linalg.solve(M, C + G))
    return list(map(complex, np.linalg.eigvals(A)))
