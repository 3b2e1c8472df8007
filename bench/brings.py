"""Write the tables of what core packages bring with them (brings.txt and exports.txt in src/rospkg_cli/ros/tables).

    python bench/brings.py FOLDER…

Each folder holds a copy of one repository.  The tables hold facts alone: whoever depends on the first name of a line
gets the others as well, at build time: by package.xml (brings.txt), or by ament_export_dependencies() alone, which
find_package() goes by (exports.txt).
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

TABLES = Path(__file__).parents[1] / "src/rospkg_cli/ros/tables"
TAGS = frozenset({"depend", "build_export_depend", "buildtool_export_depend"})
TESTS = frozenset({"test", "tests"})
EXPORTS = re.compile(r"^\s*ament_export_dependencies\(([^)$#]*)\)", re.MULTILINE)
BRINGS = "# What comes with a package for whoever builds against it: package, then what it exports. By bench/brings.py."
FINDS = "# What find_package() of a package looks for too, and its package.xml does not pass on. By bench/brings.py."


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


if __name__ == "__main__":
    found = [each for folder in sys.argv[1:] for each in packages(Path(folder))]
    brings = sorted({" ".join([name, *sorted(needs)]) for name, needs, _ in found})
    finds = sorted({" ".join([name, *sorted(more - needs)]) for name, needs, more in found if more - needs})
    (TABLES / "exported_dependencies.txt").write_text("\n".join([BRINGS, *brings]) + "\n", encoding="utf-8")
    (TABLES / "cmake_exports.txt").write_text("\n".join([FINDS, *finds]) + "\n", encoding="utf-8")
