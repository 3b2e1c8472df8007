"""Milder findings in a package that can't be built as it is: build files can't be read, or files are to be added."""

from __future__ import annotations

from pathlib import PurePosixPath

from ...files import PackageFiles
from ...finding import Finding, Severity
from ...light_dataclasses import replace
from ...package.workspace import Workspace
from .milder import RuleResults

UNREADABLE = "RPK001"
BUILD_FILES = ("package.xml", "setup.py", "CMakeLists.txt")
"""Of these in the folder of a package, one that can't be read stops the build."""

STOPS = frozenset({"CMK102", "IDL006", "SET101", "SET202", "SET302", "XML304"})
"""A package that lacks files has a finding of one of these rules."""

ASKED = ("CMK1", "DEP10", "IDL006", "IDL01", "LCH00", "LCH011", "PLG002", "PRM00", "SET", "URD00")
"""Families of rules about something missing, which a comment may announce as still to be written."""


def of_unbuilt(results: RuleResults, files: PackageFiles, folder: str, name: str, workspace: Workspace) -> RuleResults:
    """Return the results of a package, with infos for what does no harm as long as it can't be built as it is."""
    if any(isinstance(each, Finding) and each.code in STOPS and each.is_loud for each in results):
        from .lesson_folder import as_it_lies  # for packages that lack a file

        results = as_it_lies(results, files, name)
    if any(isinstance(each, Finding) and each.code.startswith(ASKED) and each.is_loud for each in results):
        from .announced import as_announced  # for packages that lack something

        results = as_announced(results, files, name)
    results = behind_unreadable(results, folder)
    if not any(isinstance(each, Finding) and each.is_loud for each in results):
        return results
    from .among_ros1 import with_ros1_neighbours  # both for packages with a finding
    from .planted_faults import with_planted_faults

    return with_planted_faults(with_ros1_neighbours(results, name, workspace), files, folder, workspace)


def behind_unreadable(results: RuleResults, folder: str) -> RuleResults:
    """Return the results of a package with an info for each fault that matters only once its build files can be read.

    Little is known of such a package: neither its programs nor what it installs and declares.
    """
    paths = {str(PurePosixPath(folder, name)) for name in BUILD_FILES}
    found = [each for each in results if isinstance(each, Finding)]
    stops = [each for each in found if each.code == UNREADABLE and each.is_loud and each.location.path in paths]
    if not stops:
        return results
    name = PurePosixPath(stops[0].location.path).name
    why = f"; this matters only once `{name}` can be read"
    return [
        replace(each, severity=Severity.INFO, message=each.message + why)
        if isinstance(each, Finding) and each.is_loud and each.code != UNREADABLE
        else each
        for each in results
    ]
