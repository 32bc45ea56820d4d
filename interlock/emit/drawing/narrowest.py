"""Places on a line: every two as far apart as they must be, the weighted sum of all distances as small as it can be."""

from __future__ import annotations

from typing import TypeVar

import networkx as nx

N = TypeVar("N")


def narrowest(graph: nx.DiGraph[N]) -> dict[N, float]:
    """Least sum of weight times length over all edges, each as long as it must be: by the dual flow."""
    flow: nx.DiGraph[N] = nx.DiGraph()
    demand = dict.fromkeys(graph.nodes, 0)
    for a, b, data in graph.edges(data=True):
        flow.add_edge(a, b, weight=-round(data["length"]))
        demand[a] -= data["weight"]
        demand[b] += data["weight"]
    for n in graph.nodes:
        flow.add_node(n, demand=demand[n])
    place: dict[N, float] = {}
    for part in map(sorted, nx.weakly_connected_components(graph)):
        sub = flow.subgraph(part)
        _, found = nx.network_simplex(sub)
        back: nx.DiGraph[N | str] = nx.DiGraph()
        back.add_nodes_from(part)
        for a, b, data in graph.subgraph(part).edges(data=True):
            back.add_edge(a, b, weight=-round(data["length"]))  # x(b) >= x(a) + length
            if found[a].get(b, 0) > 0:  # tight where there is flow
                back.add_edge(b, a, weight=round(data["length"]))
        start = "*"
        back.add_edges_from(((start, n) for n in part), weight=0)
        far = nx.single_source_bellman_ford_path_length(back, start)
        least = min(-far[n] for n in part)
        place |= {n: float(-far[n] - least) for n in part}
    return place
