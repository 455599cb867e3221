# SPDX-License-Identifier: LGPL-2.1-or-later
"""The translations are whole, up to the source, and keep the places of values."""

import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as tree

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "freecad" / "NMGSWorkbench" / "resources" / "translations"


def messages(language):
    root = tree.parse(FOLDER / f"NMGS_{language}.ts").getroot()
    return [
        (m.findtext("source"), m.findtext("translation"), m.find("translation").get("type"))
        for m in root.iter("message")
    ]


def test_whole_and_up_to_the_source():
    done = subprocess.run(
        [sys.executable, ROOT / "scripts" / "nmgs_translate.py", "--check"],
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 0, done.stdout


@pytest.mark.parametrize("language", ["de", "tr"])
def test_values_keep_their_places(language):
    found = messages(language)
    assert len(found) > 200
    for source, translation, kind in found:
        assert kind is None and translation
        places = re.findall(r"\{[^}]*\}", source)
        assert sorted(re.findall(r"\{[^}]*\}", translation)) == sorted(places), source
        # A text that only names things can be the same; a sentence cannot.
        assert " " not in source.strip() or translation != source


@pytest.mark.parametrize("language", ["de", "tr"])
def test_compiled(language):
    """The .qm has the translations of the .ts: UTF-16, as Qt's file has them."""
    data = (FOLDER / f"NMGS_{language}.qm").read_bytes()
    missing = [t for _, t, _ in messages(language) if t.encode("utf-16-be") not in data]
    assert not missing
