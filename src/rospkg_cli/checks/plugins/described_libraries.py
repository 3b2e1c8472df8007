"""Libraries that plugin descriptions name, and the CMake targets that build them."""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...languages.cmake.values import UNKNOWN
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ..cmake.source_targets import SourceTargets

PREBUILT = (".so", ".a", ".dylib", ".dll")
FETCHES = frozenset({"externalproject_add", "fetchcontent_declare", "fetchcontent_makeavailable", "ament_vendor"})


@dataclass(frozen=True)
class DescribedLibraries:
    files: PackageFiles
    cmake: CMake

    @cached_property
    def compiled(self) -> SourceTargets:
        return SourceTargets(self.cmake)

    def target(self, name: str) -> str | None:
        """Return the target that builds the library at a path of a description; None where none is known."""
        named = {new: target for target, new in self.cmake.output_names.items() if UNKNOWN not in new}
        for stem in stems(name):
            target = self.cmake.target(named.get(stem, stem))
            if target is not None and target.is_library:
                return target.name
        return None

    def are_known(self, name: str) -> bool:
        """Return whether all libraries that may have a name are known: built by CMake, and under known names."""
        fetched = any(call.name in FETCHES for call in self.cmake.calls)
        known = all(each.word.is_known for each in self.cmake.targets if each.is_library)
        known = known and not any(UNKNOWN in new for new in self.cmake.output_names.values())
        return self.cmake.is_complete and known and not fetched and not self.prebuilt.intersection(stems(name))

    @cached_property
    def prebuilt(self) -> frozenset[str]:
        """The names of the library files among the files of the package, without `lib`."""
        names = (path.rpartition("/")[2] for path in self.files.paths if path.endswith(PREBUILT) or ".so." in path)
        return frozenset(name.partition(".")[0].removeprefix("lib") for name in names)

    def of_source(self, path: str) -> list[str]:
        """Return the libraries that a source is compiled into with every build option, without those for tests."""
        names = sorted(self.compiled.targets_of(path))
        targets = [self.cmake.target(name) for name in names]
        return [
            each.name
            for each in targets
            if each is not None and each.is_library and not each.call.testing and not each.call.maybe
        ]


def stems(path: str) -> tuple[str, ...]:
    """Return the names under which pluginlib looks for the library at a path of a description.

    These are the path as it is, without `lib`, and without its folders.
    """
    names = (path, path[3:] if path.startswith("lib") else path, path.rpartition("/")[2])
    return tuple(dict.fromkeys(names))
