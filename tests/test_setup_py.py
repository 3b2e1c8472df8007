"""SetupPy: what setuptools is told by setup.py and setup.cfg, and the table of what is installed where."""

from __future__ import annotations

import pytest
from reading import one, package

from rospkg_cli.checks.setup.module_exports import MAX_DEPTH
from rospkg_cli.example import BACKDROPS, SETUP_PY, scripts, setup_py
from rospkg_cli.package.install_table import InstallTable
from rospkg_cli.package.setup.entry_point import parse_entry_point
from rospkg_cli.package.setup.setup_py import SetupPy
from rospkg_cli.package.setup.setup_text import SetupText
from rospkg_cli.source import Span
from rospkg_cli.testing import lint_files

BASE = {path: text for path, text in BACKDROPS["ament_python"].items() if text is not None}
HEAD = "from setuptools import setup, find_packages\nimport os\nfrom glob import glob\n"


def setup(text: str, **files: str) -> SetupPy:
    return one({**BASE, **files, "setup.py": text}, SetupPy)


def table(text: str, files: dict[str, str] | None = None) -> InstallTable:
    return one({**BASE, **(files or {}), "setup.py": text}, InstallTable)


def rows(found: InstallTable) -> list[tuple[str, str, str]]:
    return [(row.what, row.destination, row.source or row.entry) for row in found.rows]


def test_the_metadata() -> None:
    found = one(BASE, SetupPy)
    name, version = found.setup_text("name"), found.setup_text("version")
    assert name
    assert version
    assert (name.text, found.source.slice(name.shown)) == ("my_pkg", "my_pkg")
    assert (version.text, found.source.slice(version.shown)) == ("1.0.0", "1.0.0")
    assert [each.text for each in found.packages] == ["my_pkg"]
    assert not found.unknown


ENTRY_FORMS = [
    "entry_points={'console_scripts': ['talker = my_pkg.talker:main']}",
    "entry_points={'console_scripts': ['%s = %s.%s:main' % (n, 'my_pkg', n) for n in ['talker']]}",
    "entry_points={'console_scripts': 'talker = my_pkg.talker:main'}",
    "entry_points='''\n[console_scripts]\ntalker = my_pkg.talker:main\n'''",
    "entry_points={'console_scripts': [('talker = my_pkg.talker:main',)]}",
    "**dict(entry_points=dict(console_scripts=['talker = {}.talker:main'.format('my_pkg')]))",
]


@pytest.mark.parametrize("form", ENTRY_FORMS)
def test_entry_points_in_every_form(form: str) -> None:
    found = setup(f"{HEAD}setup(name='my_pkg', {form})\n")
    (entry,) = found.entry_points
    assert (entry.group, entry.name, entry.module, entry.attribute, entry.fault) == (
        "console_scripts", "talker", "my_pkg.talker", "main", "",
    )  # fmt: skip
    assert found.knows("entry_points")


def test_the_parts_of_an_entry_point_have_their_places() -> None:
    text = f"{HEAD}setup(entry_points={{'console_scripts': [' talker=my_pkg.talker : main [x]']}})\n"
    (entry,) = setup(text).entry_points
    spans = (entry.span, entry.name_span, entry.module_span, entry.attribute_span)
    assert [text[s.start : s.end] for s in spans] == [
        "talker=my_pkg.talker : main [x]",
        "talker",
        "my_pkg.talker",
        "main",
    ]


@pytest.mark.parametrize(
    "text, fault",
    [
        ("talker = my_pkg.talker:main", ""),
        ("talker = my_pkg.talker:Node.main", ""),
        ("talker", "no-equals"),
        ("talker = my_pkg.talker", "no-attribute"),
        ("talker = my_pkg.talker.main", "no-attribute"),
        ("talker = talker.py:main", "file-name"),
        ("talker = a:maintwo = b:main", "joined"),
        ("talker = my-pkg:main", "unreadable"),
        ("talker = my_pkg/talker:main", "unreadable"),
        ("talker = my_pkg.talker:", "unreadable"),
        ("talker = my_pkg.talker:main()", "unreadable"),
    ],
)
def test_the_faults_of_entry_points(text: str, fault: str) -> None:
    span = Span(0, len(text))
    assert parse_entry_point("console_scripts", SetupText("setup.py", text, span, span)).fault == fault


def test_setup_cfg_says_what_setup_py_does_not() -> None:
    cfg = """\
[metadata]
name = my_pkg
version = 1.2.3
[options]
packages = find:
package_dir =
    = src
[options.packages.find]
where = src
exclude = *.test
[options.entry_points]
console_scripts =
    talker = my_pkg.talker:main
[options.data_files]
share/my_pkg/launch = launch/*.py
share/my_pkg =
    package.xml
[options.extras_require]
test = pytest
[install]
install_scripts = $base/lib/my_pkg
"""
    files = {
        **BASE, "setup.py": "from setuptools import setup\nsetup(version='2.0.0')\n", "setup.cfg": cfg,
        "src/my_pkg/__init__.py": "", "src/my_pkg/talker.py": "", "src/my_pkg/test/__init__.py": "",
        "launch/a.launch.py": "",
    }  # fmt: skip
    found = one(files, SetupPy)
    assert [(s.text, s.path) for n in ("name", "version") if (s := found.setup_text(n))] == [
        ("my_pkg", "setup.cfg"),
        ("2.0.0", "setup.py"),
    ]
    assert not found.unknown
    assert rows(one(files, InstallTable)) == [
        ("share", "share/my_pkg/launch/a.launch.py", "launch/a.launch.py"),
        ("share", "share/my_pkg/package.xml", "package.xml"),
        ("share", "share/ament_index/resource_index/packages/my_pkg", ""),
        ("executable", "lib/my_pkg/talker", "my_pkg.talker:main"),
        ("module", "lib/python/my_pkg/__init__.py", "src/my_pkg/__init__.py"),
        ("module", "lib/python/my_pkg/talker.py", "src/my_pkg/talker.py"),
    ]


ODD = f"""{HEAD}
name = 'my_pkg'
data_files = [('share/ament_index/resource_index/packages', ['resource/' + name]), ('share/' + name, ['package.xml'])]

def add(folder):
    for path, _, files in os.walk(folder):
        if files:
            data_files.append((os.path.join('share', name, path), [os.path.join(path, f) for f in files]))

add('meshes')
data_files += [('lib/' + name, glob('scripts/*')), ('share/' + name + '/', ['./config/../config/a.yaml'])]
setup(
    name=name,
    packages=[name, 'vendored'],
    package_dir={{'vendored': 'third_party/vendored'}},
    package_data={{name: ['*.json', 'py.typed']}},
    py_modules=['single'],
    scripts=['bin/tool'],
    data_files=data_files,
)
"""


def test_the_table_of_an_odd_package() -> None:
    names = "meshes/a/x.stl meshes/y.stl scripts/run.sh config/a.yaml my_pkg/t.py my_pkg/s.json my_pkg/py.typed"
    more = "third_party/vendored/__init__.py single.py bin/tool other.py"
    assert rows(table(ODD, dict.fromkeys([*names.split(), *more.split()], ""))) == [
        ("share", "share/ament_index/resource_index/packages/my_pkg", "resource/my_pkg"),
        ("share", "share/my_pkg/package.xml", "package.xml"),
        ("share", "share/my_pkg/meshes/y.stl", "meshes/y.stl"),
        ("share", "share/my_pkg/meshes/a/x.stl", "meshes/a/x.stl"),
        ("executable", "lib/my_pkg/run.sh", "scripts/run.sh"),
        ("share", "share/my_pkg/a.yaml", "config/a.yaml"),
        ("executable", "lib/my_pkg/tool", "bin/tool"),
        ("module", "lib/python/my_pkg/__init__.py", "my_pkg/__init__.py"),
        ("module", "lib/python/my_pkg/t.py", "my_pkg/t.py"),
        ("module", "lib/python/vendored/__init__.py", "third_party/vendored/__init__.py"),
        ("module", "lib/python/single.py", "single.py"),
        ("module", "lib/python/my_pkg/s.json", "my_pkg/s.json"),
        ("module", "lib/python/my_pkg/py.typed", "my_pkg/py.typed"),
    ]


@pytest.mark.parametrize(
    "text, names",
    [
        ("setup(data_files=[('share/x', glob('../other/*'))])", {"data_files"}),
        ("setup(**something())", {"name", "packages", "data_files", "entry_points"}),
        ("if os.environ.get('X'):\n    setup()\nelse:\n    setup(name='x')", {"name", "packages"}),
        ("setup(entry_points={'console_scripts': [f'{os.environ[\"X\"]} = a:b']})", {"entry_points"}),
        ("open('x', 'w').write('y')\nsetup(name='my_pkg')", set()),
        ("while True:\n    pass\nsetup(name='my_pkg')", {"name"}),
        ("from somewhere import setup_it\nsetup_it()", {"name"}),
    ],
)
def test_what_is_not_known_is_known(text: str, names: set[str]) -> None:
    found = setup(HEAD + text + "\n")
    assert names <= set(found.unknown)


@pytest.mark.parametrize(
    "text, makes",
    [
        ("setup(name='my_pkg')", False),
        ("print('hello')\nx = os.path.join(*glob('*'))\nsetup(name='my_pkg')", False),
        ("open('x', 'w').write('y')\nsetup(name='my_pkg')", True),
        ("from tool.helper import generate\ngenerate('x')\nsetup(name='my_pkg')", True),
        ("os.system('make')\nsetup(name='my_pkg')", True),
        ("setup(name='my_pkg', cmdclass={'build_py': os})", True),
    ],
)
def test_it_is_seen_when_setup_py_writes_files(text: str, makes: bool) -> None:
    assert setup(f"{HEAD}{text}\n").may_write_files is makes


def test_a_cmake_package_does_not_run_its_setup_py() -> None:
    files = {**{p: t for p, t in BACKDROPS["ament_cmake"].items() if t is not None}, "setup.py": SETUP_PY}
    assert package(files).parts(SetupPy).good == ()


def test_what_other_packages_may_know() -> None:
    from rospkg_cli.package.collect_facts import collect_facts
    from rospkg_cli.ros.distros import Targets

    text = SETUP_PY.replace(
        "    zip_safe", "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n    zip_safe"
    )
    facts = collect_facts(
        package({**BASE, "setup.py": text, "my_pkg/talker.py": "def main(): ..."}), Targets(), "", "my_pkg"
    )
    assert facts.executables == {"talker"}
    assert facts.share_files == {"package.xml"}
    assert facts.modules == {"my_pkg", "my_pkg.talker"}
    assert all(facts.knows(name) for name in ("executables", "share_files", "modules"))


@pytest.mark.parametrize("count, is_judged", [(0, True), (1, True), (MAX_DEPTH, True), (MAX_DEPTH + 1, False)])
def test_star_imports_are_followed_as_far_as_promised(count: int, is_judged: bool) -> None:
    files = {f"my_pkg/m{number}.py": f"from .m{number + 1} import *\n" for number in range(count)}
    files |= {f"my_pkg/m{count}.py": "A = 1\n", "setup.py": setup_py(scripts("talker = my_pkg.m0:main"))}
    found = lint_files({**BASE, **files}, ["SET102"]).findings
    assert bool(found) is is_judged
