"""How far the rounds of a figure lie apart."""
import statistics


def interval(values):
    """The quartiles, which noise of single rounds does not move."""
    if len(values) < 2:
        return [round(value, 3) for value in (*values, *values)]
    low, _, high = statistics.quantiles(values, n=4, method="inclusive")
    return [round(low, 3), round(high, 3)]
