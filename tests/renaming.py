"""A workspace in which packages name each other in every way, and renaming one of them in memory."""

from __future__ import annotations

from rospkg_cli.example import manifest
from rospkg_cli.renaming.plan import RenamePlan, plan_rename
from rospkg_cli.tree import MemoryTree, Tree


def depends(*names: str, tag: str = "depend") -> str:
    return "".join(f"  <{tag}>{name}</{tag}>\n" for name in names)


def named(name: str, inner: str = "", build_type: str = "ament_python") -> str:
    """Return a package.xml for a package of another name than the examples have."""
    return manifest(inner, build_type).replace("<name>my_pkg</name>", f"<name>{name}</name>")


CMAKE = depends("ament_cmake", tag="buildtool_depend")


def python_package(name: str, **more: str) -> dict[str, str]:
    """Return a package of Python with one node `drive`; more files by their paths, `/` written as `__`."""
    setup = f"""\
from setuptools import find_packages, setup

package_name = '{name}'

setup(
    name=package_name,
    version='1.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    entry_points={{'console_scripts': ['drive = {name}.drive:main']}},
)
"""
    return {
        "package.xml": named(name, depends("rclpy", tag="exec_depend")),
        "setup.py": setup,
        "setup.cfg": f"[develop]\nscript_dir=$base/lib/{name}\n[install]\ninstall_scripts=$base/lib/{name}\n",
        f"resource/{name}": "",
        f"{name}/__init__.py": "",
        f"{name}/drive.py": f"from {name} import gears\n\n\ndef main():\n    gears.shift()\n",
        f"{name}/gears.py": "def shift():\n    pass\n",
        **{path.replace("__", "/"): text for path, text in more.items()},
    }


def below(folder: str, files: dict[str, str]) -> dict[str, str]:
    return {f"{folder}/{path}": text for path, text in files.items()}


def renamed(files: dict[str, str], folder: str, old: str, new: str) -> RenamePlan:
    """Rename in memory, and check that renaming back brings back every file."""
    tree = MemoryTree.of(files)
    plan = plan_rename(tree, folder, old, new)
    back = plan_rename(plan.draft.tree, plan.moved(folder), new, old)
    before, again = texts(tree), texts(back.draft.tree)
    assert {path: again.get(path) for path in before} == before
    assert again.keys() == before.keys()
    return plan


def texts(tree: Tree) -> dict[str, str]:
    return {path: tree.entry(path).data.decode() for path in tree.files()}


def after(text: str, path: str, old: str = "old_name", new: str = "new_name", **files: str) -> str:
    """Return what becomes of one file of another package where a package of Python is renamed."""
    every = below(old, python_package(old)) | {f"other/{path}": text, "other/package.xml": named("other")}
    every |= {key.replace("__", "/"): each for key, each in files.items()}
    return texts(renamed(every, old, old, new).draft.tree)[f"other/{path}"]
