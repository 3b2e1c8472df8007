"""Which broken lines does no test notice? `python -m bench.mutants FOLDER… [--count 20] [--seed 1] [--jobs 1]`

Breaks one place at a time in copies of this checkout (never in place): conditions negated, comparisons flipped,
constants, levels and safeties changed, texts dropped, results emptied.  First a map is made, once for the same sources
and tests: which tests run which lines (coverage's contexts); it is kept in the folder for temporary files.  Each mutant
meets the tests that run its line and little else, at most `--near` of them, then at most `--wider` of the others that
run it; one in a line that runs at import alone meets the laws last, which read the sources.  Prints killed or survived,
and the diff of each survivor.  What runs only in a process that a test starts is not in the map.  `--tests` names the
files of tests that take part (without `tests/real` where none is named); what survives some of the tests may be killed
by others.
"""

from __future__ import annotations

import argparse
import difflib
import hashlib
import os
import queue
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from coverage import CoverageData

from .mutations import Mutant, draw

ROOT = Path(__file__).parents[1]
COPIED = ("src", "tests", "templates", "schemas", "docs", "bench")
NOT_COPIED = shutil.ignore_patterns("__pycache__", ".*_cache", "*.egg-info", ".hypothesis")
LAWS = ["tests/test_house.py", "tests/test_rule_habits.py"]
"""Tests that read the sources, and run no line of them."""

COVERAGE = "[run]\nsource_pkgs = rospkg_cli\nrelative_files = true\ncore = ctrace\n"


def copy(to: Path) -> Path:
    for name in COPIED:
        shutil.copytree(ROOT / name, to / name, ignore=NOT_COPIED)
    for path in ROOT.iterdir():
        if path.is_file():
            shutil.copy(path, to)
    return to


def pytest(folder: Path, *arguments: str, timeout: float | None = None) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "pytest", "-q", "--tb=no", "-p", "no:cacheprovider", *arguments]
    env = {k: v for k, v in os.environ.items() if not k.startswith(("PYTEST", "COV_", "PYTHONDONTWRITE"))}
    env |= {"PYTHONPATH": str(folder / "src"), "ROSPKG_HYPOTHESIS": "quick"}
    return subprocess.run(command, cwd=folder, env=env, capture_output=True, text=True, timeout=timeout)


@dataclass
class TestMap:
    """Which tests run which lines; tests that fail as things are take no part."""

    __test__ = False

    data: CoverageData
    failing: frozenset[str]
    reach: dict[str, int] = field(default_factory=dict)
    """How many files each test runs lines of."""

    def __post_init__(self) -> None:
        for path in self.data.measured_files():
            for context in {c for found in self.data.contexts_by_lineno(path).values() for c in found}:
                self.reach[context] = self.reach.get(context, 0) + 1

    def running(self, mutant: Mutant) -> set[str]:
        """Return the contexts that run the lines of a mutant; none where they run at import alone."""
        by_line = self.data.contexts_by_lineno(mutant.path.relative_to(ROOT).as_posix())
        return {c for line in mutant.lines for c in by_line.get(line, ())} - {""}

    def is_run(self, mutant: Mutant) -> bool:
        """Return whether a test runs the lines of a mutant."""
        return bool(self.running(mutant))

    def tests(self, mutant: Mutant) -> list[str]:
        """Return the tests that run the lines of a mutant (where none does: that run its file), the narrowest first."""
        by_line = self.data.contexts_by_lineno(mutant.path.relative_to(ROOT).as_posix())
        found = self.running(mutant)
        found = found or {c for contexts in by_line.values() for c in contexts} - {""}
        ordered = sorted(found, key=lambda context: (self.reach[context], context))
        return [name for name in dict.fromkeys(c.rpartition("|")[0] for c in ordered) if name not in self.failing]


def read_map(tests: Sequence[str], jobs: int) -> TestMap:
    """Return the map of these sources and tests, made where it is not there yet."""
    digest = hashlib.sha256(repr(sorted(tests)).encode())
    for path in sorted(
        p for name in ("src", "tests") for p in (ROOT / name).rglob("*.*") if "__pycache__" not in p.parts
    ):
        digest.update(path.as_posix().encode() + (path.read_bytes() if path.is_file() else b""))
    kept = Path(tempfile.gettempdir(), f"rospkg-mutants-{digest.hexdigest()[:16]}")
    if not (kept / "failing").exists():
        with tempfile.TemporaryDirectory() as scratch:
            folder = copy(Path(scratch, "checkout"))
            (folder / "coverage.ini").write_text(COVERAGE)
            options = ("--cov", "--cov-context=test", "--cov-report=", "--cov-config=coverage.ini", "-rfE")
            done = pytest(folder, "-n", str(jobs), *options, *tests)
            if not (folder / ".coverage").exists():
                sys.exit(f"the tests did not run: {done.stdout[-2000:]}{done.stderr[-2000:]}")
            kept.mkdir(exist_ok=True)
            shutil.copy(folder / ".coverage", kept)
            failed = re.findall(r"^(?:FAILED|ERROR) (.*?)(?: - .*)?$", done.stdout, re.MULTILINE)
            (kept / "failing").write_text("\n".join(failed))
    data = CoverageData(str(kept / ".coverage"))
    data.read()
    return TestMap(data, frozenset((kept / "failing").read_text().splitlines()))


@dataclass
class Copies:
    """Copies of the checkout, one for each mutant at work."""

    free: queue.Queue[Path]
    map: TestMap
    near: int
    wider: int
    timeout: float

    def verdict(self, mutant: Mutant) -> str:
        """Return `killed by …`, or `survived …`."""
        tests = self.map.tests(mutant)
        if not tests:
            return "survived: no test runs it in its own process; name tests that do, or look by hand"
        folder = self.free.get()
        target = folder / mutant.path.relative_to(ROOT)
        original = target.read_bytes()
        try:
            write(target, mutant.of(original.decode()).encode())
            laws = [] if self.map.is_run(mutant) else LAWS
            for few in (tests[: self.near], tests[self.near : self.near + self.wider], laws):
                killer = self.killer(folder, few) if few else ""
                if killer:
                    return f"killed by {killer}"
            return f"survived: {len(tests[: self.near + self.wider])} of {len(tests)} tests"
        finally:
            write(target, original)
            self.free.put(folder)

    def killer(self, folder: Path, tests: list[str]) -> str:
        (folder / "chosen").write_text("\n".join(tests))
        try:
            done = pytest(folder, "-n", "0", "-x", "-rfE", "@chosen", timeout=self.timeout)
        except subprocess.TimeoutExpired:
            return "time"
        found = re.search(r"^(?:FAILED|ERROR) (\S+)", done.stdout, re.MULTILINE)
        return found[1] if found else "" if done.returncode == 0 else f"pytest ({done.returncode})"


def write(path: Path, data: bytes) -> None:
    """Write a source so that Python compiles it anew: two writes in one second look alike to it."""
    later = path.stat().st_mtime + 2
    path.write_bytes(data)
    os.utime(path, (later, later))


def shown(mutant: Mutant) -> str:
    name, source = mutant.path.relative_to(ROOT).as_posix(), mutant.path.read_text("utf-8")
    before, after = source.splitlines(keepends=True), mutant.of(source).splitlines(keepends=True)
    return "".join(difflib.unified_diff(before, after, name, name, n=1))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--near", type=int, default=40)
    parser.add_argument("--wider", type=int, default=400)
    parser.add_argument("--timeout", type=float, default=600, help="seconds for the tests of one mutant")
    parser.add_argument("--tests", nargs="+", default=[])
    given = parser.parse_args()
    files = sorted({p.resolve() for f in given.folders for p in ([f] if f.is_file() else f.rglob("*.py"))})
    drawn = draw(files, given.count, given.seed)
    test_map = read_map(
        given.tests or sorted(f"tests/{p.name}" for p in (ROOT / "tests").glob("test_*.py")), given.jobs
    )
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(given.jobs) as pool:
        free: queue.Queue[Path] = queue.Queue()
        for number in range(given.jobs):
            free.put(copy(Path(scratch, str(number))))
        copies, survivors = Copies(free, test_map, given.near, given.wider, given.timeout), 0
        for mutant, verdict in zip(drawn, pool.map(copies.verdict, drawn), strict=True):
            line = f"{mutant.path.relative_to(ROOT).as_posix()}:{mutant.lines.start}"
            print(f"{mutant.kind:10} {line}: {verdict}", flush=True)
            if verdict.startswith("survived"):
                survivors += 1
                print(shown(mutant), flush=True)
    print(f"{len(drawn) - survivors} of {len(drawn)} killed")


if __name__ == "__main__":
    main()
