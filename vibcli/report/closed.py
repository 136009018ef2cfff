"""Closed forms as data: frequencies in letters, as expressions of the scene language."""

from vibcli.report.language import language


def closed_data(problem):
    """{modes, damped} of a scene with symbols; values are expressions, null where no closed form is readable."""
    forms = problem.closed_forms
    names = problem.scene.coordinates
    if forms is None:
        return {"modes": None, "damped": None}
    table = problem.scene.table
    modes = []
    for i, mode in enumerate(forms.modes, 1):
        resting = mode.omega.is_zero
        shape = mode.shape or [None] * len(names)
        modes.append({
            "index": i, "omega": language(mode.omega), "frequency": language(mode.omega / (2 * table.pi)),
            "period": None if resting else language(2 * table.pi / mode.omega), "growth_rate": None,
            "shape": {name: None if value is None else language(value)
                      for name, value in zip(names, shape, strict=True)},
            "error": 0.0})
    found = {"modes": modes, "damped": None}
    if forms.polynomial:
        found["characteristic_polynomial"] = [language(node).replace("λ", "omega^2") for node in forms.polynomial]
    if forms.zeta is not None:
        omega = forms.modes[0].omega
        found["damped"] = [{"index": 1, "eigenvalue": None, "omega": language(omega), "zeta": language(forms.zeta),
                            "omega_d": language(forms.omega_d), "decay": language(forms.zeta * omega),
                            "growth_rate": None, "shape": {names[0]: "1"}, "error": 0.0}]
    return found
