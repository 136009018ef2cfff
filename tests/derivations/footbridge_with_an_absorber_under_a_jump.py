"""In sines w = sum a_n sin(n pi x/L), which are what a simply supported beam has without the absorber, n odd:

    (mu L/2)(a_n'' + w_n^2 a_n) = s_n (P - f),  m y'' = f,  f = k (w - y) + c (w' - y'),  s_n = sin(n pi/2);

P = -F (1 - cos(2 pi t/T))/2 for 0 < t < T is carried as states of its own, so that x' = A x all the time, and
x = sum v_i e^(l_i t) b_i by the eigenvectors of A.
"""
import numpy as np

SINES = 100


def motion(A, start):
    """t -> x(t)."""
    rates, vectors = np.linalg.eig(A)
    shares = np.linalg.solve(vectors, start)
    return lambda t: (vectors @ (np.exp(rates * t) * shares)).real


def answers(p):
    L, EI, mu, m, k, c, F, T = (p[n] for n in ("L", "EI", "mu", "m", "k", "c", "F", "T"))
    n = np.arange(1, 2 * SINES, 2)
    s, N = np.sin(n * np.pi / 2), SINES + 1
    row = np.append(s, -1.0)                        # w - y at the middle
    M = np.diag(np.append(np.full(SINES, mu * L / 2), m))
    K = np.diag(np.append(mu * L / 2 * (n * np.pi / L) ** 4 * EI / mu, 0.0)) + k * np.outer(row, row)
    C = c * np.outer(row, row)
    A = np.zeros((2 * N + 3, 2 * N + 3))            # ..., 1, cos and sin of 2 pi t/T
    A[:N, N:2 * N] = np.eye(N)
    A[N:2 * N, :2 * N] = -np.linalg.solve(M, np.hstack([K, C]))
    push = np.linalg.solve(M, np.append(s, 0.0)) * -F / 2
    A[N:2 * N, 2 * N], A[N:2 * N, 2 * N + 1] = push, -push
    A[2 * N + 1, 2 * N + 2], A[2 * N + 2, 2 * N + 1] = -2 * np.pi / T, 2 * np.pi / T
    start = np.zeros(2 * N + 3)
    start[2 * N] = start[2 * N + 1] = 1.0
    pushed = motion(A, start)
    free = motion(A[:2 * N, :2 * N], pushed(T)[:2 * N])

    def state(t):
        return pushed(t)[:2 * N] if t < T else free(t - T)

    def w(t, x):
        return float(np.sin(n * np.pi * x / L) @ state(t)[:SINES])

    def deepest():
        t = T + 5e-3 * int(np.argmin([w(T + 5e-3 * i, L / 2) for i in range(350)]))
        for h in (5e-3, 5e-4, 5e-5):                # the vertex of a parabola
            a, b, d = (w(t + side * h, L / 2) for side in (-1, 0, 1))
            t += h * (a - d) / 2 / (a - 2 * b + d)
        return w(t, L / 2)

    return {"bridge.u(L/2)(0.4 s)": w(0.4, L / 2), "bridge.u(L/2)(2 s)": w(2.0, L / 2),
            "bridge.u(L/2)(3 s)": w(3.0, L / 2), "bridge.u(L/4)(2 s)": w(2.0, L / 4), "min(bridge.u(L/2))": deepest()}
