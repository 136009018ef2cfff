"""Forces and moments within members along each: of a mode, at an instant of the motion, amplitudes of what lasts."""

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.language.signal_names import LEFT_OF, signal_name
from vibcli.mechanics.internal_forces import InternalForce, forces_within
from vibcli.mechanics.rest_curves import curves_at_rest
from vibcli.numerics.stretches import PARTS, CurveStretch, kept
from vibcli.results.known_digits import require_value
from vibcli.symbolic.syntax import NameRef, QuantityRef

if TYPE_CHECKING:
    from vibcli.analyses.continuous.shapes import Moved
    from vibcli.results.problem import Problem
    from vibcli.results.signal import Signal
    from vibcli.results.signals import LinearSignal
    from vibcli.results.wave_signals import WaveSignal

SAME, COARSE, A_HALF_WAVE = 1e-9, 24, 16      # of the length; parts of a stretch in time; of a half-wave of a mode
ORDERS = {("beam", "moment"): 2, ("beam", "shear"): 3, ("beam", "force"): 1, ("bar", "force"): 1,
          ("shaft", "moment"): 1}

Along = Callable[[Sequence[str], np.ndarray], np.ndarray]       # (names of signals, their places) → values


def forces_of_mode(problem: "Problem", index: int, normalise: str = "first") -> list[InternalForce]:
    """Those of a mode, normalised as its shape is; those of strings do not change."""
    mode, = problem.modal.modes.numbered(index, index)
    mode = problem.modal.told_apart(mode)
    fields, factor = problem.modal.fields(mode), complex(problem.modal.scale(mode, normalise))
    found = []
    for name, member, part in forces_within(problem.scene):
        order = ORDERS.get((member.kind.name, part))
        if order is not None:
            pieces = fields.pieces(f"{name}.along" if member.stretching and part == "force" else name)
            found.append(InternalForce(name, part, [_moved(one, order, factor) for one in pieces]))
    return found


def _moved(moved: "Moved", order: int, factor: complex) -> CurveStretch:
    piece = moved.piece
    stiffness = piece.bending or piece.tension
    waves = (max(-moved.kappa, 0.0) / stiffness) ** (1 / piece.order) * piece.length / np.pi
    return CurveStretch(moved.start, moved.start + piece.length,
                   lambda places: (stiffness * factor * moved.along(places)[:, order]).real,
                   max(PARTS, int(A_HALF_WAVE * waves)))


def forces_in_time(problem: "Problem", instant: float) -> tuple[list[InternalForce], list[str]]:
    """(those at an instant of the motion, why others are not found)."""
    at = np.array([instant])

    def signal(name: str) -> "WaveSignal":
        found: WaveSignal = problem.response.signal(NameRef(0, len(name), name, 0))
        return found

    def values(name: str, between: "tuple[float, float]") -> Along:
        beside = _beside(problem, name, signal(name), between)
        return _one_by_one(lambda one: float(signal(one).values(at)[0])) if beside is None else (
            lambda names, places: np.array([float((signal(one) if x in between else beside(x)).values(at)[0])
                                            for one, x in zip(names, places.tolist(), strict=True)]))

    def require(force: InternalForce) -> None:
        for stretch in force.stretches:
            amid = signal(f"{force.member}.{force.part}({(stretch.start + stretch.end) / 2!r} m)")
            require_value(amid, instant, force.largest, amid.error(instant))

    return _of_signals(problem, values, lambda name: signal(name).error(instant), require)


def _beside(problem: "Problem", name: str, signal: "WaveSignal",
            between: tuple[float, float]) -> "Callable[[float], Signal] | None":
    """(place between two stations) → the signal there of one that is read by modes in the middle; None of others."""
    from vibcli.results.modal_signals import ModalSignal

    if not isinstance(signal, ModalSignal) or len(signal.reads.places) != 1 or any(signal.reads[1:5]):
        return None
    named, middle = signal_name(name), sum(between) / 2
    member = problem.configuration.scene.resting.members[named.name]
    try:
        rest = next(one for one in curves_at_rest(problem.configuration, member, named.part)
                    if one.start <= middle <= one.end)
    except PhysicsError:
        return None
    return lambda x: signal.beside(x - middle, float(np.asarray(rest.values(np.array([x])))[0]))


def amplitudes(problem: "Problem") -> tuple[list[InternalForce], list[str]]:
    """(amplitudes of the steady state, why others are not found)."""
    from vibcli.results import feature_errors, steady_features

    def steady(name: str) -> QuantityRef:
        return QuantityRef(0, 0, f"steady({name})", "steady", args=(NameRef(0, len(name), name, 0),))

    def response(name: str) -> Any:
        return problem.response_of(QuantityRef(0, 0, f"amplitude({name})", "amplitude", args=(steady(name),)))

    def signal(name: str) -> "LinearSignal":
        found: LinearSignal = response(name).signal(steady(name))
        return found

    def values(name: str, between: "tuple[float, float]") -> Along:
        found = response(name).amplitudes_along(name, between) if response(name).KIND == "steady" else None
        return _one_by_one(lambda one: steady_features.amplitude(signal(one))) if found is None else (
            lambda names, places: found(places))

    return _of_signals(problem, values, lambda name: feature_errors.amplitude(signal(name)))


def _one_by_one(value: Callable[[str], float]) -> Along:
    """(names of signals, their places) → values; each of them is found once."""
    seen: dict[str, float] = {}

    def values(names: "Sequence[str]", _: np.ndarray) -> np.ndarray:
        seen.update((name, value(name)) for name in names if name not in seen)
        return np.array([seen[name] for name in names])
    return values


def _of_signals(problem: "Problem", values: Callable[[str, tuple[float, float]], Along], error: Callable[[str], float],
                require: Callable[[InternalForce], None] | None = None) -> tuple[list[InternalForce], list[str]]:
    """Those whose values signals tell: values(name of one, stations it lies between) → (names, places) → values;
    require: refuses one of which no digit is known."""
    scene, found, refused = problem.scene, [], []
    for name, member, part in forces_within(scene):
        length, stations = scene.number(member.length), [scene.number(one.place) for one in member.stations]
        stations = [0.0, *sorted(x for x in stations if SAME * length < x < (1 - SAME) * length), length]
        signal = f"{name}.{part}"
        try:
            stretches = [_of_signal(signal, between, values) for between in pairwise(stations)]
            force = InternalForce(name, part, stretches, lambda x, signal=signal: error(f"{signal}({x!r} m)"))
            force.largest       # noqa: B018 - refused where it is not found
            if require is not None:
                require(force)
            found.append(force)
        except PhysicsError as refusal:
            refused.append((f"{part} of {name}", refusal))
    if not found and refused:
        raise refused[0][1]
    return found, [f"the {what} is not found: {refusal.message}" for what, refusal in refused]


def _of_signal(signal: str, between: tuple[float, float],
               values: Callable[[str, tuple[float, float]], Along]) -> CurveStretch:
    """The CurveStretch of a signal."""
    along = values(f"{signal}({sum(between) / 2!r} m)", between)

    def at(places: np.ndarray) -> np.ndarray:
        return along([f"{signal}({x!r} m{LEFT_OF * (x >= between[1])})" for x in places.tolist()], places)

    return CurveStretch(*between, kept(at), COARSE)


def require_numbers(problem: "Problem") -> None:
    """PhysicsError where there are no members, or symbols without value."""
    if not problem.scene.members:
        raise PhysicsError("this scene has no members: no diagram of forces within them can be drawn",
                           "`vibcli draw FILE` draws the scene")
    if problem.numeric.has_free_symbols:
        from vibcli.language.parameters import require_values

        require_values(problem.scene.parameters, "a diagram of forces")
