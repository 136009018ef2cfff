"""The solution as text, in the order of a textbook: what is given, coordinates, equilibrium, energies, equations,
frequencies, damping, modes. Each section is computed when it is printed, and only if it was asked for."""

from vibcli import units
from vibcli.algebra.parse import plain_name
from vibcli.analyses.shapes import WORDS
from vibcli.errors import PhysicsError
from vibcli.questions import INSIGHT
from vibcli.report.abbreviate import abbreviated
from vibcli.report.figures import figure, table, width, with_unit, wrapped
from vibcli.report.notation import plain
from vibcli.report.results import joined, numeric_drive, numeric_row
from vibcli.report.rows import damped_row, mode_row, polar, repeated, shape_rows
from vibcli.report.sides import equation
from vibcli.spec import QUOTE

EVERYTHING = ("given", "chosen", "coordinates", "equilibrium", "virtual_work", "energies", "equations", "frequencies",
              "damping", "modes")
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
            known = "value" in record and name not in self.problem.spec.choices
            return record["value"].text if known else plain.symbol(name)

        text = QUOTE.sub(value, text)
        return " ".join(text.split())

    def section(self, title, lines):
        if lines:
            self.lines += ["", title, *(("  " + line).rstrip() for line in lines)]

    def add(self, name):
        """Add a section; where the scene has no such answer the first refusal is kept, and the others are printed."""
        try:
            if name in INSIGHT:
                from vibcli.report.insight import add

                add(self, name)
            else:
                getattr(self, "_" + name)()
        except PhysicsError as error:
            self.refusal = self.refusal or error

    def _given(self):
        lines, symbols = [], []
        for name, record in self.problem.spec.parameters.items():
            if name in self.problem.spec.choices:
                continue
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

    def _chosen(self):
        if self.problem.chosen is None:
            return
        from vibcli.report.chosen import chosen_lines

        self.section("Chosen", chosen_lines(self.problem))

    def _coordinates(self):
        problem, rows = self.problem, []
        for name in problem.scene.coordinates:
            about = problem.spec.coordinates[name].get("about") or _moves(problem, name)
            unit = _unit(problem.dimension(name))
            rows.append(f"{plain.symbol(name)} [{unit}]" + (f"  {about}" if about else ""))
        n = len(rows)
        self.section(f"Generalised coordinates ({n} degree{'s' if n != 1 else ''} of freedom)", rows + self._tied())

    def _tied(self):
        """How constraints leave these coordinates."""
        scene = self.problem.scene
        freedom = scene.freedom
        if not freedom.conditions:
            return []
        closed = [plain.symbol(name) for name in scene.loops.names] if scene.loops else []
        explicit = [f"{plain.symbol(name)} = {short(node)}" for name, node in scene.dependent.items()
                    if plain.symbol(name) not in closed]
        lines = wrapped(f"{freedom.coordinates} coordinates less {freedom.conditions} independent condition"
                        f"{'s' if freedom.conditions > 1 else ''}" + (": " if explicit else "")
                        + "   ".join(explicit), indent=2)
        if closed:
            lines.append(", ".join(closed) + (" follow" if len(closed) > 1 else " follows") + " by closing the loops")
        lines += [f"'{name}' is redundant: it follows from the other constraints" for name in freedom.redundant]
        return lines

    def _virtual_work(self):
        scene = self.problem.loose
        asked = "virtual_work" in self.problem.spec.get("find", ())
        if not (scene.forces or asked) or not 0 < len(scene.q) <= 16:
            return
        from vibcli.mechanics.virtual_work import generalised_forces

        names = [plain.symbol(name) for name in scene.coordinates]
        shown, lengths = abbreviated(scene.table, generalised_forces(scene), self.roots)
        lines = ["δA = " + " + ".join(f"Q_{name}·δ{name}" for name in names)]
        for name, node in zip(names, shown, strict=True):
            rests = scene.constraints or node.is_zero
            lines += wrapped(f"Q_{name} = {short(node)}" + ("" if rests else " = 0"), indent=4)
        driven = ", and of the inertia of driven motion" if scene.timed and scene.inertias else ""
        self.section("Virtual work of weights, springs and steady loads" + driven + ", at rest in equilibrium", lines)
        self.lines += self._lengths(lengths)

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
        values += [f"{plain.symbol(name)} = {with_unit(value, problem.dimension(name))}"
                   for name, value in problem.dependent_values.items() if name not in found.values]
        lines = [*wrapped(f"{', '.join(values)}   ({where})", indent=2),
                 f"{stable}; residual {figure(found.residual, digits=2)} of the forces"]
        warning = equilibrium_warning(problem)
        lines += wrapped(warning) if warning else []
        for name, node in problem.preloads.items():
            lines.append(f"static preload of {name}: {self._preload(node, name)}")
        if any("rope" in record for record in (problem.spec.get("constraints") or {}).values()):
            from vibcli.mechanics.reactions import slack

            lines += [f"{signal} = {figure(value)} N would be a push: the rope goes slack"
                      for signal, value in slack(problem)]
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
        from vibcli.report.letters import equilibrium_lines

        problem = self.problem
        values = equilibrium_in_letters(problem)
        first, = equilibrium_lines(values)
        lines = wrapped(first + ("   (the drawn position)" if problem.balanced_as_drawn else ""), indent=2)
        for name, node in problem.preloads.items():
            lines.append(f"static preload of {name}: {self._preload(node, name)}")
        self.section("Equilibrium", lines)

    def _reactions(self):
        problem = self.problem
        if not problem.symbolic:
            rows = [(reaction.signal, "not fixed by statics" if reaction.value is None else
                     f"{figure(reaction.value)} {'N·m' if reaction.signal.endswith('moment') else 'N'}")
                    for reaction in problem.reactions if reaction.value != 0.0]
            self.section("Reactions in equilibrium (tension positive; what supports exert on the body, fixed axes)",
                         table(rows, ("force", "value")))
        from vibcli.mechanics.reactions import along_the_motion

        lines = []
        for signal, node in along_the_motion(problem).items():
            lines += wrapped(f"{signal} = {short(node)}", indent=4)
        self.section("Reactions along a motion", lines)

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
        equations, loose = problem.equations, problem.loose
        if not loose.q:
            return
        if equations.full:
            shown, lengths = abbreviated(loose.table, equations.full + equations.conditions, self.roots)
            names = [f"{plain.symbol(name)}:  " for name in equations.names] + [""] * len(equations.conditions)
            lines = []
            for name, node in zip(names, shown, strict=True):
                lines += wrapped(name + equation(loose, node, short), indent=4)
            self.section("Equations of motion", lines)
            self.lines += self._lengths(lengths)
            if equations.multipliers:
                told = ", ".join(f"{plain(symbol)}: the multiplier of '{name}'"
                                 for symbol, name in equations.multipliers.items())
                self.lines += wrapped(told, indent=6, first=2)
        else:
            self.section("Equations of motion", [f"not written out for {len(scene.coordinates)} coordinates"])
        if equations.refusal:
            raise equations.refusal
        lines = []
        if equations.linear:
            for i, (name, node) in enumerate(zip(scene.coordinates, equations.linear, strict=True)):
                right = plain(equations.drive.get(i, scene.table.zero))
                lines += wrapped(f"{plain.symbol(name)}:  {plain(node)} = {right}", indent=4)
        numbers = not problem.symbolic and len(scene.coordinates) <= 16
        if numbers:
            lines += [""] * bool(lines) + ["in numbers (SI units):"] * bool(lines) + self._numeric_equations(equations)
        drawn = problem.balanced_as_drawn if problem.symbolic else problem.equilibrium.drawn
        where = "" if drawn else ", the coordinates counted from it"
        if lines:
            self.section(f"Small oscillations about the equilibrium{where}", lines)

    def _numeric_equations(self, equations):
        from vibcli.mechanics.lagrange import Equations

        found = Equations()
        found.M, found.C, found.G, found.K = self.problem.elements.matrices()
        lines = []
        for i, name in enumerate(self.problem.scene.coordinates):
            row, drive = numeric_row(self.problem, found, i), numeric_drive(self.problem, equations, i)
            lines += wrapped(f"{plain.symbol(name)}:  {joined(row, '·', plain, '−')} = "
                             f"{joined(drive, '·', plain, '−')}", indent=4)
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
        from vibcli.report.letters import damping_lines, frequency_lines

        equilibrium_in_letters(self.problem)  # refused where there is none
        forms = self.problem.closed_forms
        self.section("Natural frequencies [rad/s]", frequency_lines(self.problem, forms))
        self.section("Damping", damping_lines(forms) if forms is not None else [])

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
        from vibcli.report.letters import shape_lines

        forms = self.problem.closed_forms
        names = self.problem.scene.coordinates
        if forms is None or len(names) < 2:
            return
        self.section("Mode shapes (the first coordinate that moves is 1)", shape_lines(names, forms))

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


def short(node):
    """An expression as text, or its size where it is too long to read."""
    text = plain(node)
    return text if len(text) <= LONGEST else f"(an expression of {len(text)} characters; see --json)"
