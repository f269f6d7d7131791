"""From rounds to figures: medians, with the quartiles as their interval."""
import statistics

from spread import interval

RVIZ = "rviz"
FRAMES_GOALS = {"100 k": 1.5, "1 M": 4}                             # times rviz
LIGHTER = ("1 M", "5 M")


def beside(figure, ours, peer, peer_name, goal=None, more=True):
    """A figure of both in the same rounds. The goal is a bound of the ratio."""
    ratios = [a / b for a, b in zip(ours, peer)]                    # of neighbours in time, that the machine treats more alike
    ratio = statistics.median(ratios)
    return {"bench": "scene", "figure": figure, "ours": round(statistics.median(ours), 3), "ours_quartiles": interval(ours),
            "peer": round(statistics.median(peer), 3), "peer_name": peer_name, "peer_quartiles": interval(peer),
            "ratio": round(ratio, 3), "ratio_quartiles": interval(ratios),
            "goal": goal and (f">= {goal:g}" if more else f"< {goal:g} (lower is better)"),
            "holds": goal and (ratio >= goal if more else ratio < goal), "rounds": len(ratios)}


def alone(figure, values, goal, more):
    """A figure that has its goal in itself."""
    median = statistics.median(values)
    return {"bench": "scene", "figure": figure, "ours": round(median, 3), "ours_quartiles": interval(values), "peer": None, "peer_name": None,
            "ratio": None, "goal": goal and f"{'>=' if more else '<'} {goal:g}", "holds": goal and (median >= goal if more else median < goal),
            "rounds": len(values)}


def frames(variant, ours, theirs, peer_name):
    goal = next((bound for name, bound in FRAMES_GOALS.items() if variant.startswith(name + " points")), None)
    return beside(f"{variant}, frames/s", ours, theirs, peer_name, goal)


def memory(variant, ours, theirs, peer_name):
    goal = 1 if variant.startswith(tuple(f"{name} points" for name in LIGHTER)) else None
    return beside(f"{variant}, MB", [ours], [theirs], peer_name, goal, more=False)
