// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_layout.h"

#include "nmgs/support/error.h"
#include "nmgs_cad/face_cusps.h"
#include "nmgs_cad/face_general.h"
#include "nmgs_cad/face_intervals.h"
#include "nmgs_cad/face_mapped.h"
#include "nmgs_cad/face_midpoint.h"
#include "nmgs_cad/face_ring.h"

#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace nmgs::cad {
namespace {

// Two loops that ask for numbers of segments that are not too different.
bool may_be_ring(const FaceLoops &loops, const EdgeSizes &sizes) {
    if (loops.loops.size() != 2 || !loops.inner.empty() || !loops.points.empty()) {
        return false;
    }
    std::array<double, 2> segments{0, 0};
    for (std::size_t l = 0; l < 2; ++l) {
        for (const EdgeUse &use : loops.loops[l]) {
            if (use.degenerated || use.seam) {
                return false;
            }
            segments[l] += std::max(1.0, sizes.at(use.edge).segments());
        }
    }
    constexpr double most = 2.5;
    return segments[0] <= most * segments[1] && segments[1] <= most * segments[0];
}

// Of a face that is laid out in elements.
double element_size(const CadShape &shape, const LayoutOptions &options) {
    const double size = shape.diagonal() / 30;
    return options.size > 0 ? std::min(options.size, size) : size;
}

// Divides the edges of the plans that are not laid out yet.
void divide_edges(const CadShape &shape, std::vector<FacePlan> &plans, Layout &layout,
                  const LayoutOptions &options, const Progress &progress) {
    EdgeSizes sizes;
    const auto want = [&](const EdgeUse &use) {
        if (!use.degenerated && !sizes.contains(use.edge)) {
            sizes[use.edge] = size_of_edge(shape, use.edge, options);
        }
    };
    for (const FacePlan &plan : plans) {
        poll(progress, 0);
        for (const FaceLoop &loop : plan.loops.loops) {
            std::for_each(loop.begin(), loop.end(), want);
        }
        std::for_each(plan.loops.inner.begin(), plan.loops.inner.end(), want);
    }
    bool any_cusps = false;
    for (FacePlan &plan : plans) {
        poll(progress, 0);
        plan.give_up();
        plan.cusps = size_cusps(shape, plan.face, plan.loops, sizes);
        if (plan.cusps) {
            size_as_elements(plan.loops, sizes, element_size(shape, options));
        }
        any_cusps = any_cusps || plan.cusps;
    }
    for (FacePlan &plan : plans) {
        poll(progress, 0);
        Refusal refusal;
        if (any_cusps && !plan.cusps) {
            // Chains through a tip go on over these; they are not divided either.
            constexpr double longer = 5;
            constexpr double turn = 0.4;
            size_as_elements(plan.loops, sizes, longer * element_size(shape, options), turn);
        }
        const bool general = plan.cusps || plan.poor;
        if (!general) {
            plan.sides = logical_sides(plan.loops, refusal);
        }
        if (!plan.sides && !general) {
            plan.corners = midpoint_corners(plan.loops);
            plan.ring = may_be_ring(plan.loops, sizes);
        }
        if (plan.general()) {
            size_by_neighbourhood(plan.loops, sizes);
        }
    }
    std::map<int, int> counts;
    for (int round = 0; round < 3; ++round) {
        poll(progress, 0);
        std::vector<char> was_general;
        was_general.reserve(plans.size());
        for (const FacePlan &plan : plans) {
            was_general.push_back(plan.general() ? 1 : 0);
        }
        counts = assign_intervals(shape, plans, sizes, layout);
        bool changed = false;
        for (std::size_t i = 0; i < plans.size(); ++i) {
            if (plans[i].general() && was_general[i] == 0) {
                size_by_neighbourhood(plans[i].loops, sizes);
                changed = true;
            }
        }
        if (!changed) {
            break;
        }
    }
    for (const auto &[edge, places] : place_divisions(plans, counts, sizes, layout)) {
        layout.divide_edge(shape, edge, places);
    }
}

struct Cover {
    std::optional<FaceMesh> mesh;
    std::string method;
    double avoidable = -2; // the worst that could be avoided
    double quality = 0;
};

// The best quads for a face whose edges are laid out. wanted: "auto", "structured" for all but the
// general strategy, or one by name.
Cover best_cover(const CadShape &shape, const FacePlan &plan, Layout &layout,
                 const LayoutOptions &options, const std::string &wanted, Refusal &refusal,
                 const Progress &progress) {
    const FaceSurface surface(shape.face(plan.face));
    const auto boundary = boundary_of(shape, plan.loops, layout);
    std::vector<BoundaryLoop> inner;
    for (const EdgeUse &use : plan.loops.inner) {
        BoundaryLoop line = nodes_along(shape, use, layout);
        EdgeUse back = use;
        back.forward = !use.forward;
        BoundaryNode end = nodes_along(shape, back, layout).front();
        line.push_back(end);
        inner.push_back(std::move(line));
    }
    for (const int n : plan.loops.points) {
        BoundaryNode node;
        node.point = layout.vertex(shape, n);
        node.at = shape.point(n);
        node.uv = surface.nearest(node.at, 0.5 * (surface.low() + surface.high()));
        inner.push_back({node});
    }
    constexpr double good = 0.3;
    Cover best;
    const auto consider = [&](std::optional<FaceMesh> mesh, const char *name) {
        if (mesh) {
            const double q = worst_avoidable(*mesh, surface);
            if (q > best.avoidable) {
                best.avoidable = q;
                best.quality = std::min(worst_quality(*mesh), curved_quality(*mesh, surface));
                best.method = name;
                best.mesh = std::move(mesh);
            }
        }
    };
    const auto sides = logical_sides(plan.loops, refusal);
    const auto may = [&](const std::string &name) {
        return wanted == "auto" || wanted == name || (wanted == "structured" && name != "general");
    };
    if (sides && may("mapped")) {
        consider(mapped_quads(surface, *sides, boundary, refusal), "mapped");
    }
    const auto corners = midpoint_corners(plan.loops);
    if (!corners.empty() && may("mid-point")) {
        consider(midpoint_quads(surface, corners, boundary, refusal), "mid-point");
    }
    if (boundary.size() == 2 && inner.empty() && may("ring")) {
        consider(ring_quads(surface, boundary, refusal), "ring");
    }
    if (best.avoidable < good && may("general")) {
        LayoutOptions finer = options;
        if (plan.cusps) {
            finer.size = element_size(shape, options);
        }
        consider(general_quads(surface, boundary, inner, finer, refusal, progress), "general");
    }
    return best;
}

std::string cover(const CadShape &shape, const FacePlan &plan, Layout &layout,
                  const LayoutOptions &options, const std::string &wanted, Refusal &refusal,
                  double &quality, const Progress &progress) {
    const Cover best = best_cover(shape, plan, layout, options, wanted, refusal, progress);
    if (best.mesh) {
        put(*best.mesh, plan.face, layout);
        quality = best.quality;
    }
    return best.method;
}

// Divides the edges, and once more where a face's structured quads turn out poor: it is general
// then, with edges divided for that.
void divide_for_the_best(const CadShape &shape, std::vector<FacePlan> &plans, Layout &layout,
                         const LayoutOptions &options, const Progress &progress) {
    constexpr double poor = 0.2;
    Layout trial = layout;
    divide_edges(shape, plans, trial, options, progress);
    bool any = false;
    for (FacePlan &plan : plans) {
        poll(progress, 0.1);
        if (plan.general()) {
            continue;
        }
        Refusal refusal;
        try {
            plan.poor =
                best_cover(shape, plan, trial, options, "structured", refusal, progress).avoidable <
                poor;
        } catch (const Standard_Failure &) {
            plan.poor = true;
        }
        any = any || plan.poor;
    }
    if (any) {
        divide_edges(shape, plans, layout, options, progress);
    } else {
        layout = std::move(trial);
    }
}

std::string fail_safe_cover(const CadShape &shape, const FacePlan &plan, Layout &layout,
                            const LayoutOptions &options, const std::string &wanted,
                            Refusal &refusal, double &quality, const Progress &progress) {
    const std::string name = entity_name(2, plan.face);
    std::string method;
    try {
        method = cover(shape, plan, layout, options, wanted, refusal, quality, progress);
    } catch (const Standard_Failure &failure) {
        refusal = {std::string("OpenCASCADE: ") + failure.GetMessageString(), {}};
    }
    if (method.empty()) {
        refusal.reason = name + ": " + refusal.reason;
        refusal.blockers.insert(refusal.blockers.begin(), name);
    }
    return method;
}

} // namespace

bool layout_face(const CadShape &shape, int face, Layout &layout, const LayoutOptions &options,
                 Refusal &refusal, const Progress &progress) {
    if (!layout.quads_of(face).empty()) {
        return true;
    }
    auto loops = face_loops(shape, face, refusal);
    if (!loops) {
        return false;
    }
    join_touching_loops(shape, face, *loops);
    std::vector<FacePlan> plans{{face, std::move(*loops), std::nullopt, {}, false, false, false}};
    divide_edges(shape, plans, layout, options, progress);
    double quality = 0;
    return !fail_safe_cover(shape, plans.front(), layout, options, "auto", refusal, quality,
                            progress)
                .empty();
}

void divide_evenly(const CadShape &shape, int edge, int count, Layout &layout) {
    const std::string name = entity_name(1, edge);
    if (edge < 1 || edge > shape.edges.Extent()) {
        throw ArgumentError("counts: the shape has no " + name);
    }
    if (BRep_Tool::Degenerated(shape.edge(edge))) {
        throw ArgumentError("counts: " + name + " is a pole and has no length");
    }
    const bool closed =
        TopExp::FirstVertex(shape.edge(edge)).IsSame(TopExp::LastVertex(shape.edge(edge)));
    const int least = closed ? 3 : 1;
    if (count < least) {
        throw ArgumentError("counts: expected " + std::to_string(least) + " or more for " + name +
                            ", got " + std::to_string(count));
    }
    std::vector<double> places;
    for (int i = 1; i < count; ++i) {
        places.push_back(static_cast<double>(i) / count);
    }
    layout.divide_edge(shape, edge, places);
}

void layout_faces(const CadShape &shape, std::span<const int> faces, Layout &layout,
                  const LayoutOptions &options, std::vector<FitEntry> &report,
                  const Progress &progress, const std::string &method) {
    std::vector<FacePlan> plans;
    std::map<int, Refusal> refused;
    std::set<int> covered;
    for (const auto &quad : layout.quads) {
        covered.insert(quad.face);
    }
    for (const int face : faces) {
        poll(progress, 0);
        Refusal refusal;
        auto loops = face_loops(shape, face, refusal);
        if (!loops) {
            refused[face] = refusal;
        } else if (!covered.contains(face)) {
            join_touching_loops(shape, face, *loops);
            plans.push_back({face, std::move(*loops), std::nullopt, {}, false, false, false});
        }
    }
    if (method == "auto") {
        divide_for_the_best(shape, plans, layout, options, progress);
    } else {
        divide_edges(shape, plans, layout, options, progress);
    }
    for (const FacePlan &plan : plans) {
        poll(progress, 0.2 + 0.8 * static_cast<double>(&plan - plans.data()) /
                                 static_cast<double>(plans.size()));
        FitEntry entry;
        entry.entity = {2, plan.face};
        entry.first_block = static_cast<std::int32_t>(layout.quads.size());
        Refusal refusal;
        entry.method =
            fail_safe_cover(shape, plan, layout, options, method, refusal, entry.quality, progress);
        entry.blocks = static_cast<std::int32_t>(layout.quads.size()) - entry.first_block;
        if (entry.method.empty()) {
            entry.reason = refusal.reason;
            entry.blockers = refusal.blockers;
        }
        report.push_back(entry);
    }
    for (const auto &[face, refusal] : refused) {
        FitEntry entry;
        entry.entity = {2, face};
        entry.reason = refusal.reason;
        entry.blockers = refusal.blockers;
        report.push_back(entry);
    }
}

} // namespace nmgs::cad
