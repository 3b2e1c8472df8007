"""Dependencies of packages of pure Python that are declared for building as well (XML209)."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.dependency import Dependency
from ..depends.unused_dependencies import UnusedDependencies
from .manifest_inputs import ManifestAndFiles


@dataclass(frozen=True)
class PythonDependencies:
    package: ManifestAndFiles
    unused: UnusedDependencies

    def needed_to_run(self) -> Iterator[Dependency]:
        """Yield each `<depend>` that something in the package uses, or may: for an unused one the line is to go."""
        manifest, files = self.package.manifest, self.package.files
        if manifest.build_type(self.package.targets) != "ament_python" or files.exists("CMakeLists.txt"):
            return
        unused = {each.dependency.name for each in self.unused.dependencies()}
        for each in manifest.dependencies:
            if each.tag == "depend" and each.name and not manifest.depends_on(each.name, ("exec_depend",)):
                yield from () if each.name in unused else (each,)
