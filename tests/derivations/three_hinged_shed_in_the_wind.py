"""Each frame cut free: sums of forces and moments about the origin of both, six equations for the two components in
A, B and C, solved as they stand."""
import numpy as np


def answers(p):
    m, a, h, e, w, c, W, Q, g = (p[n] for n in ("m", "a", "h", "e", "w", "c", "W", "Q", "g"))
    # unknowns Ax, Ay, Bx, By, Cx, Cy; C acts on the right frame as (Cx, Cy), on the left one as (−Cx, −Cy)
    rows = [[1, 0, 0, 0, -1, 0], [0, 1, 0, 0, 0, -1], [0, 0, 0, 0, h, -a],
            [0, 0, 1, 0, 1, 0], [0, 0, 0, 1, 0, 1], [0, 0, 0, 2 * a, -h, a]]
    loads = [W, -m * g, -W * w - e * m * g, 0, -m * g - Q, -(2 * a - e) * m * g - (2 * a - c) * Q]
    Ax, Ay, Bx, By, Cx, Cy = np.linalg.solve(rows, -np.array(loads))
    return {"equilibrium[A.reaction.x]": Ax, "equilibrium[A.reaction.y]": Ay, "equilibrium[B.reaction.x]": Bx,
            "equilibrium[B.reaction.y]": By, "equilibrium[C.force.x]": Cx, "equilibrium[C.force.y]": Cy}
