"""Members cut into 1 … 128 elements a piece, cubic ones of beams, linear ones of others; `eigh` of K and M, or LU at a
frequency."""

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.finite_elements import finite_elements
from vibcli.base.errors import PhysicsError
from vibcli.evidence.meshed_members import MeshAtFrequency, at_frequency
from vibcli.evidence.methods.assembled_modes import rates_of
from vibcli.evidence.reference.member_damped_modes import by_elements
from vibcli.evidence.reference.members import with_inertia
from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject

if TYPE_CHECKING:
    from vibcli.evidence.reference.rated_members import GivenDamping
    from vibcli.mechanics.factored_system import FactoredSystem

DIVISIONS = (1, 2, 4, 8, 16, 32, 64, 128)
MOST = 600              # coordinates of which all modes are found


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """Of each number of elements that has enough modes; assembled beforehand."""
    import scipy.linalg  # noqa: F401

    if subject.kind in ("member response", "rated response"):
        yield from _responses(subject)
        return
    elements, count = subject.data
    if subject.kind == "damped member modes":
        for divisions in DIVISIONS:
            yield MethodRun("finite elements", f"{divisions} a piece", partial(_damped, elements, divisions, count))
        return
    for divisions in DIVISIONS:
        K, M = with_inertia(*finite_elements(elements, divisions))
        if len(K) >= count:
            yield MethodRun("finite elements", f"{divisions} a piece", partial(_rates, K, M, count))


def _responses(subject: Subject) -> Iterator[MethodRun]:
    """By LU of the matrix at the frequency; of modes whose damping is given by a sum over all of them."""
    exact, given, damping, Omega, read = subject.data
    for divisions in DIVISIONS:
        mesh = at_frequency(exact, given, divisions)
        if damping is not None and len(mesh.K) > MOST:
            break
        run = partial(_response, mesh, Omega, read) if damping is None else partial(_rated, mesh, damping, Omega, read)
        yield MethodRun("finite elements", f"{divisions} a piece", run)


def require_free(mesh: Any) -> None:
    """PhysicsError of a mesh whose supports hold all of it, as one element between two of them."""
    if not len(mesh.M):
        raise PhysicsError("no displacement is free: its supports hold all of so few elements")


def _response(mesh: MeshAtFrequency, Omega: float, read: Any, _: Deadline) -> MethodAnswer:
    require_free(mesh)
    s = 1j * Omega
    D = mesh.K + s * (mesh.C + s * mesh.M)
    return MethodAnswer([read(mesh.signal(s, np.linalg.solve(D, mesh.pushed(s))))])


def _rated(mesh: MeshAtFrequency, damping: "GivenDamping", Omega: float, read: Any, _: Deadline) -> MethodAnswer:
    import scipy.linalg

    require_free(mesh)
    s = 1j * Omega
    squares, shapes = scipy.linalg.eigh(mesh.K, mesh.M)
    c = damping.of(np.sqrt(np.maximum(squares, 0.0)), np.arange(len(squares)))
    return MethodAnswer([read(mesh.signal(s, shapes @ ((shapes.T @ mesh.pushed(s)) / (squares + s * (c + s)))))])


def _damped(elements: "FactoredSystem", divisions: int, count: int, _: Deadline) -> MethodAnswer:
    return MethodAnswer(by_elements(elements, divisions)[:count])


def _rates(K: np.ndarray, M: np.ndarray, count: int, _: Deadline) -> MethodAnswer:
    import scipy.linalg

    squares = scipy.linalg.eigh(K, M, eigvals_only=True, subset_by_index=[0, count - 1])
    return rates_of(squares)
