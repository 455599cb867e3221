// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/cad_shape.h"

#include "nmgs/support/error.h"
#include "nmgs_cad/cad_geometry.h"
#include "nmgs_cad/occt_vec.h"
#include "nmgs_cad/without_locations.h"

#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include <cmath>
#include <sstream>

namespace nmgs::cad {

TopoDS_Solid CadShape::solid(int n) const {
    return TopoDS::Solid(solids(n));
}
TopoDS_Face CadShape::face(int n) const {
    return TopoDS::Face(faces(n));
}
TopoDS_Edge CadShape::edge(int n) const {
    return TopoDS::Edge(edges(n));
}
TopoDS_Vertex CadShape::vertex(int n) const {
    return TopoDS::Vertex(vertices(n));
}

Vec3 CadShape::point(int n) const {
    return vec(BRep_Tool::Pnt(vertex(n)));
}

double CadShape::diagonal() const {
    return geometry->diagonal(shape);
}

double volume_of(const TopoDS_Shape &shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

CadShape make_shape(const TopoDS_Shape &shape) {
    CadShape result;
    result.shape = shape;
    result.geometry = std::make_shared<CadGeometryPool>();
    TopExp::MapShapes(shape, TopAbs_SOLID, result.solids);
    TopExp::MapShapes(shape, TopAbs_FACE, result.faces);
    TopExp::MapShapes(shape, TopAbs_EDGE, result.edges);
    TopExp::MapShapes(shape, TopAbs_VERTEX, result.vertices);
    return result;
}

CadShape read_brep(std::string_view bytes) {
    TopoDS_Shape shape;
    try {
        std::istringstream stream{std::string(bytes)};
        BRepTools::Read(shape, stream, BRep_Builder());
    } catch (const Standard_Failure &failure) {
        throw GeometryError(
            std::string("shape: OpenCASCADE cannot read it: ") + failure.GetMessageString(), {});
    }
    if (shape.IsNull()) {
        throw GeometryError("shape: it is empty, or not a BREP of OpenCASCADE", {});
    }
    return without_locations(make_shape(shape));
}

std::string entity_name(int dimension, int index) {
    constexpr const char *names[] = {"Vertex", "Edge", "Face", "Solid"};
    return names[dimension] + std::to_string(index);
}

} // namespace nmgs::cad
