"""The page that follows a file: a report whose parts are put in the place of those that have changed."""

from vibcli.cli.viewing.shown import State
from vibcli.report.formats.html_page import STYLE, words

MORE = """
#errors { white-space: pre; overflow: auto; border-left: 4px solid #b00020; padding: 0.5em 0.8em;
  font: 0.9rem/1.4 monospace; position: sticky; top: 0; z-index: 1; background: Canvas; max-height: 40vh; }
#work { position: fixed; left: 7rem; right: 1rem; bottom: 0.5rem; text-align: right;
  background: Canvas; opacity: 0.8; font-size: 0.9rem; }
#pause { position: fixed; left: 1rem; bottom: 0.5rem; font: inherit; }
#errors:empty, #work:empty { display: none; }
@media (max-width: 72rem) {
  body { padding-bottom: 4rem; }
  #pause { left: 0; bottom: 0; width: 100%; padding: 0.5em; border: 0; border-top: 1px solid var(--rule);
    background: Canvas; color: CanvasText; }
  #work { bottom: 3rem; }
}
@media print { #pause { display: none; } body { padding-bottom: 0; } }
#errors:not(:empty) ~ main { opacity: 0.45; }
.part + .part { border-top: 1px solid var(--rule); margin-top: 3rem; padding-top: 1rem; }
"""
SCRIPT = """
"use strict";
const main = document.querySelector("main"), errors = document.getElementById("errors");
const work = document.getElementById("work");
const pause = document.getElementById("pause");
let still = false;
function move() {
  pause.hidden = !main.querySelector("animate, animateTransform");
  pause.textContent = still ? "Play" : "Pause";
  for (const svg of main.querySelectorAll("svg")) if (still) svg.pauseAnimations(); else svg.unpauseAnimations();
}
pause.addEventListener("click", () => { still = !still; move(); });
let version = Number(document.body.dataset.version), parts = null;
function show(found) {
  version = found.version;
  document.title = found.title;
  errors.textContent = found.errors.join("\\n\\n");
  work.textContent = found.work;
  while (main.children.length > found.parts.length) main.lastElementChild.remove();
  found.parts.forEach((part, i) => {
    if (main.children.length <= i) {
      main.append(document.createElement("div"));
      main.lastElementChild.className = "part";
    } else if (parts && parts[i] === part) return;
    main.children[i].innerHTML = part;
  });
  parts = found.parts;
  move();
}
async function follow() {
  for (;;) {
    try {
      const answer = await fetch("content?after=" + version, {cache: "no-store"});
      if (!answer.ok) throw new Error(answer.status);
      const found = await answer.json();
      if (found.version !== version) show(found); else work.textContent = found.work;
    } catch (error) {
      work.textContent = "vibcli view has ended: this page follows the file no longer";
      await new Promise(go => setTimeout(go, 1000));
    }
  }
}
move();
follow();
"""


def page(state: State, nonce: str) -> str:
    """The page as it is now, readable without its script; with it, it follows what comes."""
    parts = "\n".join(f'<div class="part">{part}</div>' for part in state.parts)
    errors = words("\n\n".join(state.errors))
    return (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8"/>\n'
            f'<meta name="viewport" content="width=device-width, initial-scale=1"/>\n'
            f"<title>{words(state.title)}</title>\n<style>{STYLE}{MORE}</style>\n</head>\n"
            f'<body data-version="{state.version}">\n<pre id="errors" role="alert">{errors}</pre>\n'
            f'<main>{parts}</main>\n<button id="pause" type="button" hidden="">Pause</button>\n'
            f'<div id="work" role="status">{words(state.work)}</div>\n'
            f'<script nonce="{nonce}">{SCRIPT}</script>\n</body>\n</html>')
