"""The two lists of modes of a scene: without its dampers, gyroscopic terms kept, and with them.

Without gyroscopic terms the first is M q̈ + K q = 0; with them M q̈ + G q̇ + K q = 0, whose eigenvalues are purely
imaginary where it is stable, and whose shapes are complex. Forces that make K unsymmetric let modes flutter: they grow
while they oscillate. A rigid-body mode is one entry in both lists, though a mode that moves freely has the eigenvalue
zero twice.
"""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.method import SQUARES, damped_at_all, form_of
from vibcli.analyses.modal.undamped import Mode, undamped
from vibcli.base.errors import PhysicsError
from vibcli.mechanics.factored_system import MOST_DENSE, require_dense, summed

if TYPE_CHECKING:
    from vibcli.analyses.continuous.damped_source import DampedModes
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.language.spec import Spec
    from vibcli.mechanics.factored_system import FactoredSystem

    Evaluation = Callable[..., FactoredSystem | None]


def chosen_at_limit(spec: "Spec") -> bool:
    """Is a parameter chosen that is to bring a scene to its limit of stability?"""
    return any(record["so"].is_limit for record in spec.choices.values())


def natural_modes(elements: Any, precise: "Callable[..., FactoredSystem] | None" = None,
                  exact: Callable[..., Any] | None = None, digits: int | None = None,
                  at_limit: bool = False) -> list[Mode] | Any:
    """The modes of the system without its dampers: those that grow, the rigid ones, the others by ascending ω;
    at_limit: that of stability is chosen.

    What decays is left out where it only mirrors what grows: where there is no G, or K is symmetric. With members that
    have inertia, and of very many coordinates, it is what finds modes as they are asked for.
    """
    if any(placed.piece.inertia for placed in elements.pieces):
        from vibcli.analyses.continuous.mode_source import NaturalModes

        return NaturalModes(elements, precise, digits, at_limit)
    if elements.n > MOST_DENSE:
        from vibcli.analyses.modal.lowest_modes import LowestModes

        if digits is not None:
            require_dense(elements.n, "more digits than those of floats")
        return LowestModes(_still(elements))
    still, following, exactly = _changed(_still, elements, precise, exact)
    if form_of(still) == SQUARES:
        return undamped(elements, precise=precise, digits=digits)
    from vibcli.analyses.modal.damped import damped

    turning, follows = any(elements.G.values()), elements.circulatory
    found = damped(still, following, exactly, digits)
    if turning and any(not mode.omega for mode in found):
        still, following, exactly = _changed(lambda form: form.with_parts(G=None), still, following, exactly)
        found = _one_each(found, natural_modes(still, following, exactly, digits))
    modes = [_natural(mode) for mode in found if (turning and follows) or not mode.eigenvalue.real < 0]
    modes.sort(key=lambda mode: (1, mode.omega) if mode.growth_rate is None else (0, -mode.growth_rate))
    return [mode._replace(index=index) for index, mode in enumerate(modes, 1)]


def damped_modes(elements: Any, natural: Callable[..., Any], precise: "Callable[..., FactoredSystem] | None" = None,
                 exact: Callable[..., Any] | None = None, digits: int | None = None) -> "list[DampedMode] | Any":
    """The damped modes, None where nothing damps; `natural()` gives the modes without dampers."""
    if any(placed.piece.inertia or placed.piece.drag for placed in elements.pieces):
        return _of_members(elements, natural, digits)
    if not damped_at_all(elements) and not any(elements.drag.values()):
        return None
    from vibcli.analyses.modal.damped import damped

    if elements.drag:
        elements, precise, exact = _changed(_dragged, elements, precise, exact)
    found = damped(elements, precise=precise, exact=exact, digits=digits)
    still = natural() if any(not mode.omega for mode in found) else ()
    return _one_each(found, still) if still else found


def _of_members(elements: "FactoredSystem", natural: "Callable[..., Modes]",
                digits: int | None) -> "DampedModes | list[DampedMode] | None":
    """The damped modes of a scene with members, found as they are asked for."""
    if not (damped_at_all(elements) or any(elements.drag.values())
            or any(placed.piece.drag for placed in elements.pieces)):
        return None
    if digits is not None:
        raise PhysicsError("damped modes of members with distributed inertia are found in floats alone",
                           "leave --digits out, or take out what damps")
    from vibcli.analyses.continuous.damped_source import DampedModes
    from vibcli.analyses.continuous.matched_damper import dies_after, left_over, require_bounded_answers

    require_bounded_answers(elements)
    return DampedModes(elements, natural) if dies_after(elements) is None else left_over(elements)


def _still(elements: "FactoredSystem") -> "FactoredSystem":
    """The same elements without dampers and what else loads add to C."""
    return elements.with_parts(dampers=(), C=None, drag=None)


def _dragged(elements: "FactoredSystem") -> "FactoredSystem":
    """The same elements, the skew part of what loads add to C among the gyroscopic terms."""
    return elements.with_parts(G=summed(elements.G, elements.drag), drag=None)


def _changed(change: "Callable[[FactoredSystem], FactoredSystem]", elements: "FactoredSystem",
             *evaluations: "Evaluation | None") -> tuple[Any, ...]:
    """The elements with a change, and their re-evaluations with it, of which any may be None or give None."""
    def following(evaluate: "Evaluation | None") -> "Evaluation | None":
        def changed(*args: Any) -> "FactoredSystem | None":
            found = evaluate(*args)
            return None if found is None else change(found)
        return None if evaluate is None else changed

    return change(elements), *map(following, evaluations)


def _one_each(found: "list[DampedMode]", natural: "Sequence[Mode]") -> "list[DampedMode]":
    """The list with one entry for each rigid-body mode, in the shape of that mode, numbered again."""
    shapes = [mode.shape for mode in natural if mode.rigid]
    resting = [mode for mode in found if not mode.omega][:len(shapes)]
    rigid = [mode.numbered(index, shape) for index, (mode, shape) in enumerate(zip(resting, shapes, strict=False), 1)]
    numbers = {}
    return rigid + [mode.numbered(len(rigid) + numbers.setdefault(mode.index, len(numbers) + 1), mode.shape)
                    for mode in found if mode.omega]


def _natural(mode: "DampedMode") -> Mode:
    """An eigenvalue of the system without dampers as a mode: i ω, and a growth rate where Re λ is not zero."""
    growth, swing = mode.eigenvalue.real, mode.eigenvalue.imag
    omega = None if growth and not swing else swing
    shape = mode.shape if any(x.imag for x in mode.shape.tolist()) else _real(mode.shape)
    return Mode(mode.index, omega, growth or None, shape, shape, mode.error)


def _real(shape: np.ndarray) -> np.ndarray:
    return np.array([x.real for x in shape.tolist()])
