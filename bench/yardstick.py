"""How loud are we on well-kept packages? `python bench/yardstick.py REPOSITORY…`

Lints each checkout with an unknown target and the default rules, and prints the share of packages that would exit 1,
errors and warnings per package, and how many packages each rule reddens.  `--show CODE` prints that rule's findings, to
be judged one by one as their maintainer would.
"""

from __future__ import annotations

import argparse
import collections
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any


def lint(repository: Path) -> dict[str, Any]:
    """Return the JSON report of a checkout, in an environment that names no distribution."""
    environment = {k: v for k, v in os.environ.items() if k not in ("ROS_DISTRO", "AMENT_PREFIX_PATH")}
    command = [sys.executable, "-m", "rospkg_cli", "lint", "--format", "json", str(repository)]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    if done.returncode == 3 or not done.stdout:
        print(f"{repository}: exit {done.returncode}: {done.stderr}", file=sys.stderr)
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("repositories", nargs="+", type=Path)
    parser.add_argument("--show", action="append", default=[], metavar="CODE")
    arguments = parser.parse_args()
    packages, levels = 0, collections.Counter[str]()
    red: dict[str, set[tuple[str, str]]] = collections.defaultdict(set)
    for repository in arguments.repositories:
        report = lint(repository)
        packages += report["summary"]["packages"]
        for finding in report["findings"]:
            levels[finding["severity"]] += 1
            if finding["severity"] != "info":
                red[finding["code"]].add((repository.name, finding["package"]))
            if finding["code"] in arguments.show:
                print(
                    f"{finding['path']}:{finding['line']}: {finding['severity']} {finding['code']} {finding['message']}"
                )
    reddened = set().union(*red.values()) if red else set()
    print(f"{packages} packages; {len(reddened)} exit 1 ({len(reddened) / max(packages, 1):.1%})")
    for level in ("error", "warning", "info"):
        print(f"{levels[level]:>6} {level}s, {levels[level] / max(packages, 1):.2f} a package")
    for code, names in sorted(red.items(), key=lambda each: -len(each[1])):
        print(f"{code}  reddens {len(names):>4} packages ({len(names) / max(packages, 1):.1%})")
    return 0


if __name__ == "__main__":
    sys.exit(main())
