"""The arguments that a launch file takes from the files that include it."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...files import ReaderInput
from ...lazy_regex import regex
from ...ros.imports import STANDARD
from ..install_table import InstallTable
from .file_references import first_in
from .launch_classes import HOMES, SOURCES
from .launch_file import LaunchFile
from .launch_signature import LaunchSignature
from .launched_parts import DeclaredArgument
from .never_launched import never_launched

KNOWN = HOMES | SOURCES | {"launch_testing", "launch_testing_ros", "launch_pytest", "yaml", "xacro", "nav2_common"}
"""Packages whose functions neither declare nor use arguments by themselves."""

NAMED_USE = regex(r"(?:launch_configurations(?:\.get\(|\[)|LaunchConfiguration(?:Not)?Equals\()\s*['\"]([\w/.-]+)['\"]")
ANY_USE = regex(r"launch_configurations|LaunchConfiguration(?:Not)?Equals\(")


def launch_signatures(reading: ReaderInput) -> tuple[LaunchSignature, ...]:
    """Return the signature of every launch file of a package."""
    table, places = reading.parts(InstallTable).only, dict[str, set[str]]()
    for row in table.rows if table is not None else ():
        if row.destination.startswith("share/") and row.source:
            places.setdefault(row.source, set()).add(row.destination.split("/", 2)[-1])
    files = reading.parts(LaunchFile).good
    return tuple(signature_of(file, frozenset(places.get(file.path, ()))) for file in files if not file.is_ros1)


def signature_of(file: LaunchFile, places: frozenset[str]) -> LaunchSignature:
    folder, text = posixpath.dirname(file.path), file.source.text
    declared = [argument.name.literal for argument in file.arguments]
    used = [use.arguments[0].literal if use.arguments else None for use in file.configurations()]
    included = [first_in(include.file, folder) for include in file.includes]
    named = NAMED_USE.findall(text)
    imported = {each.module.partition(".")[0] for each in file.imports} - KNOWN - STANDARD
    unknown_imports = {each for each in imported if not each.endswith("_msgs")}  # which hold only interfaces
    has_substitutions = "allow_substs" in text  # then a file of parameters may ask for anything
    has_other_uses = len(named) < len(ANY_USE.findall(text))
    is_known = file.is_complete and not (unknown_imports or has_substitutions or has_other_uses)
    return LaunchSignature(
        file.path,
        places,
        frozenset(filter(None, declared)),
        frozenset(required_by(file)),
        frozenset(filter(None, [*used, *named])),
        tuple((each.package, each.path) for each in included if each is not None),
        not is_known or None in declared or None in used or None in included,
        frozenset(defaults_of(file)),
        frozenset(passed_on(file)),
        frozenset(left_idle(file)),
    )


def defaults_of(file: LaunchFile) -> Iterator[tuple[str, str]]:
    """Yield the arguments that have one known default, and that."""
    found: dict[str, set[str | None]] = {}
    for each in file.arguments:
        found.setdefault(each.name.literal or "", set()).add(each.default.literal if each.default else None)
    yield from ((name, value) for name, (value, *more) in found.items() if name and value is not None and not more)


def passed_on(file: LaunchFile) -> Iterator[tuple[str, str]]:
    """Yield the configurations that all uses pass on, as far as launch reaches these, each with its argument."""
    uses = [each for each in file.events or () if each.kind == "use"]
    read = {each.name for each in uses if not each.passed_as} | {*NAMED_USE.findall(file.source.text)}
    yield from ((each.name, each.passed_as) for each in uses if each.name and each.name not in read)


def left_idle(file: LaunchFile) -> Iterator[str]:
    """Yield the configurations that Python only binds to local names which nothing reads."""
    met = {each.name for each in file.events or () if each.kind == "use"} | {*NAMED_USE.findall(file.source.text)}
    uses = [(each.arguments[0].literal or "" if each.arguments else "", each.span) for each in file.configurations()]
    uses = [(name, span) for name, span in uses if name and name not in met]
    unread = never_launched(file.python) if uses and file.python is not None else ()
    read = {name for name, span in uses if not any(each.contains(span) for each in unread)}
    yield from dict.fromkeys(name for name, _ in uses if name not in read)


def required_by(file: LaunchFile) -> Iterator[str]:
    """Yield the arguments that an include must give: whatever is declared first counts, as launch has it."""
    first: dict[str, DeclaredArgument] = {}
    for argument in file.arguments:
        if name := argument.name.literal:
            first.setdefault(name, argument)
    deferred = file.evaluated.deferred if file.evaluated else ()
    for name, argument in first.items():
        late = any(span.holds(argument.span) for span in deferred)
        if argument.default is None and argument.is_certain and not late:
            yield name
