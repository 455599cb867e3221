// SPDX-License-Identifier: LGPL-2.1-or-later
// Points by place: finds a stored point within a tolerance in constant time, by hashing a grid of
// cells twice the tolerance wide (Teschner et al., Optimized spatial hashing, 2003).
#pragma once

#include "nmgs/support/vec3.h"

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace nmgs {

class PointHash {
public:
    explicit PointHash(double tolerance)
        : tolerance_(tolerance), scale_(tolerance > 0 ? 0.5 / tolerance : 0.0) {}

    // Index given at insertion of the nearest stored point within the tolerance, or -1.
    [[nodiscard]] std::int64_t find(Vec3 p) const {
        std::int64_t best = -1;
        double best_distance = tolerance_ * tolerance_;
        const Cell c = cell(p);
        // The tolerance is half a cell, so only the neighbours on the nearer side can matter.
        const Vec3 f = fraction(p);
        const int dx = f.x < 0.5 ? -1 : 1;
        const int dy = f.y < 0.5 ? -1 : 1;
        const int dz = f.z < 0.5 ? -1 : 1;
        for (int m = 0; m < 8; ++m) {
            const Cell n{c.x + ((m & 1) != 0 ? dx : 0), c.y + ((m & 2) != 0 ? dy : 0),
                         c.z + ((m & 4) != 0 ? dz : 0)};
            const auto range = heads_.find(key(n));
            if (range == heads_.end()) {
                continue;
            }
            for (std::int64_t e = range->second; e >= 0;
                 e = entries_[static_cast<std::size_t>(e)].next) {
                const Entry &entry = entries_[static_cast<std::size_t>(e)];
                const double d = norm2(entry.point - p);
                if (d < best_distance || (d == best_distance && (best < 0 || entry.index < best))) {
                    best = entry.index;
                    best_distance = d;
                }
            }
        }
        return best;
    }

    void reserve(std::size_t count) {
        heads_.reserve(count);
        entries_.reserve(count);
    }

    void insert(Vec3 p, std::int64_t index) {
        auto [head, fresh] = heads_.try_emplace(key(cell(p)), -1);
        entries_.push_back({p, index, head->second});
        head->second = static_cast<std::int64_t>(entries_.size()) - 1;
    }

private:
    struct Cell {
        std::int64_t x, y, z;
    };
    struct Entry {
        Vec3 point;
        std::int64_t index;
        std::int64_t next;
    };

    [[nodiscard]] Cell cell(Vec3 p) const {
        return {floor(p.x * scale_), floor(p.y * scale_), floor(p.z * scale_)};
    }
    [[nodiscard]] Vec3 fraction(Vec3 p) const {
        const Vec3 s = scale_ * p;
        return {s.x - std::floor(s.x), s.y - std::floor(s.y), s.z - std::floor(s.z)};
    }
    // Saturates: a coordinate far beyond the tolerance's grid must not overflow the conversion.
    static std::int64_t floor(double v) {
        constexpr double limit = 4e18;
        return static_cast<std::int64_t>(std::fmax(-limit, std::fmin(limit, std::floor(v))));
    }
    static std::uint64_t key(const Cell &c) {
        return static_cast<std::uint64_t>(c.x) * 73856093U ^
               static_cast<std::uint64_t>(c.y) * 19349663U ^
               static_cast<std::uint64_t>(c.z) * 83492791U;
    }

    double tolerance_;
    double scale_;
    std::unordered_map<std::uint64_t, std::int64_t> heads_;
    std::vector<Entry> entries_;
};

} // namespace nmgs
