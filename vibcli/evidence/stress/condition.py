"""Condition numbers: what the plain way multiplies relative errors of its data with.

Of natural modes that of L⁻¹ K L⁻ᵀ, (ω_max/ω_min)²; of damped ones the largest of their eigenvalues',
‖x‖ ‖y‖/|yᴴ x|; of a response that of K + iΩ C − Ω² M; of a peak |λ|/(2 |Re λ|); of a motion the largest ω t.
"""

from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.evidence.subject import Subject
from vibcli.quantities.expression import number_of

if TYPE_CHECKING:
    import mpmath


def condition(subject: Subject) -> float | None:
    """That of a Subject; None of full motions."""
    kind = {"modes": _of_squares, "damped modes": _of_eigenvalues, "response": _of_response, "peak": _of_peak,
            "motion": _of_motion}.get(subject.kind)
    return None if kind is None else float(kind(subject))


def _of_squares(subject: Subject) -> "mpmath.mpf":
    sizes = [abs(x) for x in subject.true.values if x]
    return (max(sizes) / min(sizes)) ** 2 if sizes else 1.0


def _of_eigenvalues(subject: Subject) -> float:
    import scipy.linalg

    M, C, K = subject.data
    A = np.block([[np.zeros_like(M), np.eye(len(M))], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    _, left, right = scipy.linalg.eig(A, left=True)
    with np.errstate(divide="ignore"):
        return cast("float", (1 / np.abs((left.conj() * right).sum(axis=0))).max())


def _of_response(subject: Subject) -> float:
    curve, Omega, _ = subject.data
    return cast("float", np.linalg.cond(curve.K + 1j * Omega * curve.C - Omega**2 * curve.M))


def _of_peak(subject: Subject) -> float:
    """Of the eigenvalue that decays least."""
    eigenvalues = [mode.eigenvalue for mode in subject.problem.modal.damped or ()]
    return max(abs(x) / (2 * abs(x.real)) if x.real else np.inf for x in eigenvalues)


def _of_motion(subject: Subject) -> float:
    modes, problem = subject.problem.modal.modes, subject.problem
    t = number_of(problem, problem.spec.answers[0].asked.tree.args[1])
    return t * max(float(abs(complex(mode.growth_rate or 0.0, mode.omega or 0.0))) for mode in modes)
