"""A rule's documented case: printed by `rospkg explain` and run by the tests."""

from __future__ import annotations

from collections.abc import Mapping

from .finding import Safety
from .lazy_regex import regex
from .light_dataclasses import dataclass
from .source import Span

Files = Mapping[str, str | None]

MARK = regex("[«»]")


@dataclass(frozen=True, kw_only=True)
class Example:
    """A tree for which the rule has findings, and one for which it has none.

    In `bad`, « and » enclose the exact span of each hit.  `good` gives only the files that
    differ from `bad` (None: the file is not there).  `on` names the backdrop: the other files of a faultless
    package called `my_pkg`: "ament_python", "ament_cmake", "interfaces", "config" (which installs the folder of that
    name), or "" for none.  `fix` says that the rule's own fix makes `good` of `bad`.
    """

    bad: Files
    good: Files
    on: str = "ament_python"
    fix: Safety | None = None
    targets: tuple[str, ...] = ()

    def bad_files(self) -> dict[str, str]:
        return existing_files(
            {**BACKDROPS[self.on], **{p: None if t is None else MARK.sub("", t) for p, t in self.bad.items()}}
        )

    def good_files(self) -> dict[str, str]:
        return existing_files({**BACKDROPS[self.on], **without_marks(self.bad), **self.good})

    def marks(self) -> list[tuple[str, Span]]:
        """The spans between « and » of all files, in order, counted without the marks."""
        found = []
        for path, text in self.bad.items():
            opened = 0
            for removed, mark in enumerate(MARK.finditer(text or "")):
                if mark.group() == "«":
                    opened = mark.start() - removed
                else:
                    found.append((path, Span(opened, mark.start() - removed)))
        return sorted(found)


def without_marks(files: Files) -> dict[str, str | None]:
    return {path: None if text is None else MARK.sub("", text) for path, text in files.items()}


def existing_files(files: Files) -> dict[str, str]:
    return {path: text for path, text in files.items() if text is not None}


MANIFEST = """\
<?xml version="1.0"?>
<?xml-model href="http://download.ros.org/schema/package_format3.xsd" schematypens="http://www.w3.org/2001/XMLSchema"?>
<package format="3">
  <name>my_pkg</name>
  <version>1.0.0</version>
  <description>Drives my robot</description>
  <maintainer email="ada@example.org">Ada</maintainer>
  <license>Apache-2.0</license>
{buildtool}
  <export>
    <build_type>{build_type}</build_type>
  </export>
</package>
"""

SETUP_PY = """\
from setuptools import find_packages, setup

package_name = 'my_pkg'

setup(
    name=package_name,
    version='1.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Ada',
    maintainer_email='ada@example.org',
    description='Drives my robot',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
)
"""

SETUP_PY_FOR_ALL = SETUP_PY.replace("from setuptools", "import os\n\nfrom setuptools").replace(
    "    ],\n    install_requires",
    """\
    ] + [
        (os.path.join('share', package_name, path), [os.path.join(path, name) for name in names])
        for folder in ('config', 'launch', 'maps', 'meshes', 'params', 'rviz', 'urdf', 'worlds')
        for path, _, names in os.walk(folder)
    ],
    install_requires""",
)
"""It installs all files that an example puts into such a folder, so that the example has no other fault."""

SETUP_CFG = """\
[develop]
script_dir=$base/lib/my_pkg
[install]
install_scripts=$base/lib/my_pkg
"""

CMAKE = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)
find_package(ament_cmake REQUIRED)
ament_package()
"""


CONFIG_INSTALL = """\
install(DIRECTORY config
  DESTINATION share/${PROJECT_NAME}
)
"""

INTERFACES_CMAKE = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME}
  "msg/Status.msg"
  "srv/SetMode.srv"
)
ament_export_dependencies(rosidl_default_runtime)
ament_package()
"""

INTERFACES_BODY = """\
  <buildtool_depend>rosidl_default_generators</buildtool_depend>
  <exec_depend>rosidl_default_runtime</exec_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
"""


def manifest(body: str = "", build_type: str = "ament_python", name: str = "my_pkg") -> str:
    """A faultless package.xml with `body` (lines of dependencies, two blanks deep) before its export."""
    buildtool = "  <buildtool_depend>ament_cmake</buildtool_depend>\n" if build_type == "ament_cmake" else ""
    text = MANIFEST.format(buildtool=(buildtool + body).rstrip("\n"), build_type=build_type)
    return text.replace("my_pkg", name).replace("\n\n", "\n")


XMLLINT = "from ament_xmllint.main import main\n\n\ndef test_xmllint():\n    assert main(argv=[]) == 0\n"
"""A test of an ament_python package that compares its XML files with their schemas."""


def setup_py(*lines: str) -> str:
    """A faultless setup.py that passes more arguments (lines of code, each with its comma) to setup()."""
    return SETUP_PY.replace("    zip_safe=True,\n", "    zip_safe=True,\n" + "".join(f"    {line}\n" for line in lines))


def scripts(*entries: str) -> str:
    """The lines of setup.py that make executables of `name = module:function` texts."""
    inner = "".join(f"            '{entry}',\n" for entry in entries)
    return f"entry_points={{\n        'console_scripts': [\n{inner}        ],\n    }},"


BACKDROPS: dict[str, dict[str, str | None]] = {
    "": {},
    "ament_python": {
        "package.xml": manifest(),
        "setup.py": SETUP_PY_FOR_ALL,
        "setup.cfg": SETUP_CFG,
        "resource/my_pkg": "",
        "my_pkg/__init__.py": "",
        "LICENSE": "Apache License\n",
    },
    "ament_cmake": {
        "package.xml": manifest(build_type="ament_cmake"),
        "CMakeLists.txt": CMAKE,
        "LICENSE": "Apache License\n",
    },
    "config": {
        "package.xml": manifest(build_type="ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", CONFIG_INSTALL + "ament_package"),
        "LICENSE": "Apache License\n",
    },
    "interfaces": {
        "package.xml": manifest(INTERFACES_BODY, "ament_cmake"),
        "CMakeLists.txt": INTERFACES_CMAKE,
        "LICENSE": "Apache License\n",
        "msg/Status.msg": "float32 battery_level\n",
        "srv/SetMode.srv": "string mode\n---\nbool success\n",
    },
}
