"""The dependency that provides an imported Python module."""

from __future__ import annotations

from ...languages.python.imports import Import
from ...ros.distros import Targets
from ...ros.imports import may_serve
from ...ros.rosdep import NOT_THERE
from .declared_dependencies import DeclaredDependencies

GENERATED = frozenset({"msg", "srv", "action"})
"""Modules that only rosidl generates: the package that has one is certainly a ROS package."""


def undeclared_provider(declared: DeclaredDependencies, what: Import) -> str | None:
    """Return what to declare for an import; None where nothing is missing or the provider is unknown."""
    names = () if what.is_optional or what.is_for_typing else import_providers(declared, what)
    if not names or declared.has(names) or any(may_serve(name, what.module) for name in declared.names):
        return None
    return next((name for name in names if is_served(declared, name)), None)


def is_served(declared: DeclaredDependencies, name: str) -> bool:
    """Return whether a name may be declared: it is no key of rosdep that serves older releases of Ubuntu alone."""
    index = declared.workspace.index
    if not index.is_key(name) or index.is_package(name) or declared.workspace.is_available(name):
        return True
    return any(index.installer(name, each) != NOT_THERE for each in Targets())


def import_providers(declared: DeclaredDependencies, what: Import) -> tuple[str, ...]:
    """Return the names that provide an import, any of them will do; the one to recommend first."""
    found = declared.workspace.providers_of(what.module)
    top, _, rest = what.module.partition(".")
    if not found and rest.partition(".")[0] in GENERATED and any(name[:1].isupper() for name in what.names):
        return (top,)
    return found
