"""The rod is replaced by the dynamically equal pair of particles at the distances ±i from its mass
centre (same mass, centre and inertia); their summed squared distances from the pivot and their potential
energy, differentiated twice, give the periods.
"""


def answers(p):
    import mpmath as mp

    def hung(distance):
        places = (distance - p["i"], distance + p["i"])
        J = sum(p["m"] / 2 * s**2 for s in places)

        def potential(phi):
            return sum(-p["m"] / 2 * p["g"] * s * mp.cos(phi) for s in places)

        return J, float(2 * mp.pi * mp.sqrt(J / mp.diff(potential, 0, 2)))

    (large_J, large_period), (small_J, small_period) = hung(p["h"]), hung(p["L"] - p["h"])
    return {
        "large_bearing: J[rod, O]": large_J,
        "large_bearing: period[1]": large_period,
        "small_bearing: J[rod, O]": small_J,
        "small_bearing: period[1]": small_period,
    }
