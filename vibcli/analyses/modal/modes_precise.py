"""Modes to many digits, for shares and derivatives: what cancels in them must not be rounding.

A spring 10¹² times as stiff as another stretches by 10⁻¹² of the amplitudes; 18 of 30 digits are left of it.
"""

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.analyses.modal.modes import damped_modes, natural_modes
from vibcli.base.errors import PhysicsError
from vibcli.numerics.precision import estimated_steps

if TYPE_CHECKING:
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.mechanics.configuration import Configuration

DIGITS, WORKING = 30, 60
LARGEST = 80        # coordinates
MOST = 200          # steps of a million products
SAME = 1e-24        # relative difference of repeated frequencies


def sharp_modes(configuration: "Configuration") -> "list[Mode]":
    """The modes of the system without its dampers, in numbers of mpmath with 30 correct digits."""
    elements = configuration.linear_system
    _require_quick(configuration, any(elements.G.values()))
    return natural_modes(elements, configuration.precise_system, configuration.exact_system, digits=DIGITS)


def sharp_damped(configuration: "Configuration", natural: Callable[..., Any]) -> "list[DampedMode]":
    """The damped modes as precisely; `natural`: what gives those without dampers."""
    elements = configuration.linear_system
    if elements.drag or elements.circulatory:
        raise PhysicsError("shares and sensitivities of damped modes are found where C and K are symmetric",
                           "see `vibcli frequencies` for the modes themselves")
    _require_quick(configuration, True)
    return damped_modes(elements, natural, configuration.precise_system, configuration.exact_system, digits=DIGITS)


def _require_quick(configuration: "Configuration", damped: bool) -> None:
    n, hint = configuration.linear_system.n, "see `vibcli frequencies` for the modes themselves"
    if n > LARGEST:
        raise PhysicsError(f"shares, sensitivities and estimates are found for up to {LARGEST} coordinates; this scene "
                           f"has {n}", hint)
    steps, limit = estimated_steps(n, DIGITS, damped), MOST * configuration.work.patience
    if steps > limit:
        raise PhysicsError(f"the damped modes of {n} coordinates take about {steps:.0f} steps of a million products "
                           f"each to the digits that shares and sensitivities need; the limit is {limit}",
                           f"--patience {math.ceil(steps / MOST)} allows it")


def coinciding(modes: "Sequence[Mode]") -> list[list[int]]:
    """Lists of the indices of modes that have one frequency, of two modes or more."""
    return [[mode.index for mode in group] for group in by_frequency(modes) if group[1:]]


def by_frequency(modes: "Sequence[Mode]") -> "list[list[Mode]]":
    """Lists of the modes of one frequency; those that do not oscillate are left out."""
    groups = []
    for mode in modes:
        if mode.omega and groups and mode.omega - groups[-1][-1].omega <= SAME * mode.omega:
            groups[-1].append(mode)
        elif mode.omega:
            groups.append([mode])
    return groups
