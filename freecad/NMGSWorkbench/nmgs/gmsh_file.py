# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gmsh's .msh, versions 4.1 and 2.2 (text): reference manual, chapter "Gmsh file formats".

Our own: meshio writes no entities to hang groups on, and does not read 4.1 where an entity has no
physical group. It reads binary files.
"""

from __future__ import annotations

from typing import Any, Dict, Iterator, List, TextIO, Tuple

import numpy as np

from .atomic import replaced_file
from .gmsh_reader import read_text, text_version
from .gmsh_types import POINT, TYPES
from .group_partition import numbers_by_dimension, partition
from .mesh import CELL_TYPES, Mesh
from .meshio_files import mesh_of_meshio, raw_mesh
from .text_sections import reader
from .text_rows import slices, write_rows


@reader
def read_msh(path: str) -> Mesh:
    """Cells, and physical groups by their names; a group of points is one of nodes. Text of
    versions 2.2 and 4.1 by gmsh_reader, all else by meshio. Raises FormatError, FileNotFoundError.
    """
    if text_version(path) in ("2.2", "4.1"):
        return _without_repeats(read_text(path))
    return mesh_of_meshio(path, raw_mesh(path, "gmsh"))


def _without_repeats(mesh: Mesh) -> Mesh:
    """Version 2.2 has a cell once for each of its groups: they become one again."""
    cells, groups = dict(mesh.cells), dict(mesh.groups)
    for kind, nodes in mesh.cells.items():
        _, first, place = np.unique(nodes, axis=0, return_index=True, return_inverse=True)
        if len(first) == len(nodes):
            continue
        order = np.argsort(first)
        rank = np.empty(len(order), dtype=np.int64)
        rank[order] = np.arange(len(order))
        number = rank[place.reshape(-1)]
        cells[kind] = nodes[first[order]]
        for name, (of, indices) in mesh.groups.items():
            if of == kind:
                groups[name] = (kind, np.unique(number[indices]))
    return Mesh(mesh.points, cells, groups)


def _physical_names(file: TextIO, numbers: Dict[str, Tuple[int, int]]) -> None:
    if numbers:
        file.write(f"$PhysicalNames\n{len(numbers)}\n")
        for name, (dimension, number) in numbers.items():
            plain = name.replace('"', "'")
            file.write(f'{dimension} {number} "{plain}"\n')
        file.write("$EndPhysicalNames\n")


def _entities(mesh: Mesh) -> List[Tuple[str, int, Tuple[str, ...], np.ndarray]]:
    """(cell type, dimension, groups, indices of cells): cells of one type in the same groups."""
    result = []
    for kind, nodes in mesh.cells.items():
        part, members = partition(mesh, kind)
        for number, names in enumerate(members):
            whole = len(members) == 1
            indices = np.arange(len(nodes)) if whole else np.flatnonzero(part == number)
            result.append((kind, CELL_TYPES[kind][1], names, indices))
    return result


def _rows(cells: np.ndarray, indices: np.ndarray) -> Iterator[Tuple[int, np.ndarray]]:
    for part in slices(len(indices)):
        yield part.start, cells[indices[part]]


def write_msh22(path: str, mesh: Mesh) -> None:
    """Version 2.2. A face or edge in many groups is there once for each, as Gmsh itself writes it.

    Raises ValueError for groups that share cells of the highest dimension: these cells would be
    there twice for a solver. Version 4.1 holds such groups.
    """
    numbers = numbers_by_dimension(mesh)
    entities = _entities(mesh)
    top = max((dimension for _, dimension, _, _ in entities), default=0)
    for _, dimension, names, _ in entities:
        if dimension == top and len(names) > 1:
            raise ValueError(
                f"mesh: groups {', '.join(names)} share cells, which version 2.2 cannot hold; "
                "write format='msh41'"
            )
    nodes = {name: i for name, (kind, i) in mesh.groups.items() if kind == "node"}
    count = sum(len(i) * max(len(names), 1) for _, _, names, i in entities)
    count += sum(len(indices) for indices in nodes.values())
    with replaced_file(path) as file:
        file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n")
        _physical_names(file, numbers)
        file.write(f"$Nodes\n{len(mesh.points)}\n")
        write_rows(file, "{} {} {} {}\n", mesh.points, first=1)
        file.write(f"$EndNodes\n$Elements\n{count}\n")
        element = 1
        for name, indices in nodes.items():
            head = f"{{}} {POINT} 2 {numbers[name][1]} {numbers[name][1]} {{}}\n"
            write_rows(file, head, indices[:, None], first=element, add=1)
            element += len(indices)
        for entity, (kind, _, names, indices) in enumerate(entities, 1):
            number, order = TYPES[kind]
            for name in names or ("",):
                group = numbers[name][1] if name else 0
                head = f"{{}} {number} 2 {group} {entity} " + " ".join(["{}"] * CELL_TYPES[kind][0])
                for start, rows in _rows(mesh.cells[kind], indices):
                    write_rows(file, head + "\n", rows, first=element + start, order=order, add=1)
                element += len(indices)
        file.write("$EndElements\n")


def write_msh41(path: str, mesh: Mesh) -> None:
    """Version 4.1. Cells in the same groups are an entity, which has all these groups. Nodes are of
    the first entity of the highest dimension, whatever their place."""
    numbers = numbers_by_dimension(mesh)
    entities = _entities(mesh)
    tags = _tags([dimension for _, dimension, _, _ in entities])
    groups = {name: i for name, (kind, i) in mesh.groups.items() if kind == "node"}
    loose: Dict[int, List[int]] = {}
    for name, indices in groups.items():
        for node in indices.tolist():
            loose.setdefault(node, []).append(numbers[name][1])
    with replaced_file(path) as file:
        file.write("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n")
        _physical_names(file, numbers)
        _write_entities(file, mesh, entities, tags, numbers, loose)
        _write_nodes(file, mesh, entities, tags)
        _write_elements(file, mesh, entities, tags, loose)


def _tags(dimensions: List[int]) -> List[int]:
    counts: Dict[int, int] = {}
    tags = []
    for dimension in dimensions:
        counts[dimension] = counts.get(dimension, 0) + 1
        tags.append(counts[dimension])
    return tags


def _write_entities(
    file: TextIO,
    mesh: Mesh,
    entities: Any,
    tags: List[int],
    numbers: Dict[str, Tuple[int, int]],
    loose: Dict[int, List[int]],
) -> None:
    counts = [len(loose)] + [sum(d == n for _, d, _, _ in entities) for n in (1, 2, 3)]
    file.write("$Entities\n" + " ".join(map(str, counts)) + "\n")
    for tag, (node, groups) in enumerate(loose.items(), 1):
        place = " ".join(map(repr, mesh.points[node].tolist()))
        file.write(f"{tag} {place} {len(groups)} {' '.join(map(str, groups))}\n")
    for dimension in (1, 2, 3):
        for (kind, d, names, indices), tag in zip(entities, tags):
            if d != dimension:
                continue
            low, high = _box(mesh, kind, indices)
            box = " ".join(map(repr, [*low, *high]))
            physical = " ".join(str(numbers[name][1]) for name in names)
            file.write(f"{tag} {box} {len(names)} {physical} 0\n")
    file.write("$EndEntities\n")


def _box(mesh: Mesh, kind: str, indices: np.ndarray) -> Tuple[List[float], List[float]]:
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for _, rows in _rows(mesh.cells[kind], indices):
        places = mesh.points[rows.ravel()]
        low, high = np.minimum(low, places.min(axis=0)), np.maximum(high, places.max(axis=0))
    return low.tolist(), high.tolist()


def _write_nodes(file: TextIO, mesh: Mesh, entities: Any, tags: List[int]) -> None:
    count = len(mesh.points)
    owners = sorted(((-d, tag) for (_, d, _, _), tag in zip(entities, tags))) or [(0, 1)]
    dimension, tag = -owners[0][0], owners[0][1]
    blocks = 1 if count else 0
    file.write(f"$Nodes\n{blocks} {count} {min(count, 1)} {count}\n")
    if count:
        file.write(f"{dimension} {tag} 0 {count}\n")
        write_rows(file, "{}\n", np.arange(1, count + 1)[:, None])
        write_rows(file, "{} {} {}\n", mesh.points)
    file.write("$EndNodes\n")


def _write_elements(
    file: TextIO, mesh: Mesh, entities: Any, tags: List[int], loose: Dict[int, List[int]]
) -> None:
    total = len(loose) + sum(len(indices) for _, _, _, indices in entities)
    file.write(f"$Elements\n{len(loose) + len(entities)} {total} {min(total, 1)} {total}\n")
    element = 1
    for tag, node in enumerate(loose, 1):
        file.write(f"0 {tag} {POINT} 1\n{element} {node + 1}\n")
        element += 1
    for (kind, dimension, _, indices), tag in zip(entities, tags):
        number, order = TYPES[kind]
        file.write(f"{dimension} {tag} {number} {len(indices)}\n")
        template = "{} " + " ".join(["{}"] * CELL_TYPES[kind][0]) + "\n"
        for start, rows in _rows(mesh.cells[kind], indices):
            write_rows(file, template, rows, first=element + start, order=order, add=1)
        element += len(indices)
    file.write("$EndElements\n")
