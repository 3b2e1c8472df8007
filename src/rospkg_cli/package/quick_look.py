"""A quick look at the names and texts of a package's files: some values its facts certainly do not hold.

It may say of a value that it is worth looking for and it is not there, never the other way round but for names that a
script puts together from pieces which nothing shows.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cached_property

from ..files import PackageFiles
from ..lazy_regex import regex
from ..light_dataclasses import dataclass

SETUP_FILES = ("setup.py", "setup.cfg", "pyproject.toml")
NO_NAMES = regex(
    r"^[ \t]*(?:from[ \t]+\S+[ \t]+)?import[ \t][^(\n]*$"
    r"|\b\w+_requires?[ \t]*=[ \t]*(?:\[[^\[\]]*\]|\{[^{}]*\})",
    re.MULTILINE,
)
"""What names modules in setup.py that others install: its imports, and what it requires."""
CMAKE_FILES = ("CMakeLists.txt", ".cmake")
EXPORTED = regex(
    r"pluginlib_export_plugin_description_file\s*\(([^)]*)\)|\bplugin\s*=\s*[\"']([^\"']*)[\"']", re.IGNORECASE
)
"""Where CMake and package.xml export descriptions of plugins, with what names the file."""
IDENTIFIER = regex(r"\w+")
INSTALLS_PYTHON = regex(
    "python_install|PYTHON_INSTALL|pybind|nanobind|[Pp]ython3?_add|[Ss]ite.?(packages|arch|lib)|SITE"
)
LAUNCH_ENDINGS = (".py", ".xml", ".yaml", ".yml", ".launch")
MODULE_ENDINGS = (".py", ".pyi", ".pyx", ".so")


@dataclass(frozen=True)
class QuickLook:
    files: PackageFiles
    package: str
    """Its name."""

    def may_have(self, field: str, value: Sequence[str]) -> bool:
        """Return whether a field of the facts of the package may hold a value; see `Workspace.having`."""
        if field == "modules":
            return self.may_have_module(value[0].partition(".")[0])
        if field == "header_files":
            return value[0].rpartition("/")[2] in self.names
        if field in ("started_nodes", "handed_yaml"):
            return self.has_in(LAUNCH_ENDINGS, value[0])
        if field == "other_markers":
            return self.files.exists(f"resource/{value[0]}") or self.is_named_in_build(value[0])
        if field == "plugins":
            return self.may_describe(value[0])
        return True

    def may_have_module(self, top: str) -> bool:
        """Return whether a module of a name without dots may be installed: there is a file, or the build names it."""
        return self.package in top or top in self.modules or self.is_named_in_build(top)

    @cached_property
    def modules(self) -> frozenset[str]:
        """The names of all Python files, and of the folders of packages."""
        files = [path.split("/") for path in self.files.paths if path.endswith(MODULE_ENDINGS)]
        folders = {parts[-2] for parts in files if len(parts) > 1 and parts[-1] == "__init__.py"}
        return frozenset(folders | {parts[-1].partition(".")[0] for parts in files})

    def is_named_in_build(self, name: str) -> bool:
        """Return whether setup.py or the like holds a word, or a CMake file that installs Python."""
        return name in self.build_words

    @cached_property
    def build_words(self) -> frozenset[str]:
        setup = (self.files.readable_text(path) for path in SETUP_FILES if self.files.exists(path))
        cmake = (text for text in self.cmake_texts if INSTALLS_PYTHON.search(text))
        texts = (*cmake, *(NO_NAMES.sub("", text) for text in setup))
        return frozenset(word for text in texts for word in IDENTIFIER.findall(text))

    @cached_property
    def cmake_texts(self) -> tuple[str, ...]:
        return tuple(self.files.readable_text(path) for path in self.files.paths if path.endswith(CMAKE_FILES))

    def may_describe(self, word: str) -> bool:
        """Return whether a word of a plugin's name may stand in an exported description."""
        if not self.exported:
            return False
        is_plain = all(".xml" in name for name in self.exported) and IDENTIFIER.fullmatch(word) is not None
        return not is_plain or self.has_in((".xml",), word)

    @cached_property
    def exported(self) -> tuple[str, ...]:
        """What names the files of the descriptions that are exported, as it is written."""
        texts = (*self.cmake_texts, self.files.readable_text("package.xml"))
        naming = (text for text in texts if "plugin" in text.lower())  # few do, and a pattern takes ten times as long
        return tuple(found[1] or found[2] or "" for text in naming for found in EXPORTED.finditer(text))

    def has_in(self, endings: tuple[str, ...], word: str) -> bool:
        """Return whether the text of a file with one of some endings holds a word."""
        return any(word in self.files.readable_text(path) for path in self.files.paths if path.endswith(endings))

    @cached_property
    def names(self) -> frozenset[str]:
        """The names of all files."""
        return frozenset(path.rpartition("/")[2] for path in self.files.paths)
