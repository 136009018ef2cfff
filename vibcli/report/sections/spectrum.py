"""Natural frequencies, damping and mode shapes."""

from vibcli.analyses.modal.normalisation import WORDS
from vibcli.base.errors import Inertless
from vibcli.report.blocks import TableBlock, equations, line, paragraph, section
from vibcli.report.sections.mode_tables import damped_row, mode_row, polar, repeated, shapes

WITHOUT_DAMPERS = "without its dampers nothing would hold what has no inertia in this scene"
DAMPED = "Damped modes (eigenvalue λ: ω = |λ|, ζ = −Re λ/|λ|, decay = −Re λ = ζω, log. decrement = 2πζ/√(1−ζ²))"


def frequencies(problem, _):
    if problem.numeric.has_free_symbols:
        yield from _frequencies_in_letters(problem)
        return
    if not problem.modal.modes:
        yield from section("Natural frequencies", paragraph("none are told: " + WITHOUT_DAMPERS))
        return
    modal = problem.modal
    same = repeated(modal.modes)
    rows = [mode_row(mode, modal.zero_modes.get(mode.index), mode.index in same) for mode in modal.modes]
    damped = "of the undamped system" if modal.damped else "undamped"
    head = ("mode", "ω [rad/s]", "f [Hz]", "T [s]", "error ≤", "")
    yield from section(f"Natural frequencies ({damped})", TableBlock(head, tuple(rows)), _form(problem))


def _form(problem):
    """The closed form of the frequency of one degree of freedom."""
    if len(problem.scene.coordinates) == 1 and problem.symbolic.linearisable and problem.modal.modes[0].omega:
        form = problem.closed_forms
        if form is not None:
            return equations([line("ω = ", form.modes[0].omega, hang=None)])
    return None


def _frequencies_in_letters(problem):
    from vibcli.mechanics.symbolic_equilibrium_linear import equilibrium_in_letters
    from vibcli.report.sections.symbolic_modes import damping_blocks, frequency_blocks

    equilibrium_in_letters(problem.symbolic)  # refused where there is none
    M, C, _, K = problem.symbolic.matrices
    if not M and not C:
        raise Inertless
    if len(problem.scene.q) == 1 and not M and C and K:
        yield from section("Relaxation", equations([line("λ = ", -(K[0, 0] / C[0, 0]))]))
        return
    forms = problem.closed_forms
    yield from section("Natural frequencies [rad/s]", *frequency_blocks(problem, forms))
    yield from section("Damping", *damping_blocks(forms))


def damping(problem, _):
    if problem.numeric.has_free_symbols or problem.modal.damped is None:
        return
    head = ("mode", "ω [rad/s]", "ζ", "ω_d [rad/s]", "T_d [s]", "decay [1/s]", "error ≤", "")
    yield from section(DAMPED, TableBlock(head, tuple(map(damped_row, problem.modal.damped))))


def modes(problem, report):
    names = problem.scene.coordinates
    if len(names) < 2:
        return
    if problem.numeric.has_free_symbols:
        from vibcli.report.sections.symbolic_modes import shape_blocks

        if problem.closed_forms is not None:
            yield from section("Mode shapes (the first coordinate that moves is 1)",
                               *shape_blocks(problem, names, problem.closed_forms))
        return
    if problem.modal.modes:
        yield from _shapes(problem, report, problem.modal.modes, f"Mode shapes ({WORDS[report.normalise]})")
    if problem.modal.damped is not None:
        yield from _shapes(problem, report, problem.modal.damped, "Shapes of the damped modes", only_complex=True)


def _shapes(problem, report, modes, title, only_complex=False):
    names = problem.scene.coordinates
    found = [problem.modal.shape(mode, report.normalise) for mode in modes]
    out_of_phase = any(abs(complex(value).imag) > 1e-9 * abs(value) for shape in found for value in shape)
    if out_of_phase:
        yield from section(f"{title}, amplitude ∠ phase", *shapes(names, found, polar))
    elif not only_complex:
        yield from section(title, *shapes(names, found))
