// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/plc/check.h"

#include "nmgs/plc/crossings.h"
#include "nmgs/plc/surface.h"
#include "nmgs/plc/welded.h"
#include "nmgs/support/error.h"

#include <algorithm>
#include <map>
#include <set>

namespace nmgs {
namespace {

void check_points(const Welded &welded, std::size_t limit, std::vector<PlcProblem> &problems) {
    for (std::size_t i = 0; i < welded.first.size() && problems.size() < limit; ++i) {
        const auto node = static_cast<std::int32_t>(i);
        if (welded.first[i] != node) {
            problems.push_back({PlcFault::duplicate_point,
                                {},
                                {node, welded.first[i]},
                                welded.plc.points[i],
                                distance(welded.plc.points[i], welded.point(welded.first[i]))});
        }
    }
}

void check_facets(const Welded &welded, const CheckOptions &options,
                  std::vector<PlcProblem> &problems) {
    std::vector<PlcProblem> degenerate;
    std::vector<PlcProblem> duplicate;
    std::vector<PlcProblem> nonplanar;
    std::map<std::vector<std::int32_t>, std::int32_t> seen;
    const Plc &plc = welded.plc;
    for (std::size_t f = 0; f < plc.facet_count(); ++f) {
        const auto number = static_cast<std::int32_t>(f);
        const FacetPlane &plane = welded.planes[f];
        if (welded.degenerate(f)) {
            degenerate.push_back(
                {PlcFault::degenerate_facet, {number}, {}, plane.origin, plane.area});
            continue;
        }
        if (plane.off > std::max(options.planarity * plane.size, welded.tolerance)) {
            nonplanar.push_back({PlcFault::nonplanar_facet, {number}, {}, plane.origin, plane.off});
        }
        const auto begin = plc.polygon_nodes.begin();
        const auto at = [&](std::int64_t p) {
            return plc.polygon_offsets[static_cast<std::size_t>(p)];
        };
        std::vector<std::int32_t> nodes(begin + at(plc.facet_offsets[f]),
                                        begin + at(plc.facet_offsets[f + 1]));
        std::sort(nodes.begin(), nodes.end());
        const auto [first, fresh] = seen.try_emplace(std::move(nodes), number);
        if (!fresh) {
            duplicate.push_back(
                {PlcFault::duplicate_facet, {number, first->second}, {}, plane.origin, 0});
        }
    }
    for (auto *list : {&degenerate, &duplicate, &nonplanar}) {
        list->resize(std::min(list->size(), options.limit));
        problems.insert(problems.end(), std::make_move_iterator(list->begin()),
                        std::make_move_iterator(list->end()));
    }
}

} // namespace

std::string_view name(PlcFault fault) {
    constexpr std::string_view names[] = {"duplicate_point", "degenerate_facet", "duplicate_facet",
                                          "nonplanar_facet", "crossing_facets",  "open_edge",
                                          "flipped_facet",   "inside_out",       "hole_outside",
                                          "region_outside"};
    return names[static_cast<std::size_t>(fault)];
}

double tolerance_of(const Plc &plc, const CheckOptions &options) {
    if (options.tolerance >= 0) {
        return options.tolerance;
    }
    Box box;
    for (const Vec3 p : plc.points) {
        box.add(p);
    }
    return 1e-8 * box.diagonal();
}

std::vector<PlcProblem> check(const Plc &plc, const CheckOptions &options,
                              const Progress &progress) {
    for (std::size_t i = 0; i < plc.points.size(); ++i) {
        if (!is_finite(plc.points[i])) {
            throw ArgumentError("points: point " + std::to_string(i) + " is not finite");
        }
    }
    const Welded welded(plc, tolerance_of(plc, options), progress);
    std::vector<PlcProblem> problems;
    if (!options.equal_points) {
        check_points(welded, options.limit, problems);
    }
    check_facets(welded, options, problems);
    std::vector<Box> boxes;
    boxes.reserve(plc.facet_count());
    for (std::size_t f = 0; f < plc.facet_count(); ++f) {
        boxes.push_back(welded.box(f));
    }
    const BoxTree tree(boxes);
    poll(progress, 0.4);
    auto surface = surface_problems(welded, tree, options.limit);
    auto crossing = crossings(welded, tree, options.limit, progress);
    // Which of two surfaces that cross is inside the other has no answer.
    std::set<std::int32_t> cut;
    for (const PlcProblem &problem : crossing) {
        cut.insert(problem.facets.begin(), problem.facets.end());
    }
    std::erase_if(surface, [&](const PlcProblem &problem) {
        return problem.fault == PlcFault::inside_out &&
               std::any_of(problem.facets.begin(), problem.facets.end(),
                           [&](std::int32_t facet) { return cut.contains(facet); });
    });
    for (auto *list : {&crossing, &surface}) {
        problems.insert(problems.end(), std::make_move_iterator(list->begin()),
                        std::make_move_iterator(list->end()));
    }
    return problems;
}

} // namespace nmgs
