#!/usr/bin/env python3
"""Looks whether all C++ sources are laid out as .clang-format says: format.py REPORT. Seconds; changes nothing.

Without clang-format it says so and reports one skipped test. REPORT is written as other runners of tests write theirs."""
import pathlib
import re
import shutil
import subprocess
import sys
from xml.sax.saxutils import escape

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOOL = "clang-format"
REMEDY = "in rt-native: git ls-files '*.cpp' '*.h' | xargs clang-format -i"
SHOWN = 10  # lines; all are in the report
WRONG = re.compile(r"^(.+?):(\d+):\d+: error: code should be clang-formatted", re.MULTILINE)


def sources():
    built = ROOT / "target"
    return sorted(path for suffix in ("*.cpp", "*.h") for path in ROOT.rglob(suffix) if built not in path.parents)


def misplaced():
    """The first line of each source that is laid out otherwise."""
    run = subprocess.run([TOOL, "--dry-run", "--Werror", *sources()], capture_output=True, text=True, check=False)
    first = {}
    for path, line in WRONG.findall(run.stderr):
        first.setdefault(pathlib.Path(path).relative_to(ROOT), line)
    if run.returncode != 0 and not first:
        raise RuntimeError(f"{TOOL} failed:\n{run.stderr}")
    return [f"{path}:{line}" for path, line in first.items()]


def suite(skipped, wrong):
    inner = "<skipped/>" if skipped else f"<failure>{escape(wrong)}</failure>" if wrong else ""
    head = f'<testsuite name="native-format" tests="1" failures="{int(bool(wrong))}" errors="0" skipped="{int(skipped)}">'
    return f'{head}\n<testcase classname="native-format" name="layout" time="0">{inner}</testcase>\n</testsuite>\n'


def main(report):
    if shutil.which(TOOL) is None:
        print("  The layout of the C++ sources is not looked at: clang-format is not installed.", file=sys.stderr)
        report.write_text(suite(True, ""))
        return
    found = misplaced()
    wrong = "\n".join([f"{len(found)} sources are not laid out as .clang-format says; {REMEDY}", *found]) if found else ""
    if wrong:
        print("\n".join(f"  {line}" for line in wrong.splitlines()[:SHOWN]), file=sys.stderr)
    report.write_text(suite(False, wrong))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
