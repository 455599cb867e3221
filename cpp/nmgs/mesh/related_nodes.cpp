// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/mesh/related_nodes.h"

#include "nmgs/mesh/cell_edges.h"
#include "nmgs/support/parallel.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

namespace nmgs {
namespace {

// The upper neighbours of a node are those with higher numbers. They are found first, by whichever
// cells come along, then turned round to find the lower ones: so each edge is searched for once.

// An edge that had no room in its row, the lower node in the upper half.
using Pair = std::uint64_t;

Pair pair_of(std::int32_t low, std::int32_t high) {
    return static_cast<Pair>(low) << 32 | static_cast<Pair>(high);
}
std::int32_t low(Pair pair) {
    return static_cast<std::int32_t>(pair >> 32);
}
std::int32_t high(Pair pair) {
    return static_cast<std::int32_t>(pair & 0xffffffffU);
}

// Cells that are looked at together; they fit a first-level cache.
struct Piece {
    CellType type;
    std::span<const std::int32_t> nodes;
    // Lower nodes of the edges are in [first, last].
    std::int32_t first = 0;
    std::int32_t last = std::numeric_limits<std::int32_t>::max();

    [[nodiscard]] bool reaches(std::int32_t begin, std::int32_t end) const {
        return first < end && last >= begin;
    }
};

std::vector<Piece> pieces_of(std::span<const CellView> cells) {
    constexpr std::size_t size = 12 << 7;
    std::vector<Piece> pieces;
    for (const CellView &view : cells) {
        const auto k = static_cast<std::size_t>(node_count(view.type));
        for (std::size_t c = 0; c < view.size(); c += size) {
            const std::size_t some = std::min(view.size() - c, size);
            pieces.push_back({view.type, view.nodes.subspan(c * k, some * k)});
        }
    }
    return pieces;
}

bool has_wrong_node(const Piece &piece, std::size_t points) {
    bool wrong = false;
    for (const std::int32_t node : piece.nodes) {
        wrong |= static_cast<std::uint32_t>(node) >= points;
    }
    return wrong;
}

// The lower node of an edge is at most the second highest node of its cell.
void find_range(Piece &piece) {
    const auto k = static_cast<std::size_t>(node_count(piece.type));
    piece.first = std::numeric_limits<std::int32_t>::max();
    piece.last = -1;
    for (std::size_t c = 0; c < piece.nodes.size(); c += k) {
        std::int32_t highest = -1;
        std::int32_t second = -1;
        for (const std::int32_t node : piece.nodes.subspan(c, k)) {
            piece.first = std::min(piece.first, node);
            second = std::max(second, std::min(highest, node));
            highest = std::max(highest, node);
        }
        piece.last = std::max(piece.last, second);
    }
}

// Polls while threads work on long parts.
class Pulse {
public:
    Pulse(const Progress &progress, double from, double to)
        : progress_(progress), from_(from), to_(to) {}
    // Whether to go on. Raises what the listener raises, or Cancelled, in the listener's thread.
    bool operator()(std::size_t done, std::size_t total) {
        if (std::this_thread::get_id() == owner_) {
            const double share = static_cast<double>(done) / static_cast<double>(total);
            try {
                poll(progress_, from_ + (to_ - from_) * share);
            } catch (...) {
                stopped_ = true;
                throw;
            }
        }
        return !stopped_;
    }

private:
    const Progress &progress_;
    double from_, to_;
    std::thread::id owner_ = std::this_thread::get_id();
    std::atomic<bool> stopped_{false};
};

// Where each of the threads' parts begins, and the end: nodes are shared out so that about as many
// pieces begin in each.
std::vector<std::int32_t> parts_of(std::vector<Piece> &pieces, std::size_t points,
                                   std::span<const CellView> cells, const Progress &progress) {
    constexpr int most = 16; // beyond, reading the cells takes longer than what is gained
    const auto count = static_cast<std::size_t>(std::min(threads(), most));
    const auto end = static_cast<std::int32_t>(points);
    if (count == 1) {
        return {0, end}; // the nodes are checked on the way
    }
    parallel_for(
        pieces.size(), 16,
        [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                if (has_wrong_node(pieces[i], points)) {
                    check_nodes(cells, points); // says which
                }
                find_range(pieces[i]);
            }
        },
        progress, 0.0, 0.1);
    std::vector<std::int32_t> begins;
    begins.reserve(pieces.size());
    for (const Piece &piece : pieces) {
        begins.push_back(piece.first);
    }
    std::sort(begins.begin(), begins.end());
    std::vector<std::int32_t> parts{0};
    for (std::size_t p = 1; p < count && !begins.empty(); ++p) {
        parts.push_back(std::max(parts.back(), begins[begins.size() * p / count]));
    }
    parts.push_back(end);
    return parts;
}

// The upper neighbours of each node: `width` of them in its row, the others in `more`.
template <std::size_t width>
struct UpperRows {
    Array<std::int32_t> nodes;
    Array<std::uint16_t> count; // in the row
    std::vector<Pair> more;     // ascending, each once

    explicit UpperRows(std::size_t points) : nodes(points * width), count(points) {
        std::fill(count.begin(), count.end(), std::uint16_t{0});
    }
    [[nodiscard]] std::int32_t *row(std::size_t n) { return nodes.data() + n * width; }
    [[nodiscard]] const std::int32_t *row(std::size_t n) const { return nodes.data() + n * width; }

    // Calls each(n, m) for all upper neighbours m of all nodes n, n ascending.
    template <class Each>
    void for_pairs(Pulse &pulse, const Each &each) const {
        auto next = more.begin();
        for (std::size_t n = 0; n < count.size(); ++n) {
            if (n % (1 << 16) == 0 && !pulse(n, count.size())) {
                return;
            }
            const std::int32_t *const neighbours = row(n);
            for (std::size_t i = 0; i < count[n]; ++i) {
                each(n, static_cast<std::size_t>(neighbours[i]));
            }
            for (; next != more.end() && low(*next) == static_cast<std::int32_t>(n); ++next) {
                each(n, static_cast<std::size_t>(high(*next)));
            }
        }
    }
};

// Whether the node is in the row. Four at a time: compilers leave the plain loop as it is.
template <std::size_t width>
bool has(const std::int32_t *row, std::int32_t node) {
    using Four [[gnu::vector_size(16)]] = std::int32_t;
    Four equal{};
    for (std::size_t i = 0; i < width; i += 4) {
        Four some;
        std::memcpy(&some, row + i, sizeof some);
        equal |= some == node;
    }
    std::array<std::uint64_t, 2> halves;
    std::memcpy(halves.data(), &equal, sizeof equal);
    return (halves[0] | halves[1]) != 0;
}

// Takes edges and puts those whose lower node is in [begin, end) into their rows, each once.
template <std::size_t width>
class Inserter {
public:
    Inserter(UpperRows<width> &rows, std::int32_t begin, std::int32_t end)
        : rows_(rows.nodes.data()), count_(rows.count.data()), begin_(begin),
          size_(static_cast<std::uint32_t>(end - begin)) {}

    void operator()(std::int32_t a, std::int32_t b) {
        const std::int32_t lower = std::min(a, b);
        if (is_here(lower)) {
            insert(lower, std::max(a, b));
        }
    }
    // The edges between the corners of split hexahedra, all seen already, and the nodes inside.
    template <std::size_t batch>
    void stars(const std::array<std::array<std::int32_t, batch>, 8> &corners,
               std::span<const std::int32_t> inside) {
        std::int32_t highest = highest_;
        bool fresh = true; // no node inside is in an edge so far
        for (const std::int32_t node : inside) {
            fresh = fresh && node > highest;
            highest = std::max(highest, node);
        }
        for (const auto &same : corners) {
            for (std::size_t i = 0; i < inside.size(); ++i) {
                if (!fresh) {
                    (*this)(same[i], inside[i]);
                } else if (is_here(same[i])) {
                    append(same[i], inside[i]);
                }
            }
        }
        highest_ = std::max(highest_, highest);
    }
    // What had no room; not sorted, some of it repeatedly.
    std::vector<Pair> crowded;

private:
    [[nodiscard]] bool is_here(std::int32_t lower) const {
        return static_cast<std::uint32_t>(lower - begin_) < size_;
    }
    std::int32_t *row(std::int32_t n) {
        std::int32_t *const neighbours = rows_ + static_cast<std::size_t>(n) * width;
        if (count_[n] == 0) {
            std::fill_n(neighbours, width, -1);
        }
        return neighbours;
    }
    void append(std::int32_t lower, std::int32_t upper) {
        std::int32_t *const neighbours = row(lower);
        std::uint16_t &used = count_[lower];
        if (used < width) {
            neighbours[used] = upper;
            ++used;
        } else {
            crowded.push_back(pair_of(lower, upper));
        }
    }
    void insert(std::int32_t lower, std::int32_t upper) {
        std::int32_t *const neighbours = row(lower);
        // An edge without length joins nothing.
        const bool known = has<width>(neighbours, upper) || lower == upper;
        highest_ = std::max(highest_, upper);
        std::uint16_t &used = count_[lower];
        if (used < width) {
            neighbours[used] = known ? -1 : upper;
            used = static_cast<std::uint16_t>(used + (known ? 0 : 1));
        } else if (!known) {
            crowded.push_back(pair_of(lower, upper));
        }
    }

    std::int32_t *rows_;
    std::uint16_t *count_;
    std::int32_t begin_;
    std::uint32_t size_;
    std::int32_t highest_ = -1; // of the edges seen
};

template <std::size_t width>
UpperRows<width> find_upper(std::size_t points, std::span<const CellView> cells,
                            const Progress &progress) {
    std::vector<Piece> pieces = pieces_of(cells);
    const auto parts = parts_of(pieces, points, cells, progress);
    const bool checked = parts.size() > 2;
    UpperRows<width> rows(points);
    std::vector<std::vector<Pair>> crowded(parts.size() - 1);
    Pulse pulse(progress, 0.1, 0.5);
    parallel_for(crowded.size(), 1, [&](std::size_t part, std::size_t) {
        const std::int32_t begin = parts[part];
        const std::int32_t end = parts[part + 1];
        Inserter<width> inserter(rows, begin, end);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (i % 64 == 0 && !pulse(i, pieces.size())) {
                return;
            }
            const Piece &piece = pieces[i];
            if (!checked && has_wrong_node(piece, points)) {
                check_nodes(cells, points);
            }
            if (!piece.reaches(begin, end)) {
                continue;
            }
            const auto cells_of_piece =
                piece.nodes.size() / static_cast<std::size_t>(node_count(piece.type));
            for_edges(piece.type, piece.nodes.data(), cells_of_piece, inserter);
        }
        std::vector<Pair> &more = crowded[part];
        more = std::move(inserter.crowded);
        std::sort(more.begin(), more.end());
        more.erase(std::unique(more.begin(), more.end()), more.end());
    });
    for (const auto &more : crowded) {
        rows.more.insert(rows.more.end(), more.begin(), more.end());
    }
    return rows;
}

// Few in number, and mostly in order.
void sort_row(std::int32_t *begin, const std::int32_t *end) {
    if (end - begin > 64) {
        std::sort(begin, begin + (end - begin));
        return;
    }
    for (std::int32_t *i = begin + 1; i < end; ++i) {
        const std::int32_t node = *i;
        std::int32_t *to = i;
        for (; to > begin && to[-1] > node; --to) {
            *to = to[-1];
        }
        *to = node;
    }
}

// Nodes [begin, end) of equal shares of all, one a thread.
template <class Body>
void for_shares(std::size_t points, const Body &body) {
    constexpr std::size_t most = 16;
    const std::size_t count = std::min({static_cast<std::size_t>(threads()), most, points + 1});
    parallel_for(count, 1, [&](std::size_t share, std::size_t) {
        body(points * share / count, points * (share + 1) / count);
    });
}

template <std::size_t width>
RelatedNodes related(std::size_t points, std::span<const CellView> cells,
                     const Progress &progress) {
    const UpperRows<width> upper = find_upper<width>(points, cells, progress);
    RelatedNodes result{Array<std::int64_t>(points + 1), {}};
    // Behind the loops, ends[n] is first how many neighbours n has, then where they begin, then
    // where they end.
    result.offsets[0] = 0;
    std::int64_t *const ends = result.offsets.data() + 1;
    Pulse counting(progress, 0.5, 0.6);
    for_shares(points, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) {
            ends[n] = upper.count[n];
        }
        upper.for_pairs(counting, [&](std::size_t, std::size_t m) {
            if (m >= begin && m < end) {
                ++ends[m];
            }
        });
    });
    for (const Pair pair : upper.more) {
        ++ends[low(pair)];
    }
    std::int64_t total = 0;
    for (std::size_t n = 0; n < points; ++n) {
        total += std::exchange(ends[n], total);
    }
    result.neighbours = Array<std::int32_t>(static_cast<std::size_t>(total));
    std::int32_t *const out = result.neighbours.data();
    Pulse turning(progress, 0.6, 0.8);
    for_shares(points, [&](std::size_t begin, std::size_t end) {
        upper.for_pairs(turning, [&](std::size_t n, std::size_t m) {
            if (m >= begin && m < end) {
                out[ends[m]++] = static_cast<std::int32_t>(n);
            }
        });
    });
    parallel_for(
        points, 1 << 15,
        [&](std::size_t begin, std::size_t end) {
            auto more = std::lower_bound(upper.more.begin(), upper.more.end(),
                                         pair_of(static_cast<std::int32_t>(begin), 0));
            for (std::size_t n = begin; n < end; ++n) {
                std::int32_t *const first = out + ends[n];
                std::int32_t *last = std::copy_n(upper.row(n), upper.count[n], first);
                for (; more != upper.more.end() && low(*more) == static_cast<std::int32_t>(n);
                     ++more) {
                    *last++ = high(*more);
                }
                sort_row(first, last);
                ends[n] += last - first;
            }
        },
        progress, 0.8, 1.0);
    return result;
}

} // namespace

RelatedNodes related_nodes(std::size_t points, std::span<const CellView> cells,
                           const Progress &progress) {
    poll(progress, 0.0);
    // Of the upper neighbours, tetrahedra have seven a node, split hexahedra fourteen a corner,
    // others three or four.
    const bool many = std::any_of(cells.begin(), cells.end(), [](const CellView &view) {
        return view.type == CellType::tetra;
    });
    return many ? related<16>(points, cells, progress) : related<8>(points, cells, progress);
}

} // namespace nmgs
