"""The defaults of arguments that a launch file does not declare itself, and files declare whose actions it adds."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping

from ...package.launch.default_conditions import OffByDefault, off_by_default
from ...package.launch.file_references import FileReference, first_in
from ...package.launch.included_arguments import IncludedArguments, Target
from ...package.launch.launch_classes import class_of
from ...package.launch.launch_file import LaunchFile
from ...package.launch.off_values import with_values
from ...package.launch.python_to_text import text_of
from ...ros.launch_calls import DESCRIPTION_LOADERS
from .action_conditions import given_in


def off_when_included(file: LaunchFile, package: str, files: IncludedArguments) -> tuple[OffByDefault, ...]:
    """Return what is not done for the defaults of arguments, where included files declare some of them alone."""
    defaults = included_defaults(file, package, files)
    return tuple(with_values(file.python, off_by_default(file, defaults))) if defaults else ()


def included_defaults(file: LaunchFile, package: str, files: IncludedArguments) -> Mapping[str, str]:
    """Return the default of each argument that only included files declare, where all these are known and agree.

    An included file declares its arguments for the file that includes it, too: launch keeps both in one scope.

    Args:
        package: the name of the package that the file is in.
    """
    given = given_in(file)
    targets = None if None in given else all_included(file, package, files)
    found: dict[str, set[str | None]] = {}
    for _, signature in targets or ():
        defaults = dict(signature.defaults)
        for name in signature.declared:
            found.setdefault(name, set()).add(defaults.get(name))
    agreed = {name: value for name, values in found.items() if len(values) == 1 for value in values}
    return {name: value for name, value in agreed.items() if value is not None and name not in given}


def all_included(file: LaunchFile, package: str, files: IncludedArguments) -> list[Target] | None:
    """Return the files that one includes, with what they include; None where one of them is not known."""
    folder = posixpath.dirname(file.path)
    named = [*(first_in(each.file, folder) for each in file.includes), *loaded(file, folder)]
    waiting = [files.find(package, each.package, each.path) if each is not None else None for each in named]
    found: dict[tuple[str, str], Target] = {}
    while waiting:
        target = waiting.pop()
        if target is None or target[1].may_take_others:
            return None
        key = target[0], target[1].source
        if key not in found:
            found[key] = target
            waiting += [files.find(target[0], *each) for each in target[1].includes]
    return [*found.values()]


def loaded(file: LaunchFile, folder: str) -> Iterator[FileReference | None]:
    """Yield the files whose launch descriptions Python loads, to add them as one adds an action."""
    for call in file.evaluated.calls if file.evaluated else ():
        if class_of(call) in DESCRIPTION_LOADERS:
            path = call.get("launch_file_path", 0) or call.get("python_launch_file_path")
            yield first_in(text_of(path), folder) if path is not None else None
