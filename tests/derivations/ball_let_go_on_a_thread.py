"""Energy gives the speed at each angle, v² = 2 g L (cos φ − cos α), Newton's law along the thread its force,
S = m g (3 cos φ − 2 cos α); the angle at an instant and the period by elliptic functions."""
import mpmath as mp


def answers(p):
    m, L, alpha, g = (mp.mpf(p[n]) for n in ("m", "L", "alpha", "g"))
    k, omega = mp.sin(alpha / 2), mp.sqrt(g / L)
    quarter = mp.ellipk(k * k) / omega

    def angle(t):
        return 2 * mp.asin(k * mp.ellipfun("cd", omega * t, m=k * k))

    def force(phi):
        return m * g * (3 * mp.cos(phi) - 2 * mp.cos(alpha))

    return {"thread.force(0 s)": force(alpha), "max(thread.force)": force(0), "min(thread.force)": force(alpha),
            "argmax(thread.force)": quarter, "thread.force(t1)": force(angle(p["t1"])), "period(x)": 4 * quarter}
