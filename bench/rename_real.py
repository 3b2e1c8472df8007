"""Rename real packages inside their workspaces and back again, in memory: what lint says, what is left, what returns.

    .venv/bin/python -m bench.rename_real WORKSPACE… [--stride 3] [--nodes] [--left] [--no-lint]

For each package: refused, and why; findings of lint that are there since; the places that a search for the old name
still finds, by what they are; whether renaming it back restores the bytes of all files of the workspace.
"""

from __future__ import annotations

import argparse
import re
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from rospkg_cli.change import ChangeError
from rospkg_cli.change.draft import Draft, same
from rospkg_cli.change.judge import Judgement
from rospkg_cli.cli.change.place import ChangePlace, place_of
from rospkg_cli.engine.discovery.discover import packages_below
from rospkg_cli.package.manifest import Manifest
from rospkg_cli.renaming.names_aside import judge_rename
from rospkg_cli.renaming.node_plan import executables_of, plan_rename_node
from rospkg_cli.renaming.plan import Left, plan_rename
from rospkg_cli.tree import Tree
from rospkg_cli.user_error import UserError

MAX_SHOWN = 5
"""Of one kind for each package, without --left."""
MOST = 2
"""Executables of a package that are renamed."""
NEW = "entirely_other_name"
PROSE = (".md", ".rst", ".adoc", ".dox", ".svg", "/README.txt", ".repos")
KINDS = {
    "comment": r"^(#|//|/?\*|<!--|\"\"\"|%)",
    "namespace": r"namespace [\w:]*OLD|OLD::|::OLD\b",
    "name of a plug-in": r"OLD/[A-Z]\w+",
    "address": r"https?://\S*OLD",
    "name of a node, logger or topic": r"get_logger\(|Node\(\s*[\"']|name\s*=|__init__\(|[\"']/?OLD[/\"']|^OLD:|/OLD",
}
"""What a line is in which the old name stays, by what stands in it."""


def kind_of(left: Left, old: str) -> str:
    """Return what a place is in which the old name stays."""
    if left.path.endswith(PROSE) or left.path.endswith("package.xml"):
        return "prose"
    text = re.sub(rf"\b{old}\b", "OLD", left.text)
    return next((kind for kind, pattern in KINDS.items() if re.search(pattern, text)), "other")


def outcome(place: ChangePlace, old: str, lint: bool, node: bool) -> Iterator[tuple[str, str]]:
    """Yield a word and what there is to say about it, for each thing to be told."""
    tree, rename = place.session.tree, plan_rename_node if node else plan_rename
    plan = rename(tree, place.folder, old, NEW)
    yield "edited", f"{len(plan.draft.changes)} files, {len(plan.renamed)} renamed"
    for left in plan.left:
        yield f"left: {kind_of(left, old)}", f"{left.path}:{left.line}: {left.text[:150]}"
    if lint:
        judged = judge_rename(place.session, plan, old, NEW)
        yield from (
            ("new", f"{each.code} {each.location.path}:{each.location.line} {each.message}") for each in judged.new
        )
        paths = frozenset(each.location.path for each in judged.before.findings)
        gone = Judgement(judged.after, judged.before, paths).new
        yield from (("gone", f"{each.code} {each.location.path}:{each.location.line} {each.message}") for each in gone)
    folder = plan.draft.base.moved(place.folder) if place.folder else ""  # type: ignore[attr-defined]
    yield from (("not back", path) for path in not_back(tree, rename(plan.draft.tree, folder, NEW, old).draft))


def not_back(before: Tree, draft: Draft) -> Iterator[str]:
    now = draft.tree
    yield from sorted(before.files().keys() ^ now.files().keys())
    for path in before.files().keys() & now.files().keys():
        if path in draft.changes and not same(before.entry(path), now.entry(path)):
            yield path
    yield from (path for path in draft.changes if path not in before.files())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("roots", nargs="+", type=Path)
    parser.add_argument("--stride", type=int, default=1)
    parser.add_argument("--left", action="store_true", help="show every place that still has the old name")
    parser.add_argument("--nodes", action="store_true", help="rename executables instead, some of each package")
    parser.add_argument("--no-lint", action="store_true")
    options = parser.parse_args()
    count: Counter[str] = Counter()
    every = [path for root in options.roots for path in sorted(packages_below(root.absolute()))]
    for path in every[:: options.stride]:
        begun = time.perf_counter()
        try:
            place = place_of(path)
            package = Draft(place.session.tree).package(place.folder)
            manifest = package.parts(Manifest).only
            name = manifest.name if manifest else path.name
            names = sorted(executables_of(package))[:MOST] if options.nodes else [name]
            told = [each for old in names for each in outcome(place, old, not options.no_lint, options.nodes)]
        except (ChangeError, UserError) as error:
            told = [("refused", str(error))]
        words = {word for word, _ in told}
        good = not words & {"refused", "new", "gone", "not back"}
        count.update(["packages", *(["good"] if good else [])])
        count.update(word for word, _ in told)
        print(f"{'good' if good else 'FAULTY'} {path} ({time.perf_counter() - begun:.1f} s)", flush=True)
        shown: Counter[str] = Counter()
        for word, what in told:
            shown[word] += 1
            is_fault = word in ("refused", "new", "gone", "not back", "left: other")
            if options.left or (is_fault and shown[word] <= MAX_SHOWN):
                print(f"    {word}: {what}", flush=True)
    for word, number in sorted(count.items()):
        print(f"{number:>6}  {word}")


if __name__ == "__main__":
    main()
