"""kappa (D − d) = kappa d + nu d^3 for the deflection d of the coupling; the moment M gives both deflections. By orders
d = D/2 − nu D^3/(16 kappa) of which the moment is kappa (D − d)."""

import mpmath


def answers(p):
    kappa, nu, J, M = (mpmath.mpf(p[name]) for name in ("kappa", "nu", "J", "M"))
    with mpmath.workdps(30):
        turned = mpmath.mpf("0.4")
        d = mpmath.findroot(lambda d: kappa * (turned - 2 * d) - nu * d**3, 0.1)
        under = mpmath.findroot(lambda d: kappa * d + nu * d**3 - M, 0.2)
        stiffness = 1 / (1 / kappa + 1 / (kappa + 3 * nu * under**2))
        return {"law[s](0.4 rad)": kappa * (turned - d), "law[s, d]": kappa / 2, "law[s, d^3]": nu / 16,
                "equilibrium[phi]": under + M / kappa, "equilibrium[s.stretch.2]": under,
                "omega[1]": mpmath.sqrt(stiffness / J)}
