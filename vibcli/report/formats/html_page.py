"""The frame of a report as one HTML page: its head, its style, and how words are escaped. Nothing is loaded but what
the page holds, no script runs: the policy of the page forbids both."""

from html import escape

from vibcli.base.decoding import cleaned
from vibcli.report.formats.bracket_font import FONT

FONTS = '"Latin Modern Math", "STIX Two Math", "Cambria Math", '        # for mathematics: what is installed is better
STYLE = f"""
@font-face {{ font-family: "Brackets of vibcli"; src: url("data:font/woff;base64,{FONT}") format("woff"); }}
math {{ font-family: {FONTS}"Brackets of vibcli", math; }}
""" + """
:root { color-scheme: light dark; --rule: #8886; }
body { max-width: 60rem; margin: 2rem auto; padding: 0 1rem; font: 1rem/1.5 "Latin Modern Roman", Georgia, serif;
  overflow-wrap: anywhere; }
h1, h2, h3, h4 { line-height: 1.25; margin: 1.6em 0 0.5em; }
h1 { font-size: 1.6rem; margin-top: 0; } h2 { font-size: 1.3rem; } h3 { font-size: 1.1rem; } h4 { font-size: 1rem; }
article + article { border-top: 1px solid var(--rule); margin-top: 3rem; padding-top: 1rem; }
.source, .about { opacity: 0.8; }
.wide { overflow-x: auto; }
.equation { overflow-x: auto; overflow-y: hidden; padding: 0.35em 0 0.35em 1.5em; white-space: nowrap; }
.label { display: inline-block; min-width: 2.5em; padding-right: 0.6em; }
mtd { text-align: left; padding: 0.25em 0; }
.matrix mtd { text-align: center; text-align: -webkit-center; padding: 0.15em 0.5em; }
table { border-collapse: collapse; margin: 0.5em 0 0.5em 1.5em; font-variant-numeric: tabular-nums; }
th, td { padding: 0.2em 0.9em; text-align: left; border-bottom: 1px solid var(--rule); white-space: nowrap; }
thead th, thead td { border-bottom: 2px solid; }
tbody th { font-weight: normal; }
ul.items { list-style: none; margin: 0.5em 0; padding-left: 1.5em; }
ul.flowing li { display: inline-block; margin-right: 1.8em; }
.about { margin-left: 1.2em; }
p { margin: 0.5em 0 0.5em 1.5em; }
p, ul.items li, figure { overflow-x: auto; overflow-y: hidden; padding-bottom: 0.15em; }
.question, .source { margin-left: 0; }
.refusal { border-left: 4px solid #b00020; padding-left: 0.8em; }
figure { margin: 1em 0; } figure svg { max-width: 100%; height: auto; } figcaption { font-size: 0.9rem; }
:focus-visible { outline: 2px solid; outline-offset: 2px; }
@media (max-width: 40rem) {
  body { margin: 1rem auto; } h1 { font-size: 1.4rem; } h2 { font-size: 1.2rem; }
  p, ul.items, table { margin-left: 0; } ul.items { padding-left: 0; } .equation { padding-left: 0; }
  .label { min-width: 0; } .equation, table { font-size: 0.9rem; } th, td { padding: 0.2em 0.45em; }
  th:first-child, td:first-child { padding-left: 0; }
}
@media screen and (prefers-color-scheme: dark) {
  figure svg { filter: invert(0.93) hue-rotate(180deg); }
}
@media print {
  :root { color-scheme: light; }
  body { max-width: none; margin: 0; font-size: 10.5pt; color: #000; background: #fff; }
  nav { display: none; }
  h1, h2, h3, h4 { break-after: avoid; } .equation, tr, figure { break-inside: avoid; }
  .equation, .wide, p, ul.items li, figure { overflow: visible; }
  figure svg { max-width: 100%; min-width: 0 !important; }
  th, td { white-space: normal; padding: 0.15em 0.5em; }
  article + article { break-before: page; border: 0; margin: 0; }
}
"""
POLICY = "default-src 'none'; style-src 'unsafe-inline'; font-src data:"


def words(text: str) -> str:
    """Words of a file as text or attribute of HTML."""
    return escape(cleaned(text))


def page(title: str, body: str) -> str:
    return (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8"/>\n'
            f'<meta http-equiv="Content-Security-Policy" content="{escape(POLICY)}"/>\n'
            f'<meta name="viewport" content="width=device-width, initial-scale=1"/>\n'
            f"<title>{words(title)}</title>\n<style>{STYLE}</style>\n</head>\n"
            f"<body>\n<main>\n{body}\n</main>\n</body>\n</html>")
