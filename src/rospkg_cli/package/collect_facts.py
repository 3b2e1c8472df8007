"""Phase one: collect the facts of a package for the checks of other packages."""

from __future__ import annotations

from pathlib import PurePosixPath
from typing import get_args

from ..files import ReaderInput
from ..ros.distros import Targets
from .cmake.cmake_facts import exported_targets, registered_components
from .dependency_facts import dependencies, group_dependencies, groups
from .include_dirs import include_dirs
from .interfaces.interface_index import interface_names
from .launch.launch_file import launch_summaries, loaded_components, started_nodes
from .launch.read_signature import launch_signatures
from .manifest import Manifest
from .metapackage import is_metapackage
from .package_facts import PackageFacts, UnknownField
from .params.collect_declared import declared_parameters, given_parameters
from .params.node_sources import node_code
from .plugins.plugin_facts import plugin_facts
from .read_install_table import installed_facts
from .uninstalled_files import made_files, uninstalled_files


def collect_facts(reading: ReaderInput, targets: Targets, folder: str, fallback: str) -> PackageFacts:
    """Return a package's facts; `fallback` is its name where package.xml can't be read."""
    manifest = reading.parts(Manifest).only
    if manifest is None:
        return unknown_facts(folder, fallback)
    unknown: set[UnknownField] = set()
    interfaces, complete = interface_names(reading)
    unknown |= set() if complete else {"interfaces"}
    installed = installed_facts(reading, manifest.name)
    unknown |= installed.unknown
    components, complete = registered_components(reading)
    unknown |= set() if complete else {"components"}
    plugins = plugin_facts(reading)
    unknown |= plugins.unknown
    declared = declared_parameters(reading)
    return PackageFacts(
        name=manifest.name or PurePosixPath(folder).name or fallback,
        folder=folder,
        build_type=manifest.build_type(targets),
        name_span=manifest.name_span,
        version=manifest.version,
        version_span=manifest.version_span,
        dependencies=dependencies(manifest, targets),
        groups=groups(manifest, targets),
        group_dependencies=group_dependencies(manifest, targets),
        executables=installed.executables,
        misplaced_executables=installed.misplaced_executables,
        started_nodes=started_nodes(reading),
        loaded_components=loaded_components(reading),
        launch_files=launch_signatures(reading),
        launch_summaries=launch_summaries(reading),
        interfaces=interfaces,
        parameters=declared,
        given_parameters=given_parameters(reading),
        node_code=node_code(reading) if any(each.required for each in declared) else (),
        share_files=installed.share_files,
        uninstalled=uninstalled_files(reading),
        written_files=made_files(reading),
        components=components,
        cmake_targets=exported_targets(reading),
        modules=installed.modules,
        plugins=plugins.plugins,
        plugin_uses=plugins.uses,
        loaders=plugins.loaders,
        unknown=frozenset(unknown),
        is_metapackage=is_metapackage(reading.files, manifest),
        headers=include_dirs(reading.files),
    )


def unknown_facts(folder: str, fallback: str) -> PackageFacts:
    """Return what is known of a package that can't be read: a name by its folder."""
    return PackageFacts(PurePosixPath(folder).name or fallback, folder, unknown=frozenset(get_args(UnknownField)))
