# SPDX-License-Identifier: LGPL-2.1-or-later
"""TetOptions: every switch by name, back and forth, refused by name."""

import pytest

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.nmgs.tetgen.switches import SWITCHES

VERSIONS = ("1.5", "1.6")


def valid_value(row):
    """A value in range that is not the default."""
    if row.default is None:
        return row.number(3)
    if isinstance(row.default, bool):
        return True
    for value in (row.low + 1, row.high, row.low, 0.5, 20, 2):
        kind = type(row.default)
        if row.low <= value <= row.high and value < 1e6 and kind(value) != row.default:
            return kind(value)
    raise AssertionError(row.name)


@pytest.mark.parametrize("version", VERSIONS)
def test_every_option_goes_there_and_back(version):
    for row in nmgs.TetOptions.table(version):
        options = nmgs.TetOptions(version, **{row.name: valid_value(row)})
        text = str(options)
        assert row.letter in text
        assert nmgs.TetOptions.parse(text, version) == options, row.name
        assert row.sentence.endswith(".") and row.sentence[0].isupper() or row.sentence[0].isdigit()


@pytest.mark.parametrize("version", VERSIONS)
def test_all_options_at_once(version):
    values = {row.name: valid_value(row) for row in nmgs.TetOptions.table(version)}
    options = nmgs.TetOptions(version, **values)
    assert nmgs.TetOptions.parse(str(options), version) == options


@pytest.mark.parametrize("row", SWITCHES, ids=lambda r: f"{r.name}-{'-'.join(r.versions)}")
def test_out_of_range_is_refused_by_name(row):
    bad = row.high + 1 if row.high < float("inf") else row.low - 1
    with pytest.raises(ValueError, match=row.name):
        nmgs.TetOptions(row.versions[0], **{row.name: bad})
    with pytest.raises(ValueError, match=row.name):
        nmgs.TetOptions(row.versions[0], **{row.name: "three"})


def test_a_switch_of_another_version_is_refused_by_name():
    with pytest.raises(ValueError, match="no_warnings.*1.5 does not have it.*1.6"):
        nmgs.TetOptions("1.5", no_warnings=True)
    with pytest.raises(ValueError, match="voronoi.*1.6 does not have it.*1.5"):
        nmgs.TetOptions("1.6", voronoi=True)
    with pytest.raises(ValueError, match="1.6 does not have -v"):
        nmgs.TetOptions.parse("v", "1.6")
    with pytest.raises(AttributeError, match="no option"):
        nmgs.TetOptions("1.5", colour=True)


@pytest.mark.parametrize(
    ("switches", "names"),
    [
        ("pq", {"plc": True, "quality": True}),
        ("-pq1.4/20", {"radius_edge_ratio": 1.4, "min_dihedral": 20.0}),
        ("pq1.2,10", {"radius_edge_ratio": 1.2, "min_dihedral": 10.0}),
        ("pqaa0.1A", {"volumes": True, "max_volume": 0.1, "region_attributes": True}),
        ("pY", {"keep_boundary": 1}),
        ("rqa", {"refine": True, "quality": True, "volumes": True}),
        ("po2", {"order": 2}),
        ("pM1/0", {"keep_facets": True, "keep_points": False}),
        ("pM", {"keep_facets": True, "keep_points": True}),
        ("pT1e-10S100", {"tolerance": 1e-10, "max_steiner": 100}),
        ("nnfeVV", {"neighbours": 2, "all_faces": 1, "all_edges": 1, "verbose": 2}),
        ("zgkNIQ", {}),
    ],
)
@pytest.mark.parametrize("version", VERSIONS)
def test_strings_are_read_as_tetgen_reads_them(switches, names, version):
    options = nmgs.TetOptions.parse(switches, version)
    for name, value in names.items():
        assert getattr(options, name) == value


def test_numbers_never_swallow_the_next_switch():
    options = nmgs.TetOptions("1.5", max_volume=1e-7, all_edges=1, tolerance=1e-12, plc=True)
    text = str(options)
    assert "e" in text[: text.index("a")]  # -e stands before -a1e-07
    assert nmgs.TetOptions.parse(text, "1.5") == options
    with pytest.raises(ValueError, match="no number"):
        nmgs.TetOptions.parse("pa0.1e", "1.5")


@pytest.mark.parametrize("switches", ["h", "?", "H", "pZ", "p q", "pq..1", "x" * 2000])
def test_strings_that_cannot_be_used(switches):
    with pytest.raises(ValueError, match="switches"):
        nmgs.TetOptions.parse(switches, "1.5")


def test_options_do_what_their_letters_do():
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]
    by_name = nmgs.tetrahedralize(points, nmgs.TetOptions(neighbours=1, all_edges=1))
    by_letter = nmgs.tetrahedralize(points, "ne")
    assert by_name.tetgen.switches == by_letter.tetgen.switches == "en"
    assert (by_name.tetgen.neighbours == by_letter.tetgen.neighbours).all()
