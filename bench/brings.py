"""Write the table of what core packages bring with them (src/rospkg_cli/ros/tables/brings.txt).

    python bench/brings.py FOLDER…

Each folder holds a copy of one repository.  The table holds facts alone: whoever depends on the first name of a line
gets the others as well, at build time.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

TABLE = Path(__file__).parents[1] / "src/rospkg_cli/ros/tables/brings.txt"
TAGS = frozenset({"depend", "build_export_depend", "buildtool_export_depend"})
TESTS = frozenset({"test", "tests"})
SAYS = "# What comes with a package for whoever builds against it: package, then what it exports. By bench/brings.py.\n"


def lines(folder: Path) -> Iterator[str]:
    for path in folder.rglob("package.xml"):
        root = ElementTree.parse(path).getroot()
        needs = {child.text.strip() for child in root if child.tag in TAGS and child.text}
        if not TESTS.intersection(path.relative_to(folder).parts):
            yield " ".join([(root.findtext("name") or "").strip(), *sorted(needs)])


if __name__ == "__main__":
    found = sorted({line for folder in sys.argv[1:] for line in lines(Path(folder))})
    TABLE.write_text(SAYS + "\n".join(found) + "\n", encoding="utf-8")
