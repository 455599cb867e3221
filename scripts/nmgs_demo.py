# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demo's job, run by scripts/demo inside FreeCAD with a window: STEP solid to solved hexahedra.

Environment: NMGS_DEMO_STEP, NMGS_DEMO_OUT. Leaves files and pictures there, prints a table, and
exits with 0 or, after the reason, with 1.
"""

import os
import sys
import time
import traceback

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.fem import analysis as fem_analysis
from freecad.NMGSWorkbench.objects import blocks, structured_mesh, tetgen_mesh

STEP = os.environ["NMGS_DEMO_STEP"]
OUT = os.environ["NMGS_DEMO_OUT"]
SIZE = 5.0  # mm, wanted length of an element's edge
FORCE = 500.0  # N
HEAD = ("", "nodes", "elements", "worst scaled J", "volume error", "displacement", "seconds")
rows = []


def say(text):
    """One line for the user; FreeCAD and CalculiX talk on the same stream, without the mark."""
    sys.__stdout__.write("".join(f"NMGS| {line}\n" for line in text.split("\n")))
    sys.__stdout__.flush()


def row(name, seconds, mesh=None, volume=None, displacement=None):
    """One line of the table; mesh: of volume cells, volume: the CAD's."""
    cells = ["", "", "", ""]
    if mesh is not None:
        report = mesh.report()
        kinds = [k for k in mesh.cells if k.startswith(("hexahedron", "tetra"))]
        quality = mesh.quality()
        cells = [
            f"{len(mesh.points)}",
            f"{sum(len(mesh.cells[k]) for k in kinds)}",
            f"{min(quality[k].min() for k in kinds):.3f}",
            f"{abs(report.volume / volume - 1):.1e}",
        ]
    move = "" if displacement is None else f"{displacement:.4f} mm"
    rows.append((name, *cells, move, f"{seconds:.2f}"))


def table():
    widths = [max(len(r[i]) for r in [HEAD, *rows]) for i in range(len(HEAD))]
    lines = []
    for r in [HEAD, *rows]:
        numbers = [cell.rjust(width) for cell, width in zip(r, widths)][1:]
        lines.append("  ".join([r[0].ljust(widths[0]), *numbers]).rstrip())
    return "\n".join(lines)


def timed(work):
    start = time.perf_counter()
    result = work()
    return result, time.perf_counter() - start


def recomputed(obj):
    obj.Document.recompute()
    if obj.Proxy.failure is not None:
        raise obj.Proxy.failure
    return obj


def picture(document, shown, name):
    """The 3D view with nothing but the shown objects, as OUT/name.png."""
    for obj in document.Objects:
        if obj.ViewObject is not None and hasattr(obj.ViewObject, "Visibility"):
            obj.ViewObject.Visibility = obj in shown
    view = FreeCADGui.getDocument(document.Name).activeView()
    view.viewIsometric()
    view.fitAll(0.75)
    FreeCADGui.updateGui()
    view.saveImage(os.path.join(OUT, name + ".png"), 1000, 1000, "White")


def overview(names):
    """The pictures side by side, with what they show, as OUT/overview.png."""
    width, height, line = 400, 470, 40
    sheet = QtGui.QImage(width * len(names), height, QtGui.QImage.Format_RGB32)
    sheet.fill(QtGui.QColor("white"))
    painter = QtGui.QPainter(sheet)
    painter.setFont(QtGui.QFont("Sans", 13))
    for column, (name, caption) in enumerate(names.items()):
        image = QtGui.QImage(os.path.join(OUT, name + ".png"))
        image = image.scaled(
            width, height - line, QtCore.Qt.KeepAspectRatio, QtCore.Qt.SmoothTransformation
        )
        painter.drawImage(column * width + (width - image.width()) // 2, 0, image)
        box = QtCore.QRect(column * width, height - line, width, line)
        painter.drawText(box, int(QtCore.Qt.AlignCenter), caption)
    painter.end()
    if not sheet.save(os.path.join(OUT, "overview.png")):
        raise OSError(f"{OUT}/overview.png could not be written")


def rainbow(share):
    """Blue over green to red for 0 to 1."""
    red, green, blue = (1.5 - abs(4 * share - k) for k in (3, 2, 1))
    return tuple(max(0.0, min(1.0, c)) for c in (red, green, blue))


def cut_open(document, mesh):
    """A mesh object with the tetrahedra behind the plane through the middle, across y."""
    tetra = mesh.cells["tetra"]
    middle = mesh.points[tetra].mean(axis=1)
    half = tetra[middle[:, 1] > np.median(mesh.points[:, 1])]
    return nmgs.to_fem(nmgs.Mesh(mesh.points, {"tetra": half}), document, "TetGenCutOpen")


def job():
    say(f"== reading {os.path.basename(STEP)}")
    document = FreeCAD.newDocument("Demo")
    import Import

    Import.insert(STEP, document.Name)
    part = [o for o in document.Objects if getattr(o, "Shape", None) and o.Shape.Solids][0]
    volume = part.Shape.Volume
    document.recompute()

    say("== fitting 20-node blocks")
    model = blocks.make(document)
    model.Source = [(part, ("Solid1",))]
    model.Size = SIZE
    _, seconds = timed(lambda: recomputed(model))
    rows.append((f"{model.ElementCount} blocks", "", "", "", "", "", f"{seconds:.2f}"))
    part.ViewObject.Transparency = 70
    picture(document, [part, model], "blocks")
    part.ViewObject.Transparency = 0

    meshes = {}
    for order, name in ((1, "hexahedra, 8 nodes"), (2, "hexahedra, 20 nodes")):
        say(f"== generating {name}")
        obj = structured_mesh.make(document, f"Hexahedra{'8' if order == 1 else '20'}")
        obj.Blocks = model
        obj.Order = order
        _, seconds = timed(lambda: recomputed(obj))
        meshes[order] = obj
        row(name, seconds, obj.Proxy.mesh(obj), volume)
    linear = meshes[1].Proxy.mesh(meshes[1])
    quadratic = meshes[2].Proxy.mesh(meshes[2])
    picture(document, [meshes[1]], "hexahedra")

    say("== splitting the hexahedra")
    split, seconds = timed(linear.split)
    row("12 tetrahedra a hexahedron", seconds, split, volume)

    say("== running TetGen on the same solid")
    tets = tetgen_mesh.make(document)
    tets.Source = [(part, ("Solid1",))]
    tets.Switches = f"pq1.4a{SIZE**3 / 6:g}"
    _, seconds = timed(lambda: recomputed(tets))
    tetgen = tets.Proxy.mesh(tets)
    row("TetGen " + tets.Switches, seconds, tetgen, volume)
    cut = cut_open(document, tetgen)
    picture(document, [cut], "tetgen")
    document.removeObject(cut.Name)

    say("== writing arm.n3s, arm.n3r, arm.inp, arm.vtu")
    base = os.path.join(OUT, "arm")

    def write():
        nmgs.write(base + ".n3s", linear.model)
        nmgs.write(base + ".n3r", linear)
        nmgs.write(base + ".inp", quadratic)
        nmgs.write(base + ".vtu", quadratic)

    _, seconds = timed(write)
    rows.append(("files", "", "", "", "", "", f"{seconds:.2f}"))

    say("== solving the 20-node hexahedra with CalculiX")
    ends = sorted(
        (f.CenterOfMass.z, n)
        for n, f in enumerate(part.Shape.Faces, 1)
        if f.Surface.TypeId == "Part::GeomPlane"
    )
    analysis = fem_analysis.static_analysis(
        part, meshes[2], [f"Face{ends[0][1]}"], [f"Face{ends[-1][1]}"], FORCE
    )
    result, seconds = timed(lambda: fem_analysis.solve(analysis))
    row("CalculiX, 20 nodes", seconds, quadratic, volume, max(result.DisplacementLengths))
    shown = result.Mesh
    largest = max(result.DisplacementLengths)
    colours = [rainbow(length / largest) for length in result.DisplacementLengths]
    shown.ViewObject.NodeColor = dict(zip(result.NodeNumbers, colours))
    shown.ViewObject.setNodeDisplacementByVectors(result.NodeNumbers, result.DisplacementVectors)
    shown.ViewObject.applyDisplacement(10.0 / largest)
    picture(document, [shown], "displacement")
    overview(
        {
            "blocks": f"{model.ElementCount} blocks of 20 nodes",
            "hexahedra": f"{meshes[1].ElementCount} hexahedra",
            "tetgen": f"{tets.ElementCount} tetrahedra by TetGen, cut open",
            "displacement": "displacement by CalculiX, enlarged",
        }
    )
    document.saveAs(os.path.join(OUT, "arm.FCStd"))


def go():
    code = 0
    try:
        job()
        text = table()
        with open(os.path.join(OUT, "table.txt"), "w", encoding="utf-8") as file:
            file.write(text + "\n")
        say("\n" + text + "\n")
    except BaseException as error:
        traceback.print_exc(file=sys.__stderr__)
        sys.__stderr__.write(f"error: {error}\n")
        code = 1
    sys.__stdout__.flush()
    sys.__stderr__.flush()
    # FreeCAD asks whether to save; the demo has what it wants.
    os._exit(code)


QtCore.QTimer.singleShot(1500, go)
