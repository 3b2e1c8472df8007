"""What is told of a package that colcon can't build, as its manifest or build file can't be read: the rest waits."""

from __future__ import annotations

from pathlib import PurePosixPath

from ...files import PackageFiles
from ...finding import Finding, Severity
from ...light_dataclasses import replace
from ...package.run_events import RuleCrash
from ...package.workspace import Workspace

UNREADABLE = "RPK001"
BUILD_FILES = ("package.xml", "setup.py", "CMakeLists.txt")
"""Of these in the folder of a package, one that can't be read stops the build."""

STOPS = frozenset({"CMK102", "IDL006", "SET101", "SET202", "SET302", "XML304"})
"""One of these is told of each package that is incomplete."""

ASKED = ("CMK1", "DEP10", "IDL006", "IDL01", "LCH00", "LCH011", "PLG002", "PRM00", "SET", "URD00")
"""Families of rules about what is missing, of which a comment may say that it is still to be written."""


def of_unbuilt(
    results: list[Finding | RuleCrash], files: PackageFiles, folder: str, name: str, workspace: Workspace
) -> list[Finding | RuleCrash]:
    """Return the results of a package, with infos for what nobody meets in one that is not built as it lies."""
    if any(isinstance(each, Finding) and each.code in STOPS and is_loud(each) for each in results):
        from .lesson_folder import as_it_lies  # for packages that lack a file

        results = as_it_lies(results, files, name)
    if any(isinstance(each, Finding) and each.code.startswith(ASKED) and is_loud(each) for each in results):
        from .announced import as_announced  # for packages that lack something

        results = as_announced(results, files, name)
    results = behind_unreadable(results, folder)
    if not any(isinstance(each, Finding) and is_loud(each) for each in results):
        return results
    from .planted_faults import with_planted_faults  # for packages with a finding

    return with_planted_faults(results, files, folder, workspace)


def behind_unreadable(results: list[Finding | RuleCrash], folder: str) -> list[Finding | RuleCrash]:
    """Return the results of a package with an info for each fault that is met only once the package can be built.

    What is known of such a package is little, too: which programs it has, what it installs and declares.
    """
    paths = {str(PurePosixPath(folder, name)) for name in BUILD_FILES}
    found = [each for each in results if isinstance(each, Finding)]
    stops = [each for each in found if each.code == UNREADABLE and is_loud(each) and each.location.path in paths]
    if not stops:
        return results
    name = PurePosixPath(stops[0].location.path).name
    why = f"; nobody comes here before `{name}` can be read"
    return [
        replace(each, severity=Severity.INFO, message=each.message + why)
        if isinstance(each, Finding) and is_loud(each) and each.code != UNREADABLE
        else each
        for each in results
    ]


def is_loud(found: Finding) -> bool:
    return found.severity is not Severity.INFO
