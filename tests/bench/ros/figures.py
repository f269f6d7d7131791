"""From the rounds of all subscribers to figures: medians, with the quartiles as their interval."""
import statistics

from spread import interval

OURS = "robotui"

# What a round's result is turned into, by figure: (kind of round, function of its result).
VALUES = {
    "small messages/s": ("small", lambda r: r["count"] / r["seconds"]),
    "1 MiB images, MB/s": ("image", lambda r: r["count"] * (1 << 20) / r["seconds"] / 1e6),
    "latency p50 at 1 kHz, us": ("latency", lambda r: r["p50"] / 1e3),
    "latency p99 at 1 kHz, us": ("latency", lambda r: r["p99"] / 1e3),
    "CPU per small message, us": ("small", lambda r: r["cpu"] / r["count"] * 1e6),
    "CPU per image, us": ("image", lambda r: r["cpu"] / r["count"] * 1e6),
}
# Beside roscpp: the bound of the ratio ours/peer, and whether more is better.
GOALS = {
    "small messages/s": (0.8, True),
    "1 MiB images, MB/s": (0.95, True),
    "latency p50 at 1 kHz, us": (1.5, False),
}


def compared(figure, ours, peer, peer_name, goal):
    ratios = [a / b for a, b in zip(ours, peer)]                # of neighbours in time, that the machine treats more alike
    ratio = statistics.median(ratios)
    bound, more = goal or (None, None)
    text = goal and (f">= {bound}" if more else f"<= {bound} (lower is better)")
    return {"bench": "ros", "figure": figure, "ours": round(statistics.median(ours), 3), "peer": round(statistics.median(peer), 3),
            "peer_name": peer_name, "ratio": round(ratio, 3), "goal": text,
            "holds": goal and (ratio >= bound if more else ratio <= bound),
            "ours_quartiles": interval(ours), "peer_quartiles": interval(peer),
            "ratio_quartiles": interval(ratios), "rounds": len(ours)}


def lost(kind, what, ours, peer, peer_name):
    mine, theirs = (sum(r["lost"] for r in rounds[kind].values()) for rounds in (ours, peer))
    return {"bench": "ros", "figure": f"{what} lost", "ours": mine, "peer": theirs, "peer_name": peer_name, "ratio": None,
            "goal": "0", "holds": mine == 0}


def allocation(ours):
    values = [r["allocated"] / r["count"] for r in ours["small"].values()]
    return {"bench": "ros", "figure": "bytes allocated per small message", "ours": round(statistics.median(values), 1),
            "peer": None, "peer_name": None, "ratio": None, "goal": None, "holds": None, "ours_quartiles": interval(values)}


def figures(results, peer_names):
    """RESULTS are the rounds by subscriber, kind and number. Goals are beside the first peer; a peer is compared in its rounds."""
    ours = results[OURS]
    made = []
    for number, (peer, name) in enumerate(peer_names.items()):
        theirs = results[peer]
        for figure, (kind, value) in VALUES.items():
            both = [(value(ours[kind][i]), value(theirs[kind][i])) for i in sorted(theirs[kind])]
            made.append(compared(figure, *zip(*both), name, GOALS.get(figure) if number == 0 else None))
        made += [lost("small", "small messages", ours, theirs, name), lost("image", "images", ours, theirs, name)]
    return made + [allocation(ours)]
