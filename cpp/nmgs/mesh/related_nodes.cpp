// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/mesh/related_nodes.h"

#include "nmgs/support/memory.h"
#include "nmgs/support/parallel.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

namespace nmgs {
namespace {

// Which local nodes an edge joins to each local node of a type.
struct Star {
    std::array<std::int8_t, 20> count{};
    std::array<std::array<std::int8_t, 8>, 20> nodes{};
};

Star make_star(CellType type) {
    Star star;
    const auto join = [&](int a, int b) {
        const auto i = static_cast<std::size_t>(a);
        star.nodes[i][static_cast<std::size_t>(star.count[i]++)] = static_cast<std::int8_t>(b);
    };
    for (const LocalEdge &edge : edges(type)) {
        if (is_quadratic(type)) {
            join(edge.a, edge.mid);
            join(edge.mid, edge.a);
            join(edge.mid, edge.b);
            join(edge.b, edge.mid);
        } else {
            join(edge.a, edge.b);
            join(edge.b, edge.a);
        }
    }
    return star;
}

// The places at which the cells name each node: positions in the arrays of nodes, one behind the
// other, sorted by node. Index is 32 bits wide where that is enough.
template <class Index>
struct Uses {
    std::vector<Index> first; // of each node; points + 1
    Array<Index> places;
};

template <class Index>
Uses<Index> find_uses(std::size_t points, std::span<const CellView> cells, std::size_t total,
                      const Progress &progress) {
    Uses<Index> uses{std::vector<Index>(points + 1, 0), Array<Index>(total)};
    constexpr std::size_t step = 1 << 20;
    for (const CellView &view : cells) {
        for (std::size_t i = 0; i < view.nodes.size(); ++i) {
            ++uses.first[static_cast<std::size_t>(view.nodes[i]) + 1];
        }
        poll(progress, 0.1);
    }
    for (std::size_t n = 0; n < points; ++n) {
        uses.first[n + 1] += uses.first[n];
    }
    std::size_t place = 0;
    for (const CellView &view : cells) {
        for (std::size_t i = 0; i < view.nodes.size(); ++i, ++place) {
            if (i % step == 0) {
                poll(progress, 0.1 + 0.3 * static_cast<double>(place) / static_cast<double>(total));
            }
            uses.places[uses.first[static_cast<std::size_t>(view.nodes[i])]++] =
                static_cast<Index>(place);
        }
    }
    // Filling moved each start to its end, which is the next one's start.
    for (std::size_t n = points; n > 0; --n) {
        uses.first[n] = uses.first[n - 1];
    }
    uses.first[0] = 0;
    return uses;
}

// Marks of the nodes already met; one a thread, handed out and taken back.
class Marks {
public:
    explicit Marks(std::size_t points) : points_(points) {}
    std::unique_ptr<std::vector<std::int32_t>> take() {
        const std::lock_guard lock(mutex_);
        if (free_.empty()) {
            return std::make_unique<std::vector<std::int32_t>>(points_, -1);
        }
        auto marks = std::move(free_.back());
        free_.pop_back();
        return marks;
    }
    void give(std::unique_ptr<std::vector<std::int32_t>> marks) {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(marks));
    }

private:
    std::size_t points_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<std::vector<std::int32_t>>> free_;
};

// Appends to `found` the nodes that the cells of one type join to `node`.
template <int K, class Index>
std::int32_t *gather(const Star &star, const std::int32_t *nodes, const Index *places,
                     const Index *end, std::size_t base, std::int32_t node, std::int32_t *marks,
                     std::int32_t *found) {
    for (; places != end; ++places) {
        const std::size_t at = static_cast<std::size_t>(*places) - base;
        const std::size_t local = at % K;
        const std::int32_t *cell = nodes + (at - local);
        const int count = star.count[local];
        for (int i = 0; i < count; ++i) {
            const std::int32_t other = cell[star.nodes[local][static_cast<std::size_t>(i)]];
            // Written always, kept when new: no branch to guess.
            *found = other;
            found += marks[other] != node ? 1 : 0;
            marks[other] = node;
        }
    }
    return found;
}

template <class Index>
using Gather = std::int32_t *(*)(const Star &, const std::int32_t *, const Index *, const Index *,
                                 std::size_t, std::int32_t, std::int32_t *, std::int32_t *);

template <class Index>
Gather<Index> gather_of(CellType type) {
    switch (node_count(type)) {
    case 2:
        return gather<2, Index>;
    case 3:
        return gather<3, Index>;
    case 4:
        return gather<4, Index>;
    case 5:
        return gather<5, Index>;
    case 6:
        return gather<6, Index>;
    case 8:
        return gather<8, Index>;
    case 10:
        return gather<10, Index>;
    case 13:
        return gather<13, Index>;
    case 15:
        return gather<15, Index>;
    default:
        return gather<20, Index>;
    }
}

template <class Index>
RelatedNodes relate(std::size_t points, std::span<const CellView> cells, std::size_t total,
                    const Progress &progress) {
    const auto uses = find_uses<Index>(points, cells, total, progress);
    std::vector<Star> stars;
    std::vector<Gather<Index>> gathers;
    std::vector<std::size_t> bases{0};
    std::size_t widest = 0;
    for (const CellView &view : cells) {
        stars.push_back(make_star(view.type));
        gathers.push_back(gather_of<Index>(view.type));
        bases.push_back(bases.back() + view.nodes.size());
        for (const auto count : stars.back().count) {
            widest = std::max(widest, static_cast<std::size_t>(count));
        }
    }

    constexpr std::size_t grain = 1 << 12;
    const std::size_t chunks = (points + grain - 1) / grain;
    std::vector<std::vector<std::int32_t>> parts(chunks);
    RelatedNodes result{Array<std::int64_t>(points + 1), {}};
    Marks pool(points);
    parallel_for(
        points, grain,
        [&](std::size_t first, std::size_t last) {
            auto marks = pool.take();
            auto &part = parts[first / grain];
            std::size_t filled = 0;
            for (std::size_t n = first; n < last; ++n) {
                const Index *places = uses.places.data() + uses.first[n];
                const Index *const end = uses.places.data() + uses.first[n + 1];
                const std::size_t most = static_cast<std::size_t>(end - places) * widest + 1;
                if (part.size() < filled + most) {
                    part.resize(2 * part.size() + most + 16 * grain);
                }
                const auto node = static_cast<std::int32_t>(n);
                std::int32_t *const begin = part.data() + filled;
                std::int32_t *found = begin;
                (*marks)[n] = node;
                for (std::size_t b = 0; b < cells.size(); ++b) {
                    const Index *const stop =
                        cells.size() == 1 ? end : std::lower_bound(places, end, bases[b + 1]);
                    found = gathers[b](stars[b], cells[b].nodes.data(), places, stop, bases[b],
                                       node, marks->data(), found);
                    places = stop;
                }
                std::sort(begin, found);
                result.offsets[n + 1] = found - begin;
                filled += static_cast<std::size_t>(found - begin);
            }
            part.resize(filled);
            pool.give(std::move(marks));
        },
        progress, 0.4, 0.9);

    result.offsets[0] = 0;
    for (std::size_t n = 0; n < points; ++n) {
        result.offsets[n + 1] += result.offsets[n];
    }
    result.neighbours = Array<std::int32_t>(static_cast<std::size_t>(result.offsets[points]));
    parallel_for(
        chunks, 1,
        [&](std::size_t first, std::size_t last) {
            for (std::size_t c = first; c < last; ++c) {
                if (!parts[c].empty()) {
                    std::memcpy(result.neighbours.data() + result.offsets[c * grain],
                                parts[c].data(), parts[c].size() * sizeof(std::int32_t));
                }
                parts[c] = {};
            }
        },
        progress, 0.9, 1.0);
    return result;
}

} // namespace

RelatedNodes related_nodes(std::size_t points, std::span<const CellView> cells,
                           const Progress &progress) {
    check_nodes(cells, points);
    std::size_t total = 0;
    for (const CellView &view : cells) {
        total += view.nodes.size();
    }
    const bool narrow = total <= std::numeric_limits<std::uint32_t>::max();
    require_memory(static_cast<std::int64_t>(total) * (narrow ? 4 : 8), "the related nodes");
    return narrow ? relate<std::uint32_t>(points, cells, total, progress)
                  : relate<std::uint64_t>(points, cells, total, progress);
}

} // namespace nmgs
