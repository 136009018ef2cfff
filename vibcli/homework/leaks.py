"""What is read in a student's file, and whether any of it is a key: text, titles, alternative texts, metadata."""

import re
import unicodedata
from collections.abc import Iterable, Iterator
from html import parser

import yaml

from vibcli.notation.as_printed import as_printed

NUMBER = re.compile(r"(?<![\w.,])[-−+]?\d+(?:[.,]\d+)?(?:\s*(?:e\s*[-−+]?\d+"
                    r"|[×·⋅*]\s*10(?:\s*\^\s*[-−+]?\d+|[-−+]?\d+)?(?!\w|[.,]\d)))?", re.IGNORECASE)
READ = "alt", "title", "aria-label", "alttext", "content", "data-", "name", "id"
FIGURES = 3
LONGEST_MARK = 3            # characters of a comment that tells nothing
TYPED = str.maketrans({"−": "-", "·": "*", "⋅": "*", "×": "*"})
_COMMENT = re.compile(r"(?:^|(?<=\s))#(.*)", re.MULTILINE)
_CELLS = re.compile(r"[;,\s]+")
_SINGLE = re.compile(r"[-−]?[\w.]+")        # a letter or a number alone is no secret


class _Read(parser.HTMLParser):
    """The text of a page, and of the attributes that are read; not coordinates of paths."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.found, self._style = [], 0

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self._style += tag == "style"
        self.found += [value for name, value in attributes if value and name.startswith(READ)]

    def handle_startendtag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.found += [value for name, value in attributes if value and name.startswith(READ)]

    def handle_endtag(self, tag: str) -> None:
        self._style -= tag == "style"

    def handle_data(self, data: str) -> None:
        self.found += [data] if not self._style else []

    def handle_comment(self, data: str) -> None:
        self.found.append(data)


def text_of_page(page: str) -> str:
    """All that is read in an HTML page."""
    reader = _Read()
    reader.feed(page)
    return "\n".join(reader.found)


def comments_of(scene: str) -> list[str]:
    """What stands behind # in a scene, longer than a mark."""
    tokens = yaml.scan(scene, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    texts = [(token.start_mark.index, token.end_mark.index) for token in tokens if isinstance(token, yaml.ScalarToken)]
    found = [match for match in _COMMENT.finditer(scene)
             if not any(start <= match.start() < end for start, end in texts)]
    return [text for match in found if len(text := match.group(1).strip()) > LONGEST_MARK]


def text_of_columns(text: str) -> str:
    """All that is read in a file of columns but for its rows of numbers, any of which may stand there by chance."""
    return "\n".join(line for line in text.splitlines() if not all(map(_is_number, _CELLS.split(line.strip()))))


def _is_number(cell: str) -> bool:
    try:
        float(cell.strip('"') or 0)
    except ValueError:
        return False
    return True


def leak(text: str, keys: Iterable[float], hidden: Iterable[str], formulas: Iterable[str] = ()) -> str | None:
    """What a text tells that it must not: a key at three or more figures, one of the hidden texts, or one of the
    formulas, in the language of scenes or as it is printed; None of nothing."""
    text = unicodedata.normalize("NFKC", text)
    plain = _typed(text)
    for formula in formulas:
        side = formula.removesuffix(" = 0")
        if not _SINGLE.fullmatch(side) and any(_stands(one, plain) for one in (side, as_printed(side, _names(side)))):
            return f"the key {formula}"
    running = _running(text)
    if any(word and _running(unicodedata.normalize("NFKC", word)) in running for word in hidden):
        return "the salt, or a comment of the scene"
    keys = list(keys)
    for value, half, said in numbers_in(text):
        if any(abs(abs(value) - abs(key)) <= half for key in keys):
            return f"the key {said}"
    return None


def _running(text: str) -> str:
    """A text with its lines in a row."""
    return " ".join(text.split())


def _typed(text: str) -> str:
    """A text with its signs as they are typed."""
    return unicodedata.normalize("NFKC", text).translate(TYPED).replace("\u221a", "sqrt")


def _names(text: str) -> list[str]:
    return re.findall(r"[^\W\d]\w*", text)


def _stands(formula: str, text: str) -> bool:
    """Does a formula stand in a text, whatever blanks are in it, as no part of a longer word or number?"""
    signs = r"\s*".join(map(re.escape, re.sub(r"\s", "", _typed(formula))))
    return re.search(rf"(?<![\w.]){signs}(?![\w.]*\w)", text) is not None


def numbers_in(text: str) -> Iterator[tuple[float, float, str]]:
    """(value, half a unit of its last figure, as it is written) of each number with three or more figures."""
    for match in NUMBER.finditer(text):
        found = _read(match.group())
        if found is not None:
            yield *found, match.group().strip()


def _read(text: str) -> tuple[float, float] | None:
    """(value, half a unit of its last figure) of a number with three or more figures; None of another."""
    plain = re.sub(r"\s", "", text.replace("−", "-").replace(",", ".").lower())
    plain = re.sub(r"[×·⋅*]10\^?", "e", plain)
    plain += "1" * plain.endswith("e")
    mantissa, _, exponent = plain.partition("e")
    digits = mantissa.lstrip("+-").replace(".", "").lstrip("0")
    if len(digits) < FIGURES:
        return None
    power = int(exponent or 0) - len(mantissa.partition(".")[2])
    return float(plain), 0.5 * 10.0**power
