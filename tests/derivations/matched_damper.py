"""The wave of half the strain that leaves the end releases it; the one from the clamp is swallowed."""


def answers(p):
    return {"rod.u(L)(L/sqrt(E/rho))": p["F"] * p["L"] / (2 * p["E"] * p["A"]),
            "rod.u(L)(2.5*L/sqrt(E/rho))/(F*L/(E*A)) + 1": 1, "rod.force(L/2)(2.5*L/sqrt(E/rho))/F + 1": 1}
