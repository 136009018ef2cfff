"""What is asked of each variant as a key: a number, an equation in numbers, or what stays in letters."""

from typing import TYPE_CHECKING

from vibcli.homework.equation_keys import EquationKey
from vibcli.homework.formula_keys import FormulaKey
from vibcli.homework.keys import AnswerKey, number_key
from vibcli.quantities.quantity import OF_STATE, kind_of
from vibcli.reader.variants import stays_in_letters

if TYPE_CHECKING:
    from vibcli.language.spec import Spec
    from vibcli.reader.sections.variants import AskedQuantity


def key_of(spec: "Spec", one: "AskedQuantity") -> AnswerKey:
    """The key of a quantity that is asked."""
    of_state = kind_of(spec, one.asked.tree) in OF_STATE
    if stays_in_letters(spec, spec.get("variants").axes):
        return FormulaKey(one.asked, "", 1.0, one.points)
    return EquationKey(one.asked, "", 1.0, one.points, one.rtol) if of_state else number_key(spec, one)
