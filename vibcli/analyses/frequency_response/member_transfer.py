"""The frequency response of a scene with members: its system, input and output put together."""

from typing import TYPE_CHECKING

from vibcli.analyses.continuous.dynamic_matrix import dynamic_matrix
from vibcli.analyses.continuous.spread_drives import spread_inputs
from vibcli.analyses.frequency_response.member_marks import Marks
from vibcli.analyses.frequency_response.member_places import seen_at
from vibcli.analyses.frequency_response.member_response import MemberTransfer
from vibcli.analyses.frequency_response.member_system import MemberInput, MemberOutput, MemberSystem
from vibcli.analyses.modal.modal_analysis import ModalAnalysis
from vibcli.base.errors import PhysicsError
from vibcli.language.signals import is_reaction
from vibcli.mechanics.inputs_outputs.inputs import drives_supports, named_input
from vibcli.mechanics.inputs_outputs.outputs import linear_row
from vibcli.mechanics.inputs_outputs.place_signals import place_output

if TYPE_CHECKING:
    from vibcli.analyses.frequency_response.damped_member_response import DampedMemberTransfer
    from vibcli.language.signal_names import SignalName
    from vibcli.mechanics.configuration import Configuration


def member_transfer(configuration: "Configuration", signal: "SignalName", driven_by: str, order: int,
                    modal: "ModalAnalysis | None") -> "MemberTransfer | DampedMemberTransfer":
    """The response of a signal to a named input."""
    chosen = named_input(configuration, driven_by)
    if chosen.carried:
        raise PhysicsError("responses of members to a load that turns with what is driven are not found",
                           "name a coordinate, or a force that keeps its line")
    return transfer_to(configuration, signal, MemberInput(chosen.weights, chosen.turns), order, modal)


def transfer_to(configuration: "Configuration", signal: "SignalName", given: MemberInput, order: int = 0,
                modal: "ModalAnalysis | None" = None) -> "MemberTransfer | DampedMemberTransfer":
    """The MemberTransfer of a signal to inputs; one that `damping:` damps where that is given."""
    modal = modal or ModalAnalysis(configuration)
    damping = modal.member_damping
    if damping is None:
        return _still(configuration, signal, given, order, modal)
    from vibcli.analyses.frequency_response.damped_member_response import DampedMemberTransfer

    found = _still(configuration, signal, given._replace(turns=0), order, modal)
    if any(found.system.output.rows[1:]):
        raise PhysicsError(f"'{signal.text}' needs velocities, whose response is not found with `damping:` of members",
                           "ask for displacements, forces and stresses")
    parts = found, modal.modes, damping, drives_supports(configuration, given), given.turns
    if configuration.rated_beside_dampers:
        from vibcli.analyses.frequency_response.dampers_beside_ratios import DampersBesideRatios

        return DampersBesideRatios(*parts, modal.damped)
    return DampedMemberTransfer(*parts)


def _of_displacements(output: MemberOutput, order: int) -> tuple[MemberOutput, int]:
    """An output of one rate alone as one of displacements, and the order that makes it that."""
    present = [rate for rate, row in enumerate(output.rows) if any(row.values())]
    if len(present) != 1:
        return output, order
    return output._replace(rows=(output.rows[present[0]], {}, {})), order + present[0]


def _still(configuration: "Configuration", signal: "SignalName", given: MemberInput, order: int,
           modal: "ModalAnalysis") -> MemberTransfer:
    """Without what `damping:` damps."""
    opened = configuration.with_inputs
    opened.require_steady(given.weights)
    elements, n = opened.elements, len(opened.scene.q)
    pieces, size = list(elements.pieces), n
    place = place_output(configuration, signal.text)
    if place is not None:
        pieces, size, output = seen_at(place, pieces, n)
        order += place.primes
    elif is_reaction(configuration.spec, signal.still.text) or signal.name == "ground":
        raise PhysicsError(f"'{signal.text}' of small oscillations with members is not found",
                           "ask for the force, shear or moment of a member at its end")
    else:
        row = linear_row(configuration, signal.text)
        output = MemberOutput((row.q, row.v, row.a))
        if modal.member_damping is not None:
            output, order = _of_displacements(output, order)
    inputs = range(opened.n, n)
    kept = inputs if modal.member_damping is None else None
    system = MemberSystem(dynamic_matrix(elements, pieces, size, spread_inputs(configuration, given.weights), kept),
                          inputs, given, output)
    poles = modal.once("poles of responses", lambda: _of_scene(modal, kept))
    return MemberTransfer(system, Marks(modal, system.shared(), poles), order)


def _of_scene(modal: ModalAnalysis, kept: range | None) -> MemberTransfer:
    """What has the poles of all responses of a scene, and no output."""
    opened = modal.configuration.with_inputs
    elements, n = opened.elements, len(opened.scene.q)
    system = MemberSystem(dynamic_matrix(elements, kept=kept), range(opened.n, n), MemberInput({}),
                          MemberOutput(({}, {}, {})))
    return MemberTransfer(system, Marks(modal, None))
