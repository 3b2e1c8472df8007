"""Write the tables of what core packages export (exported_dependencies.txt and cmake_exports.txt in ros/tables).

    python -m bench.exported_dependencies FOLDER…

Each folder holds a checkout of one repository.  The tables hold facts alone: whoever depends on the first name of a
line gets the others as well, at build time: by package.xml, or by ament_export_dependencies() alone, which
find_package() goes by.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from xml.etree import ElementTree

from bench.tables import Origin, Revision, revision_of, write

TAGS = frozenset({"depend", "build_export_depend", "buildtool_export_depend"})
TESTS = frozenset({"test", "tests"})
EXPORTS = re.compile(r"^\s*ament_export_dependencies\(([^)$#]*)\)", re.MULTILINE)
ORIGIN = Origin(
    "package.xml and CMakeLists.txt of the repositories of these packages, Rolling",
    "Apache-2.0, BSD-3-Clause",
    "bench/exported_dependencies.py",
)
ABOUT = {
    "exported_dependencies.txt": "What comes with a package for whoever builds against it: package, then what its "
    "package.xml exports.",
    "cmake_exports.txt": "What find_package() of a package looks for too, though its package.xml does not pass it on.",
}


def packages(folder: Path) -> Iterator[tuple[str, set[str], set[str]]]:
    """Yield each package's name, what its package.xml passes on, and what its CMakeLists.txt exports."""
    for path in folder.rglob("package.xml"):
        root = ElementTree.parse(path).getroot()
        needs = {child.text.strip() for child in root if child.tag in TAGS and child.text}
        cmake = path.with_name("CMakeLists.txt")
        calls = EXPORTS.findall(cmake.read_text(encoding="utf-8")) if cmake.is_file() else []
        if not TESTS.intersection(path.relative_to(folder).parts):
            yield (
                (root.findtext("name") or "").strip(),
                needs,
                {name.strip('"') for call in calls for name in call.split()},
            )


def revision_of_all(folders: Sequence[Path]) -> Revision:
    """Return the commits of several checkouts, and the newest of their dates."""
    every = {folder.name: revision_of(folder) for folder in folders}
    known = [f"{name} {each.commit}" for name, each in every.items() if each.commit != "unknown"]
    return Revision(", ".join(known) or "unknown", max(each.date for each in every.values()))


def main(folders: Sequence[Path]) -> None:
    found = [each for folder in folders for each in packages(folder)]
    exported = sorted({" ".join([name, *sorted(needs)]) for name, needs, _ in found})
    finds = sorted({" ".join([name, *sorted(more - needs)]) for name, needs, more in found if more - needs})
    revision = revision_of_all(folders)
    for name, rows in (("exported_dependencies.txt", exported), ("cmake_exports.txt", finds)):
        write(name, ABOUT[name], rows, ORIGIN, revision)


if __name__ == "__main__":
    main([Path(each) for each in sys.argv[1:]])
