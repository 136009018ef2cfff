"""The solution as text, in the order of a textbook: what is given, coordinates, equilibrium, energies, equations,
frequencies, damping, modes. Each section is computed when it is printed, and only if it was asked for."""

from vibcli import units
from vibcli.algebra.parse import plain_name
from vibcli.analyses.shapes import WORDS
from vibcli.errors import PhysicsError
from vibcli.report.abbreviate import abbreviated
from vibcli.report.figures import figure, table, width, with_unit, wrapped
from vibcli.report.notation import plain
from vibcli.report.results import joined, numeric_row
from vibcli.report.rows import damped_row, mode_row, polar, repeated, shape_rows
from vibcli.spec import QUOTE

ORDER = ("given", "coordinates", "equilibrium", "equilibria", "energies", "equations", "frequencies", "damping",
         "modes")
EVERYTHING = tuple(section for section in ORDER if section != "equilibria")
LONGEST = 2400


class Report:
    """Lines of a report about one problem."""

    def __init__(self, problem, normalise="first"):
        self.problem, self.normalise, self.lines, self.roots = problem, normalise, [], {}
        self.refusal = None

    def head(self, case, question=True):
        """The title, and the question with its source."""
        spec = self.problem.spec
        title = spec.get("title") or spec.file
        title = f"{title} — case {case}" if case else title
        self.lines += [title, "=" * width(title)]
        if question and not case:
            self.lines += [f"Source: {spec.get('source')}"] if spec.get("source") else []
            if spec.get("question"):
                self.lines += ["", *wrapped(self._quoting(spec.get("question")), indent=0)]

    def _quoting(self, text):
        def value(quote):
            name = plain_name(quote.group(1))
            record = self.problem.spec.parameters[name]
            return record["value"].text if "value" in record else plain.symbol(name)

        text = QUOTE.sub(value, text)
        return " ".join(text.split())

    def section(self, title, lines):
        if lines:
            self.lines += ["", title, *(("  " + line).rstrip() for line in lines)]

    def add(self, name):
        """Add a section; where the scene has no such answer the first refusal is kept, and the others are printed."""
        try:
            getattr(self, "_" + name)()
        except PhysicsError as error:
            self.refusal = self.refusal or error

    def _given(self):
        lines, symbols = [], []
        for name, record in self.problem.spec.parameters.items():
            about = "   " + record["about"] if "about" in record else ""
            if "value" in record:
                lines.append(f"{plain.symbol(name)} = {record['value'].text}{about}")
            elif about:
                lines.append(plain.symbol(name) + about)
            else:
                symbols.append(plain.symbol(name))
        if not any("   " in line for line in lines):
            lines = wrapped("   ".join(lines), gap="   ")
        self.section("Given", lines + ([", ".join(symbols) + "  (in letters)"] if symbols else []))

    def _coordinates(self):
        problem, rows = self.problem, []
        for name in problem.scene.coordinates:
            about = problem.spec.coordinates[name].get("about") or _moves(problem, name)
            unit = _unit(problem.dimension(name))
            rows.append(f"{plain.symbol(name)} [{unit}]" + (f"  {about}" if about else ""))
        n = len(rows)
        self.section(f"Generalised coordinates ({n} degree{'s' if n > 1 else ''} of freedom)", rows)

    def _equilibrium(self):
        problem = self.problem
        if problem.symbolic:
            self._equilibrium_in_letters()
            return
        from vibcli.analyses.stability import WORDS as WORDS_OF_STABILITY
        from vibcli.analyses.stability import stability
        from vibcli.report.equilibria import equilibrium_warning

        found = problem.equilibrium
        values = [f"{plain.symbol(name)} = {with_unit(value, problem.dimension(name))}"
                  for name, value in found.values.items()]
        stable = WORDS_OF_STABILITY[stability(problem).kind]
        where = "the drawn position" if found.drawn else "shifted from the drawn position"
        lines = [f"{', '.join(values)}   ({where})",
                 f"{stable}; residual {figure(found.residual, digits=2)} of the forces"]
        warning = equilibrium_warning(problem)
        lines += wrapped(warning) if warning else []
        for name, node in problem.preloads.items():
            lines.append(f"static preload of {name}: {self._preload(node, name)}")
        self.section("Equilibrium", lines)

    def _equilibria(self):
        from vibcli.report.equilibria import equilibria_lines

        self.section("Equilibria", equilibria_lines(self.problem))

    def _preload(self, node, name):
        text = plain(node)
        if self.problem.symbolic:
            return text
        from vibcli.algebra.evaluate import Floats, evaluate

        record = self.problem.spec.get("springs")[name]
        unit = "N·m" if "torsion" in record else "N"
        return f"{text} = {figure(evaluate([node], Floats, self.problem.floats)[0])} {unit}"

    def _equilibrium_in_letters(self):
        from vibcli.mechanics.symbolic import equilibrium_in_letters

        problem = self.problem
        values = equilibrium_in_letters(problem)
        lines = [", ".join(f"{plain.symbol(name)} = {plain(node)}" for name, node in values.items())
                 + ("   (the drawn position)" if problem.balanced_as_drawn else "")]
        for name, node in problem.preloads.items():
            lines.append(f"static preload of {name}: {self._preload(node, name)}")
        self.section("Equilibrium", lines)

    def _energies(self):
        energies = self.problem.energies
        for key, symbol, title in (("T", "T", "Kinetic energy"), ("V", "V", "Potential energy"),
                                   ("Phi", "Φ", "Dissipation function")):
            (shown,), lengths = abbreviated(self.problem.scene.table, [energies[key]], self.roots)
            if not shown.is_zero:
                self.section(title, wrapped(f"{symbol} = {short(shown)}"))
                self.lines += self._lengths(lengths)

    @staticmethod
    def _lengths(lengths):
        return [line for symbol, length in lengths
                for line in wrapped(f"with {plain(symbol)} = {plain(length)}", indent=6, first=2)]

    def _equations(self):
        problem, scene = self.problem, self.problem.scene
        equations = problem.equations
        if equations.full:
            shown, lengths = abbreviated(scene.table, equations.full, self.roots)
            lines = []
            for name, node in zip(scene.coordinates, shown, strict=True):
                lines += wrapped(f"{plain.symbol(name)}:  {short(node)} = 0", indent=4)
            self.section("Equations of motion", lines)
            self.lines += self._lengths(lengths)
        else:
            self.section("Equations of motion", [f"not written out for {len(scene.coordinates)} coordinates"])
        if equations.refusal:
            raise equations.refusal
        lines = []
        if equations.linear:
            for name, node in zip(scene.coordinates, equations.linear, strict=True):
                lines += wrapped(f"{plain.symbol(name)}:  {plain(node)} = 0", indent=4)
        numbers = not problem.symbolic and len(scene.coordinates) <= 16
        if numbers:
            lines += [""] * bool(lines) + ["in numbers (SI units):"] * bool(lines) + self._numeric_equations(equations)
        where = "" if problem.symbolic or problem.equilibrium.drawn else ", the coordinates counted from it"
        if lines:
            self.section(f"Small oscillations about the equilibrium{where}", lines)

    def _numeric_equations(self, equations):
        from vibcli.mechanics.lagrange import Equations

        found = Equations()
        found.M, found.C, found.G, found.K = self.problem.elements.matrices()
        lines = []
        for i, name in enumerate(self.problem.scene.coordinates):
            row = numeric_row(self.problem, found, i)
            lines += wrapped(f"{plain.symbol(name)}:  {joined(row, '·', plain, '−')}", indent=4)
        return lines

    def _frequencies(self):
        problem = self.problem
        if problem.symbolic:
            self._frequencies_in_letters()
            return
        same = repeated(problem.modes)
        rows = [mode_row(mode, problem.zero_modes.get(mode.index), mode.index in same) for mode in problem.modes]
        damped = "of the undamped system" if problem.damped else "undamped"
        self.section(f"Natural frequencies ({damped})",
                     table(rows, ("mode", "ω [rad/s]", "f [Hz]", "T [s]", "error ≤", "")))
        n = len(problem.scene.coordinates)
        if n == 1 and problem.linear_in_letters and problem.modes[0].omega:
            form = problem.closed_forms
            if form is not None:
                self.lines += [f"  ω = {plain(form.modes[0].omega)}"]

    def _frequencies_in_letters(self):
        from vibcli.mechanics.symbolic import equilibrium_in_letters

        equilibrium_in_letters(self.problem)  # refused where there is none
        forms = self.problem.closed_forms
        if forms is None:
            lines = ["no closed form that is readable; give the parameters values with --set"]
        elif forms.polynomial:
            lines = ["λ = ω² are the roots of"] + [f"{plain(node)} = 0" for node in forms.polynomial]
        else:
            lines = [f"ω{sub(i)} = {plain(mode.omega)}" for i, mode in enumerate(forms.modes, 1)]
            if len(forms.modes) > 1:
                lines.append("(numbered as at sample values of the letters; f = ω/(2π), T = 2π/ω)")
            else:
                lines.append("f = ω/(2π), T = 2π/ω")
        if self.problem.scene.dampers and (forms is None or forms.zeta is None):
            lines.append("the damped modes are found in numbers only; give the parameters values with --set")
        self.section("Natural frequencies [rad/s]", lines)
        if forms is not None and forms.zeta is not None:
            self.section("Damping", [f"ζ = {plain(forms.zeta)}",
                                     f"ω_d = ω·√(1 − ζ²) = {plain(forms.omega_d)}  for ζ < 1",
                                     "decay δ = ζ·ω"])

    def _damping(self):
        if self.problem.symbolic or self.problem.damped is None:
            return
        rows = [damped_row(mode) for mode in self.problem.damped]
        head = ("mode", "ω [rad/s]", "ζ", "ω_d [rad/s]", "T_d [s]", "decay [1/s]", "error ≤", "")
        self.section("Damped modes (eigenvalue λ: ω = |λ|, ζ = −Re λ/|λ|, decay = −Re λ, log. decrement = 2πζ/√(1−ζ²))",
                     table(rows, head))

    def _modes(self):
        problem = self.problem
        if problem.symbolic:
            self._modes_in_letters()
            return
        if len(problem.scene.coordinates) < 2:
            return
        names = problem.scene.coordinates
        self._shapes(names, problem.modes, f"Mode shapes ({WORDS[self.normalise]})")
        if problem.damped is not None:
            self._shapes(names, problem.damped, "Shapes of the damped modes", only_complex=True)

    def _shapes(self, names, modes, title, only_complex=False):
        shapes = [self.problem.shape(mode, self.normalise) for mode in modes]
        out_of_phase = any(abs(complex(value).imag) > 1e-9 * abs(value) for shape in shapes for value in shape)
        if out_of_phase:
            self.section(f"{title}, amplitude ∠ phase", shape_rows(names, shapes, polar))
        elif not only_complex:
            self.section(title, shape_rows(names, shapes))

    def _modes_in_letters(self):
        forms = self.problem.closed_forms
        names = self.problem.scene.coordinates
        if forms is None or len(names) < 2:
            return
        lines = [f"mode {i}:  " + ",  ".join(f"{plain.symbol(name)} = {plain(value)}"
                                            for name, value in zip(names, mode.shape, strict=True))
                 for i, mode in enumerate(forms.modes, 1) if mode.shape and mode.readable]
        if not lines and forms.ratio is not None:
            lines = [f"{plain.symbol(names[1])}/{plain.symbol(names[0])} = {plain(forms.ratio)}   for ω = ω₁, ω₂"]
        if not lines:
            lines = ["no closed form that is readable; give the parameters values with --set"]
        self.section("Mode shapes (the first coordinate that moves is 1)", lines)

    def text(self):
        return "\n".join(self.lines).replace("\u00a0", " ")


def _unit(dimension):
    return "rad" if dimension == {} else units.text(dimension)


def _moves(problem, name):
    """What a coordinate moves, where the file does not say: the first body whose motion is that coordinate."""
    for body_name, record in (problem.spec.get("bodies") or {}).items():
        for key in ("slide", "pin", "roll", "turn"):
            motion = record.get(key)
            values = motion.values.values() if hasattr(motion, "values") else (motion,)
            if any(getattr(value, "text", None) == name for value in values):
                words = {"slide": "displacement", "pin": "rotation", "roll": "rolling", "turn": "rotation"}[key]
                return f"{words} of {body_name}"
    return ""


def sub(number):
    return str(number).translate(str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉"))


def short(node):
    """An expression as text, or its size where it is too long to read."""
    text = plain(node)
    return text if len(text) <= LONGEST else f"(an expression of {len(text)} characters; see --json)"
