"""Packages that are installed in unusual ways, each right: for the install table and for real colcon."""

from __future__ import annotations

from rospkg_cli.example import manifest, scripts, setup_py

MAIN = "def main():\n    print('hello')\n"
CFG = "[develop]\nscript_dir=$base/lib/{name}\n[install]\ninstall_scripts=$base/lib/{name}\n"
LAUNCH = "<launch>\n</launch>\n"


def package(name: str, files: dict[str, str]) -> dict[str, str]:
    """Return the files of a package, with a manifest, a marker and a setup.cfg where none are given."""
    given = {"package.xml": manifest(name=name), f"resource/{name}": "", "setup.cfg": CFG.format(name=name), **files}
    return {path: text.replace("my_pkg", name) for path, text in given.items()}


TREES = """\
import os
from glob import glob

from setuptools import setup

name = 'my_pkg'
data_files = [('share/ament_index/resource_index/packages', ['resource/' + name]), ('share/' + name, ['package.xml'])]


def add(folder):
    for path, _, files in os.walk(folder):
        if files:
            data_files.append((os.path.join('share', name, path), [os.path.join(path, f) for f in files]))


add('meshes')
data_files += [('lib/' + name, glob('programs/*')), ('share/' + name + '/', ['./config/../config/a.yaml'])]
setup(
    name=name,
    version='1.0.0',
    packages=[name, 'vendored'],
    package_dir={'vendored': 'third_party/vendored'},
    package_data={name: ['*.json', 'data/**/*.txt', 'py.typed']},
    py_modules=['single_of_my_pkg'],
    scripts=['bin/tool'],
    data_files=data_files,
    install_requires=['setuptools'],
)
"""
IN_CFG = """\
[metadata]
name = my_pkg
version = 1.0.0
[options]
packages = find:
package_dir =
    = src
[options.packages.find]
where = src
exclude = *.test
[options.package_data]
my_pkg = *.txt
[options.entry_points]
console_scripts =
    talker = my_pkg.talker:main
[options.data_files]
share/ament_index/resource_index/packages = resource/my_pkg
share/my_pkg =
    package.xml
    README.md
[develop]
script_dir = $base/lib/my_pkg
[install]
install_scripts = $base/lib/my_pkg
"""
FROM_PARTS = """\
from pathlib import Path

from setuptools import find_namespace_packages, setup

package_name = 'my_pkg'
kwargs = dict(name=package_name, version='1.0.0', install_requires=['setuptools'])
kwargs['data_files'] = [
    (f'share/{package_name}/{path.parent}', [str(path)]) for path in sorted(Path('launch').rglob('*')) if path.is_file()
]
setup(
    packages=find_namespace_packages(include=[package_name, package_name + '.*']),
    entry_points={'console_scripts': ['%s = my_pkg.deep.%s:main' % (n, n) for n in ('one', 'two')]},
    **kwargs,
)
"""
FOUND = "find_packages(exclude=['test'])"

ODD: dict[str, dict[str, str]] = {
    "odd_trees": package(
        "odd_trees",
        {
            "setup.py": TREES,
            "odd_trees/__init__.py": "",
            "odd_trees/words.json": "{}\n",
            "odd_trees/py.typed": "",
            "odd_trees/data/deep/a.txt": "a\n",
            "third_party/vendored/__init__.py": "",
            "single_of_odd_trees.py": "",
            "bin/tool": "#!/usr/bin/env python3\nprint('tool')\n",
            "programs/run.sh": "#!/bin/sh\necho run\n",
            "meshes/y.stl": "solid y\n",
            "meshes/arm/x.stl": "solid x\n",
            "config/a.yaml": "a: 1\n",
            "not_installed.py": "",
        },
    ),
    "odd_in_cfg": package(
        "odd_in_cfg",
        {
            "setup.py": "from setuptools import setup\n\nsetup()\n",
            "setup.cfg": IN_CFG,
            "README.md": "# Odd\n",
            "src/odd_in_cfg/__init__.py": "",
            "src/odd_in_cfg/talker.py": MAIN,
            "src/odd_in_cfg/words.txt": "words\n",
            "src/odd_in_cfg/test/__init__.py": "",
        },
    ),
    "odd_parts": package(
        "odd_parts",
        {
            "setup.py": FROM_PARTS,
            "odd_parts/deep/one.py": MAIN,
            "odd_parts/deep/two.py": MAIN,
            "launch/a.launch.xml": LAUNCH,
            "launch/parts/b.launch.xml": LAUNCH,
        },
    ),
    "odd_bin": package(
        "odd_bin",
        {
            "setup.py": setup_py(scripts("odd-tool = my_pkg.tool:main")),
            "setup.cfg": "[tool:pytest]\naddopts = -q\n",
            "odd_bin/__init__.py": "",
            "odd_bin/tool.py": MAIN,
        },
    ),
    "odd_slash": package(
        "odd_slash",
        {
            "setup.py": setup_py(scripts("talker = src.my_pkg.talker:main")).replace(FOUND, "['src/my_pkg']"),
            "src/odd_slash/__init__.py": "",
            "src/odd_slash/talker.py": MAIN,
        },
    ),
}
