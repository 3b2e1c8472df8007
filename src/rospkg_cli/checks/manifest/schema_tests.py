"""Whether anything notices what only the schema of package.xml forbids."""

from __future__ import annotations

import re

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.manifest import Manifest
from ...package.schema_line import names_schema
from ...ros.distros import Targets

CHECKERS = ("ament_lint_common", "ament_cmake_xmllint", "ament_xmllint")
"""What brings ament_xmllint into a package's tests."""

RUNS_LINTERS = regex(
    r"^[^#\n]*\b(?:ament_lint_auto_find_test_dependencies|ament_xmllint|autoware_package)[ \t]*\(",
    re.MULTILINE,
)
"""A call that runs the linters which are declared: of ament, or of a wrapper such as autoware_package."""

CALLED = regex(r"^[^#\n]*\bament_xmllint[ \t]*\(", re.MULTILINE)

FOUND = regex(
    r"^[^#\n]*\b(?:find_package[ \t]*\([ \t]*(?:ament_lint_common|ament_cmake_xmllint)\b|ament_auto_find_\w+[ \t]*\()",
    re.MULTILINE,
)
"""What finds the test as well; ament_lint_auto itself looks for `<test_depend>` alone."""

LEFT_OUT = regex(r"^(?![ \t]*find_package)[^#\n]*\bament_cmake_xmllint(?:_FOUND\b|\W)", re.MULTILINE)
"""A line that switches it off: `set(ament_cmake_xmllint_FOUND TRUE)`, or AMENT_LINT_AUTO_EXCLUDE."""


@dataclass(frozen=True)
class SchemaTests:
    """A manifest, and whether the package's tests compare it with its schema."""

    manifest: Manifest
    files: PackageFiles
    targets: Targets

    @property
    def is_tested(self) -> bool:
        """Whether `colcon test` fails on what the schema refuses.

        ament_xmllint checks the schema that an `<?xml-model …?>` line names, and without one only that the file is
        well-formed (ament_xmllint/main.py).
        """
        return names_schema(self.manifest) and self.declares_checker and self.runs_linters

    @property
    def declares_checker(self) -> bool:
        """Whether a dependency brings the test; ament_xmllint alone has no part that CMake would run by itself."""
        if self.manifest.build_type(self.targets) == "ament_python" or CALLED.search(self.cmake_text):
            return any(self.manifest.depends_on(name) for name in CHECKERS)
        tags = () if FOUND.search(self.cmake_text) else ("test_depend",)
        return any(self.manifest.depends_on(name, tags) for name in CHECKERS[:2])

    @property
    def cmake_text(self) -> str:
        return self.files.readable_text("CMakeLists.txt") if self.files.exists("CMakeLists.txt") else ""

    @property
    def runs_linters(self) -> bool:
        """Whether CMakeLists.txt calls the linters, or a test of Python names this one."""
        if self.manifest.build_type(self.targets) == "ament_python":
            tests = (path for path in self.files.paths if path.startswith("test") and path.endswith(".py"))
            return any("xmllint" in path or "xmllint" in self.files.readable_text(path) for path in tests)
        return RUNS_LINTERS.search(self.cmake_text) is not None and LEFT_OUT.search(self.cmake_text) is None

    @property
    def harm(self) -> str:
        """What happens because the schema refuses something that colcon takes, as a clause."""
        if self.is_tested:
            return "`colcon test` fails, since it runs ament_xmllint"
        if names_schema(self.manifest):
            return "ament_xmllint and editors that know the schema refuse it"
        return "no tool checks it while no `<?xml-model?>` line names the schema"
