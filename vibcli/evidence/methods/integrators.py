"""SciPy's integrators of first-order equations, at tolerances 1e-3 … 1e-13."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject

if TYPE_CHECKING:
    import numpy as np

SOLVERS = ("DOP853", "LSODA", "RK45", "BDF", "Radau")
TOLERANCES = tuple(10.0**-k for k in range(3, 14))
MOST = 10**7            # steps of odeint, which the deadline ends before


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """solve_ivp by each of its methods, and odeint; rtol as atol, relative to the largest value. At the start there is
    nothing to integrate."""
    import scipy.integrate  # noqa: F401

    plain = subject.data
    if plain is None:       # constraints: no equations of first order
        return
    if not plain.times[-1]:
        states = plain.start[None].repeat(2, axis=0)
        yield MethodRun("numpy solve", "", lambda _: MethodAnswer([plain.read(states, plain.times)]))
        return
    for tolerance in TOLERANCES:
        yield MethodRun("odeint", f"{tolerance:.0e}", partial(_by_odeint, subject, tolerance))
        for method in SOLVERS:
            yield MethodRun(method, f"{tolerance:.0e}", partial(_by_solve_ivp, subject, method, tolerance))


def _by_solve_ivp(subject: Subject, method: str, tolerance: float, deadline: Deadline) -> MethodAnswer:
    from scipy.integrate import solve_ivp

    plain = subject.data
    found = solve_ivp(_watched(plain.rates, deadline), (0.0, plain.times[-1]), plain.start, method, plain.times,
                      rtol=tolerance, atol=_least(subject, tolerance))
    if not found.success:
        raise RuntimeError(found.message)
    return MethodAnswer([plain.read(found.y.T, plain.times)])


def _by_odeint(subject: Subject, tolerance: float, deadline: Deadline) -> MethodAnswer:
    import warnings

    from scipy.integrate import odeint

    plain = subject.data
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        states = odeint(_watched(plain.rates, deadline), plain.start, plain.times, tfirst=True, rtol=tolerance,
                        atol=_least(subject, tolerance), mxstep=MOST)
    return MethodAnswer([plain.read(states, plain.times)])


def _least(subject: Subject, tolerance: float) -> float:
    """atol: relative to the sizes of the states where these are known, else to the largest value of the signal."""
    sizes = subject.data.sizes
    return tolerance * (subject.scale if sizes is None else sizes)


def _watched(rates: "Callable[[float, Any], np.ndarray]", deadline: Deadline) -> "Callable[[float, Any], np.ndarray]":
    """The rates, which look at the deadline now and then."""
    calls = 0

    def watched(t: float, y: "np.ndarray") -> "np.ndarray":
        nonlocal calls
        calls += 1
        if not calls & 255:
            deadline.check()
        return rates(t, y)

    return watched
