"""The page about expressions: numbers, units, names, and the functions that are known. Data alone."""

FUNCTIONS = {
    "sin": "sine, of radians", "cos": "cosine, of radians", "tan": "tangent, of radians",
    "asin": "arc sine", "acos": "arc cosine", "atan": "arc tangent",
    "atan2": "`atan2(y, x)`: angle of the vector (x, y), from −pi to pi; both of one dimension",
    "sinh": "hyperbolic sine", "cosh": "hyperbolic cosine", "tanh": "hyperbolic tangent",
    "exp": "e to the power of", "log": "natural logarithm", "sqrt": "square root, of any dimension",
    "abs": "magnitude, of any dimension", "sign": "−1, 0 or 1, of any dimension",
    "min": "`min(a, b)`: the smaller one; both of one dimension",
    "max": "`max(a, b)`: the larger one; both of one dimension",
    "step": "0 before its argument is zero and 1 from there on: `F0*(step(t) - step(t - t1))` is a pulse; of any "
            "dimension",
    "ramp": "`ramp(u)` is `u*step(u)`, in the dimension of u: `v*ramp(t - t1)`",
    "impulse": "Dirac's impulse: zero but where its argument is, its integral is 1; `impulse(t - t1)` is in 1/s, so "
               "that `(3 N*s)*impulse(t)` is a blow of 3 N·s. Of expressions of the time alone",
    "square": "the square wave of period 2π: 1 where sin is positive, −1 where it is negative, as in "
              "`F0*square(Omega*t)`. Of expressions of the time alone",
    "sawtooth": "the wave of period 2π that rises from −1 at 0 to 1 and falls back at once, as in "
                "`F0*sawtooth(Omega*t)`. Of expressions of the time alone",
}

EXPRESSIONS = [
    "Wherever a value is wanted, an expression of the parameters may stand; in motions, stretches, loads, energies and "
    "constraints also of the coordinates and of the time `t`.",
    [
        ("numbers", "`3`, `0.5`, `1e-3`; decimals with a point, between 1e-60 and 1e60."),
        ("units", "A number followed by a unit is one value: `0.5 m`, `9.81 m/s^2`, `2 kN*m/rad`. It takes the longest "
         "chain of units that `*`, `/` and `^` join after it, powers such as `N/m^(3/2)` with them; `0.5 m` is half a "
         "metre whatever is called m."),
        ("names", "Letters, digits and _, a letter first, at most 32. Greek letters and their names are the "
         "same: `φ1` is `phi1`. `pi` is π. Upper and lower case differ."),
        ("operators", "`+ - * / ^` (or `**`) and parentheses. There is no implicit multiplication: `2*x`."),
        ("functions", "`sqrt(k/m)`, `cos(alpha)`: see `vibcli explain functions`."),
        ("derivatives", "`x'` in loads and `energies`; `x'` and `x''` in the energies and equations of `answers`."),
        ("time", "`t`: see `vibcli explain time`."),
        ("equations", "`left = right`, in `answers` and `constraints`."),
    ],
    "Dimensions are checked in every expression. In a scene that uses units a plain number has none, save that 0 "
    "fits everywhere. A scene that uses no unit at all is taken in consistent SI numbers, those within expressions "
    "and laws included: `law: d + 2*d^3` is in newtons. A parameter without "
    "value takes its dimension from where it stands, or from its `unit`.",
    "`Hz` is not `rad/s`: a cycle needs a factor π before it stands in an angle, an angular frequency or a stiffness, "
    "as in `sin(2*pi*f*t)` and `m*4*pi^2*f^2`; `frf[x, F](5 Hz)` takes either. `1/f` is a period. `rpm` is angular, "
    "`rad` is 1, and a rate in 1/s, such as `v/R`, fits both.",
    "A number without a unit is in radians where an angle is due. One beyond a full turn there gets a warning, as "
    "degrees need theirs: `alpha: 30 deg`. It stops nothing, and is not given where a unit stands: `30 rad`.",
    "Where a scene has a name that is also a unit, `2 N*m` within a longer expression could mean two things and is "
    "refused: write `(2 N)*m` or `(2 N*m)`. So is a value of its own where the name fits too: `36 km/h` beside a time "
    "h.",
    "An expression has at most 2000 characters and 64 levels of parentheses. In YAML, put quotes around a key "
    "that holds brackets when it stands within braces: `{\"omega[1]\": 3 rad/s}`.",
]
