"""From rounds to figures: medians, with the quartiles as their interval."""
import statistics

from spread import interval


def alone(figure, values, bound, unit):
    """A figure that has its goal in itself."""
    median = statistics.median(values)
    return {"bench": "ui", "figure": figure, "ours": round(median, 3), "ours_quartiles": interval(values), "peer": None, "peer_name": None,
            "ratio": None, "goal": f"<= {bound} {unit}", "holds": median <= bound, "rounds": len(values)}


def times(figure, ours, peer, peer_name, bound):
    """A figure as a multiple of a peer's in the same round, less being better."""
    ratios = [a / b for a, b in zip(ours, peer)]
    return {"bench": "ui", "figure": figure, "ours": round(statistics.median(ours), 3), "ours_quartiles": interval(ours),
            "peer": round(statistics.median(peer), 3), "peer_name": peer_name, "peer_quartiles": interval(peer),
            "ratio": round(statistics.median(ratios), 3), "ratio_quartiles": interval(ratios),
            "goal": f"<= {bound} (lower is better)", "holds": statistics.median(ratios) <= bound, "rounds": len(ratios)}


def figures(rounds, counts, teams, crowd):
    few, many = counts
    small, large = (rounds[f"team of {count}"] for count in teams)
    idle = [sum(n for name, n in r["frames"].items() if name != "Robot0") for r in rounds[many]]
    searched = [r["search"]["answering"]["p99"] for r in rounds["topics"] if r["search"]["answering"]["count"]]
    topics = f"with {crowd[0]} topics of {crowd[1]} nodes"
    return [
        alone(f"display thread p99 with {many} robots, ms", [r["p99"] for r in rounds[many]], 16, "ms"),
        alone("frames prepared by robots not selected", idle, 0, "frames"),
        times(f"processors used with {many} robots", [r["cpu"] for r in rounds[many]], [r["cpu"] for r in rounds[few]], f"itself with {few}", 2.2),
        alone(f"display thread p99 with a team of {teams[1]}, ms", [r["p99"] for r in large], 16, "ms"),
        times(f"processors used with a team of {teams[1]}", [r["cpu"] for r in large], [r["cpu"] for r in small], f"itself with {teams[0]}", 2.2),
        times(f"display thread p99 {topics}, ms", [r["p99"] for r in rounds["topics"]], [r["p99"] for r in rounds["alone"]], "itself without them", 2),
        times(f"processors used {topics}", [r["cpu"] for r in rounds["topics"]], [r["cpu"] for r in rounds["alone"]], "itself without them", 2),
        alone(f"opening a view {topics}, ms", [statistics.median(r["views"]) for r in rounds["topics"]], 200, "ms"),
        alone(f"opening the slowest of the views {topics}, ms", [max(r["views"]) for r in rounds["topics"]], 200, "ms"),
        *([alone(f"answer of the search {topics}, p99, ms", searched, 50, "ms")] if searched else []),
        alone("start to first live picture, s", [r["start"] for r in rounds["demo"]], 2.5, "s"),
        alone("memory (PSS) on the demo, MB", [r["pss"] for r in rounds["demo"]], 400, "MB"),
        alone("plot of 1 M samples, pan and zoom p95, ms", [r[1] for r in rounds["plot"]], 33, "ms"),
    ]
