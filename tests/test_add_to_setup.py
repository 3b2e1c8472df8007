"""`rospkg add node` in packages of type ament_python, whatever form their entry points have."""

from __future__ import annotations

import pytest
from adding import added, comes_back, executables, new_findings, python_package, taken, text

from rospkg_cli.change import ChangeError, NotUnderstoodError

HEAD = """\
from setuptools import setup

package_name = 'my_pkg'

setup(
    name=package_name,
    version='0.1.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/my_pkg']),
        ('share/my_pkg', ['package.xml']),
    ],
    maintainer='Ada',
    maintainer_email='ada@example.org',
    description='Drives my robot',
    license='Apache-2.0',
"""

FORMATS = {
    "black": (
        '    entry_points={\n        "console_scripts": [\n            "old = my_pkg.old:main",\n        ],\n'
        "    },\n)\n",
        '            "old = my_pkg.old:main",\n            "idler = my_pkg.idler:main",\n        ],\n',
    ),
    "yapf": (
        "    entry_points={\n        'console_scripts': ['old = my_pkg.old:main'],\n    },\n)\n",
        "        'console_scripts': ['old = my_pkg.old:main', 'idler = my_pkg.idler:main'],\n",
    ),
    "under the bracket": (
        "    entry_points={'console_scripts': ['old = my_pkg.old:main',\n"
        "                                      'older = my_pkg.old:main']},\n)\n",
        "                                      'older = my_pkg.old:main',\n"
        "                                      'idler = my_pkg.idler:main']},\n",
    ),
    "one line that is long": (
        "    entry_points={'console_scripts': ['old = my_pkg.old:main', 'older = my_pkg.old:main']},\n)\n",
        "['old = my_pkg.old:main', 'older = my_pkg.old:main',\n"
        "                                      'idler = my_pkg.idler:main']},\n",
    ),
    "no trailing comma": (
        "    entry_points={\n        'console_scripts': [\n            'old = my_pkg.old:main'\n        ]\n    }\n)\n",
        "            'old = my_pkg.old:main',\n            'idler = my_pkg.idler:main'\n        ]\n",
    ),
    "no comma before a comment": (
        "    entry_points={\n        'console_scripts': [\n            'old = my_pkg.old:main'  # the first\n"
        "        ],\n    },\n)\n",
        "            'old = my_pkg.old:main',  # the first\n            'idler = my_pkg.idler:main'\n        ],\n",
    ),
    "a comment behind the last": (
        "    entry_points={\n        'console_scripts': [\n            'old = my_pkg.old:main',  # the first\n"
        "            # more to come\n        ],\n    },\n)\n",
        "            'old = my_pkg.old:main',  # the first\n            'idler = my_pkg.idler:main',\n"
        "            # more to come\n",
    ),
    "no blanks": (
        "    entry_points={'console_scripts': ['old=my_pkg.old:main']},\n)\n",
        "['old=my_pkg.old:main', 'idler=my_pkg.idler:main']",
    ),
    "an empty list": (
        "    entry_points={\n        'console_scripts': [],\n    },\n)\n",
        "        'console_scripts': ['idler = my_pkg.idler:main'],\n",
    ),
    "an empty list on two lines": (
        "    entry_points={\n        'console_scripts': [\n        ],\n    },\n)\n",
        "        'console_scripts': [\n            'idler = my_pkg.idler:main',\n        ],\n",
    ),
    "an empty list with a comment": (
        "    entry_points={\n        'console_scripts': [\n            # 'old = my_pkg.old:main'\n        ],\n"
        "    },\n)\n",
        "            # 'old = my_pkg.old:main'\n            'idler = my_pkg.idler:main',\n        ],\n",
    ),
    "other entry points": (
        "    entry_points={\n        'gui': ['x = my_pkg.old:main'],\n    },\n)\n",
        "        'gui': ['x = my_pkg.old:main'],\n        'console_scripts': ['idler = my_pkg.idler:main'],\n",
    ),
    "none": (
        ")\n",
        "    license='Apache-2.0',\n    entry_points={'console_scripts': ['idler = my_pkg.idler:main']},\n)\n",
    ),
    "a text": (
        '    entry_points="""\n    [console_scripts]\n    old = my_pkg.old:main\n    """,\n)\n',
        "    old = my_pkg.old:main\n    idler = my_pkg.idler:main\n",
    ),
}


@pytest.mark.parametrize("form", FORMATS)
def test_the_entry_point_looks_like_the_others(form: str) -> None:
    tail, expected = FORMATS[form]
    files = python_package(HEAD + tail)
    draft = added(files, "node", "idler:empty")
    assert expected in text(draft, "setup.py")
    assert "idler" in executables(draft)
    assert new_findings(files, draft) == []
    comes_back(files, draft, "node", "idler")


def test_an_empty_dict_can_not_be_told_from_none() -> None:
    draft = added(python_package(HEAD + "    entry_points={},\n)\n"), "node", "idler:empty")
    assert "    entry_points={'console_scripts': ['idler = my_pkg.idler:main']},\n)\n" in text(draft, "setup.py")
    assert text(taken(draft, "node", "idler")[0], "setup.py") == HEAD + ")\n"


def test_a_dict_in_a_variable() -> None:
    scripts = "scripts = {'console_scripts': ['old = my_pkg.old:main']}\n\nsetup("
    setup = (HEAD + "    entry_points=scripts,\n)\n").replace("\nsetup(", f"\n{scripts}")
    files = python_package(setup)
    draft = added(files, "node", "idler:empty")
    assert "['old = my_pkg.old:main', 'idler = my_pkg.idler:main']}\n\nsetup(" in text(draft, "setup.py")
    assert executables(draft) == {"old", "idler"}
    comes_back(files, draft, "node", "idler")


CFG = {
    "lines": (
        "[options.entry_points]\nconsole_scripts =\n    old = my_pkg.old:main\n",
        "    old = my_pkg.old:main\n    idler = my_pkg.idler:main\n",
    ),
    "one line": (
        "[options.entry_points]\nconsole_scripts = old = my_pkg.old:main\n",
        "console_scripts = old = my_pkg.old:main\n    idler = my_pkg.idler:main\n",
    ),
    "other entry points": (
        "[options.entry_points]\ngui =\n    old = my_pkg.old:main\n[options]\nzip_safe = true\n",
        "    old = my_pkg.old:main\nconsole_scripts =\n    idler = my_pkg.idler:main\n[options]\n",
    ),
}


@pytest.mark.parametrize("form", CFG)
def test_entry_points_in_setup_cfg(form: str) -> None:
    section, expected = CFG[form]
    files = python_package(HEAD + ")\n")
    files["setup.cfg"] += section
    draft = added(files, "node", "idler:empty")
    assert expected in text(draft, "setup.cfg")
    assert text(draft, "setup.py") == files["setup.py"]
    assert "idler" in executables(draft)
    comes_back(files, draft, "node", "idler")


PROJECT = '[build-system]\nrequires = ["setuptools"]\n\n[project]\nname = "my_pkg"\nversion = "0.1.0"\n'
TOML = {
    "scripts": (
        PROJECT + '\n[project.scripts]\nold = "my_pkg.old:main"\n\n[tool.black]\n',
        'old = "my_pkg.old:main"\nidler = "my_pkg.idler:main"\n\n[tool.black]\n',
    ),
    "no scripts": (PROJECT, 'version = "0.1.0"\n\n[project.scripts]\nidler = "my_pkg.idler:main"\n'),
}


@pytest.mark.parametrize("form", TOML)
def test_entry_points_in_pyproject(form: str) -> None:
    toml, expected = TOML[form]
    files = python_package("from setuptools import setup\n\nsetup(packages=['my_pkg'])\n")
    files["pyproject.toml"] = toml
    draft = added(files, "node", "idler:empty")
    assert expected in text(draft, "pyproject.toml")
    assert text(draft, "setup.py") == files["setup.py"]
    comes_back(files, draft, "node", "idler")


def test_entry_points_that_are_computed_are_left_to_a_person() -> None:
    files = python_package(HEAD + "    entry_points=read_them(),\n)\n")
    with pytest.raises(NotUnderstoodError, match="can't be put among the entry points") as refused:
        added(files, "node", "idler:empty")
    assert refused.value.details == (
        "setup.py, in entry_points['console_scripts']:",
        "    'idler = my_pkg.idler:main',",
    )
    files["setup.py"] = files["setup.py"].replace("read_them()", "read_them('idler = my_pkg.idler:main')")
    assert "my_pkg/idler.py" in added(files, "node", "idler:empty").changes


@pytest.mark.parametrize("newline", ["\r\n", "\n"])
def test_line_ends_stay(newline: str) -> None:
    files = {path: each.replace("\n", newline) for path, each in python_package(HEAD + FORMATS["black"][0]).items()}
    draft = added(files, "node", "idler:empty")
    assert text(draft, "setup.py").count("\r") == text(draft, "setup.py").count("\n") * (newline == "\r\n")
    comes_back(files, draft, "node", "idler")


def test_every_kind_of_node_can_be_added_and_removed() -> None:
    from rospkg_cli.scaffold.node_kinds import offered_kinds

    files = python_package(HEAD + FORMATS["black"][0])
    for kind in offered_kinds(["python"]):
        draft = added(files, "node", f"idler:{kind}")
        assert "idler" in executables(draft)
        assert new_findings(files, draft) == [], kind
        comes_back(files, draft, "node", "idler")


def test_a_node_about_a_message() -> None:
    files = python_package(HEAD + FORMATS["black"][0])
    draft = added(files, "node", "ear:subscriber:sensor_msgs/LaserScan")
    assert "from sensor_msgs.msg import LaserScan" in text(draft, "my_pkg/ear.py")
    assert "<exec_depend>sensor_msgs</exec_depend>" in text(draft, "package.xml")
    comes_back(files, draft, "node", "ear")


def test_two_nodes_share_what_needs_no_ros() -> None:
    files = python_package(HEAD + FORMATS["black"][0])
    draft = added(files, "node", "one:publisher", "two:publisher")
    after, is_all = taken(draft, "node", "one")
    assert is_all
    assert after.entry("my_pkg/greeting.py")
    assert after.entry("my_pkg/one.py") is None
    last, _ = taken(after, "node", "two")
    assert last.entry("my_pkg/greeting.py") is None
    assert text(last, "package.xml") == files["package.xml"]


CFGS = {
    "none": None,
    "of something else": "[flake8]\nmax-line-length = 99\n",
    "with a hole": "[develop]\nscript_dir=$base/lib/my_pkg\n",
}


@pytest.mark.parametrize("cfg", CFGS)
def test_the_first_executable_brings_its_folder(cfg: str) -> None:
    files = python_package(HEAD + ")\n")
    del files["setup.cfg"]
    files |= {"setup.cfg": given} if (given := CFGS[cfg]) else {}
    draft = added(files, "node", "idler:empty")
    assert "[install]\ninstall_scripts=$base/lib/my_pkg\n" in text(draft, "setup.cfg")
    assert executables(draft) == {"idler"}
    assert new_findings(files, draft) == []
    after, is_all = taken(draft, "node", "idler")
    assert is_all
    assert text(after, "setup.py") == files["setup.py"]
    assert text(after, "setup.cfg") == text(draft, "setup.cfg")  # it serves executables to come


def test_other_executables_do_not_move_unasked() -> None:
    files = python_package(HEAD + FORMATS["black"][0])
    del files["setup.cfg"]
    with pytest.raises(NotUnderstoodError, match="the executables of this package go to bin/") as refused:
        added(files, "node", "idler:empty")
    assert refused.value.details[:3] == ("setup.cfg:", "    [develop]", "    script_dir=$base/lib/my_pkg")


def test_names_that_are_taken() -> None:
    files = python_package(HEAD + FORMATS["black"][0])
    with pytest.raises(ChangeError, match=r"`my_pkg/old.py` is there already, and is something else"):
        added(files, "node", "old:empty")
    del files["my_pkg/old.py"]
    files["my_pkg/late.py"] = "def main(): ...\n"
    files["setup.py"] = files["setup.py"].replace("my_pkg.old", "my_pkg.late")
    with pytest.raises(ChangeError, match=r"setup.py has an executable `old` already"):
        added(files, "node", "old:empty")
    files["my_pkg/greeting.py"] = "x = 1\n"
    with pytest.raises(ChangeError, match=r"`my_pkg/greeting.py` is there already.*such as NAME:empty"):
        added(files, "node", "new:publisher")


def test_without_a_package_to_put_it_in() -> None:
    files = python_package("from setuptools import setup\nsetup(name='my_pkg', py_modules=['a'])\n")
    with pytest.raises(ChangeError, match=r"setup\.py installs no Python package: list `my_pkg` in `packages`"):
        added(files, "node", "idler:empty")


def test_the_package_of_most_executables_is_chosen() -> None:
    setup = HEAD.replace("packages=[package_name]", "packages=['robot', 'robot.nodes']") + (
        "    entry_points={'console_scripts': ['a = robot.nodes.a:main']},\n)\n"
    )
    files = python_package(setup)
    files |= {"robot/__init__.py": "", "robot/nodes/__init__.py": "", "robot/nodes/a.py": NODE_A}
    draft = added(files, "node", "talker:publisher")
    assert "from robot.nodes.greeting import Greeting" in text(draft, "robot/nodes/talker.py")
    assert "'talker = robot.nodes.talker:main'" in text(draft, "setup.py")


NODE_A = "def main():\n    pass\n"


def test_a_license_without_a_known_header_gets_none() -> None:
    files = python_package(HEAD + FORMATS["black"][0])
    files["package.xml"] = files["package.xml"].replace("Apache-2.0", "Proprietary")
    assert text(added(files, "node", "idler:empty"), "my_pkg/idler.py").startswith(
        '"""A node that starts and waits."""'
    )
