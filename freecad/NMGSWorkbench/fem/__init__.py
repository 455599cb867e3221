# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a mesh to FreeCAD's FEM workbench: Fem::FemMesh, groups, analysis. No GUI import."""
