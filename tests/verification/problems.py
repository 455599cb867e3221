# SPDX-License-Identifier: LGPL-2.1-or-later
"""Problems with known answers: CAD by FreeCAD's Part, what holds it, what loads it, what to read.

Numbers are in the problem's own consistent units; CAD lengths are FreeCAD's, one to one.
"""

import dataclasses
import math
from typing import Any, Callable, Optional, Sequence

import FreeCAD  # noqa: F401  (before Part)
import numpy as np
import Part
from FreeCAD import Vector
from loads import faces_where, forces, nodes_of

Z = Vector(0, 0, 1)


@dataclasses.dataclass
class Problem:
    """shape(): the CAD. held: (faces as a function of points, degrees of freedom); held_nodes: the
    same with nodes. loads: (faces as a function of points, traction(places, normals)).
    measure(mesh, results): the number to compare with reference. published: what the problem's
    authors found with elements of this kind and the documented mesh, where that is known. size: the
    element size of the documented mesh; sizes: those of the study, from coarse to fine. tet_sizes:
    the same for tetrahedra."""

    name: str
    title: str
    source: str
    shape: Callable[[], Any]
    young: float
    poisson: float
    held: Sequence[Any]
    loads: Sequence[Any]
    measure: Callable[[Any, Any], float]
    quantity: str
    reference: float
    size: float
    sizes: Sequence[float]
    tet_sizes: Sequence[float]
    held_nodes: Sequence[Any] = ()
    density: Optional[float] = None
    modes: int = 0
    note: str = ""
    published: Optional[float] = None

    def conditions(self, mesh):
        """(held rows, forces) for calculix.solve."""
        rows = set()
        for inside, directions in self.held:
            for node in nodes_of(faces_where(mesh, inside)):
                rows.update((int(node), d, 0.0) for d in directions)
        for inside, directions in self.held_nodes:
            chosen = np.flatnonzero(inside(mesh.points))
            if not len(chosen):
                raise ValueError(f"{self.name}: no node where one is to be held")
            for node in chosen:
                rows.update((int(node), d, 0.0) for d in directions)
        total = np.zeros((len(mesh.points), 3))
        for inside, traction in self.loads:
            total += forces(mesh, faces_where(mesh, inside), traction)
        return sorted(rows), (total if len(self.loads) else None)


def near(axis, value, tolerance=1e-6):
    return lambda p: np.abs(p[:, axis] - value) < tolerance


def node_at(mesh, place):
    """The number of the node at a place. Raises ValueError when there is none."""
    distance = np.linalg.norm(mesh.points - place, axis=1)
    if distance.min() > 1e-6:
        raise ValueError(f"no node at {place}: the nearest is {distance.min():g} away")
    return int(distance.argmin())


def constant(*force):
    return lambda places, normals: np.broadcast_to(np.array(force, float), places.shape)


def pressure(value):
    return lambda places, normals: -value * normals


def mean_move(axis, inside):
    """Mean displacement of the nodes of a face."""
    return lambda mesh, r: float(r.displacement[nodes_of(faces_where(mesh, inside)), axis].mean())


# --- NAFEMS LE1 and LE10: a quarter of a plate between two ellipses


def ellipse_quarter(height, layers=1):
    inner = Part.Ellipse(Vector(), 2.0, 1.0).toShape(0, math.pi / 2)
    outer = Part.Ellipse(Vector(), 3.25, 2.75).toShape(0, math.pi / 2)
    sides = [
        Part.makeLine(Vector(2, 0, 0), Vector(3.25, 0, 0)),
        Part.makeLine(Vector(0, 1, 0), Vector(0, 2.75, 0)),
    ]
    face = Part.Face(Part.Wire(Part.__sortEdges__([inner, outer, *sides])))
    solid = face.extrude(Z * (height / layers))
    parts = [solid.translated(Z * (n * height / layers)) for n in range(layers)]
    return solid if layers == 1 else parts[0].generalFuse(parts[1:])[0]


def on_ellipse(a, b):
    return lambda p: np.abs((p[:, 0] / a) ** 2 + (p[:, 1] / b) ** 2 - 1) < 1e-3


LE1 = Problem(
    "le1",
    "NAFEMS LE1, elliptic membrane",
    "NAFEMS, The Standard NAFEMS Benchmarks, 1990",
    lambda: ellipse_quarter(0.1),
    210e9,
    0.3,
    [(near(0, 0.0), [0]), (near(1, 0.0), [1]), (near(2, 0.0), [2])],
    [(on_ellipse(3.25, 2.75), pressure(-10e6))],
    lambda mesh, r: float(r.stress[node_at(mesh, (2, 0, 0)), 1]) / 1e6,
    "stress yy at (2, 0), MPa",
    92.7,
    0.2,
    (0.8, 0.4, 0.2, 0.14, 0.1),
    (0.8, 0.4, 0.2, 0.14, 0.1),
    note="A solid 0.1 thick, held on the plane below: the membrane's plane stress.",
)

LE10 = Problem(
    "le10",
    "NAFEMS LE10, thick plate under pressure",
    "NAFEMS, The Standard NAFEMS Benchmarks, 1990",
    lambda: ellipse_quarter(0.6, layers=2),
    210e9,
    0.3,
    [
        (near(0, 0.0), [0]),
        (near(1, 0.0), [1]),
        (on_ellipse(3.25, 2.75), [0, 1]),
    ],
    [(near(2, 0.6), pressure(1e6))],
    lambda mesh, r: float(r.stress[node_at(mesh, (2, 0, 0.6)), 1]) / 1e6,
    "stress yy at (2, 0) on top, MPa",
    -5.38,
    0.25,
    (1.2, 0.8, 0.5, 0.25, 0.18),
    (1.0, 0.6, 0.4, 0.25, 0.18),
    held_nodes=[(lambda p: on_ellipse(3.25, 2.75)(p) & (np.abs(p[:, 2] - 0.3) < 1e-6), [2])],
    note="Two solids share the plane at mid-height, so that its edge carries nodes.",
)

# --- MacNeal and Harder's straight beam, with the pieces of their distorted meshes


def beam_pieces(lean):
    """Six solids of a beam of 6 x 0.2 x 0.1; the walls between lean by 45 degrees: lean(n) = 1 or
    -1 for wall n, 0 for upright ones."""
    solids = []
    for n in range(6):
        ends = []
        for wall in (n, n + 1):
            tilt = 0.1 * lean(wall) if 0 < wall < 6 else 0.0
            ends.append((wall - tilt, wall + tilt))
        (a, d), (b, c) = ends
        corners = [Vector(a, 0, 0), Vector(b, 0, 0), Vector(c, 0.2, 0), Vector(d, 0.2, 0)]
        face = Part.Face(Part.makePolygon([*corners, corners[0]]))
        solids.append(face.extrude(Z * 0.1))
    return solids[0].generalFuse(solids[1:])[0]


BEAMS = {
    "regular": ("a box", lambda: Part.makeBox(6, 0.2, 0.1)),
    "parallelogram": ("six parallelograms", lambda: beam_pieces(lambda wall: 1)),
    "trapezoid": ("six trapezoids", lambda: beam_pieces(lambda wall: 1 if wall % 2 else -1)),
}


def twist_angle(mesh, r):
    """Mean rotation of the end face about its middle, by least squares."""
    nodes = nodes_of(faces_where(mesh, near(0, 6.0)))
    arm = mesh.points[nodes] - mesh.points[nodes].mean(axis=0)
    moves = r.displacement[nodes] - r.displacement[nodes].mean(axis=0)
    turned = (arm[:, 1] * moves[:, 2] - arm[:, 2] * moves[:, 1]).sum()
    return float(turned / (arm[:, 1] ** 2 + arm[:, 2] ** 2).sum())


def three_root_corners(p):
    """Along the beam these hold it as a whole, and nothing more: the root is free to warp."""
    corners = [(0, 0, 0), (0, 0.2, 0), (0, 0, 0.1)]
    return np.any([np.linalg.norm(p - c, axis=1) < 1e-6 for c in corners], axis=0)


def torsion_angle():
    """Saint-Venant: torque times length over shear modulus times torsion constant (Timoshenko and
    Goodier, section 109), a rectangle of 0.2 x 0.1."""
    a, b = 0.2, 0.1
    odd = np.arange(1, 40, 2)
    series = (np.tanh(odd * math.pi * a / (2 * b)) / odd**5).sum()
    constant = a * b**3 / 3 * (1 - 192 / math.pi**5 * b / a * series)
    return 6 / (1e7 / 2.6 * constant)


def straight_beam(mesh, load):
    title, shape = BEAMS[mesh]
    area, polar = 0.2 * 0.1, 0.2 * 0.1 * (0.2**2 + 0.1**2) / 12
    end = near(0, 6.0)
    held = [(near(0, 0.0), [0, 1, 2])]
    held_nodes = ()
    if load == "twist":
        traction = lambda p, n: np.cross([1, 0, 0], p - [6, 0.1, 0.05]) / polar  # noqa: E731
        measure, reference = twist_angle, torsion_angle()
        held = [(near(0, 0.0), [1, 2])]
        held_nodes = [(three_root_corners, [0])]
    else:
        axis, reference = {
            "extension": (0, 3e-5),
            "in-plane": (1, 0.1081),
            "out-of-plane": (2, 0.4321),
        }[load]
        traction = constant(*(np.eye(3)[axis] / area))
        measure = mean_move(axis, end)
    return Problem(
        f"beam-{mesh}-{load}",
        f"MacNeal-Harder straight beam, {title}, {load}",
        "R. H. MacNeal, R. L. Harder, Finite Elements in Analysis and Design 1 (1985)"
        if load != "twist"
        else "Saint-Venant's torsion; Timoshenko and Goodier, Theory of Elasticity, section 109",
        shape,
        1e7,
        0.3,
        held,
        [(end, traction)],
        measure,
        "turn of the tip" if load == "twist" else "displacement of the tip",
        reference,
        0.2 if load != "twist" else 0.05,
        (2.0, 1.0, 0.5, 0.2, 0.1) if load != "twist" else (1.0, 0.1, 0.066, 0.05),
        (0.8, 0.4, 0.2, 0.1, 0.06),
        held_nodes=held_nodes,
        note="The root may warp, as the formula has it: 0.03208 in MacNeal and Harder's table is "
        "6 % below the formula's angle for this section."
        if load == "twist"
        else "",
    )


# --- MacNeal and Harder's curved beam


def curved_beam(load):
    axis, reference = {"in-plane": (1, 0.08734), "out-of-plane": (2, 0.5022)}[load]

    def shape():
        corners = [Vector(x, 0, z) for x, z in ((4.12, 0), (4.32, 0), (4.32, 0.1), (4.12, 0.1))]
        face = Part.Face(Part.makePolygon([*corners, corners[0]]))
        return face.revolve(Vector(), Z, 90)

    # Held where it begins at y = 0, loaded where it ends at x = 0, along the radius there.
    end = near(0, 0.0)
    return Problem(
        f"curved-{load}",
        f"MacNeal-Harder curved beam, {load}",
        "R. H. MacNeal, R. L. Harder, Finite Elements in Analysis and Design 1 (1985)",
        shape,
        1e7,
        0.25,
        [(near(1, 0.0), [0, 1, 2])],
        [(end, constant(*(np.eye(3)[axis] / (0.2 * 0.1))))],
        mean_move(axis, end),
        "displacement of the tip",
        reference,
        0.05,
        (1.2, 0.6, 0.2, 0.1, 0.05),
        (0.8, 0.4, 0.2, 0.1, 0.06),
    )


# --- Lamé's thick cylinder


def thick_cylinder(poisson):
    inner, outer, young = 3.0, 9.0, 1000.0

    def shape():
        corners = [Vector(x, 0, z) for x, z in ((inner, 0), (outer, 0), (outer, 1), (inner, 1))]
        face = Part.Face(Part.makePolygon([*corners, corners[0]]))
        return face.revolve(Vector(), Z, 90)

    def radius(p):
        return np.linalg.norm(p[:, :2], axis=1)

    def measure(mesh, r):
        nodes = nodes_of(faces_where(mesh, inside))
        p = mesh.points[nodes]
        return float(((p[:, :2] * r.displacement[nodes, :2]).sum(axis=1) / radius(p)).mean())

    def inside(p):
        return np.abs(radius(p) - inner) < 1e-3 * inner

    ratio = inner**2 / (outer**2 - inner**2)
    lame = (1 + poisson) / young * ratio * ((1 - 2 * poisson) * inner + outer**2 / inner)
    return Problem(
        f"cylinder-{poisson}",
        f"Thick cylinder, plane strain, Poisson's ratio {poisson}",
        "Lamé; MacNeal and Harder's nearly incompressible case",
        shape,
        young,
        poisson,
        [
            (near(0, 0.0), [0]),
            (near(1, 0.0), [1]),
            (lambda p: near(2, 0.0)(p), [2]),
            (lambda p: near(2, 1.0)(p), [2]),
        ],
        [(inside, pressure(1.0))],
        measure,
        "radial displacement inside",
        lame,
        1.0,
        (6.0, 3.0, 1.5, 1.0),
        (6.0, 3.0, 1.5, 1.0),
    )


# --- Cook's membrane


def cook_shape():
    corners = [Vector(*c) for c in ((0, 0, 0), (48, 44, 0), (48, 60, 0), (0, 44, 0))]
    return Part.Face(Part.makePolygon([*corners, corners[0]])).extrude(Z)


COOK = Problem(
    "cook",
    "Cook's membrane, plane stress",
    "R. D. Cook, J. Struct. Div. ASCE 100 (1974); converged value as quoted by many",
    cook_shape,
    1.0,
    1 / 3,
    [(near(0, 0.0), [0, 1]), (near(2, 0.0), [2])],
    [(near(0, 48.0), constant(0, 1 / 16, 0))],
    lambda mesh, r: float(
        r.displacement[np.linalg.norm(mesh.points - [48, 52, 0], axis=1).argmin(), 1]
    ),
    "deflection of the mid of the right edge",
    23.96,
    6.0,
    (48.0, 24.0, 12.0, 6.0, 4.0),
    (24.0, 12.0, 6.0, 4.0, 2.5),
    note="A solid of unit thickness, held on the plane below.",
)

# --- NAFEMS FV52, and the same plate on supports that plate theory means


def frequency(number):
    return lambda mesh, r: float(r.frequencies[number - 1])


def on_side(axis, value):
    return lambda p: np.abs(p[:, axis] - value) < 1e-6


def on_bottom_edges(p):
    sides = [on_side(axis, value)(p) for axis in (0, 1) for value in (0, 10)]
    return (np.abs(p[:, 2]) < 1e-6) & np.any(sides, axis=0)


def plate(number, reference, published):
    return Problem(
        f"fv52-{number}",
        f"NAFEMS FV52, plate on its bottom edges, frequency {number}",
        "NAFEMS, Selected Benchmarks for Natural Frequency Analysis, 1987",
        lambda: Part.makeBox(10, 10, 1),
        200e9,
        0.3,
        [],
        [],
        frequency(number),
        f"frequency {number}, Hz",
        reference,
        2.5,
        (5.0, 2.5, 1.25),
        (),
        held_nodes=[(on_bottom_edges, [2])],
        density=8000.0,
        modes=10,
        published=published,
    )


def supported_plate(number, reference):
    sides = [(on_side(0, v), [1, 2]) for v in (0, 10)] + [(on_side(1, v), [0, 2]) for v in (0, 10)]
    return Problem(
        f"plate-{number}",
        f"Thick plate, simply supported on its side faces, frequency {number}",
        "Mindlin's plate theory, the closed form that NAFEMS FV52 quotes",
        lambda: Part.makeBox(10, 10, 1),
        200e9,
        0.3,
        sides,
        [],
        frequency(number),
        f"frequency {number}, Hz",
        reference,
        2.0 if number < 6 else 1.0,
        (5.0, 2.5, 2.0, 1.0),
        (5.0, 2.5, 1.5, 1.0),
        density=8000.0,
        modes=6,
        note="u_z and the displacement along the side are held on the side faces; no lines, under "
        "which a solid gives way without limit as its mesh gets finer.",
    )


#: Of each frequency: the closed form, and what NAFEMS found with 4 x 4 x 1 elements of 20 nodes.
PLATE = {
    4: (45.897, 44.762),
    5: (109.44, 110.52),
    6: (109.44, 110.52),
    7: (167.89, 169.08),
    8: (193.59, 193.93),
    9: (206.19, 206.64),
    10: (206.19, 206.64),
}

PROBLEMS = [
    LE1,
    LE10,
    *(
        straight_beam(mesh, load)
        for mesh in BEAMS
        for load in ("extension", "in-plane", "out-of-plane", "twist")
    ),
    curved_beam("in-plane"),
    curved_beam("out-of-plane"),
    thick_cylinder(0.49),
    thick_cylinder(0.499),
    COOK,
    supported_plate(1, 45.897),
    supported_plate(2, 109.44),
    supported_plate(6, 167.89),
    *(plate(number, *references) for number, references in PLATE.items()),
]
