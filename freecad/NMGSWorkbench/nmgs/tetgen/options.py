# SPDX-License-Identifier: LGPL-2.1-or-later
"""TetOptions: TetGen's switches by name; str() gives the switches, TetOptions.parse() goes back."""

from __future__ import annotations

import re
from typing import Any, Dict, List, Tuple

import numpy as np

from .switches import FILE_SWITCHES, REFUSED, SWITCHES, Switch, switches_of
from .version import tetgen_version

#: What TetGen's parser takes for a number behind a switch. In the first kind there is no exponent.
PLAIN = re.compile(r"[0-9.]*")
WITH_EXPONENT = re.compile(r"(?:[0-9.][0-9.e+-]*)?")
EXPONENT_LETTERS = "aSTx"
#: TetGen copies the switches into 1024 characters without looking.
LONGEST = 900


class TetOptions:
    """TetGen's options by name, for the TetGen that is linked (or version="1.5" or "1.6").

    TetOptions(plc=True, quality=True, radius_edge_ratio=1.4): every name, default, range and
    meaning is a row of TetOptions.table(). A number behind a switch turns the switch on.
    Raises ValueError that names the option and its value, and for one that this version lacks.
    """

    __slots__ = ("version", "_rows", "_values")

    def __init__(self, version: str = "", **options: Any):
        object.__setattr__(self, "version", version or tetgen_version())
        object.__setattr__(self, "_rows", {r.name: r for r in switches_of(self.version)})
        object.__setattr__(self, "_values", {})
        if not self._rows:
            raise ValueError(f"version: expected '1.5' or '1.6', got {version!r}")
        for name, value in options.items():
            setattr(self, name, value)

    @staticmethod
    def table(version: str = "") -> Tuple[Switch, ...]:
        """name, letter, slot, default, low, high, versions, sentence of every option."""
        return switches_of(version or tetgen_version())

    def copy(self) -> "TetOptions":
        """Another one with the same values."""
        other = TetOptions(self.version)
        other._values.update(self._values)
        return other

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        row = self._row(name)
        return self._values.get(name, row.default)

    def __setattr__(self, name: str, value: Any) -> None:
        row = self._row(name)
        value = _checked(row, value)
        if value == row.default:
            self._values.pop(name, None)
            return
        self._values[name] = value
        owner = _owner(row, self._rows)
        if owner is not None and not self._values.get(owner.name):
            self._values[owner.name] = type(owner.default)(1)

    def _row(self, name: str) -> Switch:
        if name in self._rows:
            return self._rows[name]
        others = {v for row in SWITCHES if row.name == name for v in row.versions}
        if others:
            letter = next(row.letter for row in SWITCHES if row.name == name)
            raise ValueError(
                f"{name} (-{letter}): TetGen {self.version} does not have it, "
                f"TetGen {', '.join(sorted(others))} does"
            )
        raise AttributeError(f"TetOptions has no option {name!r}")

    def __dir__(self) -> List[str]:
        return sorted([*object.__dir__(self), *self._rows])

    def __eq__(self, other: Any) -> bool:
        if not isinstance(other, TetOptions):
            return NotImplemented
        return self.version == other.version and self._values == other._values

    def __hash__(self) -> int:
        return hash((self.version, tuple(sorted(self._values.items()))))

    def __repr__(self) -> str:
        return f"TetOptions({', '.join(f'{k}={v!r}' for k, v in self._values.items())})"

    def __str__(self) -> str:
        return "".join(_text(letter, self) for letter in _letters(self))

    @classmethod
    def parse(cls, switches: str, version: str = "") -> "TetOptions":
        """The options of a switch string, read as TetGen reads it.

        Raises ValueError for a switch that this version lacks, that cannot work here, or that has
        a number out of its range.
        """
        if not isinstance(switches, str):
            raise TypeError(f"switches: expected text, got {type(switches).__name__}")
        if len(switches) > LONGEST:
            raise ValueError(f"switches: at most {LONGEST} characters, got {len(switches)}")
        options = cls(version)
        place = 0
        while place < len(switches):
            place = _parse_one(options, switches, place)
        return options


def _owner(row: Switch, rows: Dict[str, Switch]) -> "Switch | None":
    """The switch that a number stands behind, where it means something without the number."""
    if row.slot is None or row.letter not in "pYrqRwmD":
        return None
    return next(r for r in rows.values() if r.letter == row.letter and r.slot is None)


def _checked(row: Switch, value: Any) -> Any:
    wanted = row.number if row.default is None else type(row.default)
    if value is None and row.default is None:
        return None
    where = f"{row.name} (-{row.letter})"
    if wanted is bool:
        if value not in (True, False):
            raise ValueError(f"{where}: expected True or False, got {value!r}")
        return bool(value)
    if isinstance(value, bool) and wanted is int:
        value = int(value)
    if isinstance(value, bool) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise ValueError(f"{where}: expected a number, got {value!r}")
    if wanted is int and value != int(value):
        raise ValueError(f"{where}: expected a whole number, got {value!r}")
    number = wanted(value)
    above = row.default is None and wanted is float  # a limit of 0 can never be met
    if not row.low <= number <= row.high or (above and not 0 < number < float("inf")):
        span = f"above {row.low:g}" if above else f"{row.low:g} to {row.high:g}"
        raise ValueError(f"{where}: expected {span}, got {value!r}")
    return number


def _letters(options: TetOptions) -> List[str]:
    """Letters in the order of writing: those whose number may swallow an 'e' come last."""
    seen = dict.fromkeys(row.letter for row in options._rows.values())
    return [c for c in seen if c not in EXPONENT_LETTERS + "m"] + ["m"] + list(EXPONENT_LETTERS)


def _plain(value: Any) -> str:
    return str(value) if isinstance(value, int) else np.format_float_positional(value, trim="-")


def _text(letter: str, options: TetOptions) -> str:
    rows = [row for row in options._rows.values() if row.letter == letter]
    values = options._values
    if letter == "M":
        pair = (values.get("keep_facets", False), values.get("keep_points", False))
        return {(0, 0): "", (1, 1): "M", (1, 0): "M1/0", (0, 1): "M0/1"}[pair]
    if letter == "a":
        volume = values.get("max_volume")
        return ("a" if values.get("volumes") else "") + ("" if volume is None else f"a{volume!r}")
    text = ""
    slots: Dict[int, str] = {}
    for row in rows:
        if row.name not in values:
            continue
        if row.slot is not None:
            number = values[row.name]
            slots[row.slot] = repr(number) if letter in EXPONENT_LETTERS + "m" else _plain(number)
        elif row.suffix:
            text += letter + row.suffix
        else:
            text += letter * int(values[row.name])
    if slots:
        if letter == "D" and options.version == "1.6":
            text += "D"  # with a number behind it, D alone is not switched on
        numbers = "/".join(slots.get(i, "") for i in range(max(slots) + 1))
        text = (text or letter) + numbers
    return text


def _parse_one(options: TetOptions, text: str, place: int) -> int:
    """Reads the switch at the place; returns the place behind it."""
    letter = text[place]
    if letter == "-" and place == 0:
        return 1
    rows = [row for row in options._rows.values() if row.letter == letter]
    suffixed = next((r for r in rows if r.suffix and text[place + 1 : place + 2] == r.suffix), None)
    if suffixed is not None:
        setattr(options, suffixed.name, True)
        return place + 2
    if not rows and letter in REFUSED or letter in "hH?":
        raise ValueError(f"switches: -{letter} cannot be used here: {REFUSED[letter]}")
    if letter in FILE_SWITCHES and all(r.suffix for r in rows):
        return place + (2 if text[place : place + 2] == "k2" else 1)
    if not rows:
        others = sorted({v for r in SWITCHES if r.letter == letter for v in r.versions})
        hint = f"; TetGen {', '.join(others)} does" if others else ""
        raise ValueError(f"switches: TetGen {options.version} does not have -{letter}{hint}")
    numbers, end = _numbers(text, place + 1, letter, rows, options.version)
    _apply(options, letter, rows, numbers)
    return end


def _numbers(
    text: str, place: int, letter: str, rows: List[Switch], version: str
) -> Tuple[Dict[int, str], int]:
    """Numbers behind a switch by their slot, and the place behind them."""
    slots = {row.slot: row for row in rows if row.slot is not None}
    last = (
        1 if letter == "M" else 2 if letter == "q" and version == "1.5" else max(slots, default=-1)
    )
    exponents = letter in EXPONENT_LETTERS or (letter == "m" and version == "1.6")
    found: Dict[int, str] = {}
    for slot in range(last + 1):
        if slot > 0:
            if text[place : place + 1] not in ("/", ","):
                break
            place += 1
        if slot not in slots and letter not in "Mq" and (letter, slot) != ("p", 1):
            continue  # no number here, only behind a further slash
        whole = slot in slots and slots[slot].number is int and slots[slot].high <= 9
        if whole or letter == "M":
            most = "1" if letter == "M" else "2" if letter == "o" else f"{slots[slot].high:.0f}"
            least = "2" if letter == "o" else "1" if letter == "D" else "0"
            digit = text[place : place + 1]
            number = digit if digit and least <= digit <= most else ""
        else:
            pattern = WITH_EXPONENT if exponents else PLAIN
            if letter == "b" and slot >= 2:
                pattern = re.compile(r"[0-9.-]*")
            number = pattern.match(text, place).group()  # type: ignore[union-attr]
        if number:
            found[slot] = number
        place += len(number)
    return found, place


def _apply(options: TetOptions, letter: str, rows: List[Switch], numbers: Dict[int, str]) -> None:
    if letter == "M":
        options.keep_facets = numbers.get(0, "1") == "1"
        options.keep_points = numbers.get(1, "1") == "1"
        return
    if letter == "q" and options.version == "1.5" and 2 in numbers:
        options.max_dihedral = _value(letter, float, numbers.pop(2))
    if letter == "D" and options.version == "1.6" and numbers:
        options._values["conforming_level"] = int(numbers[0])
        return
    flag = next((row for row in rows if row.slot is None and not row.suffix), None)
    if flag is not None and not (letter == "a" and numbers):
        if type(flag.default) is int:
            count = min(options._values.get(flag.name, 0) + 1, int(flag.high))
            setattr(options, flag.name, count)
        else:
            setattr(options, flag.name, True)
    for row in rows:
        if row.slot in numbers and row.slot is not None:
            number = row.number if row.default is None else type(row.default)
            setattr(options, row.name, _value(letter, number, numbers[row.slot]))


def _value(letter: str, number: type, text: str) -> Any:
    try:
        return number(text)
    except ValueError:
        raise ValueError(
            f"switches: -{letter} is followed by {text!r}, which is no number"
        ) from None
