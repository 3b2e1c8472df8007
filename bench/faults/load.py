"""Imports every file of kinds, so that they are registered, in the order of the table."""

from __future__ import annotations

from importlib import import_module

MODULES = (
    "manifest",
    "dependencies",
    "dependency_tags",
    "setup_py",
    "entry_points",
    "data_files",
    "setup_cfg",
    "cmake_stop",
    "cmake_names",
    "cmake_install",
    "cmake_export",
    "cmake_targets",
    "plugins",
    "interfaces",
    "launch_python",
    "launch_calls",
    "launch_texts",
    "params",
    "urdf",
    "xacro",
    "urdf_tree",
    "cpp_sources",
    "python_sources",
)


def load() -> None:
    for name in MODULES:
        import_module(f"bench.faults.{name}")
