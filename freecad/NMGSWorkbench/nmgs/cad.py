# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks from CAD: nmgs.fit. Needs FreeCAD's Part only through the shape that is handed in."""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np

from . import _kernel, sizing, tet_to_hexas
from .block_model import BlockModel, CadLink
from .errors import BlockingError, GeometryError, TetGenError

#: Strategies by name; "auto" takes the best.
SOLID_METHODS = ("auto", "mapped", "primitive", "submap", "sweep", "mid-point", "cut", "tet-to-hex")
FACE_METHODS = ("auto", "mapped", "mid-point", "ring", "general")
METHODS = SOLID_METHODS + FACE_METHODS[3:]
#: How far a patch may be from its face, as a part of the face's size, when nothing is asked for.
FACE_TOLERANCE = 1e-3


def fit(
    shape: Any,
    size: Optional[float] = None,
    tolerance: Optional[float] = None,
    method: str = "auto",
    progress: Optional[Callable[[float], Any]] = None,
    entities: Optional[Sequence[str]] = None,
    counts: Optional[Mapping[str, int]] = None,
) -> BlockModel:
    """Blocks over CAD: 20-node blocks in solids, or 8-node patches over faces.

    shape: a Part.Shape, a list of them, or a document object. Solids are filled if it has any, else
    its faces are covered. size: wanted length of an element's edge; None for a thirtieth of the
    shape's diagonal, finer by curvature, coarser where that makes too many cells. tolerance: blocks
    are halved until no face of theirs is farther than this from its CAD face, or there are
    thousands; None for a thousandth of the size of the face, or of the diagonal with solids. What
    was reached is in the report.
    method: one of METHODS. "auto" takes the structured strategy with the best blocks and, where
    none applies, tet-to-hex, which splits tetrahedra. Solids that touch share nodes: either all
    of them are structured, or none.
    entities: only these, all faces ("Face3", ...) or all solids ("Solid1", ...).
    counts: elements along edges, {"Edge3": 12, ...}: along chains of blocks where these allow it,
    else faces are laid out anew so that each keeps to its own; solids take them along chains only.
    The model's report has an entry a face or solid: method, and in words why no other applies.
    Raises GeometryError when the shape, or what is picked of it, is empty, not valid or without
    end, BlockingError when no block could be made or counts contradict each other, ValueError.
    """
    numbers = edge_numbers(counts)
    if method not in METHODS:
        raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")
    if size is not None and not size > 0:
        raise ValueError(f"size: expected a length above 0, got {size!r}")
    if tolerance is not None and not tolerance > 0:
        raise ValueError(f"tolerance: expected a length above 0, got {tolerance!r}")
    part = as_shape(shape)
    dimension, indices = picked(part, entities)
    check_valid(part, dimension, indices)
    kernel = _kernel.cad()
    cad_shape = kernel.CadShape(brep_bytes(part))
    accepted = 1e-3 * cad_shape.diagonal if tolerance is None else float(tolerance)
    of_face = FACE_TOLERANCE if dimension == 2 and tolerance is None else 0.0
    if dimension == 3 and method == tet_to_hexas.METHOD:
        raw = _with_tets(cad_shape, _nothing(indices), accepted, progress)
    else:
        raw = kernel.fit(cad_shape, dimension, indices, accepted, method, progress, of_face)
        if dimension == 3 and method == "auto":
            raw = _with_tets(cad_shape, raw, accepted, progress)
    model = _sized(cad_shape, raw, size)
    if not numbers:
        return model
    try:
        sizing.set_edge_counts(model, counts or {})
        return model
    except BlockingError:
        if dimension == 3:
            raise
    raw = kernel.fit(cad_shape, 2, indices, accepted, method, progress, of_face, numbers)
    left = [entry for entry in raw["report"] if not entry["method"]]
    if left:
        reasons = [entry["reason"] for entry in left]
        names = [entry["entity"] for entry in left]
        raise BlockingError("counts: " + "; ".join(reasons), names + list(counts or ()), reasons)
    model = _sized(cad_shape, raw, size)
    sizing.set_edge_counts(model, counts or {})
    return model


def edge_numbers(counts: Optional[Mapping[str, int]]) -> Dict[int, int]:
    """{3: 12, ...} of {"Edge3": 12, ...}. Raises ValueError."""
    result = {}
    for name, count in (counts or {}).items():
        number = name[4:] if isinstance(name, str) and name.startswith("Edge") else ""
        if not number.isdigit() or not int(number):
            raise ValueError(f"counts: expected names like Edge3, got {name!r}")
        if isinstance(count, bool) or count != int(count) or count < 1:
            raise ValueError(f"counts: expected a whole number from 1 on, got {count!r} for {name}")
        result[int(number)] = int(count)
    return result


def _sized(shape: Any, raw: Dict[str, Any], size: Optional[float]) -> BlockModel:
    """The model of what the kernel's fit() returned, with its divisions."""
    report = raw["report"]
    if not len(raw["nodes"]):
        names = [entry["entity"] for entry in report]
        reasons = [entry["reason"] for entry in report]
        raise BlockingError("no blocks: " + "; ".join(reasons), names, reasons)
    model = linked(shape, raw)
    divide(model, size)
    return model


def divide(
    model: BlockModel, size: Optional[float], counts: Optional[Mapping[str, int]] = None
) -> None:
    """Divisions of a fitted model by size, None for the default ones, and by counts on edges, as
    fit has them. Raises as sizing.set_edge_counts does."""
    if size is None:
        default_divisions(model)
    else:
        model.set_divisions(float(size))
    if counts:
        sizing.set_edge_counts(model, counts)


def linked(shape: Any, raw: Dict[str, Any]) -> BlockModel:
    """The model of what the kernel's fit() returned for its CadShape."""
    model = BlockModel(raw["nodes"], 1)
    model.cad = CadLink(shape, raw["offsets"], raw["entities"], raw["corners"])
    model.cad.whole = raw.get("whole")
    model.report = raw["report"]
    return model


def default_divisions(model: BlockModel) -> None:
    """Divisions for a fitted model when no size is given: elements no longer than a thirtieth of
    the shape's diagonal that turn by ten degrees at most and keep each solid's volume, and no more
    than 200 000 of them."""
    link: CadLink = model.cad  # type: ignore[assignment]
    if link.whole is not None and link.whole.all():
        return
    part = np.zeros(len(model.nodes), np.int32)
    for n, entry in enumerate(model.report):
        part[entry["first_block"] : entry["first_block"] + entry["blocks"]] = n
    model.divisions = _kernel.core().default_divisions(
        model.nodes,
        model.divisions,
        link.shape.diagonal / 30,
        corners=link.corners,
        part=part,
        structured=[entry["method"] != tet_to_hexas.METHOD for entry in model.report],
    )
    if link.whole is not None:
        divisions = model.divisions.copy()
        divisions[link.whole] = 1
        model.divisions = divisions


def _with_tets(
    shape: Any,
    raw: Dict[str, Any],
    tolerance: float,
    progress: Optional[Callable[[float], Any]],
) -> Dict[str, Any]:
    """Fills the solids that no structured strategy did, one group of solids that touch after the
    other. A group that TetGen cannot do either keeps its reasons, and gains one."""
    left = [entry for entry in raw["report"] if not entry["method"]]
    parts = [raw]
    solids = [int(entry["entity"][5:]) for entry in left]
    for group in _kernel.cad().joined_solids(shape, solids):
        entries = [entry for entry in left if int(entry["entity"][5:]) in group]
        filled, reasons = _filled(shape, group, tolerance, progress)
        for entry in entries:
            if int(entry["entity"][5:]) in reasons:
                reason = f"{tet_to_hexas.METHOD}: {reasons[int(entry['entity'][5:])]}"
                entry["reason"] = "; ".join(filter(None, (entry["reason"], reason)))
        if filled is None:
            continue
        known = {entry["entity"]: entry["reason"] for entry in entries}
        blockers = {entry["entity"]: entry["blockers"] for entry in entries}
        for entry in filled["report"]:
            entry["reason"] = known[entry["entity"]]
            entry["blockers"] = blockers[entry["entity"]]
        parts.append(filled)
    return raw if len(parts) == 1 else _joined_fits(parts)


def _nothing(solids: Sequence[int]) -> Dict[str, Any]:
    """What fit() returns where it can do nothing."""
    entry = dict(method="", reason="", blockers=[], first_block=0, blocks=0, error=0.0, quality=0.0)
    return {
        "nodes": np.empty((0, 20, 3)),
        "entities": np.empty((0, 2), np.int32),
        "report": [dict(entry, entity=f"Solid{n}", place=(0.0, 0.0, 0.0)) for n in solids],
    }


def _filled(
    shape: Any,
    solids: Sequence[int],
    tolerance: float,
    progress: Optional[Callable[[float], Any]],
) -> Tuple[Optional[Dict[str, Any]], Dict[int, str]]:
    """Blocks of as many of the solids as can be filled together; the others' reasons."""
    left, reasons = list(solids), {}
    while left:
        try:
            return tet_to_hexas.fill(shape, left, tolerance, progress), reasons
        except (BlockingError, GeometryError, TetGenError) as error:
            named = {f"Solid{n}": n for n in left}
            bad = [named[name] for name in getattr(error, "entities", ()) if name in named]
            if not bad and len(left) > 1:
                bad = [n for n in left if not _has_skin(shape, n)]
            for n in bad or left:
                reasons[n] = str(error)
            left = [n for n in left if n not in reasons]
    return None, reasons


def _has_skin(shape: Any, solid: int) -> bool:
    faces = sorted({face for face, _ in _kernel.cad().solid_faces(shape, solid)})
    try:
        _kernel.cad().make_skin(shape, faces)
    except GeometryError:
        return False
    return True


def _joined_fits(parts: Sequence[Dict[str, Any]]) -> Dict[str, Any]:
    """Several answers of the kernel's fit() as one; the report in the solids' order."""
    entries: Dict[str, Dict[str, Any]] = {}
    blocks = points = ends = 0
    offsets, corners = [np.zeros(1, np.int32)], []
    for part in parts:
        for entry in part["report"]:
            if entry["method"]:
                entry["first_block"] += blocks
            if entry["method"] or entry["entity"] not in entries:
                entries[entry["entity"]] = entry
        if not len(part["nodes"]):
            continue
        offsets.append(part["offsets"][1:] + ends)
        corners.append(part["corners"] + points)
        blocks += len(part["nodes"])
        ends += len(part["entities"])
        points += int(part["corners"].max()) + 1
    ends_of = np.concatenate(offsets)
    entities = np.concatenate([part["entities"] for part in parts])
    return {
        "nodes": np.concatenate([part["nodes"] for part in parts if len(part["nodes"])]),
        "offsets": ends_of,
        "entities": entities,
        "corners": _one_a_vertex(np.concatenate(corners), ends_of, entities),
        "whole": np.concatenate(
            [
                part.get("whole", np.zeros(len(part["nodes"]), bool))
                for part in parts
                if len(part["nodes"])
            ]
        ),
        "report": sorted(entries.values(), key=lambda entry: int(entry["entity"][5:])),
    }


def _one_a_vertex(corners: np.ndarray, offsets: np.ndarray, entities: np.ndarray) -> np.ndarray:
    """The blocks' corners with one number for each vertex of the CAD, where solids that share no
    face may touch."""
    codes = np.array(
        [a + 3 * b + 9 * c for c in (0, 2) for a, b in ((0, 0), (2, 0), (2, 2), (0, 2))]
    )
    numbers = corners.reshape(-1)
    rows = (27 * np.arange(len(numbers) // 8)[:, None] + codes).reshape(-1)
    bound = np.flatnonzero(offsets[rows + 1] > offsets[rows])
    on = entities[offsets[rows[bound]]]
    bound, vertices = bound[on[:, 0] == 0], on[on[:, 0] == 0, 1]
    if not len(bound):
        return corners
    first = np.full(vertices.max() + 1, np.iinfo(numbers.dtype).max, numbers.dtype)
    np.minimum.at(first, vertices, numbers[bound])
    renumbered = np.arange(numbers.max() + 1, dtype=numbers.dtype)
    renumbered[numbers[bound]] = first[vertices]
    return renumbered[numbers].reshape(corners.shape)


def as_shape(source: Any) -> Any:
    """The Part.Shape of a shape, a document object or a list of either. Raises TypeError."""
    if isinstance(source, (list, tuple)):
        if not source:
            raise GeometryError("shape: the list is empty")
        import Part  # only here: a single shape needs no import

        shapes = [as_shape(item) for item in source]
        return shapes[0] if len(shapes) == 1 else Part.makeCompound(shapes)
    shape = source if hasattr(source, "exportBinary") else getattr(source, "Shape", None)
    if shape is None or not hasattr(shape, "exportBinary"):
        raise TypeError(
            f"shape: expected a Part.Shape or a document object with one, got {source!r}"
        )
    if shape.isNull():
        raise GeometryError("shape: it is empty")
    return shape


def brep_bytes(shape: Any) -> bytes:
    """OpenCASCADE's text BREP of a Part.Shape, in memory. (FreeCAD's exportBinary needs a file, and
    what follows the shapes in it is FreeCAD's own, not OpenCASCADE's.)"""
    return shape.exportBrepToString().encode("ascii")


def picked(shape: Any, entities: Optional[Sequence[str]]) -> Tuple[int, List[int]]:
    counts = {"Solid": len(shape.Solids), "Face": len(shape.Faces)}
    if entities is None:
        kind = "Solid" if counts["Solid"] else "Face"
        if not counts[kind]:
            raise GeometryError("shape: it has no faces")
        return (3 if kind == "Solid" else 2), list(range(1, counts[kind] + 1))
    if not len(entities):
        raise ValueError("entities: nothing is picked")
    indices: List[int] = []
    kinds = set()
    for name in entities:
        kind = name.rstrip("0123456789")
        number = name[len(kind) :]
        if kind not in counts or not number or not 1 <= int(number) <= counts[kind]:
            raise ValueError(
                f"entities: expected Face1 to Face{counts['Face']} or Solid1 to "
                f"Solid{counts['Solid']}, got {name!r}"
            )
        kinds.add(kind)
        if int(number) not in indices:
            indices.append(int(number))
    if len(kinds) != 1:
        raise ValueError(f"entities: expected faces only or solids only, got {list(entities)!r}")
    return (3 if kinds == {"Solid"} else 2), indices


def check_valid(shape: Any, dimension: int, indices: Sequence[int]) -> None:
    parts = shape.Solids if dimension == 3 else shape.Faces
    kind = "Solid" if dimension == 3 else "Face"
    endless = [f"{kind}{n}" for n in indices if not _has_end(parts[n - 1])]
    if endless:
        raise GeometryError(
            f"shape: {', '.join(endless)} has no end: cut it, or bound it by edges", endless
        )
    bad = [f"{kind}{n}" for n in indices if not parts[n - 1].isValid()]
    if bad:
        raise GeometryError(
            f"shape: {', '.join(bad)} is not valid geometry (Part > Check Geometry tells more)", bad
        )


def _has_end(part: Any) -> bool:
    """OpenCASCADE counts parameters and lengths from 1e100 on as infinite."""
    ranges = [value for face in part.Faces for value in face.ParameterRange]
    box = part.BoundBox
    ends = [box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax]
    return all(abs(value) < 1e50 for value in ranges + ends)


def generate_on_cad(
    model: BlockModel,
    order: int,
    tolerance: float,
    progress: Optional[Callable[[float], Any]],
    force: bool = False,
) -> dict:
    """The kernel's mesh of a fitted model: points, cells and groups."""
    link: CadLink = model.cad  # type: ignore[assignment]
    return _kernel.cad().generate(
        link.shape,
        model.nodes,
        model.divisions,
        model.spacing,
        link.offsets,
        link.entities,
        order=order,
        tolerance=tolerance,
        force=force,
        progress=progress,
        corners=link.corners,
    )
