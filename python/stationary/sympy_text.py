"""SymPy expressions as formulas of a case."""

from __future__ import annotations

import functools
import importlib
from typing import Any


def plain(value: Any) -> str | float | bool:
    """The text of a SymPy expression or comparison in the language of formulas; a number as such.

    Raises ValueError, which names it, for what is no real number. Where the language has no such
    function, the case's own error says so.
    """
    sympy: Any = importlib.import_module("sympy")
    boolalg: Any = importlib.import_module("sympy.logic.boolalg")
    if isinstance(value, boolalg.BooleanAtom):
        return bool(value)
    with sympy.evaluate(True):  # where the caller does without, SymPy itself finds no end
        if getattr(value, "is_number", False):
            try:
                return float(value.doit())
            except TypeError:
                raise ValueError(f"SymPy's {value}") from None
        return str(_printer()().doprint(value))


@functools.cache
def _printer() -> Any:
    """SymPy's printer with the language's spelling; a class, made where SymPy is first needed."""
    sympy: Any = importlib.import_module("sympy")
    printing: Any = importlib.import_module("sympy.printing.str")
    levels: Any = importlib.import_module("sympy.printing.precedence")
    of_sum, of_product = levels.PRECEDENCE["Add"], levels.PRECEDENCE["Mul"]

    class Printer(printing.StrPrinter):  # type: ignore[misc]
        """Has its own sums and products: SymPy's text of unevaluated ones has another meaning."""

        def _print_Add(self, total: Any, order: Any = None) -> str:
            text = ""
            for term in self._as_ordered_terms(total, order=order):
                each = self._print(term)
                if _bare(term).is_Add or _level(term) < of_sum:
                    each = f"({each})"
                sign, each = ("-", each[1:]) if each.startswith("-") else ("+", each)
                text += f" {sign} {each}"
            return text[3:] if text.startswith(" + ") else f"-{text[3:]}"

        def _print_Mul(self, product: Any) -> str:
            sign = 1
            above, below = [], []
            for factor in product.as_ordered_factors():
                if factor.is_Number and factor.is_negative:
                    sign, factor = -sign, -factor
                if factor.is_Rational:
                    above += [str(factor.p)] if factor.p != 1 else []
                    below += [str(factor.q)] if factor.q != 1 else []
                elif factor.is_Pow and factor.exp.as_coeff_Mul()[0].is_negative:
                    power = -factor.exp
                    inverse = factor.base
                    if power is not sympy.S.One:
                        inverse = sympy.Pow(factor.base, power, evaluate=False)
                    below.append(self.parenthesize(inverse, of_product))
                else:
                    above.append(self.parenthesize(factor, of_product))
            text = ("-" if sign < 0 else "") + ("*".join(above) or "1")
            if not below:
                return text
            return f"{text}/{below[0]}" if len(below) == 1 else f"{text}/({'*'.join(below)})"

        def parenthesize(self, item: Any, level: int, strict: bool = False) -> str:
            own, text = _level(item), str(self._print(item))
            return f"({text})" if own < level or (own == level and not strict) else text

        def _print_Pow(self, power: Any, rational: bool = False) -> str:
            return str(super()._print_Pow(power, rational=rational)).replace("**", "^")

        def _print_Abs(self, absolute: Any) -> str:
            return f"abs({self._print(absolute.args[0])})"

        def _print_Min(self, least: Any) -> str:
            return self._nested("min", least)

        def _print_Max(self, most: Any) -> str:
            return self._nested("max", most)

        # Their names would be those of parameters, where a case has such.
        def _print_Exp1(self, e: Any) -> str:
            return "exp(1)"

        def _print_Pi(self, pi: Any) -> str:
            return "(4*atan(1))"

        def _print_Float(self, number: Any) -> str:
            return repr(float(number))

        # Constants that the language has no names for.
        _print_Catalan = _print_EulerGamma = _print_Float
        _print_GoldenRatio = _print_TribonacciConstant = _print_Float

        def _print_ImaginaryUnit(self, constant: Any) -> str:
            raise ValueError(f"SymPy's {constant}")

        # Their names, too, could be those of parameters.
        _print_ComplexInfinity = _print_NaN = _print_ImaginaryUnit
        _print_Infinity = _print_NegativeInfinity = _print_ImaginaryUnit

        def _nested(self, name: str, call: Any) -> str:
            first, *others = [self._print(each) for each in call.args]
            for each in others:
                first = f"{name}({first}, {each})"
            return str(first)

    def _bare(each: Any) -> Any:
        while isinstance(each, sympy.UnevaluatedExpr):
            (each,) = each.args
        return each

    def _level(each: Any) -> int:
        """How tightly its text binds: that of 1/x, a power, as a quotient."""
        each = _bare(each)
        if getattr(each, "is_Pow", False) and each.exp in (-sympy.S.One, -sympy.S.Half):
            return int(of_product)
        return int(levels.precedence(each))

    return Printer
