"""The motion of a scene from its start up to an instant."""

from vibcli.analyses.trajectory.energy import balance
from vibcli.analyses.trajectory.march import March
from vibcli.analyses.trajectory.result import Trajectory
from vibcli.analyses.trajectory.start import start, vectors
from vibcli.errors import PhysicsError
from vibcli.mechanics.system import System

ACCURACY = 1e-12


def simulate(problem, until, rtol=ACCURACY, initial=None, progress=None):
    """The Trajectory of a problem in numbers up to t = `until` [s].

    rtol: the error of each step relative to the motion. initial: {x: m or rad, x': m/s or rad/s}; what is not given
    starts at rest in equilibrium. progress(t) is called after each step.
    """
    if not 0 < until < 1e12:
        raise PhysicsError(f"a motion cannot end at t = {until:.6g} s", "ask for an instant after its start, t = 0")
    places, speeds = start(problem, initial)
    scene = problem.scene
    system = System(scene, problem.floats)
    q, v = vectors(scene, places, speeds)
    march = March(system, 0.0, q, v, rtol, progress)
    march.begin()
    while march.t < until:
        march.finish(march.advance(until))
        if until - march.t < 1e-14 * until:
            break
    return Trajectory(system, march.windows, until, (), balance(system, march.windows, march.ends), None)
