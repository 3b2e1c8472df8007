"""Write the table of what well-known packages offer (well_known.txt in ros/tables): programs, components, plugins.

    python -m bench.well_known FOLDER

FOLDER holds bare mirrors, `owner+name/repo` each.  Of every repository the branches of the supported distributions and
the newest one are read as `rospkg lint` reads a workspace, and those of older distributions, for the names that went
away.  The table holds facts alone: names of packages and of what they install.
"""

from __future__ import annotations

import io
import subprocess
import sys
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from bench.tables import Origin, Revision, write
from bench.well_known_renames import ON_PATH, RENAMED, REPOSITORIES, VOUCHED
from rospkg_cli.engine.discovery.discover import packages_in
from rospkg_cli.engine.run.pool import Pool
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.package.package_facts import PackageFacts
from rospkg_cli.package.rule_settings import RuleSettings
from rospkg_cli.ros.distros import DISTROS, Targets
from rospkg_cli.suggest import nearest
from rospkg_cli.tree import MemoryTree, TreeEntry

ORIGIN = Origin(
    "CMakeLists.txt, setup.py, sources and plugin descriptions of the repositories that the script lists, "
    + "their branches from Dashing on",
    "Apache-2.0, BSD-2-Clause, BSD-3-Clause, EPL-2.0, LGPL-2.1, LGPL-3.0, MIT",
    "bench/well_known.py",
)
TABLE = "well_known.txt"
ABOUT = {
    TABLE: "What well-known packages offer in the supported distributions: package, then the programs in its "
    "lib/<package>, those that are on the PATH too, its components, the names of its plugins; of packages of which all "
    "is known; `%20` is a blank. [removed …]: what only older distributions had, and behind `=` what it is called now, "
    "where it has a successor."
}
NEWEST = ("main", "master", "ros2")
OLD = ("dashing", "eloquent", "foxy", "galactic", "iron")
KINDS = ("programs", "components", "plugins")
READ = frozenset(
    ["", *".xml .txt .cmake .py .cfg .toml .cpp .cc .cxx .hpp .h .hxx .in .yaml .yml .urdf .xacro .rviz".split()]
)
"""The suffixes of the files that are read; of all others it counts that they are there."""
TESTS = frozenset({"test", "tests", "testing"})


@dataclass
class Offer:
    """What a package has of each kind, over some branches."""

    names: dict[str, set[str]] = field(default_factory=lambda: {kind: set() for kind in KINDS})
    on_path: set[str] = field(default_factory=set)
    unknown: set[str] = field(default_factory=set)
    """The kinds of which not all is known."""

    def add(self, facts: PackageFacts) -> None:
        self.names["programs"] |= {name for name in facts.executables if not is_leftover(name)}
        self.names["components"] |= facts.components
        self.names["plugins"] |= {plugin.name.replace(" ", "%20") for plugin in facts.plugins}
        self.on_path |= facts.misplaced_executables
        fields = {"programs": "executables", "components": "components", "plugins": "plugins"}
        vouched = {kind for kind in KINDS if facts.name in VOUCHED[kind]}
        self.unknown |= {kind for kind, name in fields.items() if name in facts.unknown} - vouched


def is_leftover(name: str) -> bool:
    """Return whether an installed file is no program for launch files: a library, or a test."""
    return name.endswith((".so", "-test")) or name.startswith("test_")


def branches(mirror: Path) -> Iterator[tuple[str, bool]]:
    """Yield the branches to read, and whether each is of a supported distribution."""
    yield "HEAD", True
    listed = git(mirror, "branch", "--format=%(refname:short)").decode().split()
    for distro in (*(each.name for each in DISTROS), *NEWEST, *OLD):
        for name in (distro, f"{distro}-devel"):
            if name in listed:
                yield name, distro not in OLD


def listed_files(mirror: Path, branch: str) -> Iterator[tuple[str, int, str]]:
    """Yield the object, the mode and the path of each file of a branch, but for those of tests."""
    listing = git(mirror, "ls-tree", "-r", "-z", branch).decode("utf-8", "replace")
    for entry in listing.split("\0"):
        about, _, path = entry.partition("\t")
        if about and not TESTS.intersection(path.split("/")[:-1]) and about.split()[1] == "blob":
            yield about.split()[2], int(about.split()[0], 8) & 0o777, path


def tree_of(mirror: Path, branch: str) -> MemoryTree:
    """Return the files of a branch; the content of those that say nothing of names, or are not there, is left out."""
    files = list(listed_files(mirror, branch))
    wanted = [sha for sha, _, path in files if Path(path).suffix in READ]
    packed = io.BytesIO(git(mirror, "cat-file", "--batch", given="\n".join(wanted).encode()))
    found: dict[str, bytes] = {}
    while head := packed.readline().split():
        if head[1] == b"blob":
            found[head[0].decode()] = packed.read(int(head[2]))
            packed.readline()
    return MemoryTree({path: TreeEntry("file", found.get(sha, b""), mode) for sha, mode, path in files})


def git(mirror: Path, *words: str, given: bytes | None = None) -> bytes:
    return subprocess.run(["git", "-C", str(mirror), *words], check=True, capture_output=True, input=given).stdout


def facts_in(mirror: Path, branch: str) -> list[PackageFacts]:
    tree = tree_of(mirror, branch)
    folders = tuple(packages_in(tree))
    scope = Scope(folders, frozenset(folders), "root")
    found = Pool(tree, scope, Targets(()), RuleSettings()).collect_facts(folders)
    return [facts for facts in found if facts.build_type != "catkin"]


def mirrored(folder: Path, names: Iterable[str]) -> tuple[list[Path], Revision]:
    """Return the mirrors of some repositories, with their newest commits and the newest of the dates of these."""
    mirrors = [folder / name.replace("/", "+") / "repo" for name in names]
    heads = [git(mirror, "log", "-1", "--format=%h %cs").decode().split() for mirror in mirrors]
    repositories = (mirror.parent.name.partition("+")[2] for mirror in mirrors)
    said = (f"{repository} {commit}" for repository, (commit, _) in zip(repositories, heads, strict=True))
    return mirrors, Revision(", ".join(said), max(day for _, day in heads))


def collect(mirrors: Iterable[Path]) -> tuple[dict[str, Offer], dict[str, Offer]]:
    """Return what is offered now, and what was offered."""
    now: dict[str, Offer] = {}
    before: dict[str, Offer] = {}
    for mirror in mirrors:
        is_known = False
        for branch, is_current in branches(mirror):
            found = facts_in(mirror, branch) if is_current or is_known else []
            is_known |= is_current and bool(found)
            for facts in found:
                (now if is_current else before).setdefault(facts.name, Offer()).add(facts)
    return now, before


def successor(kind: str, package: str, name: str, now: dict[str, Offer]) -> str:
    """Return what a removed name is called now, and in which other package; "" where that is unknown."""
    if f"{package} {name}" in RENAMED:
        return RENAMED[f"{package} {name}"]
    own = now[package].names[kind] if package in now else set()
    if len(name) > 5 and (near := nearest(name, own)):
        return near
    homes = [other for other, offer in now.items() if name in offer.names[kind]]
    if kind == "plugins":
        same = [each for each in own if each.replace("/", "::") == name.replace("/", "::")]
        return same[0] if same else ""
    return f"{homes[0]}/{name}" if len(homes) == 1 else ""


def rows(now: dict[str, Offer], before: dict[str, Offer]) -> Iterator[str]:
    for kind in KINDS:
        known = {name: offer for name, offer in sorted(now.items()) if kind not in offer.unknown}
        yield f"[{kind}]"
        yield from (" ".join([name, *sorted(offer.names[kind])]) for name, offer in known.items() if offer.names[kind])
        yield f"[removed {kind}]"
        current = {each for offer in now.values() for each in offer.names[kind]}
        for package, offer in sorted(before.items()):
            here = now[package].names[kind] if package in now else set()
            gone = offer.names[kind] - (current if kind == "plugins" else here)
            if gone and not (package in now and kind in now[package].unknown):
                pairs = [f"{name}={successor(kind, package, name, now)}" for name in sorted(gone)]
                yield " ".join([package, *pairs])
    yield "[on the path]"
    for package, names in ON_PATH.items():
        now[package].on_path |= set(names)
    yield from (" ".join([name, *sorted(offer.on_path)]) for name, offer in sorted(now.items()) if offer.on_path)


def main(folder: Path) -> None:
    mirrors, revision = mirrored(folder, REPOSITORIES)
    write(TABLE, ABOUT[TABLE], rows(*collect(mirrors)), ORIGIN, revision)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
