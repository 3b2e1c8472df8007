"""Rule input: packages that interface files use and that rosidl_generate_interfaces does not depend on."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.cmake.interface_targets import InterfaceTarget
from ...package.interfaces.interface_file import FieldType, InterfaceFile
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.core_messages import CORE_DEPENDENCIES
from ...ros.distros import Targets
from ...ros.manifest import BUILDS, RUNS
from ...ros.names import NameKind
from ...ros.read_table import rows
from ...suggest import near_names
from .rosidl_targets import RosidlTargets

PASSED_ON = (BUILDS | RUNS) - {"buildtool_depend"}
"""Tags of dependencies whose interfaces rosidl collects as well."""


@dataclass(frozen=True, slots=True)
class UnlistedDependency:
    """A package that a call's files use and that the call does not know of."""

    target: InterfaceTarget
    package: str
    interface: InterfaceFile
    kind: FieldType
    """Its first use."""
    is_certain: bool
    """The file is listed under no condition."""


@dataclass(frozen=True)
class RosidlDependencies:
    generated: RosidlTargets
    package: PackageFacts
    workspace: Workspace
    targets: Targets

    def unlisted(self) -> Iterator[UnlistedDependency]:
        """Yield each package whose types a call's files use and that its DEPENDENCIES neither list nor pass on."""
        by_path = {interface.path: interface for interface in self.generated.interfaces}
        for target in self.generated.cmake.interface_targets:
            is_clear = all(word.is_known and not word.maybe for word in target.dependencies)
            passed_on, is_all = self.passed_on(target) if is_clear else (set[str](), False)
            if not is_all:
                continue
            seen = {*passed_on, "", self.package.name, self.generated.cmake.project_name}
            for each in self.generated.listed:
                interface = by_path.get(each.path or "") if each.target is target else None
                for kind in interface.types if interface else ():
                    if interface and kind.package not in seen and not self.is_misspelt(kind.package):
                        seen.add(kind.package)
                        sure = self.generated.cmake.generated_interfaces.get(interface.path, False)
                        yield UnlistedDependency(target, kind.package, interface, kind, sure)

    def is_misspelt(self, package: str) -> bool:
        """Return whether a package is unknown and near to one that is declared: DEP108 says so."""
        if self.workspace.kind_of(package) in (NameKind.PACKAGE, NameKind.KEY):
            return False
        return len(near_names(package, (each.name for each in self.package.dependencies))) == 1

    def passed_on(self, target: InterfaceTarget) -> tuple[set[str], bool]:
        """Return the packages whose interfaces a call links, and whether these are all.

        Actions pass `action_msgs` on; since Iron, services pass `service_msgs` on too.
        """
        found: set[str] = set()
        brought = rows("runtime_dependencies.txt")
        certain, waiting = True, [word.text for word in target.dependencies]
        services_do = not self.targets.named(lambda distro: distro.name == "humble")
        if any(word.text.endswith((".srv", ".action") if services_do else ".action") for word in target.files):
            waiting += ["action_msgs", "service_msgs"]
        while waiting:
            name = waiting.pop()
            if name not in found:
                found.add(name)
                facts = self.workspace.named(name)
                if facts is not None:
                    waiting += [need.name for need in facts.dependencies if need.tag in PASSED_ON]
                elif name in CORE_DEPENDENCIES:
                    waiting += CORE_DEPENDENCIES[name]
                elif name in brought:
                    waiting += [need.removeprefix("?") for need in brought[name]]
                elif self.workspace.kind_of(name) is not NameKind.KEY:
                    certain = False
        return found, certain
