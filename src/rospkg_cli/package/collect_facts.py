"""Phase one: collect the facts of a package for the checks of other packages."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import PurePosixPath
from typing import Any, get_args

from ..files import ReaderInput
from ..ros.distros import Targets
from .cmake.cmake_facts import exported_targets, has_targets, may_register_more, registered_components, sought_packages
from .cmake.kept_links import kept_links
from .cmake.made_headers import has_other_headers, header_files
from .contested_build_type import is_build_type_contested
from .dependency_facts import dependencies, group_dependencies, groups
from .include_dirs import include_dirs
from .included_headers import included_headers
from .interfaces.interface_index import interface_names
from .interfaces.message_fields import message_fields
from .interfaces.typed_with import typed_with
from .interfaces.unlisted_interfaces import unlisted_interfaces
from .launch.launch_facts import launch_summaries, loaded_components, started_nodes
from .launch.parsed_yaml import parsed_keys, parsed_yaml
from .launch.read_signature import launch_signatures
from .manifest import Manifest
from .metapackage import is_metapackage
from .package_facts import PackageFacts, UnknownField
from .params.collect_declared import declared_parameters, given_parameters
from .params.named_yaml import named_yaml
from .params.node_names import node_names
from .params.node_sources import node_code
from .params.passed_files import handed_yaml, yaml_readers
from .plugins.plugin_facts import described_plugins, loaded_bases
from .plugins.plugin_uses import plugin_uses
from .python.run_time_files import run_time_files
from .python.taken_names import taken_names
from .read_install_table import installed_facts
from .settled_folders import settled_folders
from .uninstalled_files import made_files, uninstalled_files
from .urdf.robot_words import robot_includes, robot_words
from .used_packages import used_packages

INSTALLED = ("executables", "misplaced_executables", "other_markers", "share_files", "modules")
"""The fields that come from the install table."""

Part = Callable[[ReaderInput, Targets, Manifest], tuple[dict[str, Any], set[UnknownField]]]
"""Returns some fields of the facts of a package, and which of them are unknown."""


def of_manifest(reading: ReaderInput, targets: Targets, manifest: Manifest) -> tuple[dict[str, Any], set[UnknownField]]:
    return {
        "build_type": manifest.build_type(targets),
        "name_span": manifest.name_span,
        "version": manifest.version,
        "version_span": manifest.version_span,
        "dependencies": dependencies(manifest, targets),
        "groups": groups(manifest, targets),
        "group_dependencies": group_dependencies(manifest, targets),
        "is_metapackage": is_metapackage(reading.files, manifest),
    }, set()


def of_interfaces(reading: ReaderInput, _: Targets, __: Manifest) -> tuple[dict[str, Any], set[UnknownField]]:
    interfaces, complete = interface_names(reading)
    return {"interfaces": interfaces}, set() if complete else {"interfaces"}


def of_install_table(reading: ReaderInput, _: Targets, manifest: Manifest) -> tuple[dict[str, Any], set[UnknownField]]:
    installed = installed_facts(reading, manifest.name)
    fields = {name: getattr(installed, name) for name in INSTALLED}
    return fields, set(installed.unknown)


def of_components(reading: ReaderInput, _: Targets, __: Manifest) -> tuple[dict[str, Any], set[UnknownField]]:
    components, complete = registered_components(reading)
    return {"components": components}, set() if complete else {"components"}


def of_exports(reading: ReaderInput, _: Targets, __: Manifest) -> tuple[dict[str, Any], set[UnknownField]]:
    targets, complete = exported_targets(reading)
    return {"cmake_targets": targets}, set() if complete else {"cmake_targets"}


def of_loaders(reading: ReaderInput, _: Targets, __: Manifest) -> tuple[dict[str, Any], set[UnknownField]]:
    loaders, complete = loaded_bases(reading)
    return {"loaders": loaders}, set() if complete else {"loaders"}


def of_plugins(reading: ReaderInput, _: Targets, __: Manifest) -> tuple[dict[str, Any], set[UnknownField]]:
    plugins, complete = described_plugins(reading)
    return {"plugins": plugins}, set() if complete else {"plugins"}


def of_code(reading: ReaderInput, _: Targets, __: Manifest) -> tuple[dict[str, Any], set[UnknownField]]:
    declared = declared_parameters(reading)
    code = node_code(reading) if any(each.required for each in declared) else ()
    return {"parameters": declared, "node_code": code}, set()


def one(name: str, collect: Callable[[ReaderInput], Any]) -> Part:
    return lambda reading, _, __: ({name: collect(reading)}, set())


PARTS: dict[tuple[str, ...], Part] = {
    ("build_type", "name_span", "version", "version_span", "dependencies", "groups", "group_dependencies",
     "is_metapackage"): of_manifest,
    ("interfaces",): of_interfaces,
    ("unlisted_interfaces",): one("unlisted_interfaces", unlisted_interfaces),
    INSTALLED: of_install_table,
    ("components",): of_components,
    ("may_register_more",): one("may_register_more", may_register_more),
    ("loaders",): of_loaders,
    ("plugins",): of_plugins,
    ("parameters", "node_code"): of_code,
    ("node_names",): one("node_names", node_names),
    ("messages",): one("messages", message_fields),
    ("typed_with",): one("typed_with", typed_with),
    ("started_nodes",): one("started_nodes", started_nodes),
    ("loaded_components",): one("loaded_components", loaded_components),
    ("parsed_yaml",): one("parsed_yaml", parsed_yaml),
    ("parsed_keys",): one("parsed_keys", parsed_keys),
    ("named_yaml",): one("named_yaml", named_yaml),
    ("handed_yaml",): one("handed_yaml", handed_yaml),
    ("yaml_readers",): one("yaml_readers", yaml_readers),
    ("robot_words",): one("robot_words", robot_words),
    ("robot_includes",): one("robot_includes", robot_includes),
    ("used_packages",): one("used_packages", used_packages),
    ("launch_files",): one("launch_files", launch_signatures),
    ("launch_summaries",): one("launch_summaries", launch_summaries),
    ("given_parameters",): one("given_parameters", given_parameters),
    ("uninstalled",): one("uninstalled", uninstalled_files),
    ("written_files",): one("written_files", made_files),
    ("run_time_files",): one("run_time_files", run_time_files),
    ("settled_folders",): one("settled_folders", settled_folders),
    ("cmake_targets",): of_exports,
    ("is_compiled",): one("is_compiled", has_targets),
    ("sought_packages",): one("sought_packages", sought_packages),
    ("kept_links",): one("kept_links", kept_links),
    ("plugin_uses",): one("plugin_uses", plugin_uses),
    ("included_headers",): one("included_headers", included_headers),
    ("taken_names",): one("taken_names", taken_names),
    ("header_files",): one("header_files", header_files),
    ("headers",): one("headers", lambda reading: include_dirs(reading.files)),
}  # fmt: skip
"""What is collected together, by the fields that it yields."""

DOUBTS: dict[UnknownField, Callable[[ReaderInput], bool]] = {"header_files": has_other_headers}
"""Whether a field is unknown, where that takes longer to find out than the field, and is seldom asked."""


MADE_BY_THE_BUILD: frozenset[UnknownField] = frozenset(get_args(UnknownField)) - {"name", "dependencies", "interfaces"}
"""What is there only after the build; interfaces have files of their own."""


def collect_part(
    part: Part, reading: ReaderInput, targets: Targets, manifest: Manifest
) -> tuple[dict[str, Any], set[UnknownField]]:
    """Return some fields, and which are unknown: all that a build makes, where it is open how the package is built."""
    fields, doubts = part(reading, targets, manifest)
    made = MADE_BY_THE_BUILD.intersection(fields)
    if made and is_build_type_contested(manifest, reading.files, targets):
        doubts = doubts | made
    return fields, doubts


def collect_facts(reading: ReaderInput, targets: Targets, folder: str, fallback: str) -> PackageFacts:
    """Return a package's facts; `fallback` is its name where package.xml can't be read."""
    manifest = reading.parts(Manifest).only
    if manifest is None:
        return unknown_facts(folder, fallback)
    fields: dict[str, Any] = {}
    unknown: set[UnknownField] = set()
    for part in PARTS.values():
        found, doubts = collect_part(part, reading, targets, manifest)
        fields |= found
        unknown |= doubts
    unknown |= {name for name, is_unknown in DOUBTS.items() if is_unknown(reading)}
    return PackageFacts(name_of(manifest, folder, fallback), folder, unknown=frozenset(unknown), **fields)


def name_of(manifest: Manifest, folder: str, fallback: str) -> str:
    return manifest.name or PurePosixPath(folder).name or fallback


def is_unknown(facts: PackageFacts) -> bool:
    """Return whether facts are those of a package that can't be read; those on demand are of one that can."""
    return type(facts) is PackageFacts and len(facts.unknown) == len(get_args(UnknownField))


def unknown_facts(folder: str, fallback: str) -> PackageFacts:
    """Return what is known of a package that can't be read: a name by its folder."""
    return PackageFacts(PurePosixPath(folder).name or fallback, folder, unknown=frozenset(get_args(UnknownField)))
