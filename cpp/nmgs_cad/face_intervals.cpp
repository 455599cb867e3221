// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_intervals.h"

#include "nmgs/support/ascending.h"
#include "nmgs_cad/face_midpoint.h"

#include <TopExp.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace nmgs::cad {
namespace {

struct Intervals {
    const EdgeSizes &sizes;
    std::map<int, int> parent; // of edges: equal numbers
    std::map<int, int> count, most;
    std::map<int, bool> fixed, even;
    std::map<int, double> goal;

    int root(int e) {
        while (parent.at(e) != e) {
            e = parent.at(e) = parent.at(parent.at(e));
        }
        return e;
    }
    int segments(int e) { return count.at(root(e)); }

    void join(int a, int b) {
        a = root(a);
        b = root(b);
        if (a == b || (fixed.at(a) && fixed.at(b) && count.at(a) != count.at(b))) {
            return;
        }
        if (fixed.at(b)) {
            std::swap(a, b);
        }
        parent.at(b) = a;
        if (!fixed.at(a)) {
            count.at(a) = std::max(count.at(a), count.at(b));
        }
        even.at(a) = even.at(a) || even.at(b);
        goal.at(a) = std::max(goal.at(a), goal.at(b));
    }
    void make_even(int e) {
        const int r = root(e);
        even.at(r) = true;
        if (!fixed.at(r) && count.at(r) % 2 != 0) {
            ++count.at(r);
        }
    }
};

using Numbers = std::vector<int>;

// Edges of the loop from one use up to another.
Numbers edges_between(const FaceLoop &loop, std::size_t from, std::size_t to) {
    Numbers edges;
    for (std::size_t u = from; u != to || edges.empty(); u = (u + 1) % loop.size()) {
        edges.push_back(loop[u].edge);
    }
    return edges;
}

Numbers side_edges(const FacePlan &plan, std::size_t i) {
    const FaceLoop &loop = plan.loops.loops.front();
    if (plan.sides) {
        return edges_between(loop, plan.sides->corner[i], plan.sides->corner[(i + 1) % 4]);
    }
    return edges_between(loop, plan.corners[i], plan.corners[(i + 1) % plan.corners.size()]);
}

// Chains of edges that must have as many segments as one another.
std::vector<std::array<Numbers, 2>> equal_chains(const FacePlan &plan) {
    if (plan.sides) {
        return {{side_edges(plan, 0), side_edges(plan, 2)},
                {side_edges(plan, 1), side_edges(plan, 3)}};
    }
    if (plan.corners.size() == 2) {
        return {{side_edges(plan, 0), side_edges(plan, 1)}};
    }
    if (plan.ring) {
        std::array<Numbers, 2> loops;
        for (std::size_t l = 0; l < 2; ++l) {
            for (const EdgeUse &use : plan.loops.loops[l]) {
                loops[l].push_back(use.edge);
            }
        }
        return {loops};
    }
    return {};
}

// An edge of a chain and whether the chain runs as its curve does.
struct Directed {
    int edge;
    bool forward;
};

std::vector<Directed> directed(const FaceLoop &loop, const Numbers &edges, std::size_t from) {
    std::vector<Directed> result;
    for (std::size_t k = 0; k < edges.size(); ++k) {
        const EdgeUse &use = loop[(from + k) % loop.size()];
        result.push_back({use.edge, use.forward});
    }
    return result;
}

// Opposite chains of grids, both in the same sense.
std::vector<std::array<std::vector<Directed>, 2>> facing_chains(const FacePlan &plan) {
    std::vector<std::array<std::vector<Directed>, 2>> result;
    const auto add = [&](std::size_t i, std::size_t j, std::size_t from, std::size_t to) {
        const FaceLoop &loop = plan.loops.loops.front();
        auto one = directed(loop, side_edges(plan, i), from);
        auto two = directed(loop, side_edges(plan, j), to);
        std::reverse(two.begin(), two.end());
        for (Directed &d : two) {
            d.forward = !d.forward;
        }
        result.push_back({one, two});
    };
    if (plan.sides) {
        add(0, 2, plan.sides->corner[0], plan.sides->corner[2]);
        add(1, 3, plan.sides->corner[1], plan.sides->corner[3]);
    } else if (plan.corners.size() == 2) {
        add(0, 1, plan.corners[0], plan.corners[1]);
    }
    return result;
}

// Makes a pair of opposite sides equal; true when they are. changed: something was added.
bool balance(Intervals &work, const std::vector<int> &one, const std::vector<int> &two,
             bool &changed) {
    const auto sum = [&](const std::vector<int> &edges) {
        int s = 0;
        for (const int e : edges) {
            s += work.segments(e);
        }
        return s;
    };
    constexpr int tries = 400;
    for (int i = 0; i < tries; ++i) {
        const int a = sum(one);
        const int b = sum(two);
        if (a == b) {
            return true;
        }
        const auto &shorter = a < b ? one : two;
        const auto &longer = a < b ? two : one;
        // The group that is coarsest against its goal and does not lengthen the other side as much.
        int best = -1;
        double value = 0;
        for (const int e : shorter) {
            const int r = work.root(e);
            const auto times = [&](const std::vector<int> &edges) {
                return std::count_if(edges.begin(), edges.end(),
                                     [&](int x) { return work.root(x) == r; });
            };
            const int step = work.even.at(r) ? 2 : 1;
            if (work.fixed.at(r) || times(shorter) <= times(longer) ||
                work.count.at(r) + step > work.most.at(r)) {
                continue;
            }
            const double v = work.goal.at(r) / (work.count.at(r) + step);
            if (v > value) {
                value = v;
                best = r;
            }
        }
        if (best < 0) {
            return false;
        }
        work.count.at(best) += work.even.at(best) ? 2 : 1;
        changed = true;
        if (std::abs(sum(one) - sum(two)) >= std::abs(a - b) && i > 20) {
            return false;
        }
    }
    return false;
}

// Adds to the sides of a face with three or five until they meet in the middle.
bool meet(Intervals &work, const FacePlan &plan, bool &changed) {
    constexpr int tries = 60;
    for (int i = 0; i < tries; ++i) {
        Numbers n;
        for (std::size_t s = 0; s < plan.corners.size(); ++s) {
            n.push_back(0);
            for (const int e : side_edges(plan, s)) {
                n.back() += work.segments(e);
            }
        }
        if (midpoint_lines(n)) {
            return true;
        }
        // The shortest side that can have more.
        int best = -1;
        int least = 0;
        for (std::size_t s = 0; s < plan.corners.size(); ++s) {
            for (const int e : side_edges(plan, s)) {
                const int r = work.root(e);
                if (!work.fixed.at(r) && work.count.at(r) + 2 <= work.most.at(r) &&
                    (best < 0 || n[s] < least)) {
                    best = r;
                    least = n[s];
                }
            }
        }
        if (best < 0) {
            return false;
        }
        work.count.at(best) += work.even.at(best) ? 2 : 1;
        changed = true;
    }
    return false;
}

} // namespace

std::map<int, int> assign_intervals(const CadShape &shape, std::vector<FacePlan> &plans,
                                    const EdgeSizes &sizes, const Layout &layout) {
    Intervals work{sizes, {}, {}, {}, {}, {}, {}};
    std::map<std::array<int, 2>, std::vector<int>> between;
    for (const auto &[e, size] : sizes) {
        work.parent[e] = e;
        const auto &laid = layout.edges[static_cast<std::size_t>(e)];
        work.fixed[e] = !laid.empty();
        work.even[e] = false;
        work.goal[e] = size.segments();
        work.count[e] = !laid.empty()
                            ? static_cast<int>(laid.size()) - 1
                            : std::max(1, static_cast<int>(std::ceil(size.segments() - 0.2)));
        if (laid.empty()) {
            work.count[e] = std::max(work.count[e], size.closed ? 4 : size.tips() + 1);
        }
        int a = shape.vertices.FindIndex(TopExp::FirstVertex(shape.edge(e)));
        int b = shape.vertices.FindIndex(TopExp::LastVertex(shape.edge(e)));
        between[ascending(a, b)].push_back(e);
    }
    for (const auto &[ends, edges] : between) {
        if (edges.size() > 1 || ends[0] == ends[1]) {
            for (const int e : edges) {
                if (!work.fixed[e]) {
                    work.count[e] = std::max(work.count[e], ends[0] == ends[1] ? 3 : 2);
                }
            }
        }
    }
    constexpr int growth = 6;
    for (const auto &[e, n] : work.count) {
        work.most[e] = growth * n + 16;
    }
    // Two sides of one segment each are no face.
    for (FacePlan &plan : plans) {
        if (plan.corners.size() == 2 && plan.loops.loops.front().size() == 2) {
            for (const EdgeUse &use : plan.loops.loops.front()) {
                if (work.fixed.at(use.edge) && work.count.at(use.edge) == 1) {
                    plan.give_up();
                }
            }
        }
    }
    for (int round = 0; round < 30; ++round) {
        bool changed = false;
        // Equal sides of single edges share a number.
        for (const FacePlan &plan : plans) {
            for (const auto &[one, two] : equal_chains(plan)) {
                if (one.size() == 1 && two.size() == 1) {
                    work.join(one[0], two[0]);
                }
            }
        }
        for (const FacePlan &plan : plans) {
            if (!plan.general() && plan.corners.size() < 3) {
                continue;
            }
            for (const FaceLoop &loop : plan.loops.loops) {
                for (const EdgeUse &use : loop) {
                    if (!use.degenerated) {
                        work.make_even(use.edge);
                    }
                }
            }
            for (const EdgeUse &use : plan.loops.inner) {
                if (!use.degenerated) {
                    work.make_even(use.edge);
                }
            }
        }
        for (FacePlan &plan : plans) {
            bool good = true;
            for (const auto &[one, two] : equal_chains(plan)) {
                good = good && balance(work, one, two, changed);
            }
            if (plan.corners.size() >= 3) {
                good = meet(work, plan, changed);
            }
            if (!good) {
                plan.give_up();
                changed = true;
            }
        }
        if (!changed) {
            break;
        }
    }
    // What no number of rounds made equal is no longer asked for.
    for (FacePlan &plan : plans) {
        bool changed = false;
        bool good = true;
        Intervals copy = work;
        for (const auto &[one, two] : equal_chains(plan)) {
            good = good && balance(copy, one, two, changed);
        }
        if (plan.corners.size() >= 3) {
            good = meet(copy, plan, changed);
        }
        if (!good || changed) {
            plan.give_up();
        }
    }
    // Edges that came with odd numbers: an edge that only one face has makes the sum even.
    std::map<int, int> faces_at;
    for (const FacePlan &plan : plans) {
        for (const FaceLoop &loop : plan.loops.loops) {
            for (const EdgeUse &use : loop) {
                ++faces_at[use.edge];
            }
        }
    }
    // A loop of two edges, one of which came with one segment, is no polygon yet.
    for (const FacePlan &plan : plans) {
        for (const FaceLoop &loop : plan.loops.loops) {
            int sum = 0;
            int free = 0;
            for (const EdgeUse &use : loop) {
                sum += use.degenerated ? 1 : work.segments(use.edge);
                free = use.degenerated || work.fixed.at(work.root(use.edge)) ? free : use.edge;
            }
            if (plan.general() && loop.size() == 2 && sum < 3 && free != 0) {
                work.count.at(work.root(free)) += 4 - sum;
            }
        }
    }
    for (const FacePlan &plan : plans) {
        if (!plan.general()) {
            continue;
        }
        int sum = 0;
        int best = 0;
        for (const FaceLoop &loop : plan.loops.loops) {
            for (const EdgeUse &use : loop) {
                if (use.degenerated) {
                    continue;
                }
                sum += work.segments(use.edge);
                if (!use.seam && !work.fixed.at(work.root(use.edge)) &&
                    (best == 0 || faces_at[use.edge] < faces_at[best])) {
                    best = use.edge;
                }
            }
        }
        if (sum % 2 != 0 && best != 0) {
            ++work.count.at(work.root(best));
        }
    }
    std::map<int, int> result;
    for (const auto &[e, size] : sizes) {
        result[e] = work.segments(e);
    }
    return result;
}

std::map<int, std::vector<double>> place_divisions(const std::vector<FacePlan> &plans,
                                                   const std::map<int, int> &counts,
                                                   const EdgeSizes &sizes, const Layout &layout) {
    std::map<int, std::vector<double>> result;
    std::map<int, double> unevenness; // of what an edge has now; the most uneven is followed
    std::set<int> settled;
    for (const auto &[edge, n] : counts) {
        result[edge] = sizes.at(edge).fractions(n);
        double least = 1;
        double most = 0;
        double last = 0;
        auto all = result[edge];
        all.push_back(1);
        for (const double f : all) {
            least = std::min(least, f - last);
            most = std::max(most, f - last);
            last = f;
        }
        unevenness[edge] = least > 0 ? most / least : 1;
        if (!layout.edges[static_cast<std::size_t>(edge)].empty() || sizes.at(edge).tips() > 0) {
            settled.insert(edge);
        }
    }
    // The shares of its length at which a chain is divided.
    const auto shares = [&](const std::vector<Directed> &chain) {
        double all = 0;
        for (const Directed &d : chain) {
            all += sizes.at(d.edge).length;
        }
        std::vector<double> at;
        double before = 0;
        for (const Directed &d : chain) {
            const double length = sizes.at(d.edge).length / all;
            auto places = result.at(d.edge);
            if (!d.forward) {
                std::reverse(places.begin(), places.end());
                for (double &f : places) {
                    f = 1 - f;
                }
            }
            for (const double f : places) {
                at.push_back(before + f * length);
            }
            before += length;
            at.push_back(before);
        }
        at.pop_back();
        return at;
    };
    const auto follow = [&](const Directed &edge, std::vector<double> at) {
        if (at.size() != result.at(edge.edge).size()) {
            return;
        }
        if (!edge.forward) {
            std::reverse(at.begin(), at.end());
            for (double &f : at) {
                f = 1 - f;
            }
        }
        result[edge.edge] = at;
    };
    for (const FacePlan &plan : plans) {
        for (const auto &[one, two] : facing_chains(plan)) {
            for (const auto &chain : {one, two}) {
                for (const Directed &d : chain) {
                    if (chain.size() > 1) {
                        settled.insert(d.edge);
                    }
                }
            }
        }
    }
    // From settled edges across grids, until nothing changes; then from the most uneven edge left.
    for (;;) {
        bool changed = true;
        while (changed) {
            changed = false;
            for (const FacePlan &plan : plans) {
                for (const auto &[one, two] : facing_chains(plan)) {
                    const auto known = [&](const std::vector<Directed> &chain) {
                        return std::all_of(chain.begin(), chain.end(), [&](const Directed &d) {
                            return settled.contains(d.edge);
                        });
                    };
                    for (const auto &[from, to] : {std::pair(one, two), std::pair(two, one)}) {
                        if (to.size() == 1 && !settled.contains(to[0].edge) && known(from)) {
                            follow(to[0], shares(from));
                            settled.insert(to[0].edge);
                            changed = true;
                        }
                    }
                }
            }
        }
        int next = 0;
        for (const auto &[edge, value] : unevenness) {
            if (!settled.contains(edge) && (next == 0 || value > unevenness.at(next))) {
                next = edge;
            }
        }
        if (next == 0 || unevenness.at(next) < 1 + 1e-9) {
            break;
        }
        settled.insert(next);
    }
    return result;
}

} // namespace nmgs::cad
