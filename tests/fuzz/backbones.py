"""Families of free motions of random scenes of two and three degrees, against motions shot anew:

    PYTHONPATH=$PWD:tests python -m fuzz.backbones 100

Equations by hand, integrated by DOP853 from rest until they rest again, half a period; the start and the half period by
Newton's method, from the linear mode by ever larger amplitudes. Prints how many points agree within the bound of ω and
what the integration leaves, and the largest difference.
"""

import random
import sys
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import eigh
from scipy.optimize import fsolve
from support.motions import problem

from vibcli.api.values import given_expression
from vibcli.base.errors import PhysicsError

LEFT = 2e-11            # what integration and shooting leave of ω, relative
STEPS = 5               # amplitudes from the linear mode on


class Drawn(NamedTuple):
    """A scene in the language; the same by hand: accelerations(q, v), M and K at rest; the mode, the first coordinate's
    name and its amplitude."""

    text: str
    accelerations: Callable
    M: np.ndarray
    K: np.ndarray
    mode: int
    name: str
    amplitude: float


def drawn(chance: random.Random) -> Drawn:
    return chance.choice((_chain, _pendulums))(chance)


def _chain(chance):
    """Blocks in a row between two walls, springs k d + a d² + b d³."""
    n = chance.choice((2, 3))
    m = [round(chance.uniform(0.5, 3), 3) for _ in range(n)]
    laws = [(round(chance.uniform(20, 200), 2), round(chance.uniform(-150, 150), 1) * chance.choice((0, 1)),
             round(chance.uniform(200, 2000), 1)) for _ in range(n + 1)]
    springs = "".join(
        f"  s{i}: {{law: ({k} N/m)*d + ({a} N/m^2)*d^2 + ({b} N/m^3)*d^3, stretch: "
        + " - ".join(([f"x{i}"] if i < n else ["0 m"]) + ([f"x{i - 1}"] if i else [])) + "}\n"
        for i, (k, a, b) in enumerate(laws))
    bodies = "".join(f"  b{i}: {{mass: {mass} kg, slide: x{i}}}\n" for i, mass in enumerate(m))
    k, a, b = np.array(laws).T
    M = np.array(m)

    def accelerations(q, v):
        d = np.diff(np.concatenate(([0.0], q, [0.0])))
        return np.diff(d * (k + d * (a + b * d))) / M

    K = np.diag(k[:-1] + k[1:]) - np.diag(k[1:-1], 1) - np.diag(k[1:-1], -1)
    return Drawn(f"bodies:\n{bodies}springs:\n{springs}", accelerations, np.diag(M), K, chance.randrange(n), "x0",
                 chance.uniform(0.02, 0.15))


def _pendulums(chance):
    """Point masses on rods, one below the other, by their angles to the vertical."""
    n = chance.choice((2, 3))
    m = np.array([round(chance.uniform(0.5, 3), 3) for _ in range(n)])
    L = np.array([round(chance.uniform(0.3, 1), 3) for _ in range(n)])
    depth = [0.0, *np.cumsum(L).round(6).tolist()]
    bodies = "".join(
        f"  b{i}: {{mass: {m[i]} kg, at: [0, {-depth[i + 1]} m], pin: {{at: [0, {-depth[i]} m], by: p{i}"
        + f", carrier: b{i - 1}" * (i > 0) + "}}\n" for i in range(n))
    beyond = np.cumsum(m[::-1])[::-1]
    table = beyond[np.maximum.outer(np.arange(n), np.arange(n))] * np.outer(L, L)

    def accelerations(q, v):
        apart = q[:, None] - q
        return np.linalg.solve(table * np.cos(apart), -(table * np.sin(apart)) @ v**2
                               - beyond * L * 9.81 * np.sin(q))

    return Drawn(f"gravity: 9.81 m/s^2\nbodies:\n{bodies}", accelerations, table, np.diag(beyond * L * 9.81), 0, "p0",
                 chance.uniform(0.1, 0.6))


def shot(scene: Drawn) -> float | None:
    """ω of the motion by hand; None where its extremes are not at its ends, or Newton's steps leave
    the family."""
    n, squares, shapes = len(scene.M), *eigh(scene.K, scene.M)
    shape = shapes[:, scene.mode] / shapes[0, scene.mode]

    def run(unknown, dense=False):
        return solve_ivp(lambda t, y: np.concatenate((y[n:], scene.accelerations(y[:n], y[n:]))), (0, unknown[n]),
                         np.concatenate((unknown[:n], np.zeros(n))), method="DOP853", rtol=1e-13, atol=1e-15,
                         dense_output=dense)

    def missing(unknown, amplitude):
        end = run(unknown).y[:, -1]
        return np.append(end[n:] / squares[scene.mode] ** 0.5, (unknown[0] - end[0]) / 2 - amplitude)

    before, found = None, np.append(shape * scene.amplitude / STEPS, np.pi / squares[scene.mode] ** 0.5)
    for step in range(1, STEPS + 1):
        guess = found if before is None else 2 * found - before
        before, (found, _, good, _) = found if step > 1 else np.append(0 * shape, found[n]), fsolve(
            missing, guess, (scene.amplitude * step / STEPS,), full_output=True, xtol=1e-13)
        left = np.abs(missing(found, scene.amplitude * step / STEPS)).max()
        if (good != 1 and left > 1e-11 * scene.amplitude) or abs(found[n] / guess[n] - 1) > 0.1:
            return None
    first = run(found, True).sol(np.linspace(0, found[n], 400))[0]
    return None if np.ptp(first) > 2 * scene.amplitude * (1 + 1e-9) else np.pi / found[n]


def differences(count: int, seed: int):
    """(relative difference of ω, its bound, the scene's text); None for ω where vibcli refuses."""
    chance = random.Random(seed)
    while count:
        scene = drawn(chance)
        exact = shot(scene)
        if exact is None:
            continue
        count -= 1
        try:
            point, = problem(scene.text).free_motions.curve(
                scene.mode + 1, given_expression(scene.name, "it").tree, [scene.amplitude]).points
        except PhysicsError as refusal:
            yield None, str(refusal), scene.text
            continue
        yield abs(point.omega / exact - 1), point.error, scene.text


def main(count: int):
    inside, refused, most = 0, 0, 0.0
    for apart, bound, text in differences(count, 1):
        if apart is None:
            refused += 1
            print("refused:", bound, text, sep="\n")
        elif apart <= bound + LEFT:
            inside, most = inside + 1, max(most, apart)
        else:
            print(f"apart by {apart:.1e}, bound {bound:.1e}:", text, sep="\n")
    print(f"{inside} of {count} within the bound of ω and {LEFT:g}, {refused} refused; apart by at most {most:.1e}")


if __name__ == "__main__":
    main(int(sys.argv[1]))
