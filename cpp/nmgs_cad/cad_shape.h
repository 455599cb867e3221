// SPDX-License-Identifier: LGPL-2.1-or-later
// A CAD shape whose parts are numbered as FreeCAD numbers them.
#pragma once

#include "nmgs/support/vec3.h"

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>

#include <memory>
#include <string>
#include <string_view>

namespace nmgs::cad {

class CadGeometryPool;

// Index n of faces, edges and vertices is FreeCAD's FaceN, EdgeN, VertexN: 1-based, in the order of
// TopExp::MapShapes.
struct CadShape {
    TopoDS_Shape shape;
    TopTools_IndexedMapOfShape solids, faces, edges, vertices;
    std::shared_ptr<CadGeometryPool> geometry; // see cad_geometry.h

    [[nodiscard]] TopoDS_Solid solid(int n) const;
    [[nodiscard]] TopoDS_Face face(int n) const;
    [[nodiscard]] TopoDS_Edge edge(int n) const;
    [[nodiscard]] TopoDS_Vertex vertex(int n) const;
    [[nodiscard]] Vec3 point(int n) const; // of vertex n
    [[nodiscard]] double diagonal() const; // of the bounding box
};

// Of its solids; below 0 where they are stored inside out.
double volume_of(const TopoDS_Shape &shape);

CadShape make_shape(const TopoDS_Shape &shape);

// Reads OpenCASCADE's text BREP from memory. Raises GeometryError when it cannot be read
// or is empty.
CadShape read_brep(std::string_view bytes);

// "Face7", "Edge3", "Vertex1", "Solid2".
std::string entity_name(int dimension, int index);

} // namespace nmgs::cad
