"""The files that a launch file names and that its package, or the one they belong to, does not install."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...lazy_regex import regex
from ...light_dataclasses import replace
from ...package.launch.file_references import FileReference
from ...package.package_facts import PackageFacts
from ...ros.well_known import other_launch_file
from ...suggest import slips
from ..paths.closest_path import closest_path
from .launch_context import LaunchContext
from .missing_reference import USES, MissingReference
from .partly_known_paths import closest_to_known_part, fits_nothing
from .reference_states import is_brought, is_in_nested, state_of

DOUBLED = regex(r"((?:\.[a-z][a-z0-9]*)+)\1(?=(?:\.[a-z]+)?$)")
"""An extension, or a part before one, that stands twice, which no file is given on purpose."""


def missing_references(scope: LaunchContext) -> Iterator[MissingReference]:
    """Yield each file that is named and missing, once."""
    found: dict[tuple[str, str], list[MissingReference]] = {}
    for named in scope.file.every_path if not (scope.file.is_ros1 or scope.is_unused_test) else ():
        ask = unfitting if named.is_open else missing_at
        missing = ask(scope, named) if not scope.file.catches_missing(named.span) else None
        if missing is not None:
            found.setdefault((missing.package, missing.path), []).append(missing)
    for first, *others in found.values():
        use = min((each.use for each in (first, *others)), key=USES.index)
        yield replace(first, use=use, other_spans=tuple(other.span for other in others if other.span != first.span))


def references_missed_silently(scope: LaunchContext) -> Iterator[MissingReference]:
    """Yield each missing file that Python code opens and whose absence it catches, to go on without it."""
    seen = set()
    for named in scope.file.caught_paths if not (scope.file.is_ros1 or scope.is_unused_test) else ():
        missing = missing_at(scope, named) if named.package and not named.is_open else None
        key = (missing.package, missing.path) if missing is not None and missing.state == "absent" else None
        if missing is not None and key and key not in seen:
            seen.add(key)
            yield replace(missing, use="caught")


def missing_at(scope: LaunchContext, named: FileReference) -> MissingReference | None:
    if not named.package:
        return local_missing(scope, named)
    own = named.package == scope.package.name
    facts = scope.package if own else scope.workspace.named(named.package)
    if facts is None and (better := DOUBLED.sub(r"\1", named.path)) != named.path:
        return MissingReference(named.span, named.package, named.path, "absent", named.use, better)
    if facts is None and named.use == "include" and (other := other_launch_file(named.package, named.path)):
        home, better = other
        return MissingReference(named.span, named.package, named.path, "absent", named.use, better, (), True, home)
    if facts is None or facts.may_write(named.path):
        return None
    if not facts.knows("share_files") and posixpath.dirname(named.path) not in facts.settled_folders:
        return slip_at(scope, named, facts)
    there = named.path in facts.share_files
    if not named.has_slash:
        return MissingReference(named.span, facts.name, named.path, "no slash", named.use) if there else None
    if there or is_brought(scope, facts, named.path) or (own and is_in_nested(scope, named.path)):
        return None
    state, better_path = state_of(scope, facts, named.path)
    return MissingReference(named.span, facts.name, named.path, state, named.use, better_path)


def unfitting(scope: LaunchContext, named: FileReference) -> MissingReference | None:
    """Return a file of whose path a part is not known, where no file of the package fits what is known."""
    own = named.package == scope.package.name
    facts = scope.package if own else scope.workspace.named(named.package)
    if facts is None or not fits_nothing(named, facts, scope.files, own=own):
        return None
    better = closest_to_known_part(named.path, facts.share_files)
    return MissingReference(named.span, facts.name, named.path, "absent", named.use, better)


def slip_at(scope: LaunchContext, named: FileReference, facts: PackageFacts) -> MissingReference | None:
    """Return a file whose name is a misspelling of one in the same folder, in a package that may install more."""
    folder, name = posixpath.split(named.path)
    neighbours = [posixpath.basename(path) for path in facts.share_files if posixpath.dirname(path) == folder]
    single = DOUBLED.sub(r"\1", name)
    near = [single] if single in neighbours else slips(name, neighbours)
    near = near if named.has_slash and name not in neighbours else []
    if len(near) != 1 or is_brought(scope, facts, named.path) or state_of(scope, facts, named.path)[0] != "absent":
        return None
    better_path = posixpath.join(folder, near[0])
    return MissingReference(named.span, facts.name, named.path, "absent", named.use, better_path)


def local_missing(scope: LaunchContext, named: FileReference) -> MissingReference | None:
    """Return a missing file that is named relative to the launch file, in the source and where it is installed."""
    if scope.files.is_there(named.path) or scope.package.may_write(named.path):
        return None
    if not scope.package.knows("share_files") or scope.files.absent.is_expected(named.path):
        return None
    away = posixpath.relpath(named.path, posixpath.dirname(scope.file.path) or ".")
    for place in scope.places:
        if posixpath.normpath(posixpath.join(posixpath.dirname(place), away)) in scope.package.share_files:
            return None
    better_path = closest_path(named.path, [each for each in scope.files.paths if each != scope.file.path])
    return MissingReference(named.span, scope.package.name, named.path, "absent", named.use, better_path)


def is_made_here(scope: LaunchContext, missing: MissingReference) -> bool:
    """Return whether the launch file writes it: a robot by xacro's `open_output`, an output of a command."""
    if missing.path.endswith((".urdf", ".sdf")) and "open_output(" in scope.file.source.text:
        return True
    if missing.use == "include":
        return False
    from .outputs_of_commands import is_written  # most launch files name what is there

    return is_written(scope.file.source, (missing.span, *missing.other_spans))
