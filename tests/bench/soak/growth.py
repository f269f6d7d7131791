"""From samples to figures: how much more of each there is after an hour."""
import statistics

# What is measured, what may come in an hour, and in what unit.
GOALS = {"heap": ("heap in use", 1, "MB"), "resident": ("resident memory", 1, "MB"), "threads": ("threads", 1, ""), "files": ("file descriptors", 1, ""),
         "graphics": ("fonts, images and other graphics", 5, ""), "widgets": ("widgets", 5, ""), "forgotten": ("graphics that were not disposed of", 0, ""),
         "classes": ("classes loaded", 50, ""), "x_server": ("memory of the display", 1, "MB")}
MOST = 25


def line(times, values):
    """Slope and its standard error by least squares."""
    middle, mean = statistics.fmean(times), statistics.fmean(values)
    spread = sum((t - middle) ** 2 for t in times)
    slope = sum((t - middle) * (v - mean) for t, v in zip(times, values)) / spread
    rest = sum((v - mean - slope * (t - middle)) ** 2 for t, v in zip(times, values))
    return slope, (rest / (len(times) - 2) / spread) ** 0.5


def figures(samples, name):
    if len(samples) < 4:
        return
    times = [sample["hours"] for sample in samples]
    for key, (what, goal, unit) in GOALS.items():
        values = [sample[key] for sample in samples]
        slope, error = line(times, values)
        median = f"{statistics.median(values):.6g}{' ' + unit if unit else ''}"
        yield {"bench": "soak", "figure": f"{what} ({median}), more in an hour", "ours": round(slope, 2), "standard_error": round(error, 2), "peer": None, "peer_name": None,
               "ratio": None, "goal": f"<= {goal}{' ' + unit if unit else ''}", "holds": slope <= goal, "with": name, "rounds": len(values)}


def grown(first, last, samples):
    """The classes of whose objects most bytes came, in a sentence each."""
    yield f"{len(samples)} samples count; what came between the first and the last of them, by class:"
    more = {name: (count - first.get(name, (0, 0))[0], size - first.get(name, (0, 0))[1]) for name, (count, size) in last.items()}
    for name, (count, size) in sorted(more.items(), key=lambda each: -each[1][1])[:MOST]:
        yield f"{size:+11d} bytes {count:+8d} {name}"
