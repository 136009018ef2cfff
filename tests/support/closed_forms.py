"""Textbook results: a scene, hand formulas of its quantities, and the lines in which they are printed.

The formulas were worked out by hand; most stand in any text on vibrations (Rao; Kelly; Kovačić & Radomirović).
"""

GRAVITY = "gravity: g\n"


def chain(n, left=True, right=True, masses="m", springs="k", damped=False):
    """n masses in a row. `left`, `right`: tied to walls; `masses`, `springs`: letters, repeated as needed."""
    m = (masses.split() * n)[:n]
    ends = [("ground", "b1")] * left + [(f"b{i}", f"b{i + 1}") for i in range(1, n)] + [(f"b{n}", "ground")] * right
    k = (springs.split() * len(ends))[:len(ends)]
    letters = [*dict.fromkeys(m + k), *["c"] * damped]
    lines = ["parameters: {" + ", ".join(f"{x}: " for x in letters) + "}", "bodies:"]
    lines += [f"  b{i}: {{mass: {x}, slide: x{i}}}" for i, x in enumerate(m, 1)] + ["springs:"]
    lines += [f"  s{i}: {{k: {x}, between: [{a}, {b}]}}" for i, (x, (a, b)) in enumerate(zip(k, ends, strict=True))]
    if damped:
        lines += ["dampers:"] + [f"  d{i}: {{c: c, between: [{a}, {b}]}}" for i, (a, b) in enumerate(ends)]
    return "\n".join(lines) + "\n"


def ring(n):
    """n masses on a circle, each tied to the next."""
    lines = ["parameters: {m: , k: }", "bodies:"] + [f"  b{i}: {{mass: m, slide: x{i + 1}}}" for i in range(n)]
    lines += ["springs:"] + [f"  s{i}: {{k: k, between: [b{i}, b{(i + 1) % n}]}}" for i in range(n)]
    return "\n".join(lines) + "\n"


def pendulums(n):
    """n equal pendulums in a row, neighbours tied by springs."""
    lines = ["parameters: {m: , L: , a: , k: , g: , d: }", "gravity: g", "points:"]
    lines += [f"  A{i}: {{body: p{i}, at: [{i}*d, -a]}}" for i in range(n)] + ["bodies:"]
    lines += [f"  p{i}: {{mass: m, at: [{i}*d, -L], pin: {{at: [{i}*d, 0], by: phi{i + 1}}}}}" for i in range(n)]
    lines += ["springs:"] + [f"  s{i}: {{k: k, between: [A{i}, A{i + 1}]}}" for i in range(n - 1)]
    return "\n".join(lines) + "\n"


ROD = """
parameters: {m: , L: , a: , b: , k: , c: , g: }
gravity: g
bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [0, -L], pin: {at: [0, 0], by: phi}}}
points: {A: {body: rod, at: [0, -a]}, B: {body: rod, at: [0, -b]}}
springs: {s: {k: k, between: [A, [1, -a]]}}
dampers: {d: {c: c, between: [B, [1, -b]]}}
"""
TRACK = """
parameters: {m: , r: , R: , g: }
gravity: g
surfaces: {track: {circle: [0, 0], radius: R, side: inside}}
bodies: {disc: {shape: disc, mass: m, radius: r, at: [0, r - R], roll: {surface: track, turn: phi}}}
"""
CART = """
parameters: {M: , m: , L: , k: , g: }
gravity: g
bodies:
  cart: {mass: M, at: [0, 0], slide: x}
  bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
springs: {s: {k: k, between: [[-1, 0], cart]}}
"""
DOUBLE = """
parameters: {m: , L: , g: }
gravity: g
bodies:
  a: {mass: m, at: [0, -L], pin: {at: [0, 0], by: phi1}}
  b: {mass: m, at: [0, -2*L], pin: {at: [0, -L], carrier: a, by: phi2}}
"""
UNEQUAL = """
parameters: {m1: , m2: , L1: , L2: , g: }
gravity: g
bodies:
  a: {mass: m1, at: [0, -L1], pin: {at: [0, 0], by: phi1}}
  b: {mass: m2, at: [0, -L1 - L2], pin: {at: [0, -L1], carrier: a, by: phi2}}
"""
GOVERNOR = """
parameters: {m: , L: , g: , Omega: }
coordinates: {phi: {drawn: 1}}
energies: {T: m*L^2*(phi'^2 + Omega^2*sin(phi)^2)/2, V: -m*g*L*cos(phi)}
"""
WIND = """
parameters: {m: , L: , g: , F: {unit: N}}
gravity: g
bodies: {b: {mass: m, at: [0, -L], pin: {at: [0, 0], by: phi}}}
forces: {f: {at: b, force: [F, 0]}}
"""
CAR = """
parameters: {m: , J: , k: , c: , a: }
bodies: {car: {mass: m, inertia: J, at: [0, 0], move: [0, y, phi]}}
springs: {s: {k: k, stretch: y - a*phi}, t: {k: k, stretch: y + a*phi}}
dampers: {d: {c: c, stretch: y - a*phi}, e: {c: c, stretch: y + a*phi}}
"""
ROTOR = """
parameters: {J: , Jp: , k: {unit: N*m}, Omega: }
coordinates: {a: {drawn: 0 rad}, b: {drawn: 0 rad}}
matrices: {M: [[J, 0], [0, J]], C: [[0, Jp*Omega], [-Jp*Omega, 0]], K: [[k, 0], [0, k]]}
"""
SHAFT = """
parameters: {m: , k1: , k2: , Omega: }
coordinates: [x, y]
matrices: {M: [[m, 0], [0, m]], C: [[0, -2*m*Omega], [2*m*Omega, 0]],
           K: [[k1 - m*Omega^2, 0], [0, k2 - m*Omega^2]]}
"""
RAYLEIGH = """
parameters: {m1: , m2: , k1: , k2: , alpha: {unit: s^-1}, beta: {unit: s}}
coordinates: [x, y]
matrices:
  M: [[m1, 0], [0, m2]]
  C: [[alpha*m1 + beta*(k1 + k2), -beta*k2], [-beta*k2, alpha*m2 + beta*k2]]
  K: [[k1 + k2, -k2], [-k2, k2]]
"""
STRING = """
parameters: {m: , N: {unit: N}, L: }
bodies:
  a: {mass: m, at: [L, 0], slide: {along: [0, 1], by: y1}}
  b: {mass: m, at: [2*L, 0], slide: {along: [0, 1], by: y2}}
  c: {mass: m, at: [3*L, 0], slide: {along: [0, 1], by: y3}}
springs:
  s1: {k: 0, preload: N, between: [[0, 0], a]}
  s2: {k: 0, preload: N, between: [a, b]}
  s3: {k: 0, preload: N, between: [b, c]}
  s4: {k: 0, preload: N, between: [c, [4*L, 0]]}
"""
UPRIGHT = """
parameters: {m: , L: , g: }
gravity: g
bodies: {b: {mass: m, at: [0, L], pin: {at: [0, 0], by: phi}}}
"""
SHAFT_OF_THREE = """
parameters: {J1: , J2: , J3: , k1: {unit: N*m}, k2: {unit: N*m}}
bodies: {a: {inertia: J1, turn: phi1}, b: {inertia: J2, turn: phi2}, c: {inertia: J3, turn: phi3}}
springs: {s: {torsion: k1, between: [a, b]}, t: {torsion: k2, between: [b, c]}}
"""
SERIES = """
parameters: {m: , k1: , k2: }
bodies: {n: {slide: y}, b: {mass: m, slide: x}}
springs: {s: {k: k1, between: [ground, n]}, t: {k: k2, between: [n, b]}}
"""
TREE = """
parameters: {M: , m: , K: {unit: N/m}, k: }
bodies: {a: {mass: M, slide: x}, b: {mass: m, slide: y}, c: {mass: m, slide: z}}
springs: {s: {k: K, between: [ground, a]}, t: {k: k, between: [a, b]}, u: {k: k, between: [a, c]}}
"""
FOLLOWER = """
parameters: {m: , L: , kt: , F: {unit: N}}
bodies:
  a: {mass: m, at: [0, L], pin: {at: [0, 0], by: phi1}}
  b: {mass: m, at: [0, 2*L], pin: {at: [0, L], carrier: a, by: phi2}}
springs: {s: {torsion: kt, between: [ground, a]}, t: {torsion: kt, between: [a, b]}}
forces: {f: {at: b, force: [0, -F], carrier: b}}
"""
HANGING = """
parameters: {m1: , m2: , k1: , k2: , g: }
gravity: g
bodies:
  a: {mass: m1, at: [0, 0], slide: {along: [0, -1], by: y1}}
  b: {mass: m2, at: [0, -1], slide: {along: [0, -1], by: y2}}
springs: {s: {k: k1, between: [a, [0, 1]]}, t: {k: k2, between: [a, b]}}
"""

# name: (scene, {quantity: hand formula}, lines that are printed)
TEXTBOOK = {
    "mass on a spring and a damper": (chain(1, right=False, damped=True), {
        "omega[1]": "sqrt(k/m)", "zeta[1]": "c/(2*sqrt(k*m))"}, [
        "ω₁ = √(k/m)", "ζ = c/(2·√(m·k))", "ω_d = ω·√(1 − ζ²) = √(4·m·k − c²)/(2·m)  for ζ < 1",
        "decay δ = ζ·ω = c/(2·m)", "critical damping, ζ = 1:  c = 2·√(m·k)"]),
    "rod with a spring and a damper": (ROD, {
        "omega[1]": "sqrt((m*g*L/2 + k*a^2)/(m*L^2/3))",
        "zeta[1]": "c*b^2/(2*sqrt(m*L^2/3*(m*g*L/2 + k*a^2)))"}, [
        "ω₁ = √(3·(m·L·g + 2·a²·k)/(2·m·L²))", "ζ = √3·b²·c/(L·√(2·m·(m·L·g + 2·a²·k)))",
        "decay δ = ζ·ω = 3·b²·c/(2·m·L²)",
        "critical damping, ζ = 1:  c = L·√(2·m·(m·L·g + 2·a²·k)/3)/b²"]),
    "disc in a track": (TRACK, {"omega[1]": "sqrt(2*g/(3*(R - r)))"}, ["ω₁ = √(2·g/(3·(R − r)))"]),
    "upright pendulum": (UPRIGHT, {"growth_rate[1]": "sqrt(g/L)"}, [
        "mode 1 is unstable: it grows as exp(s·t), s = √(g/L)"]),
    "springs in series": (SERIES, {"omega[1]": "sqrt(k1*k2/((k1 + k2)*m))"}, ["ω₁ = √(k₁·k₂/(m·(k₁ + k₂)))"]),
    "two masses, free": (chain(2, False, False, "m1 m2"), {
        "omega[1]": "0", "omega[2]": "sqrt(k/m1 + k/m2)", "mode[2][x2]": "-m1/m2"}, [
        "ω₂ = √(k·(m₁ + m₂)/(m₁·m₂))", "mode 2:  x₁ = 1,  x₂ = −m₁/m₂"]),
    "two masses between walls": (chain(2, springs="k kc k"), {
        "omega[1]": "sqrt(k/m)", "omega[2]": "sqrt((k + 2*kc)/m)"}, [
        "ω₁ = √(k/m)", "ω₂ = √((k + 2·kc)/m)", "mode 1:  x₁ = 1,  x₂ = 1", "mode 2:  x₁ = 1,  x₂ = −1"]),
    "two storeys": (chain(2, right=False), {
        "omega[1]": "2*sin(pi/10)*sqrt(k/m)", "omega[2]": "2*sin(3*pi/10)*sqrt(k/m)",
        "mode[1][x2]": "(1 + sqrt(5))/2"}, [
        "ω₁ = √((3 − √5)·k/(2·m))", "ω₂ = √((3 + √5)·k/(2·m))", "mode 1:  x₁ = 1,  x₂ = (1 + √5)/2",
        "mode 2:  x₁ = 1,  x₂ = (1 − √5)/2"]),
    "two unequal masses": (chain(2, right=False, masses="m1 m2", springs="k1 k2"), {
        "omega[1]^2 + omega[2]^2": "(k1 + k2)/m1 + k2/m2", "omega[1]*omega[2]": "sqrt(k1*k2/(m1*m2))"}, [
        "ω₁,₂² = (m₁·k₂ + m₂·(k₁ + k₂) ∓ √((m₁·k₂ + m₂·(k₁ + k₂))² − 4·m₁·m₂·k₁·k₂))/(2·m₁·m₂)",
        "modes 1, 2:  x₁ = 1,  x₂ = k₂/(k₂ − m₂·ω²)   with ω = ω₁, ω₂"]),
    "three storeys": (chain(3, right=False), {
        f"omega[{i}]": f"2*sqrt(k/m)*sin({2 * i - 1}*pi/14)" for i in (1, 2, 3)}, [
        "ω₁ = 2·sin(π/14)·√(k/m)", "ω₂ = 2·sin(3·π/14)·√(k/m)", "ω₃ = 2·sin(5·π/14)·√(k/m)",
        "mode 1:  x₁ = 1,  x₂ = 2·cos(π/7),  x₃ = 1 + 2·cos(2·π/7)"]),
    "linear molecule": (chain(3, False, False, "m M m"), {
        "omega[1]": "0", "omega[2]": "sqrt(k/m)", "omega[3]": "sqrt(k*(M + 2*m)/(M*m))"}, [
        "ω₂ = √(k/m)", "ω₃ = √(k·(2·m + M)/(m·M))", "mode 2:  x₁ = 1,  x₂ = 0,  x₃ = −1",
        "mode 3:  x₁ = 1,  x₂ = −2·m/M,  x₃ = 1"]),
    "four free masses": (chain(4, False, False), {
        f"omega[{i + 1}]": f"2*sqrt(k/m)*sin({i}*pi/8)" for i in range(4)}, [
        "ω₂ = √((2 − √2)·k/m)", "ω₃ = √(2·k/m)", "ω₄ = √((2 + √2)·k/m)",
        "mode 2:  x₁ = 1,  x₂ = √2 − 1,  x₃ = 1 − √2,  x₄ = −1"]),
    "five free masses": (chain(5, False, False), {
        f"omega[{i + 1}]": f"2*sqrt(k/m)*sin({i}*pi/10)" for i in range(5)}, [
        "ω₂ = √((3 − √5)·k/(2·m))", "ω₃ = √((5 − √5)·k/(2·m))", "ω₄ = √((3 + √5)·k/(2·m))",
        "ω₅ = √((5 + √5)·k/(2·m))"]),
    "six masses between walls": (chain(6), {f"omega[{i}]": f"2*sqrt(k/m)*sin({i}*pi/14)" for i in range(1, 7)}, [
        "ω₁ = 2·sin(π/14)·√(k/m)", "ω₂ = 2·sin(π/7)·√(k/m)", "ω₆ = 2·sin(3·π/7)·√(k/m)"]),
    "ring of three": (ring(3), {"omega[1]": "0", "omega[2]": "sqrt(3*k/m)", "omega[3]": "sqrt(3*k/m)"}, [
        "ω₁ = 0", "ω₂ = ω₃ = √(3·k/m)"]),
    "ring of six": (ring(6), {f"omega[{i + 1}]": f"2*sqrt(k/m)*sin({(i + 1) // 2}*pi/6)" for i in range(6)}, [
        "ω₂ = ω₃ = √(k/m)", "ω₄ = ω₅ = √(3·k/m)", "ω₆ = 2·√(k/m)"]),
    "three pendulums": (pendulums(3), {
        f"omega[{i + 1}]": f"sqrt(g/L + {times}*k*a^2/(m*L^2))" for i, times in enumerate((0, 1, 3))}, [
        "ω₁ = √(g/L)", "ω₂ = √((m·L·g + a²·k)/(m·L²))", "ω₃ = √((m·L·g + 3·a²·k)/(m·L²))",
        "mode 3:  φ₁ = 1,  φ₂ = −2,  φ₃ = 1"]),
    "masses on a string": (STRING, {
        f"omega[{i}]": f"2*sqrt(N/(m*L))*sin({i}*pi/8)" for i in (1, 2, 3)}, [
        "ω₁ = √((2 − √2)·N/(m·L))", "ω₂ = √(2·N/(m·L))", "ω₃ = √((2 + √2)·N/(m·L))",
        "mode 1:  y₁ = 1,  y₂ = √2,  y₃ = 1"]),
    "double pendulum": (DOUBLE, {
        "omega[1]": "sqrt((2 - sqrt(2))*g/L)", "omega[2]": "sqrt((2 + sqrt(2))*g/L)", "mode[1][phi2]": "sqrt(2)"}, [
        "ω₁ = √((2 − √2)·g/L)", "ω₂ = √((2 + √2)·g/L)", "mode 1:  φ₁ = 1,  φ₂ = √2", "mode 2:  φ₁ = 1,  φ₂ = −√2"]),
    "unequal double pendulum": (UNEQUAL, {
        "omega[1]*omega[2]": "g*sqrt((m1 + m2)/(m1*L1*L2))"}, [
        "modes 1, 2:  φ₁ = 1,  φ₂ = L₁·ω²/(g − L₂·ω²)   with ω = ω₁, ω₂"]),
    "pendulum on a tied cart": (CART, {
        "omega[1]^2 + omega[2]^2": "k/M + g*(M + m)/(M*L)", "omega[1]*omega[2]": "sqrt(k*g/(M*L))"}, [
        "ω₁,₂² = (g·(M + m) + L·k ∓ √((g·(M + m) + L·k)² − 4·M·L·k·g))/(2·M·L)",
        "modes 1, 2:  x = 1,  φ = ω²/(g − L·ω²)   with ω = ω₁, ω₂"]),
    "three discs on a shaft": (SHAFT_OF_THREE, {
        "omega[1]": "0", "omega[2]^2 + omega[3]^2": "k1/J1 + (k1 + k2)/J2 + k2/J3",
        "omega[2]*omega[3]": "sqrt(k1*k2*(J1 + J2 + J3)/(J1*J2*J3))"}, ["ω₁ = 0"]),
    "two on one": (TREE, {
        "K[x,x]": "K + 2*k"}, [
        "ω₂ = √(k/m)", "ω₁,₃² = (M·k + m·(K + 2·k) ∓ √((M·k + m·(K + 2·k))² − 4·M·m·K·k))/(2·M·m)"]),
    "car with equal axles": (CAR, {
        "omega[1] + omega[2]": "sqrt(2*k/m) + a*sqrt(2*k/J)", "zeta[1]*zeta[2]": "c^2*a/(2*k*sqrt(m*J))"}, [
        "ω₁ = √(2·k/m)", "ω₂ = a·√(2·k/J)", "ζ₁ = c/√(2·m·k)", "ζ₂ = c·a/√(2·J·k)"]),
    "three masses, weakly damped like tied": (chain(3, damped=True).replace("c: }", "c: 0.01}"), {
        f"zeta[{i}]": f"c/sqrt(k*m)*sin({i}*pi/8)" for i in (1, 2, 3)}, [
        "ζ₁ = √(2 − √2)·c/(2·√(m·k))", "ζ₂ = c/√(2·m·k)", "ζ₃ = √(2 + √2)·c/(2·√(m·k))"]),
    "Rayleigh's damping": (RAYLEIGH, {
        "zeta[1]": "(alpha/omega[1] + beta*omega[1])/2", "zeta[2]": "(alpha/omega[2] + beta*omega[2])/2"}, [
        "ζ₁, ζ₂ = (α + β·ω²)/(2·ω)   with ω = ω₁, ω₂"]),
    "rotor in tilting bearings": (ROTOR, {
        "omega[1]": "(sqrt((Jp*Omega)^2 + 4*J*k) - Jp*Omega)/(2*J)",
        "omega[2]": "(sqrt((Jp*Omega)^2 + 4*J*k) + Jp*Omega)/(2*J)"}, [
        "ω₁ = (√(4·J·k + Jp²·Ω²) − Jp·Ω)/(2·J)", "ω₂ = (Jp·Ω + √(4·J·k + Jp²·Ω²))/(2·J)",
        "mode 1:  a = 1,  b = i", "mode 2:  a = 1,  b = −i"]),
    "unround shaft": (SHAFT, {
        "omega[1]^2 + omega[2]^2": "(k1 + k2)/m + 2*Omega^2"}, [
        "ω₁,₂² = (2·m·Ω² + k₁ + k₂ ∓ √(8·m·Ω²·(k₁ + k₂) + (k₂ − k₁)²))/(2·m)",
        "modes 1, 2:  x = 1,  y = −i·(k₁ − m·(Ω² + ω²))/(2·m·Ω·ω)   with ω = ω₁, ω₂"]),
    "two hanging masses": (HANGING, {
        "equilibrium[y1]": "(m1 + m2)*g/k1", "equilibrium[y2]": "(m1 + m2)*g/k1 + m2*g/k2"}, [
        "y₁ = g·(m₁ + m₂)/k₁, y₂ = g·(m₁·k₂ + m₂·(k₁ + k₂))/(k₁·k₂)"]),
    "governor": (GOVERNOR, {}, [
        "φ = acos(g/(L·Ω²))   (where g < L·Ω²)", "φ:  m·L²·φ̈ + m·(L²·Ω⁴ − g²)·φ/Ω² = 0",
        "ω₁ = √(L²·Ω⁴ − g²)/(L·Ω)"]),
    "pendulum in the wind": (WIND, {
        "equilibrium[phi]": "atan(F/(m*g))", "omega[1]": "(g^2 + (F/m)^2)^(1/4)/sqrt(L)"}, [
        "φ = atan(F/(m·g))", "ω₁ = √(√(m²·g² + F²)/(m·L))"]),
    "two rods under a follower force": (FOLLOWER, {
        "omega[1]^2 + omega[2]^2": "(6*kt - 2*L*F)/(m*L^2)", "omega[1]*omega[2]": "kt/(m*L^2)"}, [
        "ω₁,₂² = (3·kt − L·F ∓ √((L·F − 3·kt)² − kt²))/(m·L²)"]),
}
