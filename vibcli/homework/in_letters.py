"""What a scene answers in the letters that have no value, those that have one put in."""

from typing import TYPE_CHECKING

from vibcli.base.errors import NotInLetters, PhysicsError, Where
from vibcli.language.document.nodes import Scalar
from vibcli.language.reader import Expression
from vibcli.notation.scene_language import language
from vibcli.quantities.letters import expression_in_letters, state_function
from vibcli.quantities.quantity import EQUATION, OF_STATE, kind_of
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.parser import parse

if TYPE_CHECKING:
    from vibcli.language.spec import Spec
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

LONGEST = 500           # characters that a student may be expected to write
AN_EQUATION = "m*x'' + k*x = 0"


def node_in_letters(problem: "Problem", asked: Expression) -> "Node":
    """What is asked, as an expression of letters, of an equation its left side; NotInLetters where there is none."""
    if asked.text not in problem.lettered:
        problem.lettered[asked.text] = asked, _derived(problem, asked)
    _, found = problem.lettered[asked.text]
    if isinstance(found, PhysicsError):
        raise found
    return put_in(problem, found)


def _derived(problem: "Problem", asked: Expression) -> "Node | PhysicsError":
    """The node of what is asked, with letters for all parameters, or why there is none."""
    try:
        of_state = kind_of(problem.spec, asked.tree) in OF_STATE
        return state_function(problem, asked.tree) if of_state else expression_in_letters(problem, asked)
    except PhysicsError as refusal:
        return refusal


def put_in(problem: "Problem", node: "Node") -> "Node":
    """A node with the values of those letters that have one; NotInLetters of one that holds a record."""
    calls = [part.name for part in reachable([node]) if part.op == "call" and part.name in node.table.records]
    if calls:
        raise NotInLetters(f"no answer can be written in which the record {calls[0]} stands",
                           "ask for another quantity, or give the load as a function of the time")
    parameters, given = problem.scene.parameters, problem.numeric.given
    for name in reversed(parameters.order):
        if name in parameters.definitions and name not in given:
            node, = substitute([node], {parameters.nodes[name]: parameters.definitions[name]})
    table = problem.scene.table
    return substitute([node], {parameters.nodes[name]: table.number(value) for name, value in given.items()})[0]


def text_in_letters(problem: "Problem", asked: Expression) -> str:
    """The same in the language of scenes, an equation as left = 0."""
    return text_of_node(problem, node_in_letters(problem, asked), asked)


def text_of_node(problem: "Problem", node: "Node", asked: Expression) -> str:
    """A node that answers what is asked as text; NotInLetters where it is too long to be asked."""
    equation = kind_of(problem.spec, asked.tree) == EQUATION
    text = language(node) + " = 0" * equation
    if len(text) > LONGEST:
        raise NotInLetters(f"{asked.text} has {len(text)} characters in letters; the limit is {LONGEST}",
                           "ask for another quantity, or give more letters values")
    return text


def expression_of(text: str, example: str | None = None) -> Expression:
    """A text as an Expression, of an equation where an example of one is given; ExpressionError where it is none."""
    return Expression(Scalar(text, Where("answer", 1, 1, len(text))), parse(text, example))


def answer_of(text: str, spec: "Spec", asked: Expression) -> Expression:
    """A text as an Expression of the kind that answers what is asked; ExpressionError where it is none."""
    return expression_of(text, AN_EQUATION if kind_of(spec, asked.tree) == EQUATION else None)
