"""The two lists of modes of a scene: without its dampers, gyroscopic terms kept, and with them.

Without gyroscopic terms the first is M q̈ + K q = 0; with them M q̈ + G q̇ + K q = 0, whose eigenvalues are purely
imaginary where it is stable, and whose shapes are complex. Forces that make K unsymmetric let modes flutter: they grow
while they oscillate. A rigid-body mode is one entry in both lists, though a mode that moves freely has the eigenvalue
zero twice.
"""

from vibcli.analyses.modal.undamped import Mode, undamped
from vibcli.mechanics.factored_system import OscillatorElements, summed


def natural_modes(elements, precise=None, exact=None, digits=None):
    """The modes of the system without its dampers: those that grow, the rigid ones, the others by ascending ω.

    What decays is left out where it only mirrors what grows: where there is no G, or K is symmetric.
    """
    if elements.drag:
        return natural_modes(_without(elements, "drag"), _following(precise, "drag"), _following(exact, "drag"), digits)
    turning, follows = any(elements.G.values()), elements.circulatory
    if not turning and not follows:
        return undamped(elements, precise=precise, digits=digits)
    from vibcli.analyses.modal.damped import damped

    def sources(*kinds):
        return _without(elements, *kinds), _following(precise, *kinds), _following(exact, *kinds), digits

    found = damped(*sources("dampers", "C"))
    if turning and any(not mode.omega for mode in found):
        found = _one_each(found, natural_modes(*sources("dampers", "C", "G")))
    modes = [_natural(mode) for mode in found if (turning and follows) or not mode.eigenvalue.real < 0]
    modes.sort(key=lambda mode: (1, mode.omega) if mode.growth_rate is None else (0, -mode.growth_rate))
    for index, mode in enumerate(modes, 1):
        mode.index = index
    return modes


def damped_modes(elements, natural, precise=None, exact=None, digits=None):
    """The damped modes, None where nothing damps; `natural()` gives the modes without dampers."""
    if not any(c for c, _ in elements.dampers) and not any(elements.C.values()) and not any(elements.drag.values()):
        return None
    from vibcli.analyses.modal.damped import damped

    if elements.drag:
        elements, precise, exact = _dragged(elements), _then(_dragged, precise), _then(_dragged, exact)

    found = damped(elements, precise=precise, exact=exact, digits=digits)
    still = natural() if any(not mode.omega for mode in found) else ()
    return _one_each(found, still) if still else found


def _without(elements, *kinds):
    """The same elements but for some kinds."""
    parts = {kind: getattr(elements, kind) for kind in OscillatorElements.__slots__ if kind not in kinds}
    return OscillatorElements(**parts)


def _dragged(elements):
    """The same elements, the skew part of what loads add to C among the gyroscopic terms."""
    parts = {kind: getattr(elements, kind) for kind in OscillatorElements.__slots__}
    return OscillatorElements(**parts | {"G": summed(elements.G, elements.drag), "drag": {}})


def _following(evaluate, *kinds):
    """The same re-evaluation of the elements, without some kinds."""
    return _then(lambda elements: _without(elements, *kinds), evaluate)


def _then(change, evaluate):
    """A re-evaluation of the elements with a change; None where there is none."""
    if evaluate is None:
        return None

    def changed(*args):
        elements = evaluate(*args)
        return None if elements is None else change(elements)
    return changed


def _one_each(found, natural):
    """The list with one entry for each rigid-body mode, in the shape of that mode, numbered again."""
    shapes = [mode.shape for mode in natural if mode.rigid]
    resting = [mode for mode in found if not mode.omega][:len(shapes)]
    for mode, shape in zip(resting, shapes, strict=False):
        mode.shape = shape
    moving = [mode for mode in found if mode.omega]
    numbers = {}
    for mode in moving:
        mode.index = len(resting) + numbers.setdefault(mode.index, len(numbers) + 1)
    for index, mode in enumerate(resting, 1):
        mode.index = index
    return resting + moving


def _natural(mode):
    """An eigenvalue of the system without dampers as a mode: i ω, and a growth rate where Re λ is not zero."""
    growth, swing = mode.eigenvalue.real, mode.eigenvalue.imag
    omega = None if growth and not swing else swing
    shape = mode.shape if any(x.imag for x in mode.shape.tolist()) else _real(mode.shape)
    return Mode(mode.index, omega, growth or None, shape, shape, mode.error)


def _real(shape):
    import numpy as np

    return np.array([x.real for x in shape.tolist()])
