"""A figure as SVG inside a page of HTML: whole in itself, no rule and no name that reaches beyond it."""

import hashlib
import re
from html import escape

from vibcli.plots.words import printable

_DIGITS = 2      # decimals of a point of a curve, in 1/72 inch


def svg_text(figure, name=""):
    """`<svg …>…</svg>`; `name`: what its ids begin with, to be given where a page holds the same figure twice."""
    from vibcli.plots.picture import picture

    drawn = picture(figure, "svg").decode()
    width, height = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', drawn).groups()
    body = drawn[drawn.index(">", drawn.index("<svg")) + 1:drawn.rindex("</svg>")]
    for left_out in (r"<metadata>.*?</metadata>", r"<defs>\s*<style.*?</style>\s*</defs>", r"<!--.*?-->"):
        body = re.sub(left_out, "", body, flags=re.DOTALL)
    body = re.sub(r"\s*\n\s*", "\n", body)
    body = re.sub(r'(?<= d=")[^"]*', _shorter, body)
    name = re.sub(r"[^A-Za-z0-9_-]", "-", name) or "p" + hashlib.sha256(body.encode()).hexdigest()[:10]
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}pt" role="img" '
            f'aria-label="{escape(_spoken(figure))}" style="max-width: 100%; height: auto; stroke-linejoin: round; '
            f'stroke-linecap: butt">{_own_names(body, name)}</svg>')


def _shorter(match):
    """The numbers of a path with few decimals."""
    return re.sub(r"\d+\.\d+", lambda number: f"{float(number.group()):.{_DIGITS}f}".rstrip("0").rstrip("."),
                  match.group())


def _own_names(body, name):
    """Ids that are referred to begin with the name, the others go."""
    used = set(re.findall(r'(?:href="|url\()#([^")]*)', body))
    body = re.sub(r' id="([^"]*)"', lambda found: f' id="{name}-{found[1]}"' if found[1] in used else "", body)
    return re.sub(r'(?:xlink:)?(href="|url\()#', rf"\1#{name}-", body)


def _spoken(figure):
    """What a screen reader says in place of the figure."""
    axes = [f"{panel.y_label} over {panel.x_label}" for panel in figure.panels if panel.x_label and panel.y_label]
    return printable(": ".join(filter(None, (figure.title, ", ".join(axes)))))
