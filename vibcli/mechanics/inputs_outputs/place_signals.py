"""Signals within pieces of members that vibrate: parts of their deflection, in numbers."""

from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.language.signal_names import signal_name
from vibcli.mechanics.inputs_outputs.displacements import signal_of_place
from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration

SAME = 1e-14        # of the length of a member: places nearer than that are one


class PlaceOutput(NamedTuple):
    """factor · ∂ᵒʳᵈᵉʳu/∂xᵒʳᵈᵉʳ at a part `share` of the length of piece number `piece` of the linear system,
    differentiated by the time as often as there are `primes`; `place`: from the left end of the member `owner`."""

    owner: str
    place: Any
    piece: int
    share: Any
    order: int
    factor: Any
    primes: int


def place_output(configuration: "Configuration", text: str) -> PlaceOutput | None:
    """The PlaceOutput of a signal within a piece that vibrates; None of any that is a linear function of the
    coordinates and their rates (linear_row)."""
    signal = signal_name(text)
    if signal.name not in configuration.scene.members:
        return None
    opened = configuration.with_inputs
    scene = opened.scene
    found = signal_of_place(scene, signal)
    if found.motion is not None or found.is_light or found.factor.is_zero:
        return None
    start, slack = scene.number(found.left.place), SAME * scene.number(found.member.length)
    piece = next(i for i, term in enumerate(scene.pieces) if term.owner == found.member.name
                 and abs(scene.number(term.start) - start) <= slack)
    nodes = [found.left.place + found.at, found.at / (found.right.place - found.left.place), found.factor]
    place, share, factor = evaluate(nodes, opened.arithmetic, opened.values)
    return PlaceOutput(found.member.name, place, piece, share, found.order, factor, signal.primes)
