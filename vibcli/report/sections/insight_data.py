"""Shares, sensitivities and estimates as plain data with the documented keys of --json."""

from vibcli.base.errors import PhysicsError
from vibcli.language.parameters import require_values


def insight_data(problem, words):
    """{word: what it found} of those that are asked for."""
    for word in words:
        require_numbers(problem, word)
    return {word: _DATA[word](problem) for word in words}


def require_numbers(problem, word):
    """Refuse a scene with symbols."""
    if problem.numeric.has_free_symbols:
        require_values(problem.scene.parameters, f"`{word}`")


def logarithmic(value, rate, omega):
    """(p/ω) ∂ω/∂p; None where there is no derivative."""
    return None if rate is None else value * rate / omega


def _shares_data(problem):
    found = problem.modal.shares
    return {"modes": [{"index": i, "potential": found.potential[i], "kinetic": found.kinetic[i]}
                      for i in found.kinetic],
            "damped": None if found.dissipation is None else [
                {"index": mode.index, "dissipation": shares} for mode, shares in found.dissipation]}


def _sensitivities_data(problem):
    found = problem.modal.sensitivities
    omega = {mode.index: float(mode.omega) for mode in problem.modal.modes if mode.omega}
    entries = []
    for name, value in found.values.items():
        rates = found.omega.get(name, {})
        modes = [{"index": i, "omega": rate, "logarithmic": logarithmic(value, rate, omega[i])}
                 for i, rate in rates.items()]
        damped = None if found.damped is None or name in found.refused else [
            {"index": one.mode.index, "eigenvalue": [one.eigenvalue[name].real, one.eigenvalue[name].imag],
             "zeta": None if one.zeta is None else one.zeta[name]} for one in found.damped if one.eigenvalue]
        entries.append({"parameter": name, "value": value, "modes": modes, "damped": damped,
                        "refusal": found.refused.get(name)})
    return {"parameters": entries, "coinciding": found.coinciding, "refusal": found.remark}


def _estimates_data(problem):
    try:
        found = problem.modal.estimates
    except PhysicsError as error:
        return dict.fromkeys(("omega", "rayleigh", "dunkerley", "deflection", "alone")) | {"refusal": error.message}
    return {"omega": found.omega, "rayleigh": found.rayleigh, "dunkerley": found.dunkerley,
            "deflection": found.deflection, "alone": found.alone, "refusal": None}


_DATA = {"shares": _shares_data, "sensitivities": _sensitivities_data, "estimates": _estimates_data}
