"""PackageFacts: all that the checks of one package may use of another. Small, frozen, and it pickles."""

from __future__ import annotations

from collections.abc import Sequence
from fnmatch import fnmatchcase
from typing import Literal

from ..light_dataclasses import dataclass
from ..source import Span
from .interfaces.message_fields import MessageFields
from .launch.configuration_events import ConfigurationSummary
from .launch.launch_signature import LaunchSignature
from .params.declared_parameter import DeclaredParameter, NodeCode, NodeName
from .plugin import Plugin, PluginUse

UnknownField = Literal[
    "name", "dependencies", "executables", "interfaces", "share_files", "components", "modules",
    "plugins", "loaders", "cmake_targets", "header_files"
]  # fmt: skip


NOWHERE = Span(0, 0)


@dataclass(frozen=True, slots=True)
class ActiveDependency:
    """One dependency of a manifest that holds for a target: its tag, its name, and the span of the name."""

    tag: str
    name: str
    span: Span = NOWHERE
    certain: bool = True
    """Whether it holds for every target."""


@dataclass(frozen=True, slots=True)
class PackageFacts:
    name: str
    folder: str
    """Relative to the root of the run."""
    build_type: str = ""
    name_span: Span = NOWHERE
    """Of the name in package.xml."""
    version: str = ""
    version_span: Span = NOWHERE
    dependencies: tuple[ActiveDependency, ...] = ()
    groups: frozenset[str] = frozenset()
    """The groups it is a member of, for every target."""
    group_dependencies: tuple[ActiveDependency, ...] = ()
    """The groups it depends on."""
    is_metapackage: bool = False
    """Whether it has nothing of its own and only depends on others."""
    executables: frozenset[str] = frozenset()
    """The files of lib/<name> after the build."""
    misplaced_executables: frozenset[str] = frozenset()
    """Executables that are installed where `ros2 run` does not find them, such as bin/."""
    started_nodes: frozenset[tuple[str, str]] = frozenset()
    """What its launch files start under literal names: package and executable."""
    loaded_components: frozenset[tuple[str, str]] = frozenset()
    """What its launch files load under literal names: package and class."""
    parsed_yaml: frozenset[str] = frozenset()
    """The names of the YAML files that its launch files parse themselves and give to no node by their path."""
    parsed_keys: frozenset[str] = frozenset()
    """The keys that its launch files look up in YAML that they parse themselves."""
    named_yaml: frozenset[str] = frozenset()
    """The YAML files that its texts name, without their suffix; `*` where a name is put together when it runs."""
    handed_yaml: frozenset[tuple[str, str]] = frozenset()
    """The parameter files that its launch files give to nodes by a literal name: package and path in its share."""
    yaml_readers: frozenset[tuple[str, str, str, str]] = frozenset()
    """The same files, with package and executable of each node; "" for what is not literal."""
    robot_words: tuple[frozenset[str], ...] = ()
    """The words by which each of its texts may name robots; `*` where a name is put together when it runs, `>` in a
    launch file."""
    robot_includes: frozenset[tuple[str, str, str]] = frozenset()
    """The files that its robots include: package, path, and the file that includes it."""
    used_packages: frozenset[tuple[str, str]] = frozenset()
    """The packages that its files but tests start or load something of, or look for files of, each with the file."""
    interfaces: frozenset[str] = frozenset()
    """`msg/Name`, `srv/Name`, `action/Name`."""
    unlisted_interfaces: frozenset[str] = frozenset()
    """Those of them that have a file, of which CMake surely generates nothing."""
    messages: tuple[MessageFields, ...] = ()
    """The fields of its messages, services and actions, but for those in .idl files."""
    typed_with: frozenset[str] = frozenset()
    """The packages that its interfaces are generated with, and that so come with them."""
    other_markers: frozenset[str] = frozenset()
    """The other names under which it puts itself into the index of packages, where launch and `ros2 run` look."""
    share_files: frozenset[str] = frozenset()
    """The files of share/<name> after the build, relative to it."""
    settled_folders: frozenset[str] = frozenset()
    """The folders of share/<name> that are all known, where commands of other packages may install more elsewhere."""
    uninstalled: frozenset[str] = frozenset()
    """The files that it has in its folders for run time, and that nothing installs."""
    written_files: frozenset[str] = frozenset()
    """The names of the files that its build writes, or installs from elsewhere; `*` is unknown."""
    run_time_files: frozenset[str] = frozenset()
    """The files that its Python code writes into share/<name> when it runs, relative to it."""
    components: frozenset[str] = frozenset()
    may_register_more: bool = False
    """Whether macros that its CMake takes from elsewhere may register other components."""
    cmake_targets: tuple[str, ...] = ()
    """The targets that its CMake exports, with their namespace, as far as they are known."""
    is_compiled: bool = True
    """Whether its CMake has libraries or programs, as far as that is known: only these link others."""
    sought_packages: frozenset[str] = frozenset({"*"})
    """The packages that its CMake looks for; `*` stands for all that it declares, and for what is unknown."""
    kept_links: frozenset[str] = frozenset()
    """The packages that its CMake certainly finds for itself alone: no target or export hands them on."""
    modules: frozenset[str] = frozenset()
    """Dotted names of the Python modules that are installed."""
    taken_names: frozenset[tuple[str, str]] = frozenset()
    """What its Python code takes out of modules of others: the module and the name; "" where it imports all of it."""
    headers: frozenset[str] = frozenset()
    """The folders below its `include/` folders that hold headers: `rclcpp/executors`."""
    header_files: frozenset[str] = frozenset()
    """The headers below its `include/` folders: `rclcpp/executors/single_threaded_executor.hpp`."""
    included_headers: frozenset[str] = frozenset()
    """What the sources of its targets include by a path, where CMake looks nowhere else."""
    plugins: tuple[Plugin, ...] = ()
    plugin_uses: tuple[PluginUse, ...] = ()
    loaders: frozenset[tuple[str, str]] = frozenset()
    """What it loads: the package that the descriptions must be exported to, and the base class."""
    parameters: tuple[DeclaredParameter, ...] = ()
    """The parameters that its code declares, each with the file."""
    node_code: tuple[NodeCode, ...] = ()
    """The executables and components that CMake builds, as far as their code declares parameters."""
    node_names: tuple[NodeName, ...] = ()
    """The executables and components whose code gives its node one literal name."""
    given_parameters: tuple[frozenset[str], ...] = ()
    """The names in each block of its parameter files."""
    launch_files: tuple[LaunchSignature, ...] = ()
    """What its launch files take from those that include them."""
    launch_summaries: tuple[ConfigurationSummary, ...] = ()
    """What its launch files, installed or not, set for each other."""
    unknown: frozenset[UnknownField] = frozenset()
    """The fields above that could not be evaluated: nothing may be concluded from what they lack."""

    @property
    def is_ament(self) -> bool:
        """Whether it is a package of ROS 2 that is built with CMake."""
        return self.build_type in ("ament_cmake", "cmake")

    @property
    def is_for_ros1(self) -> bool:
        """Whether catkin builds it, and nothing of ament: it takes no part in a build or run of ROS 2."""
        tools = {each.name for each in self.dependencies if each.tag == "buildtool_depend"}
        return self.build_type == "catkin" and "catkin" in tools and not any(t.startswith("ament_") for t in tools)

    def knows(self, field: UnknownField) -> bool:
        return field not in self.unknown

    @property
    def is_on_demand(self) -> bool:
        """Whether each field is collected when it is asked for."""
        return False

    def may_have(self, field: str, value: Sequence[str]) -> bool:
        """Return whether it is worth looking whether a field holds a value: a quick look says that some do not."""
        return True

    def may_write(self, path: str) -> bool:
        """Return whether its build may write a file, wherever it goes."""
        name = path.rpartition("/")[2]
        return any(fnmatchcase(path if "/" in pattern else name, pattern) for pattern in self.written_files)

    def at(self, path: str) -> str:
        """Return the path of a file of this package as another package's rule must write it."""
        return f"/{self.folder}/{path}" if self.folder else f"/{path}"
