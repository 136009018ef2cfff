"""Frames of a drawing as one HTML page that needs nothing else: inline SVG, with play, pause and a slider."""

import json
from collections.abc import Sequence
from html import escape
from typing import Any

from vibcli.drawing.canvas.primitives import COLOURS, Circle, LetterRuns, Polygon, extent

MARGIN, STILL = 12.0, ("ground", "fixed")
MOST = 240

_PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; script-src \
'unsafe-inline'">
<title>{title}</title>
<style>
body {{ font-family: serif; max-width: 60rem; margin: 1rem auto; padding: 0 1rem; color: #1b1b1b; background: #fff; }}
svg {{ width: 100%; max-height: 75vh; }}
svg g {{ fill: none; stroke-linecap: round; stroke-linejoin: round; }}
figure {{ margin: 0; }}
.bar {{ display: flex; gap: 1rem; align-items: center; margin-top: .5rem; }}
input {{ flex: 1; }}
button {{ min-width: 5rem; font: inherit; }}
</style>
</head>
<body>
<h1>{title}</h1>
<figure>
<svg viewBox="{view}" role="img" aria-label="{title}: {caption}">
<g>{still}</g>
{frames}
</svg>
<figcaption>{caption}</figcaption>
</figure>
<div class="bar"><button id="play" type="button">Pause</button>
<input id="place" type="range" min="0" max="{last}" value="0" aria-label="Instant"><output id="shown"></output></div>
<script>
"use strict";
const frames = document.querySelectorAll("svg g.frame"), names = {names}, pace = {pace};
const play = document.getElementById("play"), place = document.getElementById("place");
let shown = 0, runs = true, last = 0;
function show(i) {{
  frames[shown].setAttribute("visibility", "hidden");
  shown = i;
  frames[shown].setAttribute("visibility", "visible");
  place.value = i;
  document.getElementById("shown").textContent = names[i] || "";
}}
function step(now) {{
  if (runs && now - last >= pace) {{ last = now; show((shown + 1) % frames.length); }}
  requestAnimationFrame(step);
}}
function run(wanted) {{ runs = wanted; play.textContent = runs ? "Pause" : "Play"; }}
play.addEventListener("click", () => run(!runs));
place.addEventListener("input", () => {{ run(false); show(Number(place.value)); }});
show(0);
requestAnimationFrame(step);
</script>
</body>
</html>
"""


def page(frames: Sequence[list[Any]], title: str, caption: str, names: Sequence[str] = (),
         milliseconds: int = 40) -> str:
    """The text of the page; `names` say what instant each frame shows."""
    frames = frames[:MOST]
    boxes = [extent(frame) for frame in frames]
    left, bottom = min(b[0] for b in boxes) - MARGIN, min(b[1] for b in boxes) - MARGIN
    right, top = max(b[2] for b in boxes) + MARGIN, max(b[3] for b in boxes) + MARGIN
    common = set(frames[0]).intersection(*map(set, frames[1:]))
    still = [part for part in frames[0] if part in common and part.role in STILL]
    groups = [f'<g class="frame" visibility="{"hidden" if i else "visible"}">'
              + _svg([part for part in frame if part not in still]) + "</g>" for i, frame in enumerate(frames)]
    words = {"title": escape(title), "caption": escape(caption)}
    return _PAGE.format(**words, view=f"{left:.1f} {-top:.1f} {right - left:.1f} {top - bottom:.1f}", still=_svg(still),
                        frames="\n".join(groups), last=len(frames) - 1, pace=milliseconds,
                        names=json.dumps(list(names)).replace("<", "\\u003c"))


def _svg(frame):
    parts = sorted(frame, key=lambda part: part.layer)
    return "".join(_element(part) for part in parts if not isinstance(part, LetterRuns))


def _element(part):
    closed = isinstance(part, (Polygon, Circle))
    fill = f' fill="{COLOURS[part.fill]}"' if closed and part.fill else ""
    dashes = ' stroke-dasharray="4 3"' if part.dashed else ""
    style = f'{fill} stroke="{COLOURS[part.role]}" stroke-width="{part.width:g}"{dashes}'
    if isinstance(part, Circle):
        x, y = part.centre
        return f'<circle cx="{x:.1f}" cy="{-y:.1f}" r="{part.radius:.1f}"{style}/>'
    paths = " ".join("M" + " ".join(f"{x:.1f},{-y:.1f}" for x, y in stroke) for stroke in part.strokes())
    return f'<path d="{paths}{"Z" if closed else ""}"{style}/>'
