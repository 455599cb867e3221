# SPDX-License-Identifier: LGPL-2.1-or-later
# Shared by the scripts; sourced, not run.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
preset=${NMGS_PRESET:-release}
build_dir="$root/build/$preset"

say() { printf '== %s\n' "$*"; }
fail() {
    printf 'error: %s\n' "$*" >&2
    exit 1
}

# FreeCAD's own interpreter: the distribution's, whatever else is first on PATH.
python=${NMGS_PYTHON:-/usr/bin/python3}
