"""From the rounds of all ways to figures: medians, with the quartiles as their interval."""
import statistics

from spread import interval

OURS, DIRECT = "robotui", "no bridge"
VALUES = {
    "small messages/s": ("small", lambda r: r["count"] / r["seconds"]),
    "1 MiB images/s": ("image", lambda r: r["count"] / r["seconds"]),
    "latency p50 at 200 Hz, us": ("latency", lambda r: r["p50"] / 1e3),
    "latency p99 at 200 Hz, us": ("latency", lambda r: r["p99"] / 1e3),
    "CPU per small message at 200 Hz, us": ("latency", lambda r: r["cpu"] / max(1, r["count"]) * 1e6),
    "CPU per image, us": ("image", lambda r: r["cpu"] / max(1, r["count"]) * 1e6),
}
LATENCY_US, IMAGES = 1000, 0.8


def figure(name, **values):
    return {"bench": "bridge", "figure": name, **dict.fromkeys(("ours", "peer", "peer_name", "ratio", "goal", "holds")), **values}


def compared(way, name, ours, peer, peer_name):
    ratios = [a / b if b else float("nan") for a, b in zip(ours, peer)]     # of neighbours in time, that the machine treats more alike
    latency, images = name.startswith("latency p50"), name.startswith("1 MiB") and peer_name == DIRECT
    middle, ratio = statistics.median(ours), statistics.median(ratios)
    return figure(f"{way}: {name}", ours=round(middle, 2), peer=round(statistics.median(peer), 2), peer_name=peer_name, ratio=round(ratio, 3),
                  goal=f"< {LATENCY_US} us" if latency else f">= {IMAGES}" if images else None,
                  holds=middle < LATENCY_US if latency else ratio >= IMAGES if images else None,
                  ours_quartiles=interval(ours), peer_quartiles=interval(peer), ratio_quartiles=interval(ratios), rounds=len(ours))


def figures(results):
    """RESULTS are the rounds by way, bridge, kind and number."""
    made = []
    for way, bridges in results.items():
        for peer in (name for name in bridges if name != OURS):
            for name, (kind, value) in VALUES.items():
                if kind not in bridges[peer] or (peer == DIRECT and name.startswith("CPU")):
                    continue
                both = [(value(bridges[OURS][kind][i]), value(bridges[peer][kind][i])) for i in sorted(bridges[peer][kind])]
                made.append(compared(way, name, *zip(*both), peer))
        lost = sum(r["sent"] - r["count"] for r in bridges[OURS]["latency"].values())
        made.append(figure(f"{way}: messages lost at 200 Hz", ours=lost, goal="0", holds=lost == 0))
    return made
