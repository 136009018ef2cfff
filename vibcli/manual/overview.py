"""The first page of the manual: a scene, and what there is to look up."""

from vibcli.elements.rigid_body import MOTIONS
from vibcli.elements.shapes import NEEDS
from vibcli.manual import scenes, topics
from vibcli.manual.catalogue import Catalogue
from vibcli.manual.layout import blocks, in_short, listed, paragraph, table
from vibcli.quantities import FAMILIES
from vibcli.reader.read import SECTIONS

START = ("A scene is a YAML file that says what a textbook figure shows: the bodies where they are drawn, how each "
         "may move, what joins them, and what is asked. vibcli derives the equations of motion, the equilibrium, the "
         "natural frequencies, the modes and the motions in time from it.")
SMALLEST = """title: Mass on a spring
parameters: {m: 2 kg, k: 800 N/m}
bodies:
  block: {mass: m, slide: x}
springs:
  s: {k: k, between: [ground, block]}
answers:
  omega[1]: sqrt(k/m)"""


def overview() -> str:
    """The page that `vibcli explain` prints without a word."""
    catalogue = Catalogue()
    sections = [(section, in_short(about)) for section, (_, about) in SECTIONS.items()]
    motions = [(word, in_short(catalogue.elements["body"].fields[word].about)) for word in MOTIONS]
    subjects = [(word, about) for word, (about, _) in topics.TOPICS.items()]
    width = max(len(row[0]) for row in sections + subjects)
    examples = scenes.names("examples")
    return blocks(
        ["The language of scenes"], paragraph(START), ["  " + line for line in SMALLEST.split("\n")],
        ["Sections of a scene, all optional", *table(sections, least=width)],
        ["How a body moves, one of", *table(motions, least=width)],
        ["Shapes of bodies", *listed(NEEDS)],
        ["Quantities, for `answers`", *listed(FAMILIES)],
        ["Topics", *table(subjects, least=width)],
        ["More on any word, and a scene that runs", *table([
            ("vibcli explain spring", "the keys of a spring"),
            ("vibcli explain spring.preload", "one key of it"),
            ("vibcli new --list", f"templates to start from, and {len(examples)} example scenes")])])
