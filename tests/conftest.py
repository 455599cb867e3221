# SPDX-License-Identifier: LGPL-2.1-or-later
"""Beside this file: element_meshes, which tests of all kinds import."""
