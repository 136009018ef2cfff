"""Upper bounds of the lowest frequencies by assumed deflections of members: Rayleigh's quotient, Ritz's estimates.

    ω̃² = K̂/M̂          K̂ c = ω̃² M̂ c          ω̃ᵢ ≥ ωᵢ (minimax principle)
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.analyses.continuous.assumed_shapes import AssumedShape, derivatives_of, reduced
from vibcli.analyses.continuous.finite_elements import finite_elements
from vibcli.analyses.modal.assumed_motions import RitzEstimates, RitzMode, amplitude_of, orthonormal, require_bounds
from vibcli.analyses.modal.modes_precise import WORKING
from vibcli.base.errors import PhysicsError
from vibcli.language.document.document import Scalar
from vibcli.language.reader import Expression
from vibcli.language.signal_names import signal_name
from vibcli.symbolic.parser import parse

if TYPE_CHECKING:
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.mechanics.factored_system import FactoredSystem

SPARE = 20          # digits beyond those asked for
ALONG = ".along("   # what a station of a beam does along it, which rests
WHICH = "rayleigh[f] is of scenes with one member, whose deflection is the function f of the place x"


def quotient(modal: "ModalAnalysis", text: str, digits: int | None) -> Any:
    """√(K̂/M̂) of a scene with one member that deflects as a function of x; PhysicsError where it is no bound."""
    members, written = list(modal.scene.members), Expression(Scalar(text, None), parse(text))
    if len(members) != 1:
        raise PhysicsError(WHICH + (f", and this scene has {', '.join(members)}" if members else
                                    ", and this scene has none"), "assume shapes by `find: [{ritz: {shapes: …}}]`")
    with mpmath.workdps(max(WORKING, (digits or 0) + SPARE)):
        elements = _bounded(modal)
        found = reduced(modal, elements, [AssumedShape({members[0]: derivatives_of(modal, written)}, {})])
        resting = [name for i, name in enumerate(modal.scene.coordinates)
                   if ALONG not in name and i not in found.motions[0]]
        if resting:
            raise PhysicsError(f"the motion of {', '.join(resting)} does not follow from the deflection of "
                               f"'{members[0]}'",
                               "Rayleigh's quotient of one deflection needs a scene in which all follows from it")
        if not found.M[0, 0]:
            raise PhysicsError("nothing moves in this deflection", "a function that is not zero fits")
        square = found.K[0, 0] / found.M[0, 0]
        if square < 0:
            raise PhysicsError("the square of Rayleigh's quotient is negative: the equilibrium is unstable",
                               "ask for growth_rate[1] or stable")
        return mpmath.sqrt(square)


def member_bounds(modal: "ModalAnalysis", asked: Any) -> RitzEstimates:
    """The RitzEstimates of a scene with members."""
    with mpmath.workdps(WORKING):
        elements = _bounded(modal)
        shapes = [_assumed(modal, written) for written in asked["shapes"]]
        found = reduced(modal, elements, shapes)
        units = [[mpmath.mpf(i == j) for j in range(len(shapes))] for i in range(len(shapes))]
        basis = orthonormal(units, found.M, [shape.where or asked.where for shape in shapes])
        squares, mixed = mpmath.eigsy(_within(found.K, basis))
        natural, modes = list(modal.modes.first(len(shapes))), []
        for i, square in enumerate(squares):
            weights = [sum(mixed[k, i] * one[j] for k, one in enumerate(basis)) for j in range(len(shapes))]
            if abs(square) <= _nothing() * max(map(abs, squares)):
                square = mpmath.mpf(0)
            shape = [sum(w * motion.get(q, 0) for w, motion in zip(weights, found.motions, strict=True))
                     for q in range(elements.n)]
            exact = natural[i].omega if i < len(natural) else None
            modes.append(RitzMode(i + 1, float(square), float(mpmath.sqrt(square)) if square >= 0 else None,
                                  [float(x) for x in shape], None if exact is None else float(exact),
                                  [float(x) for x in weights]))
        moved = [[float(motion.get(q, 0)) for q in range(elements.n)] for motion in found.motions]
        return RitzEstimates(moved, _floats(found.M), _floats(found.K), modes)


def _bounded(modal: "ModalAnalysis") -> "FactoredSystem":
    """The system in mpmath's numbers; PhysicsError where the minimax principle does not hold for it."""
    elements = modal.configuration.linear_system
    K, M = finite_elements(elements, 1)
    if len(K):
        require_bounds(elements, mpmath.matrix(M.tolist()), mpmath.matrix(K.tolist()))
    return modal.configuration.precise_system(mpmath.mp.dps)


def _assumed(modal: "ModalAnalysis", written: Mapping[str, Expression]) -> AssumedShape:
    """The AssumedShape as it is written."""
    functions, amplitudes, where = {}, {}, None
    for name, expression in written.items():
        where = where or expression.where
        if "." in name:
            signal = signal_name(name)
            kind = modal.scene.members[signal.name].kind
            if signal.part != kind.motion:
                raise PhysicsError(f"a {kind.name} has no '{signal.part}'", f"write {signal.name}.{kind.motion}: …",
                                   expression.where)
            functions[signal.name] = derivatives_of(modal, expression)
        else:
            place, amplitude = amplitude_of(modal, name, expression)
            amplitudes[place] = amplitude
    return AssumedShape(functions, amplitudes, where)


def _nothing() -> mpmath.mpf:
    return mpmath.mpf(10) ** (10 - WORKING)


def _floats(matrix: mpmath.matrix) -> list[list[float]]:
    """Rows of floats, those that are only rounding beside the diagonal being 0."""
    n = range(len(matrix))
    size = [mpmath.sqrt(abs(matrix[i, i])) for i in n]
    return [[float(matrix[i, j]) if abs(matrix[i, j]) > _nothing() * size[i] * size[j] else 0.0 for j in n] for i in n]


def _within(matrix: mpmath.matrix, basis: Sequence[list[mpmath.mpf]]) -> mpmath.matrix:
    """aᵀ matrix b of each pair of a basis."""
    n = range(len(matrix))
    return mpmath.matrix([[sum(x * matrix[i, j] * y for i, x in zip(n, a, strict=True)
                               for j, y in zip(n, b, strict=True)) for b in basis] for a in basis])
