# SPDX-License-Identifier: LGPL-2.1-or-later
"""clang-tidy over the units of build/release, each again only when it or a header of it changed.

usage: tidy.py [deep] [PATH...]    PATH: only units whose path begins so, such as cpp/nmgs_cad/

Without deep (or NMGS_TIDY=deep) clang's static analyzer, a third of the time, is left out.
A unit that was clean leaves build/tidy/KEY, KEY being the hash of its command, of the settings and
of all of the project's files that it includes. Exit code 1 when any unit is not clean.
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "release"
CLEAN = ROOT / "build" / "tidy"
DEEP = "deep" in sys.argv[1:] or os.environ.get("NMGS_TIDY") == "deep"
#: Added to the checks of .clang-tidy.
CHECKS = "" if DEEP else "-clang-analyzer-*"


def dependencies():
    """Object -> the project's files that it was built from, as ninja recorded them."""
    text = subprocess.run(
        ["ninja", "-C", str(BUILD), "-t", "deps"], check=True, capture_output=True, text=True
    ).stdout
    result = {}
    for line in text.splitlines():
        if line and not line.startswith((" ", "ninja")):
            name = line.split(":")[0]
            result[name] = set()
        elif line.startswith(" "):
            path = pathlib.Path(os.path.normpath(BUILD / line.strip()))
            if path.is_relative_to(ROOT) and not path.is_relative_to(BUILD):
                result[name].add(path)
    return result


def key(unit, command, files):
    digest = hashlib.sha256((command + CHECKS).encode())
    digest.update((ROOT / ".clang-tidy").read_bytes())
    for folder in (ROOT / unit).parents:
        if folder != ROOT and folder.is_relative_to(ROOT) and (folder / ".clang-tidy").exists():
            digest.update((folder / ".clang-tidy").read_bytes())
    for path in sorted(files):
        digest.update(str(path.relative_to(ROOT)).encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:32]


def check(unit, stamps):
    """What clang-tidy says about a unit; "" when it is clean."""
    done = subprocess.run(
        [
            "clang-tidy",
            "-p",
            str(BUILD),
            "--quiet",
            f"--checks={CHECKS}",
            "--extra-arg=-Wno-unknown-warning-option",
            unit,
        ],
        capture_output=True,
        text=True,
    )
    if done.returncode == 0:
        for stamp in stamps:
            stamp.touch()
        return ""
    return done.stdout or done.stderr


def main():
    CLEAN.mkdir(parents=True, exist_ok=True)
    built_from = dependencies()
    only = tuple(word for word in sys.argv[1:] if word != "deep")
    todo = {}
    units = 0
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        unit = os.path.relpath(entry["file"], ROOT)
        if not unit.startswith(only or ("cpp/",)) or unit.startswith("cpp/bench/"):
            continue
        units += 1
        words = shlex.split(entry["command"])
        files = built_from.get(words[words.index("-o") + 1], set()) | {ROOT / unit}
        stamp = CLEAN / key(unit, entry["command"], files)
        if not stamp.exists():
            todo.setdefault(unit, []).append(stamp)
    dirty = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for text in pool.map(check, todo, todo.values()):
            if text:
                dirty += 1
                print(text, flush=True)
    print(f"clang-tidy: {units} units, {len(todo)} looked at, {dirty} not clean")
    sys.exit(1 if dirty else 0)


main()
