#!/usr/bin/env python3
"""Runs clang-tidy over the sources of a build, some at a time: lint.py BUILD REPORT.

Tests and benchmarks are not looked at. What was looked at before with the same contents is not looked at again. REPORT is written as
other runners of tests write theirs."""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys
import time
from dataclasses import dataclass
from xml.sax.saxutils import escape, quoteattr

ROOT = pathlib.Path(__file__).resolve().parent.parent
RULES = ROOT / ".clang-tidy"
FOLDERS = ("config", "hal", "host", "jni", "link", "plugin", "plugins", "robot", "ros", "supervisor")
SECONDS = 300  # for one source
TOOL = "clang-tidy"
OF_GCC_ALONE = "-fno-gnu-unique"


@dataclass
class Finding:
    source: pathlib.Path
    seconds: float
    wrong: str  # nothing where all is well
    fresh: bool = True

    def case(self):
        inner = f"<failure>{escape(self.wrong)}</failure>" if self.wrong else ""
        return f'<testcase classname="native-lint" name={quoteattr(str(self.source.relative_to(ROOT)))} time="{self.seconds:.1f}">{inner}</testcase>'


def ours(path):
    return path.is_relative_to(ROOT) and path.relative_to(ROOT).parts[0] in FOLDERS and not path.stem.endswith("_test")


def commands(build):
    """Every source once, with the command that compiles it, in words that clang knows."""
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = (pathlib.Path(entry["directory"]) / entry["file"]).resolve()
        if ours(path):
            words = entry["arguments"] if "arguments" in entry else shlex.split(entry["command"])
            found[path] = {"directory": entry["directory"], "file": str(path), "arguments": [w for w in words if w != OF_GCC_ALONE]}
    return found


class Sources:
    """Knows by its contents whether a source was looked at before."""

    def __init__(self, build, cache, version):
        self.cache, self.version, self.commands = cache, version, commands(build)
        self.headers = {}
        for header in filter(ours, ROOT.rglob("*.h")):
            self.headers.setdefault(header.name, []).append(header)
        cache.mkdir(exist_ok=True)
        (cache / "compile_commands.json").write_text(json.dumps(list(self.commands.values())))

    def included(self, path):
        """The source and headers of ours that it includes, also by others: by their names, whatever folder they are in."""
        todo, seen = [path], {path}
        while todo:
            names = (line.split('"')[1].rsplit("/", 1)[-1] for line in todo.pop().read_text().splitlines() if line.startswith('#include "'))
            more = {header for name in names for header in self.headers.get(name, ())} - seen
            seen |= more
            todo += more
        return sorted(seen)

    def mark(self, path):
        digest = hashlib.sha256()
        command = shlex.join(self.commands[path]["arguments"])
        for part in (self.version, command, RULES.read_text(), *(each.read_text() for each in self.included(path))):
            digest.update(part.encode() + b"\0")
        return self.cache / digest.hexdigest()

    def look(self, path):
        mark, begun = self.mark(path), time.monotonic()
        if mark.exists():
            return Finding(path, 0, "", fresh=False)
        wrong = tidy(path, self.cache)
        if not wrong:
            mark.touch()
        return Finding(path, time.monotonic() - begun, wrong)

    def forget_others(self):
        known = {self.mark(path) for path in self.commands} | {self.cache / "compile_commands.json"}
        for mark in set(self.cache.iterdir()) - known:
            mark.unlink()


def tidy(path, database):
    try:
        run = subprocess.run([TOOL, "-p", database, "--quiet", path], capture_output=True, text=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return f"{path}: clang-tidy took longer than {SECONDS} s"
    return "" if run.returncode == 0 else run.stdout + run.stderr


def main(build, report):
    version = subprocess.run([TOOL, "--version"], capture_output=True, text=True, check=True).stdout
    sources = Sources(build, build.parent / "lint", version)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        findings = list(pool.map(sources.look, sorted(sources.commands)))
    sources.forget_others()
    wrong = [each for each in findings if each.wrong]
    for each in wrong:
        print(each.wrong, file=sys.stderr)
    print(f"  {len(findings)} sources, {sum(each.fresh for each in findings)} of them looked at, {len(wrong)} with findings", file=sys.stderr)
    suite = f'<testsuite name="native-lint" tests="{len(findings)}" failures="{len(wrong)}" errors="0" skipped="0">'
    report.write_text("\n".join([suite, *(each.case() for each in findings), "</testsuite>", ""]))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve())
