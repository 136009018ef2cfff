"""Unicode words as LaTeX in plain ASCII: every special character escaped, every symbol by its command."""

import re
import unicodedata

from vibcli.base.decoding import on_one_line
from vibcli.notation.names import COMMANDS, NAMES

SPECIAL = {"\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "%": r"\%", "&": r"\&", "#": r"\#",
           "_": r"\_", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}", "<": r"\textless{}",
           ">": r"\textgreater{}", "|": r"\textbar{}", '"': r"\textquotedbl{}", "`": r"\textasciigrave{}",
           "'": r"\textquotesingle{}"}
WORDS = {"–": r"\textendash{}", "—": r"\textemdash{}", "…": r"\ldots{}", "‘": r"\textquoteleft{}",
         "’": r"\textquoteright{}", "“": r"\textquotedblleft{}", "”": r"\textquotedblright{}",
         "„": r"\quotedblbase{}", "«": r"\guillemotleft{}", "»": r"\guillemotright{}", "ß": r"\ss{}", "æ": r"\ae{}",
         "Æ": r"\AE{}", "ø": r"\o{}", "Ø": r"\O{}", "œ": r"\oe{}", "Œ": r"\OE{}", "ł": r"\l{}", "Ł": r"\L{}",
         "đ": r"\dj{}", "Đ": r"\DJ{}", "ð": r"\dh{}", "þ": r"\th{}", "ı": r"\i{}", "§": r"\S{}", "¶": r"\P{}",
         "©": r"\textcopyright{}", "®": r"\textregistered{}", "€": r"\texteuro{}", "£": r"\pounds{}",
         "\u00a0": "~", "¡": r"\textexclamdown{}", "¿": r"\textquestiondown{}"}
MATHS = {"·": r"\cdot", "−": "-", "×": r"\times", "÷": r"\div", "±": r"\pm", "∓": r"\mp", "≤": r"\le", "≥": r"\ge",
         "≠": r"\ne", "≈": r"\approx", "≪": r"\ll", "≫": r"\gg", "∝": r"\propto", "∞": r"\infty", "∂": r"\partial",
         "∑": r"\sum", "∫": r"\int", "∇": r"\nabla", "√": r"\surd", "→": r"\to", "←": r"\leftarrow",
         "↔": r"\leftrightarrow", "∠": r"\angle", "°": r"{}^{\circ}", "ℓ": r"\ell", "∈": r"\in", "⊥": r"\perp",
         "∥": r"\parallel", "µ": r"\mu", "ᵀ": "{}^{T}", "⁻": "{}^{-}", "⁺": "{}^{+}", "′": "{}'", "″": "{}''",
         "½": r"\tfrac{1}{2}", "¼": r"\tfrac{1}{4}", "¾": r"\tfrac{3}{4}", "ϕ": r"\phi", "ϑ": r"\vartheta",
         "ϵ": r"\epsilon", "𝔇": "D"}
MATHS |= {letter: "\\" + COMMANDS.get(name, name) for letter, name in NAMES.items()}
MATHS |= {raised: f"{{}}^{{{i}}}" for i, raised in enumerate("⁰¹²³⁴⁵⁶⁷⁸⁹")}
MATHS |= {lowered: f"{{}}_{{{i}}}" for i, lowered in enumerate("₀₁₂₃₄₅₆₇₈₉")}
ACCENTS = {"\u0300": "`", "\u0301": "'", "\u0302": "^", "\u0303": "~", "\u0304": "=", "\u0306": "u", "\u0307": ".",
           "\u0308": '"', "\u030a": "r", "\u030b": "H", "\u030c": "v", "\u0327": "c", "\u0328": "k"}
DOTS = {"\u0307": r"\dot", "\u0308": r"\ddot"}
LONG = re.compile(r"\d{10}(?=\d{10})")


def escaped(text: str) -> str:
    """Words for LaTeX's text mode; a character that it has no command for is named by its number."""
    text, found = on_one_line(text), []
    for letter in unicodedata.normalize("NFD", "".join(map(_kept, text))):
        if letter in ACCENTS and found:
            found[-1] = _accented(found[-1], letter)
        else:
            found.append(_character(letter))
    text = re.sub(r"([-,])(?=\1)", r"\1{}", "".join(found))      # no ligatures
    return LONG.sub(r"\g<0>\\allowbreak{}", text)


def _kept(letter: str) -> str:
    """A letter decomposed into accents only where LaTeX writes them so."""
    parts = unicodedata.normalize("NFD", letter)
    return parts if all(part in ACCENTS for part in parts[1:]) else letter


def _character(letter: str) -> str:
    if letter in SPECIAL or letter in WORDS:
        return SPECIAL.get(letter) or WORDS[letter]
    if letter in MATHS:
        return rf"\ensuremath{{{MATHS[letter]}}}"
    return letter if letter.isascii() and letter.isprintable() else f"[U+{ord(letter):04X}]"


def _accented(base: str, accent: str) -> str:
    """A base with an accent over it: \\v{c}, or \\ensuremath{\\ddot{\\varphi}}."""
    if base.isascii() and len(base) == 1 and base.isalpha():
        return rf"\{ACCENTS[accent]}{{{base}}}"
    inner = re.fullmatch(r"\\ensuremath\{(\\[a-z]+)\}", base)
    return rf"\ensuremath{{{DOTS[accent]}{{{inner[1]}}}}}" if inner and accent in DOTS else base
