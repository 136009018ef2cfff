"""A drawing that moves as one HTML page that needs nothing else, with play, pause and a slider."""

import json
from collections.abc import Sequence

from vibcli.drawing.canvas.svg_canvas import words

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
svg {{ width: 100%; height: auto; max-height: 75vh; }}
figure {{ margin: 0; }}
.bar {{ display: flex; gap: 1rem; align-items: center; margin-top: .5rem; }}
input {{ flex: 1; }}
button {{ min-width: 5rem; font: inherit; }}
</style>
</head>
<body>
<h1>{title}</h1>
<figure>
{svg}
<figcaption>{caption}</figcaption>
</figure>
<div class="bar"><button id="play" type="button">Pause</button>
<input id="place" type="range" min="0" max="{last}" value="0" aria-label="Instant"><output id="shown"></output></div>
<script>
"use strict";
const svg = document.querySelector("svg"), names = {names}, pace = {pace}, period = pace * names.length;
const play = document.getElementById("play"), place = document.getElementById("place");
let time = 0, last = 0, runs = true;
function show() {{
  const i = Math.floor(time / pace + 1e-6);
  svg.setCurrentTime(time / 1000);
  place.value = i;
  document.getElementById("shown").textContent = names[i] || "";
}}
function step(now) {{
  if (runs) {{ time = (time + now - last) % period; show(); }}
  last = now;
  requestAnimationFrame(step);
}}
function run(wanted) {{ runs = wanted; play.textContent = runs ? "Pause" : "Play"; }}
play.addEventListener("click", () => run(!runs));
place.addEventListener("input", () => {{ run(false); time = pace * Number(place.value); show(); }});
run(!matchMedia("(prefers-reduced-motion: reduce)").matches);
svg.pauseAnimations();
show();
requestAnimationFrame(now => {{ last = now; step(now); }});
</script>
</body>
</html>
"""


def page(svg: bytes, title: str, caption: str, names: Sequence[str], milliseconds: int = 40) -> str:
    """The text of the page with an SVG that moves; `names` say what instant each of its frames shows."""
    inline = svg.decode().partition("?>")[2].strip()
    return _PAGE.format(title=words(title), caption=words(caption), svg=inline, last=len(names) - 1, pace=milliseconds,
                        names=json.dumps(list(names)).replace("<", "\\u003c"))
