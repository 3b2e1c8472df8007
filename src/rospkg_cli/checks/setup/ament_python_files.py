"""Rule input: whether the files that ament_python needs exist at all."""

from __future__ import annotations

from ...files import PackageFiles
from ...languages.xml.parser import Element
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.manifest import Manifest
from ...ros.distros import Targets

FOR_COLCON = regex(r"(?m)^[ \t]*\[+[ \t]*tool[ \t]*\.[ \t]*[\"']?colcon-[\w-]+")
"""`[tool.colcon-poetry-ros.data-files]`"""


@dataclass(frozen=True)
class AmentPythonFiles:
    manifest: Manifest
    files: PackageFiles
    targets: Targets

    @property
    def types(self) -> tuple[Element, ...]:
        """The <build_type> elements that say ament_python."""
        return tuple(each for each in self.manifest.build_types(self.targets) if each.text == "ament_python")

    @property
    def has_setup(self) -> bool:
        return self.files.exists("setup.py")

    @property
    def has_pyproject(self) -> bool:
        return self.files.exists("pyproject.toml")

    @property
    def is_built_by_extension(self) -> bool:
        """Whether pyproject.toml has a table for an extension of colcon, which then builds the package from it."""
        return FOR_COLCON.search(self.files.readable_text("pyproject.toml")) is not None
