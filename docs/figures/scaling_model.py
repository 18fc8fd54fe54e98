"""Where the time of a Newton iteration goes on many ranks: a model from measured work and counted messages.

A body of n nodes is cut into p parts. With m = (n/p)^(1/3) nodes along an edge of a part, of a Newton iteration

- elements: residual and tangent of one rank, over p, times (1 + 1/m)^3: a rank works on every cell that touches its
  nodes;
- solve: the linear solve of one rank, over p;
- factorization: MueLu's setup, over p. A direct factorisation goes up a tree of separators, each a dense front of
  `width` nodes: the lower levels over p, the upper log2 p levels one after the other, level l on p / 2^l ranks a front,
  of which a front uses at most FRONT_RANKS. Its triangular solves, a part of the linear solve, go the same way;
- messages: those counted, times the latency and by the bandwidth. Neighbours grow from those of the counted run to at
  most 26 (of a slender body 2), bytes with the part's surface n/p to the power 2/3 (of a slender body, its section,
  they stay);
- reductions: those counted, times log2 p latencies.

Nothing overlaps, no rank waits for another that has more to do, and iterations are as many as were counted.
"""
import math

LATENCY = 2e-6  # seconds a message: InfiniBand with MPI
BANDWIDTH = 1e9  # bytes a second and rank: a node's 25 GB/s shared by some 25 ranks
FRONT_RANKS = 16  # that a dense front of a thousand rows keeps busy
PHASES = ("elements", "factorization", "linear solve", "messages", "reductions")


def tree(seconds, fronts, ranks):
    """A factorisation of so many equal fronts, and the seconds of one rank, on several."""
    front = seconds / fronts
    levels = min(math.log2(ranks), math.log2(fronts))
    upper = sum(front / min(max(ranks / 2**level, 1), FRONT_RANKS) for level in range(round(levels)))
    return seconds / ranks + upper


def neighbours(ranks, slender):
    """Parts that a part touches at most."""
    return min(ranks - 1, 2 if slender else 26)


def times(one, counts, counted_ranks, ranks, slender, width):
    """Returns the seconds of a Newton iteration by phase.

    one: those of one rank, and `nodes`. counts: a rank's `messages`, `bytes` and `reductions` on `counted_ranks`.
    width: nodes of a separator, if the solver is direct."""
    m = (one["nodes"] / ranks) ** (1 / 3)
    result = dict.fromkeys(PHASES, 0.0)
    result["elements"] = (one["residual"] + one["tangent"]) / ranks * (1 + 1 / m) ** 3
    fronts = one["nodes"] / width if width else 0
    for phase in ("factorization", "linear solve"):
        result[phase] = tree(one[phase], fronts, ranks) if width else one[phase] / ranks
    if ranks > 1:
        more = neighbours(ranks, slender) / neighbours(counted_ranks, slender)
        surface = 1 if slender else (counted_ranks / ranks) ** (2 / 3)
        result["messages"] = counts["messages"] * more * LATENCY + counts["bytes"] * more * surface / BANDWIDTH
        result["reductions"] = counts["reductions"] * math.log2(ranks) * LATENCY
    return result
