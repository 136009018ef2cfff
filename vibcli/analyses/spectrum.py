"""The two lists of modes of a scene: without its dampers, gyroscopic terms kept, and with them.

Without gyroscopic terms the first is M q̈ + K q = 0; with them M q̈ + G q̇ + K q = 0, whose eigenvalues are purely
imaginary where it is stable, and whose shapes are complex. A rigid-body mode is one entry in both lists, though a mode
that moves freely has the eigenvalue zero twice.
"""

from vibcli.analyses.modal import Mode, undamped
from vibcli.mechanics.elements import OscillatorElements


def natural_modes(elements, precise=None, exact=None, digits=None):
    """The modes of the system without its dampers."""
    if not any(elements.G.values()):
        return undamped(elements, precise=precise, digits=digits)
    from vibcli.analyses.damped import damped

    found = damped(_conservative(elements), _following(precise), _following(exact), digits)
    rigid = undamped(elements, precise=precise, digits=digits) if any(not m.omega for m in found) else ()
    modes = [_natural(mode) for mode in _one_each(found, rigid) if not mode.eigenvalue.real < 0]
    modes.sort(key=lambda mode: (mode.omega is not None, mode.omega if mode.omega is not None else -mode.growth_rate))
    for index, mode in enumerate(modes, 1):
        mode.index = index
    return modes


def damped_modes(elements, natural, precise=None, exact=None, digits=None):
    """The damped modes, None where nothing damps; `natural()` gives the modes without dampers."""
    if not any(c for c, _ in elements.dampers) and not any(elements.C.values()):
        return None
    from vibcli.analyses.damped import damped

    found = damped(elements, precise=precise, exact=exact, digits=digits)
    return _one_each(found, natural()) if any(not mode.omega for mode in found) else found


def _conservative(elements):
    return OscillatorElements(elements.n, elements.inertias, elements.springs, (), M=elements.M, G=elements.G,
                              K=elements.K, K_size=elements.K_size, rational_rows=elements.rational_rows,
                              massless=elements.massless)


def _following(evaluate):
    """The same re-evaluation of the elements, without their dampers."""
    if evaluate is None:
        return None

    def conservative(*args):
        elements = evaluate(*args)
        return None if elements is None else _conservative(elements)
    return conservative


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
    """A conservative eigenvalue as a mode: iω, or a growth rate where Re λ > 0."""
    growing = mode.growth_rate is not None
    return Mode(mode.index, mode.growth_rate if growing else mode.omega, growing, mode.shape, mode.shape, mode.error)
