"""Does lint stay linear? `python -m bench.many [--counts 100 1000 10000] [--jobs 2] [--folder DIR]`

Writes N small packages that lint without a warning, of five kinds in turn (a C++ node, a Python node, interfaces,
parameters and launch files, plain CMake), each depending on a few of those before it, and times `rospkg lint -j JOBS`
on them in a process of its own: wall seconds, CPU seconds of all its processes, time per package, and the peak of the
memory of all its processes at one moment (proportional set size: pages that are shared are counted once; sampled, so a
short peak can be missed).  The last lines compare the time per package at the most packages with that at the others;
it leaves with 1 where the wall time at the most is over 1.5 times that at the fewest.

What the sample can't show: real packages are larger and differ from each other, so the seconds mean little in
themselves, only their growth does.  Start-up (under a second) is a good part of the figure at 100, so look at the
growth from 1,000, too.  Names are unique, and every package lies two folders below the root.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from .many_packages import write_packages

EVERY = 0.1
"""Seconds between two looks at the memory."""


@dataclass(frozen=True)
class Figures:
    """What one run took: seconds, and the peak of memory in MiB; `said` is its last line."""

    count: int
    status: int
    wall: float
    cpu: float
    peak: float
    said: str

    @property
    def each(self) -> float:
        """Return the wall milliseconds per package."""
        return self.wall / self.count * 1000

    @property
    def cpu_each(self) -> float:
        """Return the CPU milliseconds per package."""
        return self.cpu / self.count * 1000

    def __str__(self) -> str:
        return (
            f"{self.count:>6} packages: exit {self.status}, {self.wall:8.2f} s wall, {self.cpu:8.2f} s CPU, "
            f"{self.each:6.2f} ms wall each, {self.cpu_each:6.2f} ms CPU each, "
            f"{self.peak:7.0f} MiB peak; {self.said}"
        )


def measure(folder: Path, count: int, jobs: int, timeout: float) -> Figures:
    """Lint a folder of packages; a run over `timeout` wall seconds is ended, and its status is -9."""
    command = [sys.executable, "-m", "rospkg_cli", "lint", "-j", str(jobs), "--format", "concise", str(folder)]
    before, began, peak = os.times(), time.perf_counter(), 0.0
    with tempfile.TemporaryFile("w+") as output:
        running = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT, cwd=folder)
        while running.poll() is None:
            peak = max(peak, sum(map(memory_of, family(running.pid))))
            if time.perf_counter() - began > timeout:
                for pid in reversed(list(family(running.pid))):
                    os.kill(pid, 9)
            time.sleep(EVERY)
        wall, after = time.perf_counter() - began, os.times()
        output.seek(0)
        lines = output.read().splitlines()
    cpu = after.children_user + after.children_system - before.children_user - before.children_system
    return Figures(count, running.returncode, wall, cpu, peak, lines[-1] if lines else "nothing said")


def family(pid: int) -> Iterator[int]:
    """Yield a process and those it started, as far as they live."""
    yield pid
    try:
        children = Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    except OSError:
        return
    for child in children:
        yield from family(int(child))


def memory_of(pid: int) -> float:
    """Return a process's proportional set size in MiB; 0 when it is gone."""
    try:
        found = re.search(r"^Pss:\s+(\d+) kB", Path(f"/proc/{pid}/smaps_rollup").read_text(), re.M)
    except OSError:
        return 0.0
    return int(found[1]) / 1024 if found else 0.0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--counts", nargs="+", type=int, default=[100, 1_000, 10_000])
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--timeout", type=float, default=1_800, help="wall seconds of one run")
    parser.add_argument("--folder", type=Path, help="write them here and leave them")
    arguments = parser.parse_args()
    found = []
    for count in arguments.counts:
        with tempfile.TemporaryDirectory() as temporary:
            folder = (arguments.folder or Path(temporary)) / f"of_{count}"
            if not folder.exists():
                write_packages(folder, count)
            found.append(measure(folder, count, arguments.jobs, arguments.timeout))
            print(found[-1], flush=True)
    few, many = min(found, key=lambda f: f.count), max(found, key=lambda f: f.count)
    for other in found:
        wall, cpu = many.each / other.each, many.cpu_each / other.cpu_each
        print(f"{wall:.2f} × the wall time per package at {other.count}, {cpu:.2f} × the CPU time")
    return 0 if all(f.status in (0, 1) for f in found) and many.each <= 1.5 * few.each else 1


if __name__ == "__main__":
    sys.exit(main())
