// SPDX-License-Identifier: LGPL-2.1-or-later
// The triangulation that make_skin works on: local operations that keep it on the CAD.
#pragma once

#include "nmgs_cad/face_geometry.h"
#include "nmgs_cad/skin.h"

#include <BRepAdaptor_Curve.hxx>
#include <Geom2d_Curve.hxx>

#include <map>
#include <memory>
#include <optional>
#include <unordered_map>

namespace nmgs::cad {

// A curve of a CAD edge with its ends.
struct EdgeGeometry {
    BRepAdaptor_Curve curve;
    double first, last;
    bool degenerated;
    explicit EdgeGeometry(const TopoDS_Edge &edge);
};

struct SkinPoint {
    Vec3 p{0, 0, 0};
    CadEntity on{2, 0};
    double t = 0;                          // on an edge
    Uv uv;                                 // on a face
    std::int32_t previous = -1, next = -1; // on an edge: its neighbours along the curve
    double size = 0;                       // wanted length of the edges here
    bool kept = false;                     // may neither move nor go
    std::int32_t source = -1;
    bool alive = true;
};

class SkinMesh {
public:
    SkinMesh(const CadShape &shape, const SkinOptions &options);

    struct Triangle {
        std::array<std::int32_t, 3> p;
        std::int32_t face; // 0: gone
    };
    std::vector<SkinPoint> points;
    std::vector<Triangle> triangles;
    std::vector<std::vector<std::int32_t>> around; // triangles of each point
    std::vector<char> bound;                       // by CAD edge: its division is given
    std::vector<int> inner;                        // by CAD edge: points between its ends
    // By CAD face, edge: what the allowed turn is multiplied by.
    std::vector<double> face_turn, edge_turn;
    [[nodiscard]] bool closed(std::int32_t edge) const;

    void add_triangle(std::array<std::int32_t, 3> p, std::int32_t face);
    void add_segment(std::int32_t a, std::int32_t b, std::int32_t edge);
    // The CAD edge that the two points follow each other on, or 0.
    [[nodiscard]] std::int32_t segment(std::int32_t a, std::int32_t b) const;
    [[nodiscard]] const std::map<std::array<std::int32_t, 2>, std::int32_t> &segments() const {
        return segments_;
    }
    const FaceGeometry &face(std::int32_t n) const;
    const EdgeGeometry &edge(std::int32_t n) const;
    // The parameters of a segment's ends on its edge, those of a first.
    [[nodiscard]] std::array<double, 2> parameters(std::int32_t a, std::int32_t b,
                                                   std::int32_t edge) const;

    // Wanted lengths from curvature, features and limits, graded.
    void find_sizes(const std::vector<double> &also); // also: upper bounds by point, or empty
    void pass(const Progress &progress, double from, double to); // split, collapse, flip, smooth
    void split_long();
    void collapse_short();
    void flip();
    void flip(std::vector<std::array<std::int32_t, 2>> work);
    void smooth();
    void cut_ears();
    // Removes or splits triangles that are nearly on a line.
    void drop_flat();
    // No two points joined by curves of two faces, or by one beside a segment.
    void part_twins();

    struct Corner {
        Uv uv;
        SurfaceFrame frame;
    };
    const Corner &corner(std::int32_t face, std::int32_t point);
    // Triangles of both points (of one face, if it is not 0).
    [[nodiscard]] std::vector<std::int32_t> between(std::int32_t a, std::int32_t b,
                                                    std::int32_t face = 0) const;
    // Edge's length by the wanted one.
    double length(std::int32_t a, std::int32_t b, std::int32_t face);
    double length(std::int32_t a, std::int32_t b, std::int32_t face, double size);
    // share: of the quality that the new triangles must have.
    bool split(std::int32_t a, std::int32_t b, std::int32_t face, bool force = false,
               double share = 1);
    bool collapse(std::int32_t from, std::int32_t to, bool force = false);
    bool flip(std::int32_t a, std::int32_t b);
    [[nodiscard]] double turn_allowed(double curvature, double scale) const;
    [[nodiscard]] std::vector<std::array<std::int32_t, 3>> edges() const; // a, b, face or 0
    double diagonal = 0;

private:
    struct Score {
        double normal;  // least cosine between the triangle and the surface at its corners
        double quality; // 1 equilateral in the metric, 0 flat
    };
    Score score(std::int32_t face, const std::array<std::int32_t, 3> &p);
    // With point p[0] at another place.
    double normal_of(const std::array<Vec3, 3> &at,
                     const std::array<SurfaceFrame, 3> &frames) const;
    double turn_along(std::int32_t a, std::int32_t b, std::int32_t edge);
    void replace(std::int32_t triangle, std::int32_t from, std::int32_t to);
    void remove(std::int32_t triangle);
    bool smooth_point(std::int32_t n);
    void forget(std::int32_t n); // what is known of a point that moves
    Vec3 tangent(std::int32_t edge, double t) const;
    std::int32_t new_point(const SkinPoint &point);
    // Between the segments from b to a and to c.
    double corner_angle(std::int32_t b, std::int32_t a, std::int32_t c);

    const CadShape &shape_;
    const SkinOptions &options_;
    std::map<std::array<std::int32_t, 2>, std::int32_t> segments_;
    std::unordered_map<std::uint64_t, double> turns_; // of segments
    std::vector<std::vector<std::pair<std::int32_t, Corner>>> corners_;
    mutable std::vector<std::unique_ptr<FaceGeometry>> faces_;
    mutable std::vector<std::unique_ptr<EdgeGeometry>> edges_;
    std::vector<double> face_scale_, edge_scale_; // size of the smallest solid that has it
    std::map<std::array<std::int32_t, 2>, Handle(Geom2d_Curve)> pcurves_;
};

} // namespace nmgs::cad
