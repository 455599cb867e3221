// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/convert/matching.h"

#include <lemon/matching.h>
#include <lemon/smart_graph.h>

namespace nmgs {

std::vector<std::int32_t> maximum_weight_matching(std::int32_t nodes,
                                                  const std::vector<WeightedPair> &pairs) {
    using Graph = lemon::SmartGraph;
    using Weights = Graph::EdgeMap<std::int64_t>;
    Graph graph;
    graph.reserveNode(nodes);
    graph.reserveEdge(static_cast<int>(pairs.size()));
    for (std::int32_t n = 0; n < nodes; ++n) {
        graph.addNode();
    }
    Weights weights(graph);
    for (const WeightedPair &pair : pairs) {
        weights[graph.addEdge(Graph::nodeFromId(pair.a), Graph::nodeFromId(pair.b))] = pair.weight;
    }
    lemon::MaxWeightedMatching<Graph, Weights> matching(graph, weights);
    matching.run();
    std::vector<std::int32_t> mate(static_cast<std::size_t>(nodes), -1);
    for (std::int32_t n = 0; n < nodes; ++n) {
        const Graph::Node other = matching.mate(Graph::nodeFromId(n));
        if (other != lemon::INVALID) {
            mate[static_cast<std::size_t>(n)] = Graph::id(other);
        }
    }
    return mate;
}

} // namespace nmgs
