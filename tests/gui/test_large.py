# SPDX-License-Identifier: LGPL-2.1-or-later
"""Large meshes: shown by their boundary, handed to FEM when it asks. The window lives on."""

import subprocess
import time

import FreeCAD
import numpy as np
import pytest
from conftest import pick, process_events, run, screenshot, wait_until
from PySide import QtCore

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.objects import imported_mesh, make, preferences, structured_mesh
from freecad.NMGSWorkbench.objects.run import run as run_job

SIDE = 40  # elements, 64000 in all: more than FreeCAD's view is given at once


@pytest.fixture
def large(document):
    blocks = make.blocks_from_model(document, nmgs.shapes.cube(1.0, SIDE))
    mesh = structured_mesh.make(document)
    mesh.Blocks = blocks
    document.recompute()
    assert mesh.Proxy.failure is None and SIDE**3 > preferences.most_filled()
    return mesh


def test_its_boundary_is_shown_and_fem_gets_it_when_it_asks(document, large):
    assert large.ElementCount == SIDE**3 and large.FemMesh.VolumeCount == 0
    drawn = large.ViewObject.Proxy.scene.plot
    assert sum(len(p) for p in drawn.polygons) == 6 * SIDE**2
    screenshot("large")
    mesh = large.Proxy.mesh(large)
    analysis = document.addObject("Fem::FemAnalysis", "Analysis")
    analysis.addObject(large)
    assert large.FemMesh.HexaCount == SIDE**3 and large.FemMesh.NodeCount == (SIDE + 1) ** 3
    assert large.Proxy.mesh(large) is mesh


def test_it_is_saved_and_reopened(document, large, tmp_path):
    before = large.Proxy.mesh(large)
    path = str(tmp_path / "large.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    again = FreeCAD.openDocument(path).getObject("StructuredMesh")
    mesh = again.Proxy.mesh(again)
    assert np.array_equal(mesh.points, before.points)
    assert np.array_equal(mesh.cells["hexahedron"], before.cells["hexahedron"])
    assert set(mesh.groups) == set(before.groups)
    wait_until(lambda: again.ViewObject.Proxy.scene.plot is not None)


def test_undo_and_redo(document, large):
    before = large.Content
    document.openTransaction("Smaller")
    large.Blocks.Divisions = [3, 3, 3]
    document.recompute()
    document.commitTransaction()
    assert large.FemMesh.HexaCount == 27
    document.undo()
    assert large.Content == before and large.FemMesh.VolumeCount == 0
    assert len(large.Proxy.mesh(large).cells["hexahedron"]) == SIDE**3
    document.redo()
    assert large.FemMesh.HexaCount == 27 == len(large.Proxy.mesh(large).cells["hexahedron"])


CONTROL = """
import time
end, last, longest = time.monotonic() + 10, time.monotonic(), 0.0
while last < end:
    time.sleep(0.005)
    now = time.monotonic()
    longest, last = max(longest, now - last), now
print(longest)
"""


class Pulse:
    """The longest time for which the event loop did not come round."""

    def __init__(self):
        self.longest, self._last, self.beats = 0.0, None, 0
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._beat)
        self._timer.start(5)

    def _beat(self):
        now = time.monotonic()
        if self._last is not None:
            self.longest = max(self.longest, now - self._last)
        self._last, self.beats = now, self.beats + 1

    def stop(self):
        self._timer.stop()


def test_the_window_lives_on_during_a_long_job(document):
    """Kernel and Python work by turns, as in a real recompute, for ten seconds."""
    model = nmgs.shapes.ball(1.0, 12)

    def job(progress):
        end, rounds = time.monotonic() + 10.0, 0
        while time.monotonic() < end:
            mesh = model.generate().split()
            mesh.quality()
            sum(n * n for n in range(20000))
            rounds += 1
            progress(1.0 - (end - time.monotonic()) / 10.0)
        return rounds

    # A process that does nothing else tells how long the machine itself holds a process up.
    control = subprocess.Popen(["/usr/bin/python3", "-c", CONTROL], stdout=subprocess.PIPE)
    pulse = Pulse()
    assert run_job(job, "Ten seconds of work") > 0
    pulse.stop()
    held_up = float(control.communicate(timeout=60)[0])
    print(f"longest pause: {1000 * pulse.longest:.0f} ms, of the machine {1000 * held_up:.0f} ms")
    assert pulse.beats > 100
    assert pulse.longest < 0.1 + held_up


def test_a_mesh_of_no_blocks_is_drawn_too(document):
    mesh = nmgs.shapes.sphere_surface(1.0, 6).generate()
    obj = imported_mesh.make(document, mesh)
    process_events()
    pick(obj)
    assert len(obj.ViewObject.Proxy.scene.plot.polygons[1]) == obj.ElementCount
    obj.ViewObject.PlotAs = "Triangles or tetrahedra"
    assert len(obj.ViewObject.Proxy.scene.plot.polygons[0]) == 2 * obj.ElementCount
    run("NMGS_MeshReport")
