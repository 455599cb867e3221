# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nastran bulk data (.bdf, .nas, .dat): GRID*, solid and shell elements, SET3.

Our own writer: meshio's has no groups and no properties. Quick reference guide of MSC Nastran.
"""

from __future__ import annotations

import re
from typing import Any, Dict, List, TextIO, Tuple

import numpy as np

from .atomic import replaced_file
from .group_partition import one_number
from .mesh import CELL_TYPES, Mesh
from .text_rows import slices
from .text_sections import Lines, reader

#: Card of a cell type, and its nodes as indices into ours. Uprights come before the top.
TYPES: Dict[str, Tuple[str, Any]] = {
    "line": ("CROD", None),
    "line3": ("CBEAM3", None),
    "triangle": ("CTRIA3", None),
    "triangle6": ("CTRIA6", None),
    "quad": ("CQUAD4", None),
    "quad8": ("CQUAD8", None),
    "tetra": ("CTETRA", None),
    "tetra10": ("CTETRA", None),
    "pyramid": ("CPYRAM", None),
    "pyramid13": ("CPYRAM", None),
    "wedge": ("CPENTA", None),
    "wedge15": ("CPENTA", (0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11)),
    "hexahedron": ("CHEXA", None),
    "hexahedron20": (
        "CHEXA",
        (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15),
    ),
}
_PREFIX = "$NMGS "


def write_nastran(path: str, mesh: Mesh) -> None:
    """All cells and groups.

    The property of an element is the number of the first of its groups, in the order of the mesh,
    and the number behind the last for elements in none. Every group is a SET3 as well, with its
    name in a comment before it: Nastran has no names.
    """
    number = {name: at for at, name in enumerate(mesh.groups, 1)}
    with replaced_file(path) as file:
        file.write("$ NMGS Workbench\nBEGIN BULK\n")
        for part in slices(len(mesh.points)):
            rows = mesh.points[part].tolist()
            file.writelines(
                f"{'GRID*':<8}{n:>16d}{'':16}{_real(x)}{_real(y)}{'*':<8}\n{'*':<8}{_real(z)}\n"
                for n, (x, y, z) in enumerate(rows, part.start + 1)
            )
        first: Dict[str, int] = {}
        element = 1
        for kind, nodes in mesh.cells.items():
            first[kind] = element
            label = one_number(mesh, kind, number)
            label[label == 0] = len(number) + 1
            _write_elements(file, kind, nodes, label, element)
            element += len(nodes)
        for name, (kind, indices) in mesh.groups.items():
            what = "GRID" if kind == "node" else "ELEM"
            file.write(f"{_PREFIX}{what} {number[name]} {' '.join(name.split())}\n")
            _write_set(file, number[name], what, indices + (1 if kind == "node" else first[kind]))
        file.write("ENDDATA\n")


def _real(value: float) -> str:
    """16 columns: the shortest text that reads back alike where it fits, else 10 digits or more."""
    text = repr(value)
    if len(text) > 16:
        text = next(t for t in (f"{value:.{n}E}" for n in range(15, 5, -1)) if len(t) <= 16)
    if "." not in text:
        # A number without a point would be a whole one.
        mantissa, e, exponent = text.partition("e")
        text = f"{mantissa}.0{e}{exponent}"
    return f"{text:>16}"


def _write_elements(
    file: TextIO, kind: str, nodes: np.ndarray, label: np.ndarray, number: int
) -> None:
    card, order = TYPES[kind]
    count = nodes.shape[1]
    pieces = [f"{card:<8}{{:>8d}}{{:>8d}}"]
    for at in range(count):
        # Eight fields a line: the first has number and property, too.
        if at >= 6 and (at - 6) % 8 == 0:
            pieces.append("+\n+       ")
        pieces.append("{:>8d}")
    template = "".join(pieces) + "\n"
    for part in slices(len(nodes)):
        rows = nodes[part] if order is None else nodes[part][:, list(order)]
        columns = [range(number + part.start, number + part.stop), label[part].tolist()]
        columns += (rows + 1).T.tolist()
        file.write("".join(map(template.format, *columns)))


def _write_set(file: TextIO, number: int, what: str, members: np.ndarray) -> None:
    if not len(members):
        return
    file.write(f"{'SET3':<8}{number:>8d}{what:>8}")
    for part in slices(len(members)):
        for at, member in enumerate(members[part].tolist(), part.start):
            if at >= 6 and (at - 6) % 8 == 0:
                file.write("+\n+       ")
            file.write(f"{member:>8d}")
    file.write("\n")


@reader
def read_nastran(path: str) -> Mesh:
    """GRID, CTETRA, CHEXA, CPENTA, CPYRAM, shells and rods, in free, small or large fields; SET3 as
    groups, or a group Property1, ... for each property where there are none. Other cards are passed
    over. Raises FormatError, FileNotFoundError."""
    lines = Lines(path)
    cards = {}
    for name, (card, _) in TYPES.items():
        cards.setdefault(card, []).append(name)
    for alias, card in (("CBAR", "CROD"), ("CBEAM", "CROD"), ("CQUADR", "CQUAD4")):
        cards[alias] = cards[card]
    places: Dict[int, List[float]] = {}
    found: Dict[str, List[Tuple[int, int, List[int]]]] = {}
    sets: List[Tuple[int, str, List[int]]] = []
    names: Dict[int, str] = {}
    while lines.more():
        line = lines.next("a card")
        if line.startswith(_PREFIX):
            words = line[len(_PREFIX) :].split(None, 2)
            if len(words) == 3 and words[1].isdigit():
                names[int(words[1])] = words[2].strip()
        if line.startswith("$") or not line.strip():
            continue
        fields = _card(lines, line)
        head = fields[0].upper().rstrip("*")
        try:
            if head == "GRID":
                places[int(fields[1])] = [_float(f) for f in (fields + [""] * 6)[3:6]]
            elif head == "SET3":
                sets.append((int(fields[1]), fields[2].upper(), _members(fields[3:])))
            elif head in cards:
                end = 2 + max(CELL_TYPES[n][0] for n in cards[head]) + 1
                nodes = [int(f) for f in fields[3:end] if f and _whole(f)]
                kind = _kind(lines, head, cards[head], nodes)
                nodes = nodes[: CELL_TYPES[kind][0]]
                found.setdefault(kind, []).append((int(fields[1]), int(fields[2] or 0), nodes))
        except ValueError:
            raise lines.error(f"expected numbers in {line.strip()[:60]!r}") from None
    return _mesh(lines, places, found, sets, names)


def _whole(field: str) -> bool:
    return field.lstrip("+-").isdigit()


def _kind(lines: Lines, head: str, names: List[str], nodes: List[int]) -> str:
    # A card with all its nodes is quadratic, one with the corners alone linear.
    for name in sorted(names, key=lambda n: -CELL_TYPES[n][0]):
        if len(nodes) >= CELL_TYPES[name][0]:
            return name
    raise lines.error(f"{head} with {len(nodes)} nodes")


def _card(lines: Lines, line: str) -> List[str]:
    """The fields of a card and its continuations, without the continuations' own."""
    fields = _fields(line)
    while True:
        following = lines.peek()
        if not following or following[0] not in "+*," and not following.startswith("        "):
            return fields
        if not following.strip():
            return fields
        more = _fields(lines.next("a continuation"))
        # A line holds eight fields, or four wide ones, behind the first.
        wide = 4 if line.split(",")[0][:8].rstrip().endswith("*") and "," not in line else 8
        lack = -(len(fields) - 1) % wide
        fields += [""] * lack + more[1:]


def _fields(line: str) -> List[str]:
    line = line.split("$")[0].rstrip("\n")
    if "," in line:
        return [field.strip() for field in line.split(",")][:9]
    line = line.expandtabs(8)
    head = line[:8].strip()
    wide = 16 if "*" in head else 8
    return [head] + [line[at : at + wide].strip() for at in range(8, min(len(line), 72), wide)]


def _float(field: str) -> float:
    """Nastran may leave the E out: 1.5-3."""
    if not field:
        return 0.0
    text = field.upper().replace("D", "E")
    return float(re.sub(r"(?<=[0-9.])([+-]\d+)$", r"E\1", text) if "E" not in text else text)


def _members(fields: List[str]) -> List[int]:
    members: List[int] = []
    words = [field.upper() for field in fields if field]
    at = 0
    while at < len(words):
        if words[at] == "THRU" and members and at + 1 < len(words):
            members += range(members[-1] + 1, int(words[at + 1]) + 1)
            at += 2
            continue
        if _whole(words[at]):
            members.append(int(words[at]))
        at += 1
    return members


def _mesh(lines: Lines, places: Any, found: Any, sets: Any, names: Dict[int, str]) -> Mesh:
    tags = list(places)
    row = {tag: at for at, tag in enumerate(tags)}
    cells: Dict[str, np.ndarray] = {}
    place: Dict[int, Tuple[str, int]] = {}
    groups: Dict[str, Any] = {}
    for kind, entries in found.items():
        try:
            nodes = np.array([[row[n] for n in entry[2]] for entry in entries])
        except KeyError as error:
            raise lines.error(f"an element names node {error}, which the file lacks") from None
        order = TYPES[kind][1]
        cells[kind] = nodes if order is None else nodes[:, np.argsort(order)]
        place.update({entry[0]: (kind, at) for at, entry in enumerate(entries)})
    for number, what, members in sets:
        name = names.get(number, f"Set{number}")
        if what == "GRID":
            groups[name] = ("node", np.array([row[m] for m in members if m in row]))
            continue
        parts: Dict[str, List[int]] = {}
        for member in members:
            if member in place:
                parts.setdefault(place[member][0], []).append(place[member][1])
        for kind, indices in parts.items():
            groups[name if len(parts) == 1 else f"{name}_{kind}"] = (kind, np.array(indices))
    if not sets:
        for kind, entries in found.items():
            numbers = np.array([entry[1] for entry in entries])
            for value in np.unique(numbers).tolist():
                name = f"Property{value}"
                title = name if name not in groups else f"{name}_{kind}"
                groups[title] = (kind, np.flatnonzero(numbers == value))
    points = np.array([places[tag] for tag in tags], dtype=np.float64).reshape(-1, 3)
    return Mesh(points, cells, groups)
