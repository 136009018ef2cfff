"""Beside programs of others: frequency and step responses of a chain by python-control, the double pendulum of
`trajectories` by MuJoCo's Runge-Kutta steps of ever smaller length. A peer that is not installed is a row that says so.

Chain and equations are built before; what is timed begins with the matrices on either side.
"""

import json
from collections.abc import Callable, Sequence
from functools import partial
from statistics import median
from time import process_time
from typing import Any

from vibcli.bench.processes import answer, installed
from vibcli.bench.rows import Timing
from vibcli.bench.trajectories import AT_100, DOUBLE

DEGREES, FREQUENCIES, INSTANTS, END = 4, 1000, 10_000, "10"
STEPS = (1e-3, 5e-4)            # s, of MuJoCo
START = (0.3, 0.2)              # of the pendulum, the second angle counted from the first
CHAIN_ERROR, PENDULUM_ERROR = 1e-12, 1e-9
POINT = '<inertial pos="0 0 -1" mass="1" diaginertia="1e-14 1e-14 1e-14"/>'
MODEL = f"""<mujoco><option gravity="0 0 -9.81" integrator="RK4" timestep="%s"/><worldbody>
<body><joint type="hinge" axis="0 1 0"/>{POINT}<body pos="0 0 -1"><joint type="hinge" axis="0 1 0"/>{POINT}
</body></body></worldbody></mujoco>"""


def rows(runs: Any) -> list[Timing]:
    """Times and errors of ours, with those of the peers as baselines."""
    found: list[Timing] = []
    ours = _child("chain", runs)
    peer, theirs = _peer("python-control", "control", "controlled", runs)
    for what, key in ((f"{FREQUENCIES} frequencies, {DEGREES} masses", "frequencies"),
                      (f"{INSTANTS} instants after a step, {DEGREES} masses", "instants")):
        found += [Timing(what, ours[key][0], "ms", None, peer, theirs and theirs[key][0]),
                  Timing("  error", ours[key][1], "", CHAIN_ERROR, peer, theirs and theirs[key][1], absolute=True)]
    spent, error = _child("pendulum", runs)["double"]
    peer, theirs = _peer("MuJoCo", "mujoco", "stepped", runs)
    for step in map(str, STEPS):
        name = f"{peer}, RK4 by {step} s" if theirs else peer
        found += [Timing("double pendulum, 100 s", spent, "ms", None, name, theirs and theirs[step][0]),
                  Timing("  error", error, "", PENDULUM_ERROR, name, theirs and theirs[step][1], absolute=True)]
        if theirs is None:
            break
    return found


def _child(function: str, runs: Any) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(answer(f"from vibcli.bench import peers; peers.{function}()", min(runs, 5)))
    return found


def _peer(name: str, package: str, function: str, runs: Any) -> tuple[str, Any]:
    return (name, _child(function, runs)) if installed(package) else (f"{name}, not installed", None)


def _scene() -> str:
    links = [("ground" if i == 1 else f"b{i - 1}", f"b{i}") for i in range(1, DEGREES + 1)]
    lines = ["motion: small", f"find: [{{response: {{until: {END} s}}}}]", "answers: {max(x1): 1 m}", "bodies:",
             *(f"  b{i}: {{mass: {i} kg, slide: x{i}}}" for i in range(1, DEGREES + 1)), "springs:",
             *(f"  s{i}: {{k: {800 + 100 * i} N/m, between: [{a}, {b}]}}" for i, (a, b) in enumerate(links)),
             "dampers:",
             *(f"  d{i}: {{c: {1 + i % 3} N*s/m, between: [{a}, {b}]}}" for i, (a, b) in enumerate(links)),
             "forces:", f"  F: {{at: b{DEGREES}, force: (1 N)*step(t)}}", ""]
    return "\n".join(lines)


def _known() -> Any:
    """(problem, frequencies, instants, the true H at one of them and the true x1 at the end)."""
    from fractions import Fraction

    import mpmath
    import numpy as np

    from vibcli.api.source import problem_of, text_source
    from vibcli.evidence.reference import frequency_response, motion

    problem = problem_of(text_source(_scene()))
    Omega, t = np.linspace(1.0, 60.0, FREQUENCIES), np.linspace(0.0, float(END), INSTANTS)
    H = frequency_response.value(problem, "x1", "F", lambda: mpmath.mpf(float(Omega[FREQUENCIES // 3]))).values[0]
    small = motion.small(problem)
    x = motion.at_instant(small, small.coordinate("x1"), Fraction(END), problem.work).values[0]
    return problem, Omega, t, complex(H), float(x)


def chain() -> None:
    """Child process: print ours of the chain."""
    problem, Omega, t, H, x = _known()
    tree = problem.spec.answers[0].asked.tree.args[0]
    print(json.dumps({
        "frequencies": _measured(lambda: problem.afresh().frequency_response("x1", "F").at_each(Omega),
                                 lambda found: abs(found[FREQUENCIES // 3][0] - H) / abs(H)),
        "instants": _measured(lambda: problem.afresh().response.signal(tree).values(t),
                              lambda found: abs(found[-1] - x) / abs(found).max())}))


def controlled() -> None:
    """Child process: print python-control's."""
    import control
    import numpy as np

    problem, Omega, t, H, x = _known()
    M, C, _, K = problem.configuration.linear_system.arrays()
    n, inverse = len(M), np.linalg.inv(M)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ K, -inverse @ C]])
    B = np.vstack([np.zeros((n, 1)), inverse[:, -1:]])
    row = np.eye(1, 2 * n)

    def system() -> Any:
        return control.ss(A, B, row, [[0.0]])

    print(json.dumps({
        "frequencies": _measured(lambda: system()(1j * Omega), lambda found: abs(found[FREQUENCIES // 3] - H) / abs(H)),
        "instants": _measured(lambda: control.forced_response(system(), t, np.ones(len(t))).outputs,
                              lambda found: abs(found[-1] - x) / abs(found).max())}))


def pendulum() -> None:
    """Child process: print ours of the double pendulum."""
    from vibcli.analyses.time_integration.integrate import simulate
    from vibcli.api.source import problem_of, text_source

    scene = problem_of(text_source(DOUBLE)).configuration

    def ours() -> list[float]:
        q, v, _ = simulate(scene, 100.0, initial={"p": START[0], "r": sum(START)}).at([100.0])
        return [*q[:, 0], *v[:, 0]]

    print(json.dumps({"double": _measured(ours, _off)}))


def stepped() -> None:
    """Child process: print MuJoCo's."""
    import mujoco

    def run(step: float) -> list[float]:
        model = mujoco.MjModel.from_xml_string(MODEL % step)
        data = mujoco.MjData(model)
        data.qpos[:] = START
        for _ in range(round(100.0 / step)):
            mujoco.mj_step(model, data)
        (a, b), (u, w) = data.qpos, data.qvel
        return [a, a + b, u, u + w]

    print(json.dumps({str(step): _measured(partial(run, step), _off) for step in STEPS}))


def _off(found: Sequence[float]) -> float:
    return max(abs(float(x) - y) for x, y in zip(found, AT_100, strict=True))


def _measured(solved: Callable[[], Any], off: Callable[[Any], float]) -> list[float]:
    """[ms, error]: the median of the runs that are asked for, after one that does not count."""
    import sys

    found, spent = solved(), []
    for _ in range(int(sys.argv[1])):
        start = process_time()
        found = solved()
        spent.append(process_time() - start)
    return [1e3 * median(spent), float(off(found))]
