"""Why a plain launch does not reach a place of a launch file, whatever is wrong there."""

from __future__ import annotations

import re
from typing import Annotated

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...source import Span
from ...unreadable import READABLE
from ..fault import Fault
from .idle_actions import NEVER_CALLED, is_uncalled
from .launch_context import LaunchContext
from .lost_faults import why_lost
from .unstarted_launch_files import UNSTARTED, UnstartedLaunchFiles
from .who_meets import why_python_stops


@dataclass(frozen=True)
class UnmetPlaces:
    """Rule input: the launch files of a package that can be read."""

    files: PackageFiles
    scopes: Annotated[tuple[LaunchContext, ...], READABLE]
    unstarted: UnstartedLaunchFiles | None = None

    def why_unstarted(self, path: str) -> str:
        """Return why a launch file is never started; "" where it may be."""
        is_left = self.unstarted is not None and self.unstarted.has(path) and not self.is_imported(path)
        return UNSTARTED if is_left else self.why_stale(path)

    def why_stale(self, path: str) -> str:
        """Return what says that a launch file is no longer used, or not finished; "" where nothing does."""
        from .stale_launch_files import why_stale  # what findings alone need

        scope = next((each for each in self.scopes if each.file.path == path), None)
        if scope is None or self.is_imported(path):
            return ""
        return why_stale(self.files, scope.package, scope.workspace, path)

    def why(self, path: str, span: Span, *, is_late: bool) -> str:
        """Return why a plain launch does not reach a place; "" where it may, and in other files.

        What is late shows when launch visits the action or reads the value; all else when Python runs the line.
        """
        scope = next((each for each in self.scopes if each.file.path == path), None)
        if scope is None or self.is_imported(path):
            return ""
        if is_late:
            return why_lost(scope, Fault(span, ""))
        if scope.file.python is not None and is_uncalled(scope.file.python, span):
            return NEVER_CALLED
        return why_python_stops(scope.file, span, scope.workspace)

    def is_imported(self, path: str) -> bool:
        """Return whether other Python code of the package names a launch file as a module, whose parts it may use."""
        stem = path.rpartition("/")[2].removesuffix(".py")
        if not path.endswith(".py") or not stem.isidentifier():
            return False
        word = re.compile(rf"\b(?:import|from)\b.*\b{stem}\b")
        others = (each for each in self.files.paths if each.endswith(".py") and each != path)
        return any(stem in text and word.search(text) for text in map(self.files.readable_text, others))
