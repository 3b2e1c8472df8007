"""Format package.xml files, real and broken ones, and look at what came out.

    python -m bench.format_manifests --xsd REP/xsd [--mutations N] [--seed S] FOLDER...

Of each that can be read: it can still be read; catkin_pkg says the same of it, dependency by dependency, with the same
conditions and limits; the official schema has nothing against the order; every comment is still there, every line but
those that moved; a second run changes nothing.  The exit status is 1 where one of these does not hold.
"""

from __future__ import annotations

import argparse
import contextlib
import random
import warnings
from collections import Counter
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

from rospkg_cli.edits.format_manifest import format_text
from rospkg_cli.package.manifest import Manifest, manifest_of
from rospkg_cli.source import Source
from rospkg_cli.unreadable import UnreadableError

from .break_manifest import break_manifest
from .manifest_parity import Official
from .manifests import manifests

LISTS = (
    "build_depends", "buildtool_depends", "build_export_depends", "buildtool_export_depends", "exec_depends",
    "test_depends", "doc_depends", "conflicts", "replaces", "group_depends", "member_of_groups",
)  # fmt: skip


def told(text: str) -> Counter[str] | str:
    """Return what catkin_pkg reads of dependencies and exports, or why it refuses, in words without an order."""
    package = import_module("catkin_pkg.package")
    try:
        found = package.parse_package_string(text, warnings=[])
    except Exception as error:  # whatever it says, it must say it of both
        return "".join(sorted(f"{type(error).__name__} {error}"))
    each = Counter(f"{name} {sorted(slots(d))}" for name in LISTS for d in getattr(found, name))
    each.update(f"export {export}" for export in found.exports)
    each[f"{found.name} {found.version} {sorted(found.licenses)} {[str(m) for m in found.maintainers]}"] += 1
    return each


def slots(dependency: object) -> Iterator[str]:
    for slot in getattr(type(dependency), "__slots__", ()):
        yield f"{slot}={getattr(dependency, slot)}"


def faults(text: str, official: Official) -> Iterator[str]:
    """Yield what formatting did wrong."""
    manifest = manifest_of(Source("package.xml", text))
    formatted = format_text(text)
    try:
        after = manifest_of(Source("package.xml", formatted))
    except UnreadableError as error:
        yield f"can't be read any more: {error}"
        return
    if told(formatted) != told(text):
        yield "catkin_pkg says something else"
    if Counter(c.text for c in after.document.comments) != Counter(c.text for c in manifest.document.comments):
        yield "a comment is lost"
    if Counter(formatted.split()) != Counter(text.split()):
        yield "a word is lost"
    if format_text(formatted) != formatted:
        yield "a second run changes it again"
    yield from disorder(after, official, official.accepts(formatted, manifest.schema_format))


def disorder(manifest: Manifest, official: Official, accepted: bool) -> Iterator[str]:
    """Yield a fault where the official schema refuses a document that our schema takes, or finds only out of order."""
    if (
        not accepted
        and manifest.verdict.is_valid
        and not any(quirk in manifest.source.text for quirk in ("compatibility", "condition"))
    ):
        yield "the official schema refuses it"
    if not manifest.verdict.is_ordered and not any(v.kind.name == "TEXT" for v in manifest.verdict.violations):
        yield "it is out of order"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--xsd", type=Path, required=True, help="the official schemas")
    parser.add_argument("--mutations", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    warnings.simplefilter("ignore")
    texts: dict[str, str] = {}
    for path in manifests(arguments.folders):
        with contextlib.suppress(UnicodeError):
            texts[str(path)] = path.read_text("utf-8")
    chance, names = random.Random(arguments.seed), sorted(texts)
    for index in range(arguments.mutations):
        name = names[index % len(names)]
        texts[f"{name} (broken copy {index})"] = break_manifest(texts[name], chance, chance.choice([1, 2, 3]))
    official, counts, bad = Official(arguments.xsd), Counter[str](), list[str]()
    for label, text in texts.items():
        try:
            counts["changed" if format_text(text) != text else "in order already"] += 1
        except UnreadableError:
            counts["can't be read"] += 1
            continue
        bad += [f"{label}: {fault}" for fault in faults(text, official)]
    print(
        f"== {len(names)} real, {arguments.mutations} broken copies",
        *(f"{n:6}  {what}" for what, n in sorted(counts.items())),
        sep="\n",
    )
    print(f"== {len(bad)} faults", *bad[:40], sep="\n")
    return 1 if bad else 0


if __name__ == "__main__":
    raise SystemExit(main())
