"""The second route of these tests: the state of a piece carried along it by the exponential of its 4 × 4 system."""

import mpmath


def transfer(piece, kappa):
    """exp(A l) for the state (u, u′, M = B u″, Q = N u′ − (B u″)′), of bars (u, Q = N u′); mpmath's matrix."""
    length, bending, tension = (mpmath.mpf(value) for value in piece[:3])
    kappa = mpmath.mpmathify(kappa)
    if bending:
        system = mpmath.matrix([[0, 1, 0, 0], [0, 0, 1 / bending, 0], [0, tension, 0, -1], [kappa, 0, 0, 0]])
    else:
        system = mpmath.matrix([[0, 1 / tension], [kappa, 0]])
    return mpmath.expm(system * length, method="taylor")


def stiffness(piece, kappa):
    """d by solving for the forces at the left end, with digits to spare for what grows along the piece."""
    size = float(piece.length * (abs(piece.tension / (piece.bending or 1)) ** 0.5 + 1 +
                                 abs(complex(kappa) / (piece.bending or piece.tension)) ** (1 / piece.order)))
    with mpmath.workdps(50 + int(size * 1.5)):
        matrix, half = transfer(piece, kappa), piece.order // 2
        own, by = matrix[:half, :half], matrix[:half, half:]
        inverse = by**-1
        left = _beside(-inverse * own, inverse)
        right = matrix[half:, half:] * left + _beside(matrix[half:, :half], mpmath.zeros(half))
        rows = [-left[i, :] for i in reversed(range(half))] + [right[i, :] for i in reversed(range(half))]
        return [[row[j] for j in range(2 * half)] for row in rows]


def _beside(one, other):
    found = mpmath.zeros(one.rows, one.cols + other.cols)
    found[:, :one.cols], found[:, one.cols:] = one, other
    return found


def fields(piece, kappa, ends, places):
    """[[u, u′, (u″, u‴)]] at places, carried on from the state at the left end."""
    half = piece.order // 2
    size = float(piece.length * (abs(piece.tension / (piece.bending or 1)) ** 0.5 + 1 +
                                 abs(complex(kappa) / (piece.bending or piece.tension)) ** (1 / piece.order)))
    with mpmath.workdps(50 + int(size * 1.5)):
        matrix = transfer(piece, kappa)
        start = mpmath.matrix([mpmath.mpmathify(complex(value)) for value in ends])
        forces = matrix[:half, half:] ** -1 * (start[half:, 0] - matrix[:half, :half] * start[:half, 0])
        state = mpmath.matrix([*start[:half], *forces])
        found = [transfer(piece._replace(length=mpmath.mpf(x)), kappa) * state for x in places]
        if half == 1:
            return [[one[0], one[1] / piece.tension] for one in found]
        return [[one[0], one[1], one[2] / piece.bending, (piece.tension * one[1] - one[3]) / piece.bending]
                for one in found]
