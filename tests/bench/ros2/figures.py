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
    "discovery of 1 endpoint, ms": ("discover 1", lambda r: r["seconds"] * 1e3),
    "discovery of 100 endpoints, ms": ("discover 100", lambda r: r["seconds"] * 1e3),
}
# By peer and figure: the bound of the ratio ours/peer, and whether more is better.
GOALS = {
    ("rclpy", "small messages/s"): (5, True),
    ("Cyclone C", "small messages/s"): (0.8, True),
    ("Cyclone C", "1 MiB images, MB/s"): (0.9, True),
    ("Cyclone C", "latency p50 at 1 kHz, us"): (1.5, False),
}
DISCOVERY_MS = 2000


def figure(name, **values):
    made = dict.fromkeys(("ours", "peer", "peer_name", "ratio", "goal", "holds"))
    return {"bench": "ros2", "figure": name, **made, **values}


def compared(name, ours, peer, peer_name):
    ratios = [a / b for a, b in zip(ours, peer)]                # of neighbours in time, that the machine treats more alike
    ratio = statistics.median(ratios)
    bound, more = GOALS.get((peer_name, name), (None, None))
    return figure(name, ours=round(statistics.median(ours), 3), peer=round(statistics.median(peer), 3), peer_name=peer_name, ratio=round(ratio, 3),
                  goal=bound and (f">= {bound}" if more else f"<= {bound} (lower is better)"),
                  holds=bound and (ratio >= bound if more else ratio <= bound),
                  ours_quartiles=interval(ours), peer_quartiles=interval(peer), ratio_quartiles=interval(ratios), rounds=len(ours))


def lost(results, kind, what):
    mine = sum(r["lost"] for r in results[OURS][kind].values())
    theirs = {name: sum(r["lost"] for r in rounds[kind].values()) for name, rounds in results.items() if name != OURS}
    return figure(f"{what} lost", ours=mine, peer=max(theirs.values()), peer_name=max(theirs, key=theirs.get), goal="0", holds=mine == 0)


def allocation(results, kind, what):
    values = [r["allocated"] / r["count"] for r in results[OURS][kind].values()]
    return figure(f"bytes allocated per {what}", ours=round(statistics.median(values), 1), ours_quartiles=interval(values))


def discovery(results):
    slowest = max(r["seconds"] for r in results[OURS]["discover 100"].values()) * 1e3
    return figure("slowest discovery of 100 endpoints, ms", ours=round(slowest, 1), goal=f"< {DISCOVERY_MS}", holds=slowest < DISCOVERY_MS)


def figures(results):
    """RESULTS are the rounds by subscriber, kind and number."""
    made = []
    for peer in (name for name in results if name != OURS):
        for name, (kind, value) in VALUES.items():
            both = [(value(results[OURS][kind][i]), value(results[peer][kind][i])) for i in sorted(results[peer][kind])]
            made.append(compared(name, *zip(*both), peer))
    made += [lost(results, "small", "small messages"), lost(results, "image", "images"), discovery(results)]
    return made + [allocation(results, "small", "small message"), allocation(results, "image", "image")]
