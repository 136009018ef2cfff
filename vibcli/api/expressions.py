"""Expressions and equations of a scene, to be read, typeset, or handed over to SymPy."""

from typing import TYPE_CHECKING

from vibcli.symbolic.node import Node

if TYPE_CHECKING:
    from sympy import Eq, Expr

    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene


class SymbolicExpression:
    """An expression of the letters of a scene: str() writes it in the scene language."""

    __slots__ = ("_moving", "_node")

    def __init__(self, node: Node, moving: tuple[str, ...] = ()) -> None:
        self._node, self._moving = node, moving

    def __str__(self) -> str:
        from vibcli.notation.scene_language import language

        return language(self._node)

    __repr__ = __str__

    @property
    def latex(self) -> str:
        """The expression in LaTeX, without dollar signs."""
        from vibcli.notation.latex import in_one_line

        return in_one_line(self._node)

    def to_sympy(self) -> "Expr":
        """The expression in SymPy; coordinates are functions of Symbol("t")."""
        from vibcli.symbolic.in_sympy import in_sympy

        return in_sympy([self._node], self._moving)[0]

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex}$"


def node_of(expression: SymbolicExpression) -> Node:
    """The expression as the engine has it."""
    return expression._node


class MotionEquation:
    """The equation of motion of a coordinate: `text` and `latex` in full, `linear_text` and `linear_latex` of small
    oscillations about the equilibrium; None where there is none."""

    __slots__ = ("_linear", "_node", "_scene", "coordinate", "latex", "linear_latex", "linear_text", "text")

    def __init__(self, scene: "Scene", row: dict[str, str | None], node: Node | None, linear: Node | None) -> None:
        self._scene, self._node, self._linear = scene, node, linear
        self.coordinate, self.text, self.latex = row["coordinate"], row["text"], row["latex"]
        self.linear_text, self.linear_latex = row["linear_text"], row["linear_latex"]

    def __str__(self) -> str:
        return self.text or self.linear_text or ""

    def __repr__(self) -> str:
        return f"<{self.coordinate}: {self}>"

    def to_sympy(self, linear: bool = False) -> "Eq":
        """The equation in SymPy, the coordinates functions of Symbol("t"); `linear`: that of small oscillations."""
        from vibcli.base.errors import NotInLetters
        from vibcli.notation.equation_sides import sides
        from vibcli.symbolic.in_sympy import equation_in_sympy

        node = self._linear if linear else self._node
        if node is None:
            raise NotInLetters(f"the equation of '{self.coordinate}' is not found in letters",
                               "its linear_text has it in numbers, where the scene has them")
        return equation_in_sympy(sides(self._scene, node), tuple(self._scene.coordinates))

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex or self.linear_latex or ''}$"


def equations_of(problem: "Problem") -> dict[str, MotionEquation]:
    """{coordinate: its equation}."""
    from vibcli.base.errors import PhysicsError
    from vibcli.report.sections.equations_of_motion import equation_rows

    if problem.scene.pieces:
        raise PhysicsError("the equations of motion of members are partial differential equations, which the report "
                           "writes out", "ask for frequencies, modes or frequency responses")
    equations, found = problem.symbolic.equations, {}
    for i, row in enumerate(equation_rows(problem)):
        name = row["coordinate"]
        linear = None
        if equations.in_letters and name in problem.scene.coordinates:
            k = problem.scene.coordinates.index(name)
            linear = equations.linear[k] - equations.drive.get(k, problem.scene.table.zero)
        scene = problem.system.scene_with_multipliers
        found[name] = MotionEquation(scene, row, equations.full[i] if equations.full else None, linear)
    return found
