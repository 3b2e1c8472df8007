"""Add to real packages and remove again, in memory: what lint says then, whether only insertions were made.

    .venv/bin/python -m bench.add_real REPOSITORY… [--verbs node-py,launch,…] [--stride 3] [--show]

For each package and verb: added, or refused and why; new findings of lint; whether each file that was there is still
in the new one, character for character; whether adding twice is adding once; whether `remove` brings the bytes back.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from rospkg_cli.addition.part import put_in, take_out
from rospkg_cli.addition.wanted import Wanted, parts_to_add, parts_to_remove
from rospkg_cli.change import ChangeError
from rospkg_cli.change.draft import Draft, same
from rospkg_cli.change.judge import judge
from rospkg_cli.cli.change.place import ChangePlace, place_of
from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.discovery.discover import packages_below
from rospkg_cli.engine.run.results import Results
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.light_dataclasses import replace
from rospkg_cli.package.install_table import InstallTable
from rospkg_cli.package.manifest import Manifest
from rospkg_cli.ros.distros import Targets
from rospkg_cli.scaffold import ScaffoldError
from rospkg_cli.scaffold.workspace import WorkspacePackages
from rospkg_cli.user_error import UserError

THERE = WorkspacePackages()
VERBS = {
    "node": (Wanted("node", ("added_talker:publisher",)), "added_talker"),
    "node-timer": (Wanted("node", ("added_clock:timer",)), "added_clock"),
    "node-empty": (Wanted("node", ("added_idler:empty",)), "added_idler"),
    "component": (Wanted("node", ("added_part:component",)), "added_part"),
    "node-script": (Wanted("node", ("added_script:subscriber:python",)), "added_script"),
    "launch": (Wanted("launch", ("added_up",)), "added_up"),
    "launch-xml": (Wanted("launch", ("added_up:xml",)), "added_up:xml"),
    "params": (Wanted("params", ("added_params",)), "added_params"),
    "msg": (Wanted("msg", ("AddedStatus",)), "AddedStatus"),
    "srv": (Wanted("srv", ("AddedAsk:geometry_msgs/Pose at --- bool done",)), "AddedAsk"),
    "action": (Wanted("action", ("AddedGo",)), "AddedGo"),
    "msg-here": (Wanted("msg", ("AddedStatus",), here=True), "AddedStatus"),
    "test": (Wanted("test", ("added_thing",)), "added_thing"),
    "dependency": (Wanted("dependency", ("diagnostic_msgs",)), "diagnostic_msgs"),
}
DEPENDENCY = ("depend>", "find_package", "dependencies")
"""What a line has that names a dependency."""
INTERFACES = {"msg", "srv", "action"}


def packages(roots: list[Path]) -> Iterator[Path]:
    for root in roots:
        yield from sorted(packages_below(root.absolute()))


def alone(place: ChangePlace, path: Path) -> ChangePlace:
    """Return a package without those around it but their names, which is linted in a fraction of the time."""
    tree = DiskTree(path)
    names = {folder.rpartition("/")[2] for folder in place.located.scope.folders}
    scope = Scope(("",), frozenset({""}), path.name, prefix_names=place.session.scope.prefix_names | names)
    located = replace(place.located, root=path, scope=scope)
    return replace(place, located=located, session=replace(place.session, tree=tree, scope=scope))


def fits(place: ChangePlace, verb: str, build_type: str) -> bool:
    """Return whether a verb is for a package of this kind at all."""
    package = Draft(place.session.tree).package(place.folder)
    generates = "rosidl_generate_interfaces" in package.files.readable_text("CMakeLists.txt")
    if verb in INTERFACES:
        return generates
    if verb in ("component", "node-script"):
        return build_type == "ament_cmake"
    return build_type == "ament_cmake" if verb == "msg-here" else True


def outcome(place: ChangePlace, before: Results, verb: str, show: bool) -> tuple[str, str]:
    """Return a word and what there is to say about it."""
    wanted, back = VERBS[verb]
    draft = Draft(place.session.tree)
    try:
        put_in(draft, place.folder, parts_to_add(draft.package(place.folder), wanted, wanted.names[0], THERE))
    except (ChangeError, ScaffoldError) as error:
        return "refused", str(error)
    faults = [*not_insertions(place, draft), *not_once(place, draft, wanted), *not_there(place, draft, wanted)]
    faults += [
        f"new {each.code} {each.location.path}: {each.message}"
        for each in judge(place.session, draft, before=before).new
    ]
    faults += not_back(place, draft, wanted, back)
    if show and faults:
        from rospkg_cli.cli.diff import unified

        existing = {p: e for p, e in draft.changes.items() if p not in set(draft.created())}
        sys.stdout.writelines(unified(place.session.tree, existing))
    return ("faulty" if any(not each.startswith("~") for each in faults) else "good"), "; ".join(faults)


def not_insertions(place: ChangePlace, draft: Draft) -> Iterator[str]:
    for path, entry in draft.changes.items():
        if path not in set(draft.created()):
            before, data = place.session.tree.entry(path).data, entry.data if entry else b""
            if path.endswith("package.xml") and as_format_3(before) != before and b'format="3"' in data:
                yield "~package.xml becomes one of format 3"
                before = as_format_3(before)
            after = iter(data)
            if not all(byte in after for byte in before):
                yield f"more than insertions in {path}"


def as_format_3(manifest: bytes) -> bytes:
    """Return a package.xml of format 2 as one of format 3: groups ask for it, and removing leaves it so."""
    return manifest.replace(b'format="2"', b'format="3"').replace(b"package_format2", b"package_format3")


def not_once(place: ChangePlace, draft: Draft, wanted: Wanted) -> Iterator[str]:
    again = draft.copy()
    try:
        put_in(again, place.folder, parts_to_add(again.package(place.folder), wanted, wanted.names[0], THERE))
    except (ChangeError, ScaffoldError) as error:
        yield f"twice is refused: {error}"
    yield from (f"twice changes {path}" for path in again.changes if not same(again.entry(path), draft.entry(path)))


def not_there(place: ChangePlace, draft: Draft, wanted: Wanted) -> Iterator[str]:
    package = draft.package(place.folder)
    table, manifest = package.parts(InstallTable).only, package.parts(Manifest).only
    if wanted.what == "node" and table and manifest:
        name = wanted.names[0].partition(":")[0]
        if f"lib/{manifest.name}/{name}" not in {row.destination for row in table.rows}:
            yield "no executable"


def not_back(place: ChangePlace, draft: Draft, wanted: Wanted, back: str) -> Iterator[str]:
    """Yield what `remove` leaves; what it takes of dependencies that nothing names is marked with `~`."""
    after = Draft(draft.tree)
    try:
        parts = parts_to_remove(after.package(place.folder), wanted, back, THERE)
        take_out(after, place.folder, parts)
    except (ChangeError, ScaffoldError) as error:
        named = "still name" in str(error)
        yield f"{'~' if named else ''}remove is refused: {error}"
        return
    for path in sorted(draft.changes.keys() | after.changes.keys()):
        before, now = Draft(place.session.tree).entry(path), after.entry(path)
        if not same(before, now):
            old, new = (entry.data.decode("utf-8", "replace") if entry else "" for entry in (before, now))
            gone = Counter(old.split("\n")) - Counter(new.split("\n"))
            more = Counter(new.split("\n")) - Counter(old.split("\n"))
            only = all(any(w in line.lower() for w in DEPENDENCY) for line in [*gone, *more])
            shown = f"-{[*gone]} +{[*more]}"[:300]
            only = only or path.endswith("setup.cfg") or as_format_3(old.encode()) == new.encode()
            yield f"{'~' if only else ''}not back {path}: {shown}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("roots", nargs="+", type=Path)
    parser.add_argument("--verbs", default=",".join(VERBS))
    parser.add_argument("--stride", type=int, default=1)
    parser.add_argument("--type", default="")
    parser.add_argument("--alone", action="store_true", help="lint each package without those around it")
    parser.add_argument("--show", action="store_true")
    options = parser.parse_args()
    count: Counter[tuple[str, str, str]] = Counter()
    for number, path in enumerate(packages(options.roots)):
        if number % options.stride:
            continue
        try:
            place = place_of(path)
        except UserError as error:
            print(f"{path}: {error}")
            continue
        manifest = Draft(place.session.tree).package(place.folder).parts(Manifest).only
        build_type = manifest.build_type(Targets()) if manifest else ""
        if build_type not in ("ament_python", "ament_cmake") or options.type not in ("", build_type):
            continue
        if options.alone:
            place = alone(place, path)
        before = place.session.run()
        for verb in options.verbs.split(","):
            if fits(place, verb, build_type):
                word, why = outcome(place, before, verb, options.show)
                count[verb, build_type, word] += 1
                if why:
                    print(f"{word} {verb} {path}: {why}", flush=True)
    for verb, build_type in sorted({key[:2] for key in count}):
        row = {word: count[verb, build_type, word] for word in ("good", "faulty", "refused")}
        print(f"{verb:<12} {build_type:<13} " + "  ".join(f"{word} {n}" for word, n in row.items()))


if __name__ == "__main__":
    main()
