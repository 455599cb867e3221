// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/logical_directions.h"

#include "nmgs_cad/edge_curve.h"

#include <BRep_Tool.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace nmgs::cad {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int values = 6;
using Values = std::array<double, values>;

constexpr std::array<int, 3> components(int direction) {
    std::array<int, 3> v{0, 0, 0};
    v[static_cast<std::size_t>(axis_of(direction))] = sign_of(direction);
    return v;
}

constexpr int turns_between(int axis, int from, int to) {
    if (axis_of(axis) == axis_of(from) || axis_of(axis) == axis_of(to)) {
        return -1;
    }
    if (from == to) {
        return 0;
    }
    if (axis_of(from) == axis_of(to)) {
        return 2;
    }
    const auto a = components(axis);
    const auto f = components(from);
    const auto t = components(to);
    const int left = a[0] * (f[1] * t[2] - f[2] * t[1]) + a[1] * (f[2] * t[0] - f[0] * t[2]) +
                     a[2] * (f[0] * t[1] - f[1] * t[0]);
    return left > 0 ? 1 : 3;
}

// Of all axes and directions: the search asks for little else.
constexpr std::array<std::int8_t, values * values * values> all_quarter_turns() {
    std::array<std::int8_t, values * values * values> table{};
    for (int n = 0; n < values * values * values; ++n) {
        table[static_cast<std::size_t>(n)] = static_cast<std::int8_t>(
            turns_between(n / (values * values), n / values % values, n % values));
    }
    return table;
}

// An angle taken for `count` right angles: nothing for the right one, more for a worse one, and
// infinite where the blocks would have hardly any angle left.
double angle_cost(double angle, int count) {
    const double each = angle / count;
    const double least = std::numbers::pi / 12;
    if (each < least || each > std::numbers::pi - least) {
        return infinite;
    }
    return count * (each - std::numbers::pi / 2) * (each - std::numbers::pi / 2);
}

// Variables `from` and `to` differ by quarter turns about variable `axis`; cost[turns]. A variable
// is a face or an edge; a negated one stands for the opposite direction.
struct Relation {
    std::array<int, 3> variable; // axis, from, to
    std::array<bool, 3> negated;
    std::array<double, 4> cost;
};

struct Search {
    const SolidBoundary &boundary;
    std::vector<Relation> relations;
    std::vector<std::vector<int>> relations_of;
    std::vector<int> edge_variable; // by coedge
    std::size_t faces;
    std::vector<LogicalDirections> found;
    int budget = 4000;

    std::vector<int> value;
    std::vector<Values> domain;

    [[nodiscard]] int direction(std::size_t coedge) const {
        const int v = value[static_cast<std::size_t>(edge_variable[coedge])];
        return boundary.coedges[coedge].forward ? v : v ^ 1;
    }
    [[nodiscard]] double relation_cost(const Relation &r, std::array<int, 3> v) const {
        for (std::size_t i = 0; i < 3; ++i) {
            v[i] = r.negated[i] ? v[i] ^ 1 : v[i];
        }
        const int turns = quarter_turns(v[0], v[1], v[2]);
        return turns < 0 ? infinite : r.cost[static_cast<std::size_t>(turns)];
    }
    // The least cost of a relation for each value of one of its variables; variables without a
    // value may take any.
    void add_cost(const Relation &r, std::size_t place, Values &sum) const {
        std::array<int, 3> v{};
        for (int x = 0; x < values; ++x) {
            double least = infinite;
            const std::size_t a = (place + 1) % 3;
            const std::size_t b = (place + 2) % 3;
            const int va = value[static_cast<std::size_t>(r.variable[a])];
            const int vb = value[static_cast<std::size_t>(r.variable[b])];
            v[place] = x;
            for (v[a] = va < 0 ? 0 : va; v[a] < (va < 0 ? values : va + 1); ++v[a]) {
                for (v[b] = vb < 0 ? 0 : vb; v[b] < (vb < 0 ? values : vb + 1); ++v[b]) {
                    least = std::min(least, relation_cost(r, v));
                }
            }
            sum[static_cast<std::size_t>(x)] += least;
        }
    }
    void update(int variable) {
        Values sum{};
        for (const int n : relations_of[static_cast<std::size_t>(variable)]) {
            const Relation &r = relations[static_cast<std::size_t>(n)];
            bool touched = false;
            for (const int other : r.variable) {
                touched = touched || value[static_cast<std::size_t>(other)] >= 0;
            }
            if (!touched) {
                continue;
            }
            for (std::size_t i = 0; i < 3; ++i) {
                if (r.variable[i] == variable) {
                    add_cost(r, i, sum);
                    break;
                }
            }
        }
        domain[static_cast<std::size_t>(variable)] = sum;
    }
    // One loop goes once round the face, the others once round a hole each.
    [[nodiscard]] bool closes(std::size_t face) const {
        int outer = 0;
        for (const int start : boundary.loops[face]) {
            int sum = 0;
            int at = start;
            do {
                const Coedge &c = boundary.coedges[static_cast<std::size_t>(at)];
                const int turns =
                    quarter_turns(value[face], direction(static_cast<std::size_t>(at)),
                                  direction(static_cast<std::size_t>(c.next)));
                sum += turns == 3 ? -1 : turns;
                at = c.next;
            } while (at != start);
            if (sum != 4 && sum != -4) {
                return false;
            }
            outer += sum == 4 ? 1 : 0;
        }
        return outer == 1;
    }
    [[nodiscard]] bool complete(std::size_t face) const {
        for (const int start : boundary.loops[face]) {
            int at = start;
            do {
                const auto c = static_cast<std::size_t>(at);
                if (value[static_cast<std::size_t>(edge_variable[c])] < 0) {
                    return false;
                }
                at = boundary.coedges[c].next;
            } while (at != start);
        }
        return value[face] >= 0;
    }
    [[nodiscard]] bool loops_close(int variable) const {
        for (const int n : relations_of[static_cast<std::size_t>(variable)]) {
            for (const int other : relations[static_cast<std::size_t>(n)].variable) {
                const auto face = static_cast<std::size_t>(other);
                if (face < faces && complete(face) && !closes(face)) {
                    return false;
                }
            }
        }
        return true;
    }
    // True when the value does not contradict what is known.
    bool assign(int variable, int x) {
        value[static_cast<std::size_t>(variable)] = x;
        for (const int n : relations_of[static_cast<std::size_t>(variable)]) {
            for (const int other : relations[static_cast<std::size_t>(n)].variable) {
                if (value[static_cast<std::size_t>(other)] < 0) {
                    update(other);
                }
            }
        }
        return loops_close(variable);
    }
    void keep(double cost) {
        LogicalDirections result{{}, {}, cost};
        for (std::size_t f = 0; f < faces; ++f) {
            result.face.push_back(static_cast<std::int8_t>(value[f]));
        }
        for (std::size_t c = 0; c < edge_variable.size(); ++c) {
            result.coedge.push_back(static_cast<std::int8_t>(direction(c)));
        }
        found.push_back(std::move(result));
        std::sort(found.begin(), found.end(),
                  [](const auto &a, const auto &b) { return a.cost < b.cost; });
        constexpr std::size_t most = 6;
        if (found.size() > most) {
            found.pop_back();
        }
    }
    void run(double cost) {
        if (--budget < 0 || (found.size() == 6 && cost >= found.back().cost)) {
            return;
        }
        // The variable whose best value is clearest.
        int next = -1;
        double clearest = -1;
        for (std::size_t v = 0; v < value.size(); ++v) {
            if (value[v] >= 0) {
                continue;
            }
            Values sorted = domain[v];
            std::sort(sorted.begin(), sorted.end());
            if (sorted[0] == infinite) {
                return;
            }
            const double gap = sorted[1] - sorted[0];
            if (gap > clearest) {
                clearest = gap;
                next = static_cast<int>(v);
            }
        }
        if (next < 0) {
            keep(cost);
            return;
        }
        const Values choices = domain[static_cast<std::size_t>(next)];
        std::array<int, values> order{0, 1, 2, 3, 4, 5};
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
            return choices[static_cast<std::size_t>(a)] < choices[static_cast<std::size_t>(b)];
        });
        for (const int x : order) {
            const double more = choices[static_cast<std::size_t>(x)];
            if (more == infinite) {
                break;
            }
            const auto saved_value = value;
            const auto saved_domain = domain;
            if (assign(next, x)) {
                run(cost + more);
            }
            value = saved_value;
            domain = saved_domain;
        }
    }
};

Vec3 chord(const CadShape &shape, const Coedge &c) {
    const EdgeCurve curve(shape.edge(c.edge));
    const Vec3 v = curve.at(1) - curve.at(0);
    return c.forward ? v : -1.0 * v;
}

Vec3 vector_area(const CadShape &shape, const SolidBoundary &boundary, int start) {
    Vec3 area{0, 0, 0};
    Vec3 origin{};
    int at = start;
    do {
        const Coedge &c = boundary.coedges[static_cast<std::size_t>(at)];
        const EdgeCurve curve(shape.edge(c.edge));
        if (at == start) {
            origin = curve.at(c.forward ? 0 : 1);
        }
        for (int i = 0; i < 4; ++i) {
            const Vec3 a = curve.at(c.forward ? 0.25 * i : 1 - 0.25 * i);
            const Vec3 b = curve.at(c.forward ? 0.25 * (i + 1) : 1 - 0.25 * (i + 1));
            area += cross(a - origin, b - origin);
        }
        at = c.next;
    } while (at != start);
    return area;
}

// A face's holes have no edge in common with its outline: their longest edges are turned as they
// lie to the outline's longest, about the normal that the loop's area gives.
void relate_loops(const CadShape &shape, const SolidBoundary &boundary, std::size_t face,
                  const std::vector<int> &edge_variable, std::vector<Relation> &relations) {
    const auto &loops = boundary.loops[face];
    std::vector<int> longest;
    std::size_t outer = 0;
    double largest = -1;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const double area = norm(vector_area(shape, boundary, loops[l]));
        if (area > largest) {
            largest = area;
            outer = l;
        }
        int best = loops[l];
        double length = -1;
        int at = loops[l];
        do {
            const Coedge &c = boundary.coedges[static_cast<std::size_t>(at)];
            const double here = norm(chord(shape, c));
            if (here > length * (1 + 1e-6)) {
                length = here;
                best = at;
            }
            at = c.next;
        } while (at != loops[l]);
        longest.push_back(best);
    }
    const Vec3 normal = vector_area(shape, boundary, loops[outer]);
    const auto &reference = boundary.coedges[static_cast<std::size_t>(longest[outer])];
    const Vec3 from = chord(shape, reference);
    for (std::size_t l = 0; l < loops.size(); ++l) {
        if (l == outer) {
            continue;
        }
        const Coedge &c = boundary.coedges[static_cast<std::size_t>(longest[l])];
        const Vec3 to = chord(shape, c);
        const double turn = std::atan2(
            dot(normal, cross(from, to)) / std::max(norm(normal), 1e-300), dot(from, to));
        Relation r{{static_cast<int>(face), edge_variable[static_cast<std::size_t>(longest[outer])],
                    edge_variable[static_cast<std::size_t>(longest[l])]},
                   {false, !reference.forward, !c.forward},
                   {}};
        for (int k = 0; k < 4; ++k) {
            const double away =
                std::remainder(turn - k * std::numbers::pi / 2, 2 * std::numbers::pi);
            r.cost[static_cast<std::size_t>(k)] = away * away;
        }
        relations.push_back(r);
    }
}

} // namespace

int quarter_turns(int axis, int from, int to) {
    static constexpr auto table = all_quarter_turns();
    return table[static_cast<std::size_t>((axis * values + from) * values + to)];
}

std::vector<LogicalDirections> logical_directions(const CadShape &shape,
                                                  const SolidBoundary &boundary, Refusal &refusal) {
    const std::string name = entity_name(3, boundary.solid);
    for (std::size_t i = 0; i < boundary.coedges.size(); ++i) {
        const Coedge &c = boundary.coedges[i];
        const auto edge = entity_name(1, c.edge);
        if (c.degenerated) {
            refusal = {"a face of " + name + " has a pole", {edge}};
            return {};
        }
        if (boundary.seam(static_cast<int>(i))) {
            refusal = {"a face of " + name + " meets itself along the seam ", {edge}};
            refusal.reason += edge;
            return {};
        }
        if (c.next == static_cast<int>(i)) {
            refusal = {edge + " is closed and has no corners", {edge}};
            return {};
        }
    }
    constexpr std::size_t most = 600;
    if (boundary.faces.size() + boundary.coedges.size() / 2 > most) {
        refusal = {name + " has too many faces and edges for a search over their directions",
                   {name}};
        return {};
    }

    const std::size_t faces = boundary.faces.size();
    Search search{boundary, {}, {}, {}, faces, {}, 4000, {}, {}};
    std::map<int, int> variable;
    for (const Coedge &c : boundary.coedges) {
        const auto next = static_cast<int>(faces + variable.size());
        search.edge_variable.push_back(variable.try_emplace(c.edge, next).first->second);
    }
    for (std::size_t i = 0; i < boundary.coedges.size(); ++i) {
        const Coedge &c = boundary.coedges[i];
        const auto prev = static_cast<std::size_t>(c.prev);
        search.relations.push_back({{c.face, search.edge_variable[prev], search.edge_variable[i]},
                                    {false, !boundary.coedges[prev].forward, !c.forward},
                                    {angle_cost(c.corner, 2), angle_cost(c.corner, 1), infinite,
                                     angle_cost(c.corner, 3)}});
        if (search.relations.back().cost[0] == infinite &&
            search.relations.back().cost[1] == infinite &&
            search.relations.back().cost[3] == infinite) {
            refusal = {entity_name(2, boundary.faces[static_cast<std::size_t>(c.face)]) +
                           " runs out to a point at " + entity_name(0, c.vertex),
                       {entity_name(0, c.vertex)}};
            return {};
        }
        if (c.mate > static_cast<int>(i)) {
            const int other = boundary.coedges[static_cast<std::size_t>(c.mate)].face;
            search.relations.push_back({{search.edge_variable[i], c.face, other},
                                        {!c.forward, false, false},
                                        {angle_cost(c.dihedral, 2), angle_cost(c.dihedral, 1),
                                         infinite, angle_cost(c.dihedral, 3)}});
        }
    }
    for (std::size_t f = 0; f < faces; ++f) {
        if (boundary.loops[f].size() > 1) {
            relate_loops(shape, boundary, f, search.edge_variable, search.relations);
        }
    }
    const std::size_t variables = faces + variable.size();
    search.relations_of.resize(variables);
    for (std::size_t r = 0; r < search.relations.size(); ++r) {
        for (const int v : search.relations[r].variable) {
            auto &list = search.relations_of[static_cast<std::size_t>(v)];
            if (list.empty() || list.back() != static_cast<int>(r)) {
                list.push_back(static_cast<int>(r));
            }
        }
    }
    search.value.assign(variables, -1);
    search.domain.assign(variables, Values{});
    // Which way is which is free: the first face looks along zeta, its first edge runs along xi.
    search.assign(0, 4);
    const auto first = static_cast<std::size_t>(boundary.loops[0].front());
    search.assign(search.edge_variable[first], boundary.coedges[first].forward ? 0 : 1);
    search.run(0);
    if (search.found.empty()) {
        refusal = {name + " cannot be taken for a solid made of cubes: its angles do not add up to "
                          "right angles",
                   {name}};
    }
    return std::move(search.found);
}

} // namespace nmgs::cad
