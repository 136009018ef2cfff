"""The motion in time of members whose modes dampers couple, as a sum over damped modes (Foss 1958), the products being
integrals along members and sums over what is lumped:

    u = Σ Re(aₖ Xₖ e^{λₖt}),   D(λₖ) Xₖ = 0,   ȧₖ = λₖaₖ + Xₖ·F/nₖ,   nₖ = Xₖ·(2λₖM + C)Xₖ,
    aₖ(0) = Xₖ·(M u̇ + (λₖM + C) u)/nₖ,   twice that of one of a pair.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.complex_numbers import cleared, complex_told
from vibcli.report.steps.from_modes import ALIKE, waves
from vibcli.report.steps.step import WorkedSolution, number, told, unit_told
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.parser import VALUE
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.results.modal_signals import ModalSignal
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

FIRST = 3           # damped modes that are told
ROOT = 1e-8         # of D at a root: its least singular value beside the largest one
PAIRS = ",  products being integrals along members,  and a pair of roots adds twice the real part of one"


def tell_damped_members(problem: "Problem", sheet: WorkedSolution) -> None:
    """Write down damped modes and what they add up to at the places asked; nothing of another kind of response."""
    from vibcli.results.damped_modal_response import DampedModalResponse

    try:
        if isinstance(problem.response, DampedModalResponse):
            modes = _roots(problem, sheet)
            if modes:
                _write(problem, sheet, modes)
    except PhysicsError:
        return


def tell_damped_roots(problem: "Problem", sheet: WorkedSolution) -> None:
    """Write down the damped modes that dampers make, where no line before tells them."""
    if any(line.settles == "damped modes" for line in sheet.steps) or problem.spec.get("damping") is not None:
        return
    try:
        _roots(problem, sheet)
    except PhysicsError:
        return


def _roots(problem: "Problem", sheet: WorkedSolution) -> "list[DampedMode]":
    """The first damped modes that oscillate, written down; none where D is not singular at their roots."""
    if problem.modal.damped is None:
        return []
    modes = [mode for mode in problem.modal.damped.first(2 * FIRST) if complex(mode.eigenvalue).imag][:FIRST]
    if not modes or not _singular(problem, [complex(mode.eigenvalue) for mode in modes]):
        return []
    line = sheet.write(Words("with what damps each mode goes as  "), "exp(λ·t)", Words(
        "  instead, so that in these conditions  "), "∂/∂t", Words(" is "), "λ", Words(" and "), "ω²", Words(" is "),
                       "−λ²", settles="damped modes", uses=[sheet.last])
    for mode in modes:
        _root(sheet, mode, line)
    return modes


def _singular(problem: "Problem", roots: Sequence[complex]) -> bool:
    """Is D singular at each of the roots?"""
    import numpy as np

    from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix
    from vibcli.analyses.continuous.mode_basis import in_floats
    from vibcli.results.damped_modal_response import DampedModalResponse

    response = DampedModalResponse(problem)
    M, C, K = response.matrices
    D = DynamicMatrix(np.array([K, C, M]), in_floats(response.linear.pieces)).at(np.array(roots)).D
    for k in range(len(roots)):
        scale = 1 / np.sqrt(np.abs(D[:, :, k]).max(axis=1))
        size = np.linalg.svd(D[:, :, k] * np.outer(scale, scale), compute_uv=False)
        if len(D) > 1 and size[-1] > ROOT * size[0]:
            return False
    return True


def _write(problem: "Problem", sheet: WorkedSolution, modes: "list[DampedMode]") -> None:
    started = problem.spec.get("initial") is not None or bool(problem.spec.let_go)
    M, C = (Name(sheet.letter(letter)) for letter in "MC")
    of_start = [Words("of the start each has  "), "a_k(0) = X_k·(", M, "·", Name("u'"), " + (λ_k·", M, " + ", C,
                ")·u)/n_k", Words(",  ")] * started
    of_loads = [Words("under the loads  "), Name("a_k'"), " = λ_k·a_k + X_k·F(t)/n_k", Words(
        ",  ")] * problem.scene.timed
    line = sheet.write("u(x, t) = Σ a_k(t)·X_k(x)", Words(":  "), *of_start, *of_loads,
                       "n_k = X_k·(2·λ_k·", M, " + ", C, ")·X_k", Words(PAIRS), settles="parts of damped modes",
                       uses=[sheet.last])
    told_of = set()
    for answer in problem.spec.answers:
        tree = answer.asked.tree
        if getattr(tree, "head", "") == VALUE and isinstance(tree.args[0], NameRef):
            signal = problem.response.signal(tree.args[0])
            unit = unit_told(problem.spec, answer.asked)
            _at_place(problem, sheet, (signal, tree.args[0].name, modes, unit), told_of, line)


def _root(sheet: WorkedSolution, mode: "DampedMode", line: int) -> int:
    """The line of λ, δ and ω_d of a mode."""
    root, k = complex(mode.eigenvalue), mode.index
    sheet.write(Name(sheet.letter(f"lambda{k}")), f" = {complex_told(root)}", Words(" 1/s   (by a search),  "),
                        Name(sheet.letter(f"omega_d{k}")), *number(root.imag, "rad/s"),
                        settles=f"omega_d[{k}]", value=root.imag, unit="rad/s", uses=[line])
    return sheet.write(Name(sheet.letter(f"delta{k}")), *number(-cleared(root).real, "1/s"), settles=f"decay[{k}]",
                       value=-root.real, unit="1/s", joined=True)


def _at_place(problem: "Problem", sheet: WorkedSolution, asked: "tuple[ModalSignal, str, list[DampedMode], str]",
              told_of: set[tuple[str, float]], line: int) -> None:
    """The line of what the modes add up to at a place, free of loads: from the start, or after they have ended."""
    signal, name, modes, unit = asked
    last = signal.modal.stretches(0.0)[-1]
    if not signal.modal.forcing.listed or last.strokes or (name, last.start) in told_of:
        return
    told_of.add((name, last.start))
    weights = signal.modal.rows_of(signal.reads)[0][0] * last.free
    sizes = {k: sum(w for w, rate in zip(weights, signal.modal.states.rates, strict=True)
                    if abs(rate - complex(mode.eigenvalue)) <= ALIKE * abs(rate)) for k, mode in enumerate(modes)}
    scene, tau = problem.scene, _time_from(problem, sheet, last.start)
    terms: list[Any] = []
    for k, size in sizes.items():
        if abs(size) > ALIKE * max(abs(one) for one in weights):
            terms += waves(scene, sheet, modes[k].index, (size.real, -size.imag), ALIKE * abs(size), True)
    if terms:
        shown = [part if isinstance(part, str) else substitute([part], {scene.time: tau})[0] for part in terms]
        after = [Words(",  "), tau, " = ", scene.time, f" − {told(last.start)}", Words(" s")] * bool(last.start)
        head = [Words("when the loads have ended  ")] * bool(last.start)
        first = shown[1:] if shown[0] == " + " else ["−", *shown[1:]]
        rest = [f" + {told(signal.reads.constant)}"] * bool(signal.reads.constant)
        sheet.write(*head, Name(name), " = ", *first, " + …", *rest, *after, Words(f"   (in {unit})"),
                    settles=f"motion of {name}", uses=[line])


def _time_from(problem: "Problem", sheet: WorkedSolution, start: float) -> "Node":
    """The symbol of the time from an instant on."""
    return problem.scene.table.parameter(sheet.letter("tau")) if start else problem.scene.time
