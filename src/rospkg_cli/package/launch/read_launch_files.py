"""Find the launch files of a package and read each with its frontend."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...files import PackageFiles, ReaderInput
from ...languages.python.evaluate.sandbox_filesystem import SandboxFilesystem
from ...lazy_regex import regex
from ...read_problem import ReadProblem
from ...source import Source, Span
from ...unreadable import Unreadable, UnreadableError
from ..file_role import role_of
from ..python_modules import PythonModules
from .launch_file import LaunchFile
from .read_python import read_python_launch

NAMED = regex(r"(^|[._/-])launch\.(py|xml|ya?ml)$|\.launch$|(^|/)launch(es)?/(.*/)?[^/]*\.(py|xml|ya?ml)$")
"""Files that their name or their folder makes launch files."""

MAX_CHARACTERS = 500_000
"""Of the launch files of one package together, some 3 s of reading: the largest known package of them has 260,000."""

ENTRY = regex(r"^def generate_(launch|test)_description\b", re.MULTILINE)


def read_launch_files(reading: ReaderInput) -> Iterator[LaunchFile | Unreadable]:
    """Read every launch file; those of tests are left out where they are broken."""
    modules = reading.parts(PythonModules).only
    assert modules is not None
    reader = LaunchReader(reading.files, modules)
    for path in reading.files.paths:
        role = role_of(path)
        if role == "aside" or path == "package.xml":
            continue
        try:
            found = reader.read(path)
        except UnreadableError as error:
            if role == "launch":
                yield error.unreadable
            continue
        if found is not None:
            yield found


class LaunchReader:
    def __init__(self, files: PackageFiles, modules: PythonModules) -> None:
        self.files, self.modules = files, modules
        self.folder: SandboxFilesystem | None = None
        self.characters = 0
        """Of the launch files so far."""

    def read(self, path: str) -> LaunchFile | None:
        """Return the launch file at a path; None for another file; raises UnreadableError."""
        if path.endswith(".py"):
            return self.read_python(path)
        if not NAMED.search(path):
            return None
        source = self.files.source(path)
        if path.endswith(".launch") and ENTRY.search(source.text):
            return None  # launch tries its frontends, then loads it as Python
        if "<launch" in source.text or "launch:" in source.text:
            self.spend(source)
        from .read_xml_yaml import read_xml_launch, read_yaml_launch

        return read_yaml_launch(source) if path.endswith(("yaml", "yml")) else read_xml_launch(source)

    def read_python(self, path: str) -> LaunchFile | None:
        source = self.files.source(path)
        if not NAMED.search(path) and not ENTRY.search(source.text):
            return None
        try:
            self.spend(source)
        except UnreadableError as error:
            self.modules.skip(error.unreadable)
            raise
        if self.folder is None:
            self.folder = SandboxFilesystem(self.files)
        parsed = self.modules.read(path)
        if isinstance(parsed, Unreadable):
            raise UnreadableError(
                parsed.path,
                parsed.span,
                parsed.code,
                *parsed.details,
                grammar=parsed.grammar,
                skipped=parsed.skipped,
            )
        return read_python_launch(parsed, self.folder)

    def spend(self, source: Source) -> None:
        """Raise UnreadableError where the launch files of the package get too long."""
        self.characters += len(source.text)
        if self.characters > MAX_CHARACTERS:
            self.characters -= len(source.text)
            most = f"{MAX_CHARACTERS:,}"
            raise UnreadableError(source.path, Span(0, 0), ReadProblem.LAUNCH_LENGTH, most, skipped=True)
