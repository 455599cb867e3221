// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/quad_cleanup.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace nmgs::cad {
namespace {

using Quad = std::array<std::int32_t, 4>;
constexpr double pi = std::numbers::pi;

struct Step {
    enum class Kind { rotate, close, open } kind = Kind::rotate;
    double gain = 0;
    std::array<std::int32_t, 2> quads{-1, -1}; // rotate: both; close: the first
    std::array<std::int32_t, 6> ring{};        // rotate: the hexagon, new edge from 0 to 3
    std::int32_t node = -1;                    // close: keeps; open: divided
    std::int32_t other = -1;                   // close: goes
    std::vector<std::int32_t> fan;             // open: quads that the new node takes
    std::int32_t a = -1, b = -1;               // open: ends of the new quad's other diagonal
};

struct CleanUp {
    FaceMesh &mesh;
    const FaceSurface &surface;
    std::vector<std::vector<std::int32_t>> quads_at;
    std::map<std::array<std::int32_t, 2>, std::int32_t> of_edge; // quad on the left of a -> b

    CleanUp(FaceMesh &m, const FaceSurface &s) : mesh(m), surface(s) { index(); }

    void index() {
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
    static std::size_t at(std::int32_t n) { return static_cast<std::size_t>(n); }
    [[nodiscard]] const Quad &quad(std::int32_t q) const { return mesh.quads[at(q)]; }
    [[nodiscard]] int valence(std::int32_t n) const {
        return static_cast<int>(quads_at[at(n)].size());
    }
    [[nodiscard]] bool joined(std::int32_t a, std::int32_t b) const {
        return of_edge.contains({a, b}) || of_edge.contains({b, a});
    }
    // How far a number of quads is from what is wanted at the node.
    [[nodiscard]] double price(std::int32_t n, int count) const {
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
    [[nodiscard]] double change(std::int32_t n, int by) const {
        return price(n, valence(n) + by) - price(n, valence(n));
    }
    [[nodiscard]] static std::size_t corner(const Quad &q, std::int32_t n) {
        return static_cast<std::size_t>(std::find(q.begin(), q.end(), n) - q.begin());
    }

    void rotations(std::vector<Step> &steps) const {
        for (const auto &[ends, q] : of_edge) {
            const auto [a, b] = ends;
            const auto twin = of_edge.find({b, a});
            if (a > b || twin == of_edge.end()) {
                continue;
            }
            const Quad &left = quad(q);
            const Quad &right = quad(twin->second);
            const std::size_t i = corner(left, b);
            const std::size_t j = corner(right, a);
            // Round the hexagon: b, c, d, a, e, f.
            const std::array<std::int32_t, 6> h{b, left[(i + 1) % 4],  left[(i + 2) % 4],
                                                a, right[(j + 1) % 4], right[(j + 2) % 4]};
            auto sorted = h;
            std::sort(sorted.begin(), sorted.end());
            if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
                continue;
            }
            for (std::size_t k = 1; k < 3; ++k) {
                if (joined(h[k], h[k + 3])) {
                    continue;
                }
                Step step;
                step.kind = Step::Kind::rotate;
                step.quads = {q, twin->second};
                for (std::size_t m = 0; m < 6; ++m) {
                    step.ring[m] = h[(k + m) % 6];
                }
                step.gain = change(a, -1) + change(b, -1) + change(h[k], 1) + change(h[k + 3], 1);
                steps.push_back(step);
            }
        }
    }
    void closings(std::vector<Step> &steps) const {
        for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
            const Quad &c = mesh.quads[q];
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
                Step step;
                step.kind = Step::Kind::close;
                step.quads[0] = static_cast<std::int32_t>(q);
                step.node = keep;
                step.other = gone;
                step.a = b;
                step.b = d;
                step.gain = price(keep, valence(keep) + valence(gone) - 2) -
                            price(keep, valence(keep)) - price(gone, valence(gone)) +
                            change(b, -1) + change(d, -1) - 0.2;
                steps.push_back(step);
            }
        }
    }
    [[nodiscard]] std::vector<std::int32_t> neighbours(std::int32_t n) const {
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
    // Quads at the node in their order round it, counter-clockwise; empty when they are no fan.
    [[nodiscard]] std::vector<std::int32_t> fan(std::int32_t n) const {
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
    void openings(std::vector<Step> &steps) const {
        for (std::size_t i = 0; i < mesh.points.size(); ++i) {
            const auto n = static_cast<std::int32_t>(i);
            const int count = valence(n);
            if (count < (mesh.fixed(n) ? 3 : 5)) {
                continue;
            }
            const auto round = fan(n);
            if (round.empty()) {
                continue;
            }
            for (int from = mesh.fixed(n) ? 1 : 0; from < count; ++from) {
                for (int k = 1; k < count - 1; ++k) {
                    if (mesh.fixed(n) && from + k >= count) {
                        break;
                    }
                    Step step;
                    step.kind = Step::Kind::open;
                    step.node = n;
                    for (int m = 0; m < k; ++m) {
                        step.fan.push_back(round[at((from + m) % count)]);
                    }
                    const Quad &first = quad(step.fan.front());
                    const Quad &last = quad(step.fan.back());
                    step.a = first[(corner(first, n) + 1) % 4];
                    step.b = last[(corner(last, n) + 3) % 4];
                    if (step.a == step.b) {
                        continue;
                    }
                    step.gain = price(n, count - k + 1) - price(n, count) +
                                (k + 1 - 4) * (k + 1 - 4) + (k + 1 < 3 ? 12 : 0) +
                                change(step.a, 1) + change(step.b, 1) + 0.2;
                    steps.push_back(step);
                }
            }
        }
    }

    void apply(const Step &step) {
        switch (step.kind) {
        case Step::Kind::rotate: {
            const auto &h = step.ring;
            mesh.quads[at(step.quads[0])] = {h[0], h[1], h[2], h[3]};
            mesh.quads[at(step.quads[1])] = {h[3], h[4], h[5], h[0]};
            break;
        }
        case Step::Kind::close: {
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
        case Step::Kind::open: {
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
    // The nodes whose quads a step changes.
    [[nodiscard]] std::vector<std::int32_t> touched(const Step &step) const {
        std::vector<std::int32_t> nodes{step.node, step.other, step.a, step.b};
        if (step.kind == Step::Kind::rotate) {
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
    bool pass() {
        std::vector<Step> steps;
        rotations(steps);
        closings(steps);
        openings(steps);
        std::erase_if(steps, [](const Step &s) { return s.gain > -0.5; });
        std::stable_sort(steps.begin(), steps.end(),
                         [](const Step &s, const Step &t) { return s.gain < t.gain; });
        std::vector<char> busy(mesh.points.size(), 0);
        bool any = false;
        for (const Step &step : steps) {
            const auto nodes = touched(step);
            if (std::any_of(nodes.begin(), nodes.end(),
                            [&](std::int32_t n) { return busy[at(n)] != 0; })) {
                continue;
            }
            for (const std::int32_t n : nodes) {
                busy[at(n)] = 1;
            }
            apply(step);
            any = true;
        }
        std::erase_if(mesh.quads, [](const Quad &q) { return q[0] < 0; });
        index();
        return any;
    }
};

} // namespace

void clean_up_quads(FaceMesh &mesh, const FaceSurface &surface) {
    CleanUp work(mesh, surface);
    constexpr int passes = 30;
    for (int i = 0; i < passes && work.pass(); ++i) {
    }
}

} // namespace nmgs::cad
