"""What a load that swings keeps up of members where dampers act beside `damping:` of each mode: by the receptance of
the modes that are damped by themselves, and what the dampers take of it,

    U = H (F − iΩ C U),   H = Σ Xₖ Xₖᵀ/(mₖ (ωₖ² − Ω² + 2iδₖΩ)).
"""

from math import isclose
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.complex_numbers import cleared, complex_told
from vibcli.report.steps.matrix_units import unit_of_receptance
from vibcli.report.steps.step import WorkedSolution, number

if TYPE_CHECKING:
    from numpy import ndarray

    from vibcli.results.problem import Problem

WRITTEN = 3         # motions whose H is written out
CLOSE = 1e-8        # relative: of an amplitude by the lines and the engine's


def tell_coupled_steady(problem: "Problem", sheet: WorkedSolution, Omega: float, forces: "ndarray") -> None:
    """Write down H, C and U of loads F at one frequency; nothing where dampers do not act beside `damping:`, and where
    the engine finds other amplitudes."""
    from vibcli.results.coupled_modal_response import CoupledModalResponse

    try:
        H, C = CoupledModalResponse(problem).apart_from_dampers(1j * Omega)
        if C.any() and len(H) <= WRITTEN:
            _write(problem, sheet, (H, C, forces), Omega)
    except PhysicsError:
        return


def _write(problem: "Problem", sheet: WorkedSolution, parts: "tuple[ndarray, ndarray, ndarray]", Omega: float) -> None:
    import numpy as np

    H, C, F = parts
    names = problem.scene.coordinates
    U = [cleared(complex(x)) for x in np.linalg.solve(np.eye(len(F)) + 1j * Omega * H @ C, H @ F)]
    known = [abs(_phasor(problem, name, Omega)) for name in names]
    if not all(isclose(abs(u), size, rel_tol=CLOSE) for u, size in zip(U, known, strict=True)):
        return
    h, u, f, c = (Name(sheet.letter(letter)) for letter in ("H", "U", "F", "C"))
    rule = sheet.write(Words("without the dampers each mode is damped by itself, so that loads  "), f, "·exp(i·Ω·t)",
                       Words("  keep up  "), h, "·", f, Words("  with  "), h,
                       " = Σ X_k·X_k/(m_k·(ω_k² − Ω² + 2·i·δ_k·Ω))", Words(",  the second  "), "X_k",
                       Words("  transposed"), settles="receptance", uses=[sheet.last])
    more = [part for i in range(len(H)) for j in range(i, len(H)) for part in (
        Words(",  "), Name(sheet.letter(f"H{i + 1}{j + 1}")), f" = {complex_told(cleared(complex(H[i, j])))}",
        Words(f" {unit_of_receptance(problem, i, j)}"))]
    of = [part for name in names for part in (Words(", "), Name(name))][1:]
    line = sheet.write(Words("of  "), *of, Words(":  "), *more[1:], settles="entries of the receptance", uses=[rule])
    line = sheet.write(Words("dampers take  "), "i·Ω·", c, "·", u, Words(" of the loads:  "), u, " = ", h, "·(", f,
                       " − i·Ω·", c, "·", u, ")", settles="balance at the dampers", uses=[line])
    for i, name in enumerate(names):
        unit, letter = "m" if problem.system.dimension(name) else "rad", Name(sheet.letter(f"U{i + 1}"))
        sheet.write(Words("so  " * (not i)), letter, f" = {complex_told(U[i])}", Words(f" {unit},  "), "|", letter,
                    "|", *number(abs(U[i]), unit), settles=f"steady {name}", value=abs(U[i]), unit=unit, uses=[line],
                    joined=i > 0)


def _phasor(problem: "Problem", name: str, Omega: float) -> complex:
    """The phasor of a coordinate at a frequency, by the engine."""
    from vibcli.symbolic.syntax import NameRef

    signal = problem.response.kept_up.signal(NameRef(0, len(name), name, 0))
    return next((value for at, value in signal.phasors if isclose(at, Omega, rel_tol=CLOSE)), 0.0)
