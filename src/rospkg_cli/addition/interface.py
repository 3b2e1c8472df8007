"""A message, service or action: its file, its place in rosidl_generate_interfaces, and what its types need."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from shlex import quote

from ..change import ChangeError
from ..package.interfaces.interface_file import InterfaceFile
from ..package.manifest import Manifest
from ..package.package import Package
from ..ros.distros import Targets
from ..ros.interfaces import GROUP
from ..scaffold.interface import RequestedInterface, interface_of, interfaces_of
from .cmake_find import FoundInCMake, cmake_of
from .dependency import AddedDependency, manifest_of
from .group import GroupMember
from .interface_list import ListedFile, ListedPackage
from .new_file import NewFile
from .part import Part
from .rendered import identifier

GENERATORS, RUNTIME = "rosidl_default_generators", "rosidl_default_runtime"
OF_ACTIONS = "action_msgs"
"""What the code of every action uses; rosidl finds it itself."""


def interface_parts(package: Package, form: str, asked: Sequence[str], here: bool = False) -> tuple[Part, ...]:
    """Return the parts of interfaces that were asked for as NAME[:FIELDS]; `form` is msg, srv or action.

    `here` generates them in a package that generates none yet. Raises ChangeError and ScaffoldError.
    """
    manifest = manifest_of(package)
    check_package(package, manifest, form, asked, here)
    messages = {each.name for each in package.parts(InterfaceFile).good if each.kind == "msg"}
    messages |= {text.partition(":")[0] for text in asked if form == "msg"}
    wanted = [interface_of(form, text, messages) for text in asked]
    interfaces_of({form: tuple(asked)} if form == "msg" else {})  # refuses a name that is given twice
    return tuple(parts_of(manifest, wanted))


def parts_of(manifest: Manifest, wanted: Sequence[RequestedInterface], force: bool = False) -> Iterator[Part]:
    """Yield the parts of interfaces; `force`: their files may have been edited since."""
    needs = sorted({name for each in wanted for name in each.packages} - {manifest.name})
    yield AddedDependency(GENERATORS, "buildtool")
    is_action = any(each.path.endswith(".action") for each in wanted)
    yield from (AddedDependency(name, "all") for name in sorted({*needs, *([OF_ACTIONS] if is_action else [])}))
    yield AddedDependency(RUNTIME, "exec")
    yield GroupMember(GROUP)
    yield FoundInCMake(GENERATORS)
    yield from (FoundInCMake(name) for name in needs)
    for each in wanted:
        yield NewFile(each.path, each.text, force=force)
        yield ListedFile(each.path)
    paths = tuple(each.path for each in wanted)
    yield from (ListedPackage(name, paths) for name in needs)


def check_package(package: Package, manifest: Manifest, form: str, asked: Sequence[str], here: bool) -> None:
    """Raise ChangeError where a package can't generate interfaces, or generates none and is not asked to."""
    texts = " ".join(f"--{form} {quote(text)}" for text in asked)
    stem = manifest.name.removesuffix("_interfaces").removesuffix("_msgs")
    elsewhere = f"rospkg new {stem}_interfaces --type interfaces {texts}"
    if manifest.build_type(Targets()) != "ament_cmake":
        raise ChangeError(f"only packages of type ament_cmake can generate interfaces; make one: {elsewhere}")
    cmake = cmake_of(package)
    if cmake.named("rosidl_generate_interfaces"):
        return
    if not here:
        raise ChangeError(
            f"the package generates no interfaces: make a package for them with `{elsewhere}`, or give --here"
        )
    installed = [call.words[0] for call in cmake.named("ament_python_install_package") if call.words]
    if any(not each.is_known or each.text == identifier(manifest.name) for each in installed):
        raise ChangeError(
            f"CMake installs a Python package here, and the generated one has the same name; make one: {elsewhere}"
        )
