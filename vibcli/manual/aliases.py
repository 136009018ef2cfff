"""Other names of words of the manual. Data alone."""

from vibcli.report.formats import FORMATS

ALIASES = {
    "expression": "expressions", "derivatives": "expressions", "derivative": "expressions", "names": "expressions",
    "numbers": "expressions", "x'": "expressions", "unit": "units", "function": "functions",
    "convention": "conventions", "signs": "conventions", "coordinate system": "conventions", "axes": "conventions",
    "normalisation": "conventions", "normalise": "conventions", "delta": "conventions", "lambda": "conventions",
    "damping ratio": "conventions", "mode shapes": "conventions", "phase lag": "conventions", "lag": "conventions",
    "quantity": "quantities", "tolerance": "quantities", "exit codes": "exit", "exit code": "exit",
    "json keys": "json", "progress": "patience", "limits": "patience",
    "schema": "editors", "inertias": "shapes", "case": "cases", "signal": "signals",
    "pulley": "pulley of a rope", "drum": "pulley of a rope", "ropes": "rope", "multiplier": "constraint",
    "unbalanced": "unbalance", "follower": "force.carrier", "search": "request",
    "t": "time", "driven": "time", "shock": "time", "pulse": "time", "blow": "time", "bump": "time",
    "base motion": "time", "base excitation": "time", "earthquake": "record", "quake": "record", "measured": "record",
    "responses": "response", "motion in time": "response", "free vibration": "response", "duration": "response",
    "forced vibration": "response", "steady state": "response", "excitation": "time", "released": "initial",
    "initial conditions": "initial", "beats": "beat_period", "overshoots": "overshoot",
    "frequency response": "frequency_response", "resonance": "frequency_response",
    "resonances": "frequency_response", "absorber": "frequency_response", "isolation": "frequency_response",
    "receptance": "frequency_response", "mobility": "frequency_response", "bandwidth": "frequency_response",
    "bode": "frequency_response", "nyquist": "frequency_response", "q factor": "quality",
    "import": "python", "api": "python", "notebook": "python", "jupyter": "python", "numpy": "python",
    "sympy": "python",
    "nonlinear": "law", "dry friction": "friction", "coulomb": "friction", "stop": "gap", "clearance": "gap",
    "slack": "acts", "cable": "acts", "frame": "statics", "beam": "statics", "support": "statics",
    "supports": "statics", "determinate": "statics", "atwood": "statics", "free fall": "statics",
    "draw": "pictures", "animate": "pictures", "animation": "pictures", "figure": "pictures", "plot": "pictures",
    "plots": "pictures", "picture": "pictures", "svg": "pictures", "pdf": "pictures", "png": "pictures",
    "gif": "pictures", "report": "reports", "format": "reports", "csv": "data", "npz": "data", "save": "data",
    "export": "data", **{name: "reports" for name in FORMATS if name != "text"},
}
