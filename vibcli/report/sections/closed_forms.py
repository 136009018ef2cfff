"""Closed forms as data: frequencies in letters, as expressions of the scene language."""

from vibcli.notation.scene_language import language


def closed_data(problem):
    """{modes, damped} of a scene with symbols; values are expressions, null where no closed form is readable."""
    forms = problem.closed_forms
    names = problem.scene.coordinates
    if forms is None:
        return {"modes": None, "damped": None}
    table = problem.scene.table
    modes = []
    for mode in forms.modes:
        still = mode.unstable or mode.omega.is_zero
        shape = mode.shape or [None] * len(names)
        modes.append({
            "index": mode.index, "omega": None if mode.unstable else language(mode.omega),
            "frequency": None if mode.unstable else language(mode.omega / (2 * table.pi)),
            "period": None if still else language(2 * table.pi / mode.omega),
            "growth_rate": language(mode.omega) if mode.unstable else None,
            "shape": _shape(names, shape), "error": 0.0})
    damped = [{"index": mode.index, "eigenvalue": None, "omega": language(mode.omega), "zeta": language(mode.zeta),
               "omega_d": language(mode.omega_d), "omega_d_where": language(mode.zeta) + " < 1",
               "decay": language(mode.zeta * mode.omega), "growth_rate": None,
               "shape": _shape(names, mode.shape or [None] * len(names)), "error": 0.0}
              for mode in forms.modes if mode.zeta is not None]
    found = {"modes": modes, "damped": damped or None}
    if forms.polynomials:
        square = table.parameter("omega") ** 2
        whole = [table.sum(*((c * square ** i, 1) for i, c in enumerate(reversed(polynomial))))
                 for polynomial in forms.polynomials]
        found["characteristic_polynomial"] = [language(node) for node in whole]
    return found


def _shape(names, shape):
    return {name: None if value is None else language(value) for name, value in zip(names, shape, strict=True)}
