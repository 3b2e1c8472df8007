"""Find the package.xml files below some folders, each content once: what the other measures go through.

python -m bench.manifests FOLDER...
"""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Iterator
from pathlib import Path


def manifests(folders: Iterable[Path]) -> Iterator[Path]:
    """Yield one path for each different package.xml, sorted within a folder."""
    seen: set[bytes] = set()
    for folder in folders:
        for path in sorted(folder.rglob("package.xml")):
            if path.is_file() and ".git" not in path.parts:
                data = path.read_bytes()
                if data not in seen:
                    seen.add(data)
                    yield path


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path)
    for path in manifests(parser.parse_args().folders):
        print(path)


if __name__ == "__main__":
    main()
