"""Transfer of shear and displacement from the free top downwards: the upper girder 1, the ground what fits; frequencies
where the ground then stays at rest."""
from math import sqrt


def answers(p):
    m, k, Y, W = (p[n] for n in ("m", "k", "Y", "Omega"))

    def from_top(W):
        upper = 1.0
        shear2 = -m * W**2 * upper                  # k (x2 - x1) = m W^2 x2, as a pull on the upper girder negative
        lower = upper + shear2 / k
        shear1 = shear2 - m * W**2 * lower
        return upper, lower, lower + shear1 / k, shear1, shear2

    upper, lower, ground, shear1, shear2 = (abs(x) for x in from_top(W))
    low, high = sqrt((3 - sqrt(5)) / 2), sqrt((3 + sqrt(5)) / 2)
    for ratio in (low, high):
        assert abs(from_top(ratio * sqrt(k / m))[2]) < 1e-12
    still = from_top(sqrt(k / m))
    return {
        "omega[1]": low * sqrt(k / m),
        "omega[2]": high * sqrt(k / m),
        "amplitude(x1)": Y * lower / ground,
        "amplitude(x2)": Y * upper / ground,
        "amplitude(s2.force)": Y * shear2 / ground,
        "amplitude(s1.force)": Y * shear1 / ground,
        "still:amplitude(x1)": round(Y * abs(still[1] / still[2]), 12),
        "still:amplitude(x2)": Y * abs(still[0] / still[2]),
    }
