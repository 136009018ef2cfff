"""k = m Omega^2 holds the tip; the spring's force balances the drive, k y = -F."""


def answers(p):
    k = p["m"] * p["Omega"] ** 2
    return {"k": k, "amplitude(y)": p["F"] / k, "amplitude(arm.u(L))": 0}
