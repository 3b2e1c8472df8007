"""setup.py in the ways that people write it: what we evaluate is what setup() would be given."""

from __future__ import annotations

import posixpath
import sys
import types
from pathlib import Path
from typing import Any

import pytest
from reading import one
from setuptools import find_namespace_packages, find_packages

from rospkg_cli.example import manifest
from rospkg_cli.package.setup.setup_py import SetupPy

FILES = {
    "package.xml": manifest(),
    "resource/my_pkg": "",
    "my_pkg/__init__.py": "",
    "my_pkg/nodes/__init__.py": "",
    "my_pkg/nodes/talker.py": "",
    "my_pkg/data/words.txt": "",
    "src/other/__init__.py": "",
    "src/other/deep/__init__.py": "",
    "test/__init__.py": "",
    "test/unit/__init__.py": "",
    "launch/a.launch.py": "",
    "launch/b_launch.xml": "",
    "launch/parts/c.launch.py": "",
    "config/one.yaml": "",
    "config/deep/two.yaml": "",
    "meshes/base.stl": "",
    "meshes/arm/link.dae": "",
    "README.md": "# My package\n",
    "VERSION": "1.2.3\n",
    "requirements.txt": "numpy\n# comment\nscipy>=1.0\n",
}

IDIOMS = {
    "the documentation's": """\
data_files=[
    ('share/' + package_name, ['package.xml']),
    (os.path.join('share', package_name, 'launch'), glob(os.path.join('launch', '*launch.[pxy][yma]*'))),
]
setup(name=package_name, packages=find_packages(exclude=['test']), data_files=data_files)
""",
    "a walk": """\
def package_files(data_files, directory_list):
    paths_dict = {}
    for directory in directory_list:
        for (path, directories, filenames) in os.walk(directory):
            for filename in filenames:
                file_path = os.path.join(path, filename)
                install_path = os.path.join('share', package_name, path)
                if install_path in paths_dict.keys():
                    paths_dict[install_path].append(file_path)
                else:
                    paths_dict[install_path] = [file_path]
    for key in paths_dict.keys():
        data_files.append((key, paths_dict[key]))
    return data_files
setup(name=package_name, data_files=package_files([('share/x', ['package.xml'])], ['launch', 'meshes']))
""",
    "a generator": """\
def tree(top):
    for path, _, names in os.walk(top):
        yield os.path.join('share', package_name, path), [os.path.join(path, n) for n in names]
setup(name=package_name, data_files=[*tree('config'), *tree('meshes')])
""",
    "files of a glob one by one": """\
files = []
for f in glob('launch/**', recursive=True):
    if os.path.isfile(f):
        files.append((os.path.join('share', package_name, os.path.dirname(f)), [f]))
setup(name=package_name, data_files=files)
""",
    "pathlib": """\
here = Path(__file__).parent.resolve()
files = [
    (str(Path('share') / package_name / p.parent), [str(p)])
    for p in sorted(Path('config').rglob('*')) if p.is_file() and p.suffix == '.yaml'
]
setup(name=package_name, version=(here / 'VERSION').read_text().strip(), data_files=files)
""",
    "texts made of parts": """\
nodes = ['talker', 'listener']
setup(
    name=package_name,
    entry_points={'console_scripts': [
        '{0} = {1}.nodes.{0}:main'.format(node, package_name) for node in nodes
    ] + ['%s_node = %s.nodes.%s:main' % (n, package_name, n) for n in nodes] + [f'x = {package_name}.x:main']},
)
""",
    "kwargs": """\
kwargs = dict(name=package_name, packages=[package_name])
kwargs['packages'] += [package_name + '.nodes']
kwargs.update(version='0.1.0', scripts=['bin/tool'])
setup(**kwargs, py_modules=['single'])
""",
    "another root": """\
setup(name=package_name, package_dir={'': 'src'}, packages=find_packages(where='src', include=['other*']))
""",
    "namespaces": "setup(name=package_name, packages=find_namespace_packages(include=['my_pkg', 'my_pkg.*']))\n",
    "excluding below": "setup(name=package_name, packages=find_packages(exclude=('test', 'test.*', '*.nodes')))\n",
    "sub-packages from a loop": """\
packages = [package_name]
for sub in sorted(os.listdir(package_name)):
    if os.path.exists(os.path.join(package_name, sub, '__init__.py')):
        packages.append('.'.join([package_name, sub]))
setup(name=package_name, packages=packages)
""",
    "a version that is read": """\
with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), 'VERSION')) as f:
    version = f.readline().strip()
setup(name=package_name, version=version)
""",
    "requirements from a file": """\
install_requires = [l.strip() for l in open('requirements.txt') if l.strip() and not l.startswith('#')]
setup(name=package_name, install_requires=install_requires, version=str(len(install_requires)))
""",
    "a condition on what is there": """\
data = [('share/' + package_name, ['package.xml'])]
if os.path.isdir('meshes'):
    data.append(('share/' + package_name + '/meshes', glob('meshes/*.stl')))
if os.path.isdir('nowhere'):
    data.append(('share/' + package_name + '/nowhere', glob('nowhere/*')))
setup(name=package_name, data_files=data)
""",
    "main": """\
def main():
    setup(name=package_name, version='1.0.0')

if __name__ == '__main__':
    main()
""",
    "filters": """\
launch = list(filter(os.path.isfile, glob('launch/*')))
config = [f for f in glob('config/**/*', recursive=True) if not os.path.isdir(f)]
setup(name=package_name, data_files=[('share/l', launch), ('share/c', config)])
""",
    "an entry point text": """\
setup(name=package_name, entry_points=\"\"\"
    [console_scripts]
    talker = my_pkg.nodes.talker:main
    # listener = my_pkg.nodes.listener:main
    [my.plugins]
    one = my_pkg.plugins:One
\"\"\")
""",
    "a dict of destinations": """\
files = {'launch': '*.py', 'config': '*.yaml'}
setup(name=package_name, data_files=[
    (f'share/{package_name}/{folder}', glob(f'{folder}/{pattern}')) for folder, pattern in files.items()
])
""",
    "zip and ternaries": """\
names, functions = ('a', 'b'), ('main', 'run')
setup(name=package_name, entry_points={
    'console_scripts': [n + ' = my_pkg.' + n + ':' + f for n, f in zip(names, functions)],
    'gui_scripts': ['c = my_pkg.c:main'] if len(names) > 1 else [],
})
""",
}
HEAD = """\
import os
from glob import glob
from pathlib import Path

from setuptools import find_namespace_packages, find_packages, setup

package_name = 'my_pkg'
"""


def really(text: str, folder: Path, monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """Return what setup() is given when this text of ours is run."""
    for path, content in FILES.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(content)
    given: list[dict[str, Any]] = []
    stand_in = types.ModuleType("setuptools")
    stand_in.__dict__.update(
        setup=lambda **named: given.append(named),
        find_packages=find_packages,
        find_namespace_packages=find_namespace_packages,
    )
    monkeypatch.chdir(folder)
    monkeypatch.setitem(sys.modules, "setuptools", stand_in)
    exec(compile(text, "setup.py", "exec"), {"__name__": "__main__", "__file__": str(folder / "setup.py")})
    (only,) = given
    return only


def pairs(entries: Any) -> list[tuple[str, str]]:
    return sorted((posixpath.normpath(into), source) for into, sources in entries or () for source in sources)


@pytest.mark.parametrize("idiom", IDIOMS)
def test_it_is_as_python_says(idiom: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = HEAD + IDIOMS[idiom]
    setup = one({**FILES, "setup.py": text}, SetupPy)
    folder = tmp_path / "<package>"
    folder.mkdir()
    real = really(text, folder, monkeypatch)
    assert not setup.unknown
    ours = [(e.destination.text, [f.setup_text.text for f in e.files]) for e in setup.data_entries if e.destination]
    assert pairs(ours) == pairs(real.get("data_files"))
    for name in ("packages", "py_modules", "scripts"):
        assert sorted(said.text for said in setup.texts(name)) == sorted(real.get(name, ()))
    for name in ("name", "version"):
        said = setup.setup_text(name)
        assert (said.text if said else None) == real.get(name)
    entries = real.get("entry_points", {})
    if isinstance(entries, dict):
        made = {(e.group, e.text) for e in setup.entry_points}
        assert made == {(group, text) for group, texts in entries.items() for text in texts}
    else:
        assert [e.group for e in setup.entry_points] == ["console_scripts", "my.plugins"]
