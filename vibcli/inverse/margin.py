"""How far a scene is from flutter and divergence: a number that passes through zero at the limit of stability.

With C, or loads that follow velocities: −max Re λ. Without: of the μ = −λ² the least one, or the least (μᵢ − μⱼ)²,
which is negative where two have met and left the real axis (flutter).
"""

ZERO = 1e-9


def margin(elements):
    """(margin, its size); None of a conservative system without gyroscopic terms."""
    damped = bool(elements.dampers) or any(elements.C.values()) or any(elements.drag.values())
    pushed = any(elements.C.values()) or any(elements.drag.values()) or any(c < 0 for c, _ in elements.dampers)
    if not (elements.circulatory or pushed or any(elements.G.values())):
        return None
    roots = _eigenvalues(elements, damped)
    if damped:
        size = max(map(abs, roots))
        moving = [root for root in roots if abs(root) > ZERO * size]
        return -max(root.real for root in moving), size
    squares = [-root * root for root in roots if root.imag > 0 or (root.imag == 0 and root.real > 0)]
    size = max(map(abs, squares))
    real = [x.real for x in squares if abs(x.imag) <= ZERO * size]
    apart = [((x - y) * (x - y)).real / size for i, x in enumerate(squares) for y in squares[:i]
             if abs((x - y).real * (x - y).imag) <= ZERO * size * size]
    return min(real + apart, default=size), size


def _eigenvalues(elements, damped):
    """All λ of λ²M + λ(C + G) + K, in floats."""
    import numpy as np

    n = elements.n
    M, C, G, K = (np.array([[float(matrix.get((i, j), 0)) for j in range(n)] for i in range(n)])
                  for matrix in elements.matrices())
    if not damped and not G.any():
        roots = np.sqrt(-np.linalg.eigvals(np.linalg.solve(M, K)).astype(complex))
        return [complex(sign * root) for root in roots for sign in (1, -1)]
    lower = np.hstack([-np.linalg.solve(M, K), -np.linalg.solve(M, C + G)])
    return list(map(complex, np.linalg.eigvals(np.vstack([np.eye(n, 2 * n, n), lower]))))
