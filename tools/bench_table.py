"""Reads JSON lines of figures, prints them as a table and then again as they are."""
import json
import sys

COLUMNS = ("bench", "figure", "ours", "peer", "peer_name", "ratio", "goal", "holds")


def cell(value):
    if isinstance(value, bool):
        return "yes" if value else "NO"
    if isinstance(value, float):
        return f"{value:.4g}"
    return "-" if value is None else str(value)


def table(figures):
    rows = [COLUMNS] + [tuple(cell(figure.get(column)) for column in COLUMNS) for figure in figures]
    widths = [max(len(row[i]) for row in rows) for i in range(len(COLUMNS))]
    return "\n".join("  ".join(text.ljust(width) for text, width in zip(row, widths)).rstrip() for row in rows)


def main():
    figures = [json.loads(line) for line in sys.stdin if line.strip()]
    print(table(figures), end="\n\n")
    for figure in figures:
        print(json.dumps(figure))


if __name__ == "__main__":
    main()
