# SPDX-License-Identifier: LGPL-2.1-or-later
"""N2S, N3S, N2R, N3R: read(write(x)) is x to the bit; bad files are errors with a line."""

import os
import re

import numpy as np
import pytest
from block_helpers import QUAD8, unit_cube, unit_square
from hypothesis import given, settings
from hypothesis import strategies as st

from freecad.NMGSWorkbench import nmgs

IDS = {
    "n2s": "NMGS-SSMG Problem Setup File",
    "n3s": "NMGS-SVMG Problem Setup File",
    "n2r": "NMGS-SSMG Result File",
    "n3r": "NMGS-SVMG Result File",
}


def surface():
    model = nmgs.shapes.hemisphere(radius=np.pi, divisions=2)
    model.reference = "hémisphère, 日本 (x) "
    return model


def solid():
    return nmgs.BlockModel(
        [unit_cube((0.1, 0.2, 0.3), (0.7, 1 / 3, 1)), unit_cube((0.8, 0.2, 0.3), (0.7, 1 / 3, 1))],
        [(2, 1, 1), (1, 1, 1)],
        "two boxes",
    )


def example(kind):
    model = surface() if kind[1] == "2" else solid()
    return model if kind[2] == "s" else model.generate()


def same_models(a, b):
    assert a.nodes.tobytes() == b.nodes.tobytes()
    np.testing.assert_array_equal(a.divisions, b.divisions)
    assert a.reference == b.reference
    for x, y in zip(a.spacing, b.spacing):
        assert (x is None) == (y is None)
        assert x is None or x.tobytes() == y.tobytes()


def same(a, b):
    if isinstance(a, nmgs.BlockModel):
        return same_models(a, b)
    assert a.points.tobytes() == b.points.tobytes()
    assert list(a.cells) == list(b.cells)
    for name in a.cells:
        np.testing.assert_array_equal(a.cells[name], b.cells[name])
    same_models(a.model, b.model)


@pytest.fixture(params=IDS)
def kind(request):
    return request.param


def written(tmp_path, kind):
    path = tmp_path / f"a.{kind}"
    nmgs.write(path, example(kind))
    return path


def test_round_trip(tmp_path, kind):
    path = written(tmp_path, kind)
    same(nmgs.read(path), example(kind))
    # And by the format's name, whatever the extension.
    other = tmp_path / "other.txt"
    nmgs.write(other, example(kind), format=kind)
    assert other.read_bytes() == path.read_bytes()
    same(nmgs.read(other, format=kind), example(kind))


def test_round_trip_with_gradings(tmp_path, kind):
    model = surface() if kind[1] == "2" else solid()
    model.set_divisions(soft={(0, 0): 4, (1, 1): 5})
    model.set_grading(0, "xi", nmgs.grading.geometric(ratio=1.3))
    model.set_grading(1, "eta", nmgs.grading.tanh(first=0.01, last=0.1))
    obj = model if kind[2] == "s" else model.generate()
    path = tmp_path / f"a.{kind}"
    nmgs.write(path, obj)
    same(nmgs.read(path), obj)


@settings(max_examples=50, deadline=None)
@given(
    st.lists(st.floats(allow_nan=False, allow_infinity=False), min_size=60, max_size=60),
    st.text(st.characters(blacklist_categories=("Cs",), blacklist_characters="\r\n")),
)
def test_any_doubles_and_references_come_back(tmp_path_factory, values, reference):
    model = nmgs.BlockModel(np.array(values).reshape(1, 20, 3), [1, 2, 3], reference)
    path = tmp_path_factory.mktemp("any") / "a.n3s"
    nmgs.write(path, model)
    same(nmgs.read(path), model)


def test_the_first_lines_are_the_tables(tmp_path):
    path = tmp_path / "a.n2s"
    nmgs.write(path, nmgs.BlockModel([unit_square()], [3, 4], "ref"))
    assert path.read_text().splitlines() == [
        "NMGS-SSMG Problem Setup File", "ref", "1", "3 4", "0 0 0", "1 0 0", "1 1 0", "0 1 0",
        "0.5 0 0", "1 0.5 0", "0.5 1 0", "0 0.5 0",
    ]  # fmt: skip


def test_a_result_of_one_square_by_hand(tmp_path):
    path = tmp_path / "a.n2r"
    nmgs.write(path, nmgs.BlockModel([unit_square()], [1, 1], "").generate())
    assert path.read_text().split("\n")[12:] == [
        "4", "1", "1 2 4 3", "0 0 0 1 0 0 1 1 0 0 1 0", "0 0 0 0", "1",
        "1 2", "2", "3", "2 3", "1", "3", "4", "3 3", "1", "2", "4", "4 2", "2", "3",
        "1", "0 0 0", "2", "1 0 0", "3", "0 1 0", "4", "1 1 0", "",
    ]  # fmt: skip


def test_common_nodes_and_related_nodes(tmp_path):
    """CN is 1 for a node that a lower block made; related nodes are mutual; NTZ = 12 NHZ."""
    path = written(tmp_path, "n3r")
    mesh = example("n3r")
    words = iter(path.read_text().split("\n", 2)[2].split())

    def take(count, kind=int):
        return [kind(next(words)) for _ in range(count)]

    take(1)
    take(2 * 3)
    take(2 * 20 * 3, float)
    nodes, zones = take(2)
    assert (nodes, zones) == (len(mesh.points), 3)
    common = []
    for zone in range(zones):
        assert take(1) == [zone + 1]
        corners = take(8)
        places = np.array(take(24, float)).reshape(8, 3)
        np.testing.assert_array_equal(places, mesh.points[np.array(corners) - 1])
        common.append(take(8))
    # Zones 1 and 2 are of the first block; the third's low face along xi is the second's high one.
    assert common == [[0] * 8, [0] * 8, [1, 0, 0, 1, 1, 0, 0, 1]]

    def related(count):
        pairs = set()
        for node in range(1, count + 1):
            number, size = take(2)
            assert number == node
            neighbours = take(size)
            assert neighbours == sorted(set(neighbours)) and node not in neighbours
            pairs |= {(node, other) for other in neighbours}
        assert pairs == {(b, a) for a, b in pairs}
        return pairs

    edges = {
        (a + 1, b + 1)
        for hexa in mesh.cells["hexahedron"]
        for i, j in [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4),
                     (0, 4), (1, 5), (2, 6), (3, 7)]
        for a, b in [(hexa[i], hexa[j]), (hexa[j], hexa[i])]
    }  # fmt: skip
    assert related(nodes) == edges
    for node in range(nodes):
        assert take(1) == [node + 1]
        np.testing.assert_array_equal(take(3, float), mesh.points[node])
    more, tetrahedra = take(2)
    assert (more, tetrahedra) == (nodes + zones, 12 * zones)
    volume = 0.0
    tetra_edges = set()
    for zone in range(tetrahedra):
        assert take(1) == [zone + 1]
        corners = take(4)
        p = np.array(take(12, float)).reshape(4, 3)
        assert np.linalg.det(p[1:] - p[0]) > 0
        volume += np.linalg.det(p[1:] - p[0]) / 6
        tetra_edges |= {(a, b) for a in corners for b in corners if a != b}
    assert volume == pytest.approx(1.4 / 3, rel=1e-12)
    assert related(more) == tetra_edges
    for node in range(more):
        assert take(1) == [node + 1]
        take(3, float)
    assert next(words, None) is None


def explained(text, kind):
    """The file as the thesis prints it, with its explaining lines."""
    lines = text.splitlines()
    return "\n".join(
        ["--- start of file", "(File Id text)", lines[0], lines[1], "--- start of problem setup"]
        + ["(Number of noded isoparametric", " elements)"]
        + lines[2:]
        + ["--- end of file"]
    )


@pytest.mark.parametrize("ending", ["\n", "\r\n"])
def test_explanations_line_ends_and_white_space(tmp_path, kind, ending):
    path = written(tmp_path, kind)
    text = path.read_text(encoding="utf-8")
    text = explained(text, kind).replace("\n", ending)
    path.write_bytes(text.encode("utf-8"))
    same(nmgs.read(path), example(kind))
    head, rest = text.split(ending)[:4], ending.join(text.split(ending)[4:])
    loose = ending.join(head) + ending + re.sub(r"(?<=\d) (?=[-\d])", "  \t ", rest) + ending * 3
    path.write_bytes(loose.encode("utf-8"))
    same(nmgs.read(path), example(kind))


def test_an_empty_reference_in_an_explained_file(tmp_path):
    path = tmp_path / "a.n2s"
    nmgs.write(path, nmgs.BlockModel([unit_square()], [3, 4]))
    lines = path.read_text().splitlines()
    path.write_text("\n".join(["--- start", lines[0], "--- start of problem setup"] + lines[2:]))
    assert nmgs.read(path).reference == ""


def test_latin_1_and_fortran_numbers(tmp_path):
    path = tmp_path / "a.n2s"
    lines = [IDS["n2s"], "Fläche", "1", "+3 4"]
    lines += [f"{x + 1:.1f}D+00 {y + 1:.1f}d0 .5" for x, y in QUAD8]
    path.write_bytes("\n".join(lines).encode("latin-1"))
    model = nmgs.read(path)
    assert model.reference == "Fläche"
    np.testing.assert_array_equal(model.nodes[0, :, :2], QUAD8 + 1)
    assert (model.nodes[..., 2] == 0.5).all()


def perimeter(nodes):
    """The file order of an element's nodes round its perimeter."""
    order = [0, 4, 1, 5, 2, 6, 3, 7]
    if len(nodes) == 20:
        order = [0, 8, 1, 9, 2, 10, 3, 11, 16, 17, 18, 19, 4, 12, 5, 13, 6, 14, 7, 15]
    return nodes[order]


@pytest.mark.parametrize("kind", ["n2s", "n3s"])
def test_numbering(tmp_path, kind):
    nodes = unit_square() if kind == "n2s" else unit_cube()
    listed = nmgs.BlockModel([perimeter(nodes)], [1] * (2 if kind == "n2s" else 3))
    path = tmp_path / f"a.{kind}"
    nmgs.write(path, listed)
    np.testing.assert_array_equal(nmgs.read(path, numbering="perimeter").nodes[0], nodes)
    with pytest.raises(nmgs.FormatError, match='numbering="perimeter"'):
        nmgs.read(path)
    nmgs.write(path, nmgs.BlockModel([nodes], listed.divisions))
    with pytest.raises(nmgs.FormatError, match="corners-first"):
        nmgs.read(path, numbering="perimeter")
    with pytest.raises(ValueError, match="numbering"):
        nmgs.read(path, numbering="round and round")


def test_a_file_of_another_kind(tmp_path, kind):
    for other in IDS:
        if other != kind:
            path = written(tmp_path, other)
            with pytest.raises(nmgs.FormatError, match=IDS[kind]) as caught:
                nmgs.read(path, format=kind)
            assert caught.value.line == 1
            assert caught.value.path == str(path)


def test_truncated_at_every_line(tmp_path, kind):
    lines = written(tmp_path, kind).read_text(encoding="utf-8").splitlines()
    path = tmp_path / f"cut.{kind}"
    for count in range(len(lines)):
        path.write_text("\n".join(lines[:count]), encoding="utf-8")
        with pytest.raises(nmgs.FormatError) as caught:
            nmgs.read(path)
        assert caught.value.line <= count + 1


def test_one_number_too_many(tmp_path, kind):
    path = written(tmp_path, kind)
    with open(path, "a", encoding="utf-8") as file:
        file.write("17\n")
    with pytest.raises(nmgs.FormatError, match="expected the end of the file, found '17'") as error:
        nmgs.read(path)
    assert error.value.line == len(path.read_text(encoding="utf-8").splitlines())


@pytest.mark.parametrize("word", ["abc", "nan", "inf", "-inf", "1e999", "1,5", "\x00", "(", "--"])
def test_words_that_are_no_numbers(tmp_path, kind, word):
    lines = written(tmp_path, kind).read_text(encoding="utf-8").splitlines()
    path = tmp_path / f"bad.{kind}"
    for at in range(2, len(lines), max(1, len(lines) // 40)):
        words = lines[at].split()
        # Not in front: a parenthesis there begins an explanation.
        words[-1] = word if len(words) > 1 else "1" + word
        changed = lines[:at] + [" ".join(words)] + lines[at + 1 :]
        path.write_text("\n".join(changed), encoding="utf-8")
        if words[-1] in ("1--", "1("):
            continue
        with pytest.raises(nmgs.FormatError) as caught:
            nmgs.read(path)
        assert caught.value.line in (at + 1, 0), (lines[at], words)


@pytest.mark.parametrize("count", ["0", "-1", "1.5", "1000000000000", "99999999999999999999"])
def test_counts_that_cannot_be(tmp_path, kind, count):
    lines = written(tmp_path, kind).read_text(encoding="utf-8").splitlines()
    path = tmp_path / f"bad.{kind}"
    path.write_text("\n".join(lines[:2] + [count] + lines[3:]), encoding="utf-8")
    with pytest.raises(nmgs.FormatError) as caught:
        nmgs.read(path)
    assert caught.value.line == 3
    divisions = lines[3].split()
    divisions[0] = count
    path.write_text("\n".join(lines[:3] + [" ".join(divisions)] + lines[4:]), encoding="utf-8")
    with pytest.raises(nmgs.FormatError) as caught:
        nmgs.read(path)
    assert caught.value.line == 4


@pytest.mark.parametrize("kind", ["n2r", "n3r"])
def test_huge_divisions_in_a_result(tmp_path, kind):
    lines = written(tmp_path, kind).read_text(encoding="utf-8").splitlines()
    lines[3] = " ".join(["2000000000"] * len(lines[3].split()))
    path = tmp_path / f"bad.{kind}"
    path.write_text("\n".join(lines), encoding="utf-8")
    with pytest.raises(nmgs.FormatError):
        nmgs.read(path)


@pytest.mark.parametrize("kind", ["n2r", "n3r"])
def test_numbers_that_contradict_each_other(tmp_path, kind):
    """Any whole number of a result changed by one is noticed, but for a common node's or a
    diagonal's mark and a related node's number, which say nothing that is read."""
    lines = written(tmp_path, kind).read_text(encoding="utf-8").splitlines()
    nodes = 40 if kind == "n2r" else 40
    at = 3 + (5 if kind == "n2r" else 2) + nodes
    path = tmp_path / f"bad.{kind}"
    zones = [i for i in range(at + (1 if kind == "n2r" else 2), len(lines)) if lines[i] == "1"]
    for line in (at, zones[0]):
        changed = list(lines)
        changed[line] = str(int(changed[line]) + 1)
        path.write_text("\n".join(changed), encoding="utf-8")
        with pytest.raises(nmgs.FormatError):
            nmgs.read(path)
    # A zone's node out of range, and one elsewhere.
    for number in ("0", "1000", "7"):
        changed = list(lines)
        words = changed[zones[0] + 1].split()
        words[0] = number
        changed[zones[0] + 1] = " ".join(words)
        path.write_text("\n".join(changed), encoding="utf-8")
        with pytest.raises(nmgs.FormatError):
            nmgs.read(path)


@settings(max_examples=200, deadline=None)
@given(st.sampled_from(list(IDS)), st.data())
def test_mutated_files_are_read_or_refused(tmp_path_factory, kind, data):
    """Bytes removed, doubled or overwritten anywhere: a result, or a FormatError."""
    folder = tmp_path_factory.mktemp("mutated")
    text = bytearray(written(folder, kind).read_bytes())
    for _ in range(data.draw(st.integers(1, 4))):
        at = data.draw(st.integers(0, len(text) - 1))
        length = data.draw(st.integers(1, 20))
        action = data.draw(st.sampled_from(["remove", "double", "write"]))
        if action == "remove":
            del text[at : at + length]
        elif action == "double":
            text[at:at] = text[at : at + length]
        else:
            text[at : at + length] = data.draw(st.binary(min_size=length, max_size=length))
        if not text:
            break
    path = folder / f"mutated.{kind}"
    path.write_bytes(bytes(text))
    try:
        nmgs.read(path)
    except nmgs.FormatError as error:
        assert error.path == str(path)


def test_what_a_format_cannot_hold(tmp_path):
    model, mesh = surface(), surface().generate()
    path = tmp_path / "a"
    for kind, obj, message in [
        ("n2s", mesh, "BlockModel"),
        ("n3s", model, "20-node"),
        ("n2s", solid(), "8-node"),
        ("n2r", model, "Mesh"),
        ("n3r", mesh, "20-node"),
        ("n2r", nmgs.Mesh(mesh.points, mesh.cells), "model"),
        ("n2r", mesh.split(), "quad"),
        ("n2r", nmgs.Mesh(mesh.points, {"quad": mesh.cells["quad"][1:]}, model=model), "cells"),
    ]:
        with pytest.raises(ValueError, match=message):
            nmgs.write(path, obj, format=kind)
        assert os.listdir(tmp_path) == []


def test_a_write_that_fails_leaves_the_old_file(tmp_path, kind):
    path = written(tmp_path, kind)
    before = path.read_bytes()
    obj = example(kind)
    (obj if kind[2] == "s" else obj.model).nodes[0, 0, 0] = np.nan
    with pytest.raises(ValueError):
        nmgs.write(path, obj)
    assert path.read_bytes() == before
    assert os.listdir(tmp_path) == [path.name]


@pytest.mark.parametrize("kind", ["n2r", "n3r"])
def test_cancel_leaves_no_file(tmp_path, kind):
    path = tmp_path / f"a.{kind}"
    with pytest.raises(nmgs.Cancelled):
        nmgs.write(path, example(kind), progress=lambda fraction: False)
    assert os.listdir(tmp_path) == []
    nmgs.write(path, example(kind))
    with pytest.raises(nmgs.Cancelled):
        nmgs.read(path, progress=lambda fraction: False)


def test_missing_files_and_folders(tmp_path, kind):
    with pytest.raises(FileNotFoundError):
        nmgs.read(tmp_path / f"none.{kind}")
    with pytest.raises(FileNotFoundError):
        nmgs.write(tmp_path / "none" / f"a.{kind}", example(kind))
    (tmp_path / f"folder.{kind}").mkdir()
    with pytest.raises(IsADirectoryError):
        nmgs.read(tmp_path / f"folder.{kind}")
    with pytest.raises(IsADirectoryError):
        nmgs.write(tmp_path / f"folder.{kind}", example(kind))
    (tmp_path / f"empty.{kind}").touch()
    with pytest.raises(nmgs.FormatError):
        nmgs.read(tmp_path / f"empty.{kind}")
