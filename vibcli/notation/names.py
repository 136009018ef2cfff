"""Names as letters with indices: φ₁ of phi1, the product EI₂ of EI2."""

import re
from functools import lru_cache

GREEK = {"alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ", "eta": "η", "theta": "θ",
          "iota": "ι", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "rho": "ρ", "sigma": "σ",
          "tau": "τ", "upsilon": "υ", "phi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω", "pi": "π", "Gamma": "Γ",
          "Delta": "Δ", "Theta": "Θ", "Lambda": "Λ", "Xi": "Ξ", "Pi": "Π", "Sigma": "Σ", "Phi": "Φ", "Psi": "Ψ",
          "Omega": "Ω"}
COMMANDS = {"phi": "varphi", "epsilon": "varepsilon"}      # of LaTeX, where they differ from the names
NAMES = {letter: name for name, letter in GREEK.items()}
SUBSCRIPT = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
NAMED = re.compile(r"(?<![\w.\[])((?<!')[^\W\d]\w*'*|(?<=')[^\W\d]\w*)(?![\w\[(]|\.\w)")  # in quotes it has no primes
PRODUCTS = r"([EG])([AIJ](?:[op]|\d*))"       # names read as products: EI, GIo of members
PLACES = "xξsχ"         # letters of a place along members
BESSEL = "J0", "J1", "Y0", "Y1"         # functions that are written with an index
TYPED = r"[A-Za-z][a-z]\d{1,2}"               # kt1: the stiffness k of torsion number 1


def lowered(number: int) -> str:
    """'₁₂' of 12."""
    return str(number).translate(SUBSCRIPT)


def factors_of(name: str) -> list[str]:
    """The names of which one is a product, as E and I2 of EI2, β and x of a wave number times a place; none of
    others."""
    found = re.fullmatch(PRODUCTS, name) if name[:1] in ("E", "G") else None
    along = len(name) == 2 and name[0] in NAMES and (name[1] == "L" or name[1] in PLACES)
    return list(name) if along else list(found.groups()) if found else []


@lru_cache(maxsize=1000)
def split_name(name: str) -> tuple[str, str, str]:
    """('φ', '1', "'") of phi1': letter, subscript, primes; ('k', 't1', '') of kt1; words as length stay whole."""
    bare = name.rstrip("'")
    primes = name[len(bare):]
    letter = max((word for word in GREEK if bare.startswith(word)), key=len, default=bare[:1])
    rest = bare[len(letter):]
    if letter != "ℓ" and not (letter.isascii() and letter.isalpha()):
        return bare, "", primes
    short = len(bare) == 2 or (letter in GREEK and len(rest) <= 2) or (
        2 < len(bare) < 5 and re.fullmatch(TYPED, bare))
    return (letter, rest, primes) if short or rest.isdigit() or rest[:1] in ("", "_") else (bare, "", primes)


def split_marks(name: str) -> tuple[str, int]:
    """("phi0'", 1) of phi0′': the name without the marks ′ of a letter that stands beside another, and their number."""
    bare = name.rstrip("'")
    own = bare.rstrip("′")
    return own + name[len(bare):], len(bare) - len(own)
