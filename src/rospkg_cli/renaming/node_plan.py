"""What renaming an executable of a package changes: what makes it, and what starts it in the workspace."""

from __future__ import annotations

from collections.abc import Iterator

from ..change import ChangeError
from ..change.draft import Draft
from ..change.moved_tree import MovedTree
from ..files import PackageFiles
from ..finding import Edit
from ..languages.cmake.parser import parse
from ..package.collect_facts import collect_facts
from ..package.manifest import Manifest
from ..package.package import Package
from ..package.setup.entry_point import EntryPoint
from ..package.setup.setup_py import SetupPy
from ..ros.distros import Targets
from ..source import Source, Span
from ..suggest import did_you_mean
from ..tree import Tree
from .node_places import started_places
from .patterns import found
from .plan import Left, RenamePlan, refuse_taken, stays, texts_with
from .references import PROSE, inside
from .renamed_package import BUILD_FILES, RenamedPackage

TARGET = (r"^%NAME%$", r"(?<=[:,])%NAME%(?=>)", r"(?<=/)%NAME%$")
ENTRY = r"""["'][ \t]*%NAME%(?=[ \t]*=)"""
NO_NAMES = frozenset({"message", "project", "find_package", "generate_parameter_library"})


def plan_rename_node(tree: Tree, folder: str, old: str, new: str) -> RenamePlan:
    """Return what to change so that an executable of the package in a folder has another name.

    Raises ChangeError where there is none of the old name, or where what makes it is not understood.
    """
    package = Package(PackageFiles(tree.sub(folder), folder, tree))
    manifest = package.parts(Manifest).only
    before = executables_of(package)
    refuse_unknown(before, old, new)
    moves = dict(scripts(package, folder, old, new))
    refuse_taken(tree.files(), moves)
    moved = MovedTree(tree, moves)
    draft, left, mentions = Draft(moved), list[Left](), set[str]()
    made = {f"{folder}/{path}".lstrip("/"): spans for path, spans in makers(package, old).items()}
    for path, text in texts_with(tree, old):
        spans = set(made.get(path, ()))
        if manifest and not path.endswith(PROSE):
            spans |= set(started_places(Source(path, text), manifest.name, old))
        if spans:
            mentions.add(path)
        target = moved.moved(path)
        draft.apply("", [Edit(target, span, new) for span in sorted(spans)])
        if manifest and (manifest.name in text or inside(path, package.files) is not None):
            left += stays(target, text, old, spans)
    if executables_of(draft.package(folder)) != before - {old} | {new}:
        raise ChangeError(f"what makes the executable `{old}` is not understood; rename it there by hand")
    return RenamePlan(RenamedPackage(old, new, package), draft, moves, frozenset(mentions), tuple(left))


def executables_of(package: Package) -> frozenset[str]:
    return collect_facts(package, Targets(), "", "").executables


def refuse_unknown(there: frozenset[str], old: str, new: str) -> None:
    """Raise ChangeError where there is no executable of the old name, or one of the new."""
    if old not in there:
        raise ChangeError(f"the package installs no executable `{old}`{did_you_mean(old, sorted(there))}")
    if new in there:
        raise ChangeError(f"the package has an executable `{new}` already; choose another name")


def scripts(package: Package, folder: str, old: str, new: str) -> Iterator[tuple[str, str]]:
    """Yield the script that is the executable, where CMake installs a file of this name."""
    if package.files.exists("CMakeLists.txt"):
        paths = [path for path in package.files.paths if path.rpartition("/")[2] == old]
        if len(paths) == 1:
            yield f"{folder}/{paths[0]}".lstrip("/"), new


def makers(package: Package, old: str) -> dict[str, list[Span]]:
    """Return where files of the package name what they make an executable of, by their paths."""
    found_: dict[str, list[Span]] = {}
    setup = package.parts(SetupPy).only
    for each in setup.entry_points if setup else ():
        if each.is_script and each.name == old and (span := name_place(package.files.source(each.path), each)):
            found_.setdefault(each.path, []).append(span)
    for path in package.files.paths:
        if path.endswith(BUILD_FILES) and old in package.files.readable_text(path):
            found_[path] = list(targets(package.files.source(path), old))
    return found_


def name_place(source: Source, entry: EntryPoint) -> Span | None:
    """Return where the name of an entry point stands; None where it is put together."""
    if source.slice(entry.name_span) == entry.name:
        return entry.name_span
    spans = list(found((ENTRY,), source.text, entry.name))
    return spans[0] if len(spans) == 1 else None


def targets(source: Source, old: str) -> Iterator[Span]:
    """Yield the places of a target or of a script in CMake."""
    for command in parse(source).commands:
        for argument in command.arguments if command.name not in NO_NAMES else ():
            for span in found(TARGET, argument.text, old):
                yield Span(argument.inner.start + span.start, argument.inner.start + span.end)
