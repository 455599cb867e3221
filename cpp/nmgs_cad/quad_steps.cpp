// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/quad_steps.h"

#include "nmgs/support/at.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nmgs::cad {
namespace {

using Quad = QuadSteps::Quad;
constexpr double pi = std::numbers::pi;

std::size_t corner(const Quad &q, std::int32_t n) {
    return static_cast<std::size_t>(std::find(q.begin(), q.end(), n) - q.begin());
}

} // namespace

QuadSteps::QuadSteps(FaceMesh &m, const FaceSurface &s,
                     const std::set<std::array<std::int32_t, 2>> &edges_kept)
    : mesh(m), surface(s), kept(edges_kept) {
    for (const auto &ends : kept) {
        kept_nodes.insert(ends.begin(), ends.end());
    }
    index();
}

void QuadSteps::index() {
    quads_at.assign(mesh.points.size(), {});
    of_edge.clear();
    for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
        for (std::size_t c = 0; c < 4; ++c) {
            const Quad &quad = mesh.quads[q];
            quads_at[at(quad[c])].push_back(static_cast<std::int32_t>(q));
            of_edge[{quad[c], quad[(c + 1) % 4]}] = static_cast<std::int32_t>(q);
        }
    }
}

void QuadSteps::commit() {
    std::erase_if(mesh.quads, [](const Quad &q) { return q[0] < 0; });
    index();
}

double QuadSteps::price(std::int32_t n, int count) const {
    constexpr double unusable = 12;
    if (!mesh.fixed(n)) {
        return (count - 4) * (count - 4) + (count < 3 ? unusable : 0);
    }
    if (count < 1) {
        return 1000;
    }
    const double angle = mesh.rim[at(n)].angle;
    const int ideal = std::max(1, static_cast<int>(std::lround(angle / (pi / 2))));
    // A quad's corner that is nearly straight cannot be mended by moving nodes.
    const bool flat = angle / count > 0.8 * pi;
    const bool sharp = count > 1 && angle / count < pi / 7;
    return 1.5 * (count - ideal) * (count - ideal) + (flat ? unusable : 0) + (sharp ? 4 : 0);
}

double QuadSteps::change(std::int32_t n, int by) const {
    return price(n, valence(n) + by) - price(n, valence(n));
}

void QuadSteps::rotations(std::int32_t a, std::int32_t b, std::vector<QuadStep> &steps) const {
    const auto own = of_edge.find({a, b});
    const auto twin = of_edge.find({b, a});
    if (own == of_edge.end() || twin == of_edge.end() || is_kept(a, b)) {
        return;
    }
    const Quad &left = quad(own->second);
    const Quad &right = quad(twin->second);
    const std::size_t i = corner(left, b);
    const std::size_t j = corner(right, a);
    // Round the hexagon: b, c, d, a, e, f.
    const std::array<std::int32_t, 6> h{b, left[(i + 1) % 4],  left[(i + 2) % 4],
                                        a, right[(j + 1) % 4], right[(j + 2) % 4]};
    auto sorted = h;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
        return;
    }
    for (std::size_t k = 1; k < 3; ++k) {
        if (joined(h[k], h[k + 3])) {
            continue;
        }
        QuadStep step;
        step.kind = QuadStep::Kind::rotate;
        step.quads = {own->second, twin->second};
        for (std::size_t m = 0; m < 6; ++m) {
            step.ring[m] = h[(k + m) % 6];
        }
        step.gain = change(a, -1) + change(b, -1) + change(h[k], 1) + change(h[k + 3], 1);
        steps.push_back(step);
    }
}

void QuadSteps::closings(std::int32_t q, std::vector<QuadStep> &steps) const {
    const Quad &c = quad(q);
    for (std::size_t k = 0; k < 2; ++k) {
        std::int32_t keep = c[k];
        std::int32_t gone = c[k + 2];
        if (mesh.fixed(gone)) {
            std::swap(keep, gone);
        }
        const std::int32_t b = c[(k + 1) % 4];
        const std::int32_t d = c[(k + 3) % 4];
        if (mesh.fixed(gone) || keep == gone || b == d) {
            continue;
        }
        // Two quads at one of the others that would then share two edges.
        int common = 0;
        for (const std::int32_t n : neighbours(gone)) {
            common += n != keep && joined(n, keep) ? 1 : 0;
        }
        if (common != 2 || joined(keep, gone)) {
            continue;
        }
        QuadStep step;
        step.kind = QuadStep::Kind::close;
        step.quads[0] = q;
        step.node = keep;
        step.other = gone;
        step.a = b;
        step.b = d;
        step.gain = price(keep, valence(keep) + valence(gone) - 2) - price(keep, valence(keep)) -
                    price(gone, valence(gone)) + change(b, -1) + change(d, -1) - 0.2;
        steps.push_back(step);
    }
}
std::vector<std::int32_t> QuadSteps::neighbours(std::int32_t n) const {
    std::vector<std::int32_t> result;
    for (const std::int32_t q : quads_at[at(n)]) {
        const std::size_t c = corner(quad(q), n);
        for (const std::size_t o : {(c + 1) % 4, (c + 3) % 4}) {
            if (std::find(result.begin(), result.end(), quad(q)[o]) == result.end()) {
                result.push_back(quad(q)[o]);
            }
        }
    }
    return result;
}

std::vector<std::int32_t> QuadSteps::fan(std::int32_t n) const {
    const auto &all = quads_at[at(n)];
    std::int32_t first = all.front();
    if (mesh.fixed(n)) {
        for (const std::int32_t q : all) {
            const Quad &c = quad(q);
            // The edge from n is the boundary's.
            if (!of_edge.contains({c[(corner(c, n) + 1) % 4], n})) {
                first = q;
            }
        }
    }
    std::vector<std::int32_t> result{first};
    while (result.size() < all.size()) {
        const Quad &c = quad(result.back());
        const auto next = of_edge.find({n, c[(corner(c, n) + 3) % 4]});
        if (next == of_edge.end() || next->second == first) {
            return {};
        }
        result.push_back(next->second);
    }
    return result;
}

void QuadSteps::openings(std::int32_t n, std::vector<QuadStep> &steps) const {
    const int count = valence(n);
    if (count < (mesh.fixed(n) ? 3 : 5) || kept_nodes.contains(n)) {
        return;
    }
    const auto round = fan(n);
    if (round.empty()) {
        return;
    }
    for (int from = mesh.fixed(n) ? 1 : 0; from < count; ++from) {
        for (int k = 1; k < count - 1; ++k) {
            if (mesh.fixed(n) && from + k >= count) {
                break;
            }
            QuadStep step;
            step.kind = QuadStep::Kind::open;
            step.node = n;
            for (int m = 0; m < k; ++m) {
                step.fan.push_back(round[static_cast<std::size_t>((from + m) % count)]);
            }
            const Quad &first = quad(step.fan.front());
            const Quad &last = quad(step.fan.back());
            step.a = first[(corner(first, n) + 1) % 4];
            step.b = last[(corner(last, n) + 3) % 4];
            if (step.a == step.b) {
                continue;
            }
            step.gain = price(n, count - k + 1) - price(n, count) + (k + 1 - 4) * (k + 1 - 4) +
                        (k + 1 < 3 ? 12 : 0) + change(step.a, 1) + change(step.b, 1) + 0.2;
            steps.push_back(step);
        }
    }
}

void QuadSteps::apply(const QuadStep &step) {
    switch (step.kind) {
    case QuadStep::Kind::rotate: {
        const auto &h = step.ring;
        mesh.quads[at(step.quads[0])] = {h[0], h[1], h[2], h[3]};
        mesh.quads[at(step.quads[1])] = {h[3], h[4], h[5], h[0]};
        break;
    }
    case QuadStep::Kind::close: {
        for (const std::int32_t q : quads_at[at(step.other)]) {
            auto &c = mesh.quads[at(q)];
            std::replace(c.begin(), c.end(), step.other, step.node);
        }
        mesh.quads[at(step.quads[0])] = {-1, -1, -1, -1};
        if (!mesh.fixed(step.node)) {
            const Uv middle = 0.5 * (mesh.uv[at(step.node)] + mesh.uv[at(step.other)]);
            mesh.move(surface, step.node, middle);
        }
        break;
    }
    case QuadStep::Kind::open: {
        Uv centre{0, 0};
        for (const std::int32_t q : step.fan) {
            const Quad &c = quad(q);
            centre = centre + mesh.uv[at(c[(corner(c, step.node) + 2) % 4])];
        }
        const double share = 1.0 / static_cast<double>(step.fan.size());
        const Uv from = mesh.uv[at(step.node)];
        const std::int32_t made = mesh.add(surface, from + 0.3 * (share * centre - from));
        for (const std::int32_t q : step.fan) {
            auto &c = mesh.quads[at(q)];
            std::replace(c.begin(), c.end(), step.node, made);
        }
        mesh.quads.push_back({step.node, step.a, made, step.b});
        break;
    }
    }
}

std::vector<std::int32_t> QuadSteps::touched(const QuadStep &step) const {
    std::vector<std::int32_t> nodes{step.node, step.other, step.a, step.b};
    if (step.kind == QuadStep::Kind::rotate) {
        nodes.assign(step.ring.begin(), step.ring.end());
    }
    for (const std::int32_t n : {step.node, step.other}) {
        if (n >= 0) {
            for (const std::int32_t q : quads_at[at(n)]) {
                nodes.insert(nodes.end(), quad(q).begin(), quad(q).end());
            }
        }
    }
    std::erase(nodes, -1);
    return nodes;
}

} // namespace nmgs::cad
