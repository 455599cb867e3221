# SPDX-License-Identifier: LGPL-2.1-or-later
"""TetGen's own formats, GiD's, OFF, STL and Medit's: against text written here and meshio."""

import meshio
import numpy as np
import pytest
from tetgen_cases import CUBE, CUBE_FACETS, check_mesh, cube

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.nmgs.surface_files import plc_of_file

POLY = """# a cube with a square hole in its bottom
8 3 1 1   # attributes and markers
1  0 0 0  0.5 7
2  1 0 0  1D1
3  1 1 0  2 -3
4  0 1 0  3
5  0 0 1  4
6  1 0 1  5
7  1 1 1  6

8  0 1 1  7
3 1
2 1 9
4  1 2
   3 4
3  1 2 3
1  0.5 0.5 0
1
4  5 6 7 8
1 0 -2
2  1 5
1
1  0.5 0.5 0.5
2
1  0.1 0.1 0.1  3 0.25
2  0.2 0.2 0.2  4
"""


def write(tmp_path, name, text):
    path = tmp_path / name
    path.write_text(text)
    return path


def arrays(plc):
    names = "points polygon_nodes polygon_offsets facet_offsets markers point_markers".split()
    names += "point_attributes facet_holes facet_hole_offsets holes regions".split()
    return {name: getattr(plc, name) for name in names}


def assert_same(a, b):
    for name, value in arrays(a).items():
        other = getattr(b, name)
        assert (value is None) == (other is None), name
        assert value is None or np.array_equal(value, other), name


def test_poly_in_full(tmp_path):
    plc = nmgs.read(write(tmp_path, "a.poly", POLY))
    assert len(plc.points) == 8
    assert plc.point_attributes[:, 0].tolist() == [0.5, 10, 2, 3, 4, 5, 6, 7]
    assert plc.point_markers.tolist() == [7, 0, -3, 0, 0, 0, 0, 0]
    assert [[ring.tolist() for ring in plc.facet(f)] for f in range(3)] == [
        [[0, 1, 2, 3], [0, 1, 2]],
        [[4, 5, 6, 7]],
        [[0, 4]],
    ]
    assert plc.markers.tolist() == [9, 0, -2]
    assert plc.facet_holes.tolist() == [[0.5, 0.5, 0]]
    assert plc.facet_hole_offsets.tolist() == [0, 1, 1, 1]
    assert plc.holes.tolist() == [[0.5, 0.5, 0.5]]
    assert plc.regions.tolist() == [[0.1, 0.1, 0.1, 3, 0.25], [0.2, 0.2, 0.2, 4, 4]]
    nmgs.write(tmp_path / "b.poly", plc)
    assert_same(plc, nmgs.read(tmp_path / "b.poly"))
    nmgs.write(tmp_path / "c.poly", plc, first=0)
    assert_same(plc, nmgs.read(tmp_path / "c.poly"))


def test_poly_with_points_in_a_node_file(tmp_path):
    write(tmp_path, "a.node", "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n")
    plc = nmgs.read(write(tmp_path, "a.poly", "0 3 0 0\n1 0\n1\n3 0 1 3\n0\n0\n"))
    assert plc.facet(0)[0].tolist() == [0, 1, 3]
    smesh = nmgs.read(write(tmp_path, "a.smesh", "0 3 0 0\r\n1 1\r\n3 0 1 3 5\r\n0\r\n"))
    assert smesh.markers.tolist() == [5]


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        ("3  1 1 0  2 -3", "3  1 x 0  2 -3", 5),
        ("8 3 1 1 ", "8 2 1 1 ", 2),
        ("4  5 6 7 8", "4  5 6 7 9", 19),
        ("8 3 1 1 ", "800000000 3 1 1 ", 2),
        ("1  0.5 0.5 0.5", "1  0.5 0.5", 23),
        ("3  1 1 0  2 -3", "4  1 1 0  2 -3", 5),
    ],
)
def test_bad_poly_names_file_and_line(tmp_path, old, new, line):
    assert old in POLY
    path = write(tmp_path, "a.poly", POLY.replace(old, new, 1))
    with pytest.raises(nmgs.FormatError) as caught:
        nmgs.read(path)
    assert caught.value.path == str(path)
    assert caught.value.line == line


@pytest.mark.parametrize("cut", range(0, len(POLY) - 40, 37))
def test_a_truncated_poly_is_an_error_or_ends_at_a_section(tmp_path, cut):
    path = write(tmp_path, "a.poly", POLY[:cut])
    try:
        plc = nmgs.read(path)
    except nmgs.FormatError as error:
        assert error.path == str(path)
    else:
        assert len(plc) in (0, 3)


def test_mesh_files_go_there_and_back(tmp_path):
    plc = cube(markers=[1, 2, 3, 4, 5, 6], regions=[[0.5, 0.5, 0.5, 2]])
    for switches in ("pqAa0.05nef", "pqAo2a0.2"):
        mesh = nmgs.tetrahedralize(plc, switches)
        nmgs.write(tmp_path / "m.ele", mesh)
        nmgs.write(tmp_path / "m.face", mesh)
        again = nmgs.read(tmp_path / "m.ele")
        assert np.array_equal(again.points, mesh.points)
        assert set(again.cells) == set(mesh.cells)
        for kind in mesh.cells:
            assert np.array_equal(again.cells[kind], mesh.cells[kind])
        assert np.array_equal(again.groups["Region2"][1], mesh.groups["Region2"][1])
        for n in range(1, 7):
            assert np.array_equal(again.groups[f"Facet{n}"][1], mesh.groups[f"Facet{n}"][1])
    mesh = nmgs.tetrahedralize(plc, "pqa0.05n")
    nmgs.write(tmp_path / "m.neigh", mesh)
    assert np.array_equal(nmgs.read(tmp_path / "m.neigh"), mesh.tetgen.neighbours)


def test_meshio_reads_what_is_written(tmp_path):
    mesh = nmgs.tetrahedralize(cube(), "pqa0.05")
    nmgs.write(tmp_path / "m.ele", mesh, first=0)
    raw = meshio.read(tmp_path / "m.ele")
    assert np.array_equal(raw.points, mesh.points)
    assert np.array_equal(raw.cells_dict["tetra"], mesh.cells["tetra"])
    surface = nmgs.Mesh(mesh.points, {"triangle": mesh.cells["triangle"]})
    nmgs.write(tmp_path / "m.off", surface)
    assert np.array_equal(
        meshio.read(tmp_path / "m.off").cells_dict["triangle"], surface.cells["triangle"]
    )
    for binary in (True, False):
        nmgs.write(tmp_path / "m.stl", surface, binary=binary)
        raw = meshio.read(tmp_path / "m.stl")
        assert len(raw.cells_dict["triangle"]) == len(surface.cells["triangle"])
        ours = nmgs.read(tmp_path / "m.stl")
        corners = ours.points[ours.cells["triangle"]]
        wanted = surface.points[surface.cells["triangle"]]
        assert np.array_equal(corners, wanted.astype(np.float32) if binary else wanted)


def test_stl_tells_binary_by_its_size(tmp_path):
    surface = nmgs.Mesh(CUBE, {"triangle": np.array([f[:3] for f in CUBE_FACETS])})
    nmgs.write(tmp_path / "a.stl", surface)
    data = (tmp_path / "a.stl").read_bytes()
    (tmp_path / "b.stl").write_bytes(b"solid like text" + data[15:])
    assert len(nmgs.read(tmp_path / "b.stl").cells["triangle"]) == 6
    assert len(plc_of_file(str(tmp_path / "b.stl")).points) == 18
    (tmp_path / "c.stl").write_bytes(data[:-1])
    with pytest.raises(nmgs.FormatError, match="solid"):
        nmgs.read(tmp_path / "c.stl")


GID = """#made by hand
"mesh dimension = 3 elemtype tetrahedron nnode = 4"
any words
coordinates
 1 0 0 0
 2 1 0 0
 3 0 1 0
 7 0 0 1
end coordinates

elements
1  1 2 3 7
end elements
"""


def test_gid_in_both_spellings(tmp_path):
    mesh = nmgs.read(write(tmp_path, "a.ele.gid", GID))
    assert mesh.cells["tetra"].tolist() == [[0, 1, 2, 3]]
    own = GID.replace(
        '"mesh dimension = 3 elemtype tetrahedron nnode = 4"',
        "MESH dimension 3 " "ElemType Tetrahedra Nnode 4",
    ).replace("end elements", "End Elements")
    assert nmgs.read(write(tmp_path, "b.ele.gid", own)).cells["tetra"].tolist() == [[0, 1, 2, 3]]
    big = nmgs.tetrahedralize(cube(), "pq")
    nmgs.write(tmp_path / "c.ele.gid", big)
    nmgs.write(tmp_path / "c.face.gid", big)
    assert np.array_equal(nmgs.read(tmp_path / "c.ele.gid").cells["tetra"], big.cells["tetra"])
    faces = nmgs.read(tmp_path / "c.face.gid")
    assert np.array_equal(faces.cells["triangle"], big.cells["triangle"])
    assert np.array_equal(faces.points, big.points)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("1 2 3 7", "1 2 3 4"),
        ("nnode = 4", "nnode = 5"),
        ("end elements", ""),
        (" 7 0 0 1", " 7 0 0"),
    ],
)
def test_bad_gid(tmp_path, old, new):
    with pytest.raises(nmgs.FormatError):
        nmgs.read(write(tmp_path, "a.ele.gid", GID.replace(old, new)))


MEDIT = """MeshVersionFormatted 1
Dimension 3
Vertices
4
0.1 0 0 1
1 0 0 1
0 1 0 1
0 0 1 1
Corners 2
1 2
Triangles
2
1 2 3 5
1 2 4 0
Tetrahedra
1
1 2 3 4 8
End
"""


def test_medit_keeps_double_precision(tmp_path):
    mesh = nmgs.read(write(tmp_path, "a.mesh", MEDIT))
    assert mesh.points[0, 0] == 0.1
    assert mesh.cells["tetra"].tolist() == [[0, 1, 2, 3]]
    assert mesh.groups["Facet5"][1].tolist() == [0]
    assert mesh.groups["Region8"][1].tolist() == [0]
    assert plc_of_file(str(tmp_path / "a.mesh")).markers.tolist() == [5, 0]
    with pytest.raises(nmgs.FormatError, match="a.mesh:17"):
        nmgs.read(write(tmp_path, "a.mesh", MEDIT.replace("1 2 3 4 8", "1 2 3 9 8")))


def test_off_with_polygons_and_colours(tmp_path):
    text = "COFF # comment\n5 2 0\n0 0 0 255 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 2 0\n"
    text += "5 0 1 2 4 3 0 0 1\n3 0 1 2\n"
    plc = nmgs.read(write(tmp_path, "a.off", text))
    assert [plc.facet(f)[0].tolist() for f in range(2)] == [[0, 1, 2, 4, 3], [0, 1, 2]]
    with pytest.raises(nmgs.FormatError, match="a.off:9"):
        nmgs.read(write(tmp_path, "a.off", text.replace("3 0 1 2\n", "3 0 1 5\n")))


def test_missing_points_are_named(tmp_path):
    with pytest.raises(nmgs.FormatError, match="points are missing"):
        nmgs.read(write(tmp_path, "a.ele", "0 4 0\n"))
    with pytest.raises(FileNotFoundError):
        nmgs.read(tmp_path / "none.ele")


def test_results_of_the_program_are_read(tmp_path):
    mesh = nmgs.tetrahedralize(cube(), "pqa0.05")
    check_mesh(mesh, volume=1.0)
    write(tmp_path, "x.node", "# none\n4  3  0  0\n 0 0 0 0\n 1 1 0 0\n 2 0 1 0\n 3 0 0 1\n# end")
    write(tmp_path, "x.face", "1  1\n 0  0 1 2  -1\n# Generated by tetgen\n")
    write(tmp_path, "x.edge", "1  1\n 0  0 1  3\n")
    ele = write(tmp_path, "x.ele", "1  4  1\n 0  0 1 2 3  5.5\n# Generated by tetgen\n")
    mesh = nmgs.read(ele)
    assert mesh.groups["Facet-1"][1].tolist() == [0]
    assert mesh.groups["Region5.5"][1].tolist() == [0]
    assert nmgs.read(tmp_path / "x.edge").groups["Edge3"][1].tolist() == [0]
