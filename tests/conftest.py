# SPDX-License-Identifier: LGPL-2.1-or-later
"""Beside this file: element_meshes and tetgen_bounds, which tests of all kinds import."""
