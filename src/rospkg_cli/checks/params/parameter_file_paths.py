"""The parameter files of a package that a path in a launch file may refer to."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.install_table import InstallTable
from ...package.launch.launch_file import LaunchFile
from ...package.launch.text import LaunchText, Literal, Substitution
from ...package.package_facts import PackageFacts
from ...package.params.parameter_file import ParameterFile

MAX_DEPTH = 5
SHARE = "\0share"


@dataclass(frozen=True)
class ParameterFilePaths:
    """The parameter files of a package, and where the build installs them."""

    files: tuple[ParameterFile, ...]
    package: PackageFacts
    table: InstallTable | None

    def files_at(self, text: LaunchText, launch: LaunchFile) -> Iterator[ParameterFile]:
        """Yield the files of this package that a path may mean; what is unknown in it may be any name."""
        pattern = "".join(self.pattern(text, launch, 0))
        if text.literal and text.literal.startswith("/"):
            yield from (file for file in self.files if text.literal.endswith(f"/{self.package.name}/{file.path}"))
        if pattern.startswith(SHARE):
            path = re.compile(re.sub("/+", "/", pattern[len(SHARE) :]).lstrip("/"))
            for file in self.files:
                if any(path.fullmatch(each) for each in self.share_paths(file)):
                    yield file

    def pattern(self, text: LaunchText, launch: LaunchFile, depth: int) -> Iterator[str]:
        for part in text.parts:
            match part:
                case Literal(text=literal):
                    yield re.escape(literal)
                case Substitution(name="find-pkg-share", arguments=(package, *_)):
                    yield SHARE if package.literal == self.package.name else "\0elsewhere"
                case Substitution(name="var", arguments=(name, *_)) if depth < MAX_DEPTH:
                    defaults = [each.default for each in launch.arguments if each.name.literal == name.literal]
                    if len(defaults) == 1 and defaults[0] is not None:
                        yield from self.pattern(defaults[0], launch, depth + 1)
                    else:
                        yield "[^/]*"
                case _:
                    yield "[^/]*"

    def share_paths(self, file: ParameterFile) -> list[str]:
        """Return where a file is installed in the share directory."""
        rows = self.table.below(f"share/{self.package.name}") if self.table else ()
        return [path for path, row in rows if row.source == file.path] or [file.path]
