"""Outputs of the small oscillations: every signal (vibcli/language/signals.py) as a linear function of the motion.

Signals are counted from the drawn position, so the constant of an output is its value in equilibrium. What a driven
displacement or a load does to a signal directly goes to a channel of its own. Energies and powers are quadratic: sums
of products of linear outputs, E = Σ F²/(2k) of springs, P = Σ c ṡ² of dampers, P = Σ F ṡ of loads.
"""

from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.language.signal_names import signal_name
from vibcli.language.signals import ENERGIES, is_load
from vibcli.mechanics.inputs_outputs.displacements import displacement
from vibcli.mechanics.inputs_outputs.linear_functions import LinearFunction, combined, rate
from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration

QUADRATIC = ("energy", "power")


def is_quadratic(text: str) -> bool:
    return signal_name(text).part in QUADRATIC


def linear_row(configuration: "Configuration", text: str) -> LinearFunction:
    """The LinearFunction of a signal over the coordinates and inputs of the opened scene."""
    signal = signal_name(text)
    row = _row(configuration, signal.still.text)
    for _ in range(signal.primes):
        row = rate(row, configuration.with_inputs.scene)
    return row


def _row(configuration: "Configuration", text: str) -> LinearFunction:
    opened, scene = configuration.with_inputs, configuration.with_inputs.scene
    name = (signal := signal_name(text)).name
    if text in ENERGIES:
        raise PhysicsError(f"'{text}' is quadratic in the motion: it is not linear", "ask for coordinates or forces")
    if is_quadratic(text):
        raise PhysicsError(f"'{text}' is quadratic in the motion: it is not linear", _instead(configuration, text))
    if name == "ground":
        from vibcli.mechanics.support_forces import on_the_ground

        return on_the_ground(opened, signal)
    node = displacement(scene, text)
    if node is not None:
        return opened.rows([node])[0]
    if name in scene.members:
        raise PhysicsError(f"'{text}' lies within what vibrates: it is no linear function of the coordinates",
                           "ask for a place where something is attached")
    if is_load(configuration.spec, text):
        return opened.rows([term.force(scene) for term in scene.terms_of(name, "forces")])[0]
    from vibcli.mechanics.support_forces import weighted_rates

    if rates := weighted_rates(opened, name):
        return combined(rates)
    force = scene.force_of(name)
    return configuration.moving_reactions.row(text) if force is None else opened.rows([force])[0]


def _instead(configuration: "Configuration", text: str) -> str:
    """What is linear of that whose power or energy is asked."""
    name, spec = signal_name(text).name, configuration.spec
    if not is_load(spec, text):
        return f"ask for {name}.force or {name}.stretch"
    known = [part for part in ("force", "moment") if is_load(spec, f"{name}.{part}")]
    return f"ask for {name}.{known[0]}" if known else "ask for motions of places where it acts"


def products(configuration: "Configuration", text: str) -> list[tuple[float, list[LinearFunction]]]:
    """[(weight, [LinearFunction, LinearFunction])] of a signal that is a sum of products, the same twice of squares."""
    opened, scene = configuration.with_inputs, configuration.with_inputs.scene
    name, part, *_ = signal_name(text)
    if scene.terms_of(name, "laws"):
        raise PhysicsError(f"'{text}' of a nonlinear law is found along the full motion alone", "write motion: full")
    if is_load(configuration.spec, text):
        if any(force.owner == name for force in scene.spread_forces):
            raise PhysicsError(f"'{text}' of a load along a member that vibrates is not found",
                               "ask for motions of places on it")
        terms = scene.terms_of(name, "forces")
        forces, places = opened.rows([term.weight for term in terms]), opened.rows([term.s for term in terms])
        return [(1.0, [force, rate(place, scene)]) for force, place in zip(forces, places, strict=True)]
    if part == "power":
        from vibcli.mechanics.support_forces import weighted_rates

        return [(weight, [row, row]) for weight, row in weighted_rates(opened, name)]
    terms = scene.terms_of(name, "springs")
    stiffnesses = evaluate([term.weight for term in terms], opened.arithmetic, opened.values)
    if not all(stiffnesses):
        raise PhysicsError(f"'{name}' has no stiffness: its energy is not a square of its force",
                           f"ask for {name}.force")
    rows = opened.rows([term.force(scene) for term in terms])
    return [(0.5 / k, [row, row]) for k, row in zip(stiffnesses, rows, strict=True)]
