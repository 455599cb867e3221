// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves and surfaces of a shape's entities, made at their first use and kept with the shape.
#pragma once

#include "nmgs_cad/cad_shape.h"
#include "nmgs_cad/edge_curve.h"
#include "nmgs_cad/face_projection.h"

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace nmgs::cad {

// For one thread at a time.
class CadGeometry {
public:
    explicit CadGeometry(const CadShape &shape);

    // Of edge or face n, from 1 on.
    EdgeCurve &curve(int n);
    // Without a guess of what was asked before.
    FaceProjection &face(int n);
    // As the last user left it; face(n) must have been called.
    FaceProjection &face_as_it_is(int n) { return *faces_[static_cast<std::size_t>(n)]; }

private:
    std::vector<TopoDS_Edge> edge_shapes_;
    std::vector<TopoDS_Face> face_shapes_;
    std::vector<std::unique_ptr<EdgeCurve>> curves_;
    std::vector<std::unique_ptr<FaceProjection>> faces_;
};

// What a shape keeps: one CadGeometry for each thread that has asked at the same time.
class CadGeometryPool {
public:
    std::unique_ptr<CadGeometry> take(const CadShape &shape);
    void give_back(std::unique_ptr<CadGeometry> geometry);
    // Of the shape's bounding box, measured once.
    double diagonal(const TopoDS_Shape &shape);

private:
    std::mutex mutex_;
    std::optional<double> diagonal_;
    std::vector<std::unique_ptr<CadGeometry>> free_;
};

// A CadGeometry of the shape's, for as long as this lives; take one in each chunk of a parallel
// loop.
class BorrowedGeometry {
public:
    explicit BorrowedGeometry(const CadShape &shape);
    ~BorrowedGeometry();
    BorrowedGeometry(const BorrowedGeometry &) = delete;
    BorrowedGeometry &operator=(const BorrowedGeometry &) = delete;
    CadGeometry *operator->() { return geometry_.get(); }
    CadGeometry &operator*() { return *geometry_; }

private:
    std::shared_ptr<CadGeometryPool> pool_;
    std::unique_ptr<CadGeometry> geometry_;
};

} // namespace nmgs::cad
