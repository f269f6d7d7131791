"""From rounds to figures: medians, with the quartiles as their interval."""
import statistics

from spread import interval


def alone(figure, values, **more):
    return {"bench": "rt", "figure": figure, "ours": round(statistics.median(values), 3), "ours_quartiles": interval(values), "peer": None,
            "peer_name": None, "ratio": None, "goal": None, "holds": None, "rounds": len(values), **more}


def beside(figure, ours, peer, peer_name, bound=None):
    """A figure of which less is better, as a multiple of a peer's in the same round."""
    ratios = [a / b for a, b in zip(ours, peer)]
    ratio = statistics.median(ratios)
    return {**alone(figure, ours), "peer": round(statistics.median(peer), 3), "peer_name": peer_name, "peer_quartiles": interval(peer),
            "ratio": round(ratio, 3), "ratio_quartiles": interval(ratios), "goal": bound and f"<= {bound} (lower is better)",
            "holds": bound and ratio <= bound}


def described(figure):
    text = "  {figure}: {ours:g} {ours_quartiles}".format(**figure)
    if figure["peer"] is not None:
        text += ", {peer_name} {peer:g} {peer_quartiles}, ratio {ratio:g} {ratio_quartiles}".format(**figure)
    return text
