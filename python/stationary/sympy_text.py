"""SymPy expressions as formulas of a case."""

from __future__ import annotations

import importlib
from typing import Any


def plain(value: Any) -> str | float | bool:
    """The text of a SymPy expression or comparison in the language of formulas; a number as such.

    Where the language has no such function, the case's own error says so.
    """
    boolalg: Any = importlib.import_module("sympy.logic.boolalg")
    printing: Any = importlib.import_module("sympy.printing.str")

    class Printer(printing.StrPrinter):  # type: ignore[misc]
        def _print_Pow(self, power: Any, rational: bool = False) -> str:
            return str(super()._print_Pow(power, rational=rational)).replace("**", "^")

        def _print_Abs(self, absolute: Any) -> str:
            return f"abs({self._print(absolute.args[0])})"

        def _print_Min(self, least: Any) -> str:
            return self._nested("min", least)

        def _print_Max(self, most: Any) -> str:
            return self._nested("max", most)

        def _print_Exp1(self, e: Any) -> str:
            return "e"

        def _print_Float(self, number: Any) -> str:
            return repr(float(number))

        def _nested(self, name: str, call: Any) -> str:
            first, *others = [self._print(each) for each in call.args]
            for each in others:
                first = f"{name}({first}, {each})"
            return str(first)

    if isinstance(value, boolalg.BooleanAtom):
        return bool(value)
    if getattr(value, "is_number", False):
        return float(value)
    return str(Printer().doprint(value))
