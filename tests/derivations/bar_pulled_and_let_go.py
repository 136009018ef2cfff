"""Two waves of half the strain: the free end moves to and fro in straight lines of period 4L/c, the force is +-F."""
from math import sqrt


def answers(p):
    L, EA, mu, F = (p[n] for n in ("L", "EA", "mu", "F"))
    c, top = sqrt(EA / mu), F * L / EA

    def end(t):
        phase = (c * t / L) % 4
        return top * (1 - phase if phase < 2 else phase - 3)

    return {"rod.u(L)(0.4 ms)": end(4e-4), "rod.u(L)(1 ms)": end(1e-3), "max(rod.u(L))": top,
            "rod.force(0 m)(0.4 ms)": F if (c * 4e-4 / L) % 4 < 1 else -F,
            "rod.force(0 m)(0.6 ms)": F if (c * 6e-4 / L) % 4 < 1 or (c * 6e-4 / L) % 4 > 3 else -F}
