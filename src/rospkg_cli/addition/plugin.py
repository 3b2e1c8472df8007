"""A plugin: its source, its description, its library, and what it depends on."""

from __future__ import annotations

from collections.abc import Iterator

from ..change import ChangeError
from ..package.package import Package
from ..ros.distros import DISTROS, distro
from ..scaffold.plugin import RequestedPlugin, plugin_of
from ..scaffold.plugin_kinds import plugin_kinds
from ..scaffold.resolve_request import distro_of
from ..scaffold.template import load_template
from .cmake_find import FoundInCMake, cmake_of
from .cmake_node import TargetInstalled
from .cmake_plugin import PluginTarget, base_target
from .dependency import AddedDependency
from .new_file import NewFile
from .node import NodePlace, node_place
from .part import Part
from .rendered import identifier, rendered_files


def plugin_parts(package: Package, asked: str) -> tuple[Part, ...]:
    """Return the parts of a plugin asked for as [NAME:]KIND, for $ROS_DISTRO; raises ChangeError and ScaffoldError."""
    place = plugin_place(package)
    chosen = distro_of("", []).name
    return tuple(parts_of_plugin(place, plugin_of(asked, identifier(place.manifest.name), chosen), chosen))


def plugin_place(package: Package) -> NodePlace:
    place = node_place(package)
    if place.build_type != "ament_cmake":
        raise ChangeError("plugins are libraries in C++, which a package of type ament_python has none of")
    return place


def parts_of_plugin(place: NodePlace, plugin: RequestedPlugin, name: str, force: bool = False) -> Iterator[Part]:
    """Yield the parts in the order in which they are put in; `name` is that of the distribution."""
    packages = sorted(plugin.kind.libraries)
    yield from (AddedDependency(each, "all") for each in packages)
    yield from (FoundInCMake(each) for each in packages)
    template = load_template("plugin")
    wanted = tuple(file for file in template.files if file.source.startswith("_shared/plugins/"))
    files = rendered_files(template, wanted, place.manifest, plugin.package, plugins=(plugin,), distro=distro(name))
    has_base = base_target(cmake_of(place.package), plugin)
    for file in files:
        path = file.path
        if path.startswith("include/"):
            if not has_base:
                shared = path.replace("include/", "src/", 1)
                header = path.removeprefix("include/")
                yield NewFile(shared, file.entry.text.text, users=rf'include\s*"{header}"', force=force)
            continue
        yield NewFile(path, file.entry.text.text, force=force)
    yield PluginTarget(plugin, place.manifest.name)
    yield TargetInstalled(plugin.library)


def plugin_that_is_there(package: Package, name: str, force: bool) -> tuple[Part, ...]:
    """Return the parts of a plugin, of whatever kind and for whatever distribution; raises ChangeError."""
    place = plugin_place(package)
    name = name.partition(":")[0]
    path = f"src/{name}.cpp"
    if not package.files.exists(path):
        raise ChangeError(f"there is no source of a plugin `{name}` where `add` puts one; nothing was removed")
    text = package.files.readable_text(path)
    found: tuple[Part, ...] = ()
    for kind in plugin_kinds():
        for each in DISTROS:
            plugin = plugin_of(f"{name}:{kind}", identifier(place.manifest.name), each.name)
            parts = tuple(parts_of_plugin(place, plugin, each.name, force))
            [source] = [part for part in parts if isinstance(part, NewFile) and part.path == path]
            if source.says(text) == source.says(source.text):
                return parts
            if (plugin.base or "BT_REGISTER_NODES") in text:
                found = found or parts
    if not found or not force:
        raise ChangeError(f"the source of `{name}` is not as `add` writes it; --force removes it all the same")
    return found
