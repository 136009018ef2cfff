"""Mechanisms twice: as scenes, and as T, V and Φ written out by hand for SymPy, from the velocities.

Each function returns (text of the scene, names of coordinates, energies), where energies(p, q, v) gives (T, V, Phi) for
lists of symbols q and v and exact parameter values p.
"""

from sympy import Matrix, cos, sin, sqrt


def square(*vector):
    return sum(x * x for x in vector)


def speed(place, q, v):
    """The velocity of a place (x, y) given in coordinates."""
    return Matrix(place).jacobian(Matrix(q)) * Matrix(v)


def double_pendulum():
    text = """
        parameters: {m1: 3 kg, m2: 2 kg, L1: 0.8 m, L2: 0.5 m, g: 9.81 m/s^2}
        gravity: g
        bodies:
          one: {shape: rod, mass: m1, from: [0, 0], to: [0, -L1], pin: {at: [0, 0], by: a}}
          two: {shape: rod, mass: m2, from: [0, -L1], to: [0, -L1 - L2], pin: {at: [0, -L1], carrier: one, by: b}}
        """

    def energies(p, q, v):
        (a, b), (u, w) = q, v
        m1, m2, L1, L2, g = (p[n] for n in ("m1", "m2", "L1", "L2", "g"))
        across = L1**2 * u**2 + L2**2 / 4 * w**2 + L1 * L2 * u * w * cos(a - b)
        T = m1 * L1**2 / 6 * u**2 + m2 / 2 * across + m2 * L2**2 / 24 * w**2
        return T, -m1 * g * L1 / 2 * cos(a) - m2 * g * (L1 * cos(a) + L2 / 2 * cos(b)), 0
    return text, ("a", "b"), energies


def cart_pendulum():
    text = """
        parameters: {M: 4 kg, m: 1.5 kg, L: 0.7 m, k: 300 N/m, c: 6 N*s/m, ct: 0.2 N*m*s, g: 9.81 m/s^2}
        gravity: g
        bodies:
          cart: {mass: M, at: [0, 0], slide: x}
          bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
        springs:
          s: {k: k, between: [[-3*L, 0], cart]}
        dampers:
          d: {c: c, between: [[-3*L, 0], cart]}
          hinge: {torsion: ct, between: [cart, bob]}
        """

    def energies(p, q, v):
        (x, f), (u, w) = q, v
        M, m, L, k, c, ct, g = (p[n] for n in ("M", "m", "L", "k", "c", "ct", "g"))
        T = M * u**2 / 2 + m * (u**2 + 2 * L * u * w * cos(f) + L**2 * w**2) / 2
        return T, k * x**2 / 2 - m * g * L * cos(f), c * u**2 / 2 + ct * w**2 / 2
    return text, ("x", "phi"), energies


def rod_on_cart_with_springs():
    """An upright rod on a cart, held by a spring between cart and tip that is inclined and preloaded."""
    text = """
        parameters: {M: 5 kg, m: 2 kg, L: 0.9 m, b: 0.4 m, k: 900 N/m, K: 250 N/m, N: 12 N, c: 3 N*s/m, g: 9.81 m/s^2}
        gravity: g
        points:
          tip: {body: rod, at: [0, L]}
          post: {body: cart, at: [-b, 0]}
        bodies:
          cart: {mass: M, at: [0, 0], slide: x}
          rod: {shape: rod, mass: m, from: [0, 0], to: [0, L], pin: {at: [0, 0], carrier: cart, by: f}}
        springs:
          stay: {k: k, between: [post, tip], preload: N}
          wall: {k: K, between: [[-2*b, L], tip]}
        dampers:
          d: {c: c, between: [[2*b, L], tip]}
        """

    def energies(p, q, v):
        (x, f), (u, w) = q, v
        M, m, L, b, k, K, N, c, g = (p[n] for n in ("M", "m", "L", "b", "k", "K", "N", "c", "g"))
        tip = (x - L * sin(f), L * cos(f))
        middle = speed((x - L / 2 * sin(f), L / 2 * cos(f)), q, v)
        T = M * u**2 / 2 + m * square(*middle) / 2 + m * L**2 / 24 * w**2
        stay = sqrt(square(tip[0] - x + b, tip[1])) - sqrt(L**2 + b**2)
        wall = sqrt(square(tip[0] + 2 * b, tip[1] - L)) - 2 * b
        reach = sqrt(square(2 * b - tip[0], tip[1] - L))
        rate = (Matrix([reach]).jacobian(Matrix(q)) * Matrix(v))[0]
        V = m * g * L / 2 * cos(f) + N * stay + k * stay**2 / 2 + K * wall**2 / 2
        return T, V, c * rate**2 / 2
    return text, ("x", "f"), energies


def disc_in_track_with_rod():
    text = """
        parameters: {m: 2 kg, r: 0.1 m, R: 0.5 m, M: 0.8 kg, L: 0.6 m, g: 9.81 m/s^2}
        gravity: g
        surfaces:
          track: {circle: [0, 0], radius: R, side: inside}
        bodies:
          disc: {shape: disc, mass: m, radius: r, at: [0, r - R], roll: {surface: track, swing: psi}}
          rod: {shape: rod, mass: M, from: [0, r - R], to: [0, r - R - L],
                pin: {at: [0, r - R], carrier: disc, by: phi}}
        """

    def energies(p, q, v):
        (s, f), (u, w) = q, v
        m, r, R, M, L, g = (p[n] for n in ("m", "r", "R", "M", "L", "g"))
        a = R - r
        middle = speed((a * sin(s) + L / 2 * sin(f), -a * cos(s) - L / 2 * cos(f)), q, v)
        turning = a / r * u
        T = m * a**2 * u**2 / 2 + m * r**2 / 4 * turning**2 + M * square(*middle) / 2 + M * L**2 / 24 * w**2
        return T, -m * g * a * cos(s) - M * g * (a * cos(s) + L / 2 * cos(f)), 0
    return text, ("psi", "phi"), energies


def rolling_on_cart():
    """A cart on an incline; on its deck, which is level, a ring rolls, tied to the cart."""
    text = """
        parameters: {M: 6 kg, m: 2 kg, r: 0.2 m, h: 0.3 m, k: 150 N/m, K: 800 N/m, beta: 20 deg,
                     g: 9.81 m/s^2, w: 0.9 m}
        gravity: g
        points:
          post: {body: cart, at: [-w, h + r]}
        surfaces:
          deck: {line: [[-w, h], [w, h]], body: cart}
        bodies:
          cart: {mass: M, at: [0, 0], slide: {along: [cos(beta), sin(beta)], by: x}}
          ring: {shape: ring, mass: m, radius: r, at: [0, h + r], roll: {surface: deck, travel: s}}
        springs:
          a: {k: k, between: [post, ring]}
          b: {k: K, between: [[-w*cos(beta), -w*sin(beta)], cart]}
        """

    def energies(p, q, v):
        (x, s), (u, w) = q, v
        M, m, k, K, beta, g = (p[n] for n in ("M", "m", "k", "K", "beta", "g"))
        T = M * u**2 / 2 + m * square(u * cos(beta) + w, u * sin(beta)) / 2 + m * w**2 / 2
        return T, (M + m) * g * x * sin(beta) + k * s**2 / 2 + K * x**2 / 2, 0
    return text, ("x", "s"), energies


def welded_hammer():
    """A rod with a disc welded to its end and a hole cut out of the disc, on a torsion spring."""
    text = """
        parameters: {m: 2 kg, L: 0.6 m, rho: 500 kg/m^2, r: 0.12 m, e: 0.05 m, kt: 40 N*m, ct: 0.3 N*m*s, g: 9.81 m/s^2}
        gravity: g
        bodies:
          arm: {shape: rod, mass: m, from: [0, 0], to: [L, 0], pin: {at: [0, 0], by: phi}}
          head:
            parts:
              - {shape: disc, density: rho, radius: r, at: [L, 0]}
              - {shape: disc, density: rho, radius: e, at: [L, r/2], cut: true}
            weld: arm
        springs:
          s: {torsion: kt, between: [ground, arm], preload: static}
        dampers:
          d: {torsion: ct, between: [arm, ground]}
        """

    def energies(p, q, v):
        from sympy import pi

        (f,), (w,) = q, v
        m, L, rho, r, e, kt, ct, g = (p[n] for n in ("m", "L", "rho", "r", "e", "kt", "ct", "g"))
        disc, hole = rho * pi * r**2, rho * pi * e**2
        J = m * L**2 / 3 + disc * (r**2 / 2 + L**2) - hole * (e**2 / 2 + L**2 + r**2 / 4)
        along = m * L / 2 + (disc - hole) * L
        height = along * sin(f) - hole * r / 2 * cos(f)
        return J * w**2 / 2, g * height - g * along * f + kt * f**2 / 2, ct * w**2 / 2
    return text, ("phi",), energies


def three_links():
    """Three links of a chain, the third measured from the second, with springs and dampers at the joints."""
    text = """
        parameters: {m: 1 kg, L: 0.4 m, I: 0.02 kg*m^2, kt: 5 N*m, k: 60 N/m, c: 0.4 N*m*s, g: 9.81 m/s^2, d: 0.7 m}
        gravity: g
        points:
          end: {body: three, at: [0, -3*L]}
        bodies:
          one: {mass: m, inertia: I, at: [0, -L/2], pin: {at: [0, 0], by: a}}
          two: {mass: m, inertia: I, at: [0, -3*L/2], pin: {at: [0, -L], carrier: one, by: b}}
          three: {mass: m, inertia: I, at: [0, -5*L/2], pin: {at: [0, -2*L], carrier: two, by: c3, relative: true}}
        springs:
          s: {torsion: kt, between: [one, two]}
          t: {k: k, between: [[d, -3*L], end]}
        dampers:
          u: {torsion: c, between: [two, three]}
          w: {torsion: c, between: [ground, three]}
        """

    def energies(p, q, v):
        a, b, t = q
        m, L, J, kt, k, c, g, d = (p[n] for n in ("m", "L", "I", "kt", "k", "c", "g", "d"))
        angles, rates = (a, b, b + t), (v[0], v[1], v[1] + v[2])
        x = y = T = V = 0
        for angle, rate in zip(angles, rates, strict=True):
            middle = (x + L / 2 * sin(angle), y - L / 2 * cos(angle))
            T += m * square(*speed(middle, q, v)) / 2 + J * rate**2 / 2
            V += m * g * middle[1]
            x, y = x + L * sin(angle), y - L * cos(angle)
        V += kt * (b - a) ** 2 / 2 + k * (sqrt(square(x - d, y + 3 * L)) - d) ** 2 / 2
        return T, V, c * v[2] ** 2 / 2 + c * rates[2] ** 2 / 2
    return text, ("a", "b", "c3"), energies


def geared():
    """Two shafts geared together and a drum, lumped, with a weight on its rope."""
    text = """
        parameters: {J1: 0.2 kg*m^2, J2: 0.9 kg*m^2, R: 0.3 m, r: 0.1 m, m: 4 kg, kt: 300 N*m, k: 2 kN/m, c: 5 N*s/m,
                     g: 9.81 m/s^2}
        coordinates: [u, v, y]
        gravity: g
        bodies:
          pinion: {inertia: J1, turn: u}
          gear: {inertia: J2, turn: -r/R*v}
          motor: {inertia: J1, turn: v}
          load: {mass: m, at: [R, -1.5*R], slide: {along: [0, 1], by: R*u - y}}
        springs:
          shaft: {torsion: kt, between: [pinion, motor]}
          brake: {torsion: kt, between: [ground, gear]}
          rope: {k: k, stretch: y}
        dampers:
          air: {c: c, between: [[R, -9*R], load]}
        """

    def energies(p, q, v):
        (x, y, z), (a, b, w) = q, v
        J1, J2, R, r, m, kt, k, c, g = (p[n] for n in ("J1", "J2", "R", "r", "m", "kt", "k", "c", "g"))
        fall = R * a - w
        T = J1 * a**2 / 2 + J2 * (r / R * b) ** 2 / 2 + J1 * b**2 / 2 + m * fall**2 / 2
        V = kt * (y - x) ** 2 / 2 + kt * (r / R * y) ** 2 / 2 + k * z**2 / 2 + m * g * (R * x - z)
        return T, V, c * fall**2 / 2
    return text, ("u", "v", "y"), energies


ALL = (double_pendulum, cart_pendulum, rod_on_cart_with_springs, disc_in_track_with_rod, rolling_on_cart, welded_hammer,
       three_links, geared)
