"""Nothing of a linted tree is executed or imported, no socket is opened, and no process started but git by `new`."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

FORMATS = "text concise json sarif github gitlab junit markdown rdjson html".split()
COMMANDS = [
    ["lint", *(word for name in FORMATS for word in ("--output", f"{name}:{os.devnull}"))],
    ["lint", "--pedantic", "--release", "--jobs", "2", "--traceback"],
    ["lint", "--diff"],
    ["lint", "--fix", "--unsafe-fixes"],
    ["lint", "--add-ignores", "for now"],
    ["format"],
    ["inspect"],
    ["inspect", "--format", "json"],
    ["graph"],
    ["doctor"],
    ["explain", "XML104"],
    ["rules"],
    ["index", "status"],
    ["new", "other_pkg", "--into", ".."],
]

RAN = "import os\nopen(os.environ['RAN'], 'a').write(__file__ + '\\n')\n"
"""What a hostile module does."""

SHADOWS = (
    "typer yaml rich click jinja2 lxml tomllib json tempfile multiprocessing concurrent rospkg sitecustomize".split()
)

HOOK = """
import os, sys
root, log = os.environ["LINTED"], open(os.environ["AUDIT"], "a", buffering=1)
inside = lambda name: isinstance(name, str) and name[:1] != "<" and os.path.realpath(name).startswith(root + os.sep)
def hook(event, arguments):
    if event == "exec" and inside(arguments[0].co_filename):
        log.write(f"exec {arguments[0].co_filename}\\n")
    elif event == "import" and inside(arguments[1]):
        log.write(f"import {arguments[0]} {arguments[1]}\\n")
    elif event.startswith(("socket.connect", "socket.bind", "socket.getaddrinfo")):
        log.write(f"{event} {arguments}\\n")
    elif event in ("subprocess.Popen", "os.exec", "os.posix_spawn", "os.system"):
        log.write(f"process {arguments[0]}\\n")
    elif event == "os.fork":
        log.write("fork\\n")
sys.addaudithook(hook)
import atexit
def modules():
    for name, module in list(sys.modules.items()):
        if inside(getattr(module, "__file__", None)):
            log.write(f"module {name}\\n")
atexit.register(modules)
"""


@pytest.fixture
def hostile(tmp_path: Path, write, clean) -> Path:
    """A package in which every file that Python, CMake or pytest could run tells when it is run."""
    evil = dict.fromkeys(
        [
            *(
                "conftest.py",
                "my_pkg/conftest.py",
                "my_pkg/evil.py",
                "launch/a.launch.py",
                "test/test_a.py",
                "__init__.py",
            ),
            *("__main__.py", "doc/conf.py", "noxfile.py", "_distutils_hack/__init__.py", "evil_rules.py"),
            *(f"{name}.py" for name in SHADOWS if name not in ("rich", "concurrent", "multiprocessing")),
            *(f"{name}/__init__.py" for name in ("rich", "concurrent", "multiprocessing")),
        ],
        RAN,
    )
    setup = RAN + clean["setup.py"].replace("packages=", "scripts=[__import__('evil').x, open(1)],\n    packages=")
    others = {
        "setup.py": setup,
        "my_pkg/__init__.py": RAN,
        "CMakeLists.txt": "execute_process(COMMAND touch ran)\nfile(WRITE ran x)\ninclude(evil.cmake)\n",
        "evil.cmake": "execute_process(COMMAND touch ran)\n",
        "launch/b.launch.xml": "<launch><executable cmd='touch ran'/><arg name='a' default='$(eval x)'/></launch>",
        "launch/c.launch.yaml": "launch:\n- executable: {cmd: touch ran}\n- arg: {name: !!python/name:os.system x}\n",
        "config/p.yaml": "a: !!python/object/apply:os.system [touch ran]\n",
        "urdf/a.urdf.xacro": "<robot xmlns:xacro='x' name='${__import__(\"os\").system(\"touch ran\")}'/>",
        "pyproject.toml": "[build-system]\nbuild-backend = 'evil'\nbackend-path = ['.']\n",
        "evil-1.0.dist-info/METADATA": "Metadata-Version: 2.1\nName: evil\nVersion: 1.0\n",
        "evil-1.0.dist-info/entry_points.txt": "[rospkg_cli.rules]\nevil = evil_rules\n",
        "evil.pth": "import evil_rules\n",
        ".git/hooks/post-checkout": "#!/bin/sh\ntouch ran\n",
    }
    return write(tmp_path / "ws/my_pkg", {**clean, **evil, **others})


def audited(command: list[str], cwd: Path, tmp_path: Path, first: str = "") -> list[str]:
    """Run a command under an audit hook; return what the hook and the hostile modules have written."""
    code = (
        f"{HOOK}\nsys.argv = ['rospkg', *{command!r}]\n{first}\nfrom rospkg_cli.__main__ import main; sys.exit(main())"
    )
    own = {"RAN": str(tmp_path / "ran"), "AUDIT": str(tmp_path / "audit"), "LINTED": str((tmp_path / "ws").resolve())}
    environment = {**os.environ, **own, "XDG_CACHE_HOME": str(tmp_path / "cache")}
    (tmp_path / "audit").touch()
    (tmp_path / "hook.py").write_text(code)
    done = subprocess.run(
        [sys.executable, str(tmp_path / "hook.py")], cwd=cwd, env=environment, capture_output=True, text=True
    )
    assert "Traceback" not in done.stderr, done.stderr
    assert "internal error" not in done.stderr
    written = [path for path in (tmp_path / "ran", tmp_path / "audit") if path.exists()]
    return [line for path in written for line in path.read_text().splitlines()]


def test_the_hook_sees_what_runs(hostile: Path, tmp_path: Path) -> None:
    first = "sys.path.insert(0, os.getcwd()); import evil_rules, subprocess, socket; subprocess.run(['true'])"
    found = audited(["rules"], hostile, tmp_path, f"{first}\nsocket.socket().bind(('127.0.0.1', 0))")
    assert f"{hostile}/evil_rules.py" in found
    assert f"exec {hostile}/evil_rules.py" in found
    assert "module evil_rules" in found
    assert "process true" in found
    assert any(line.startswith("socket.bind") for line in found)


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_nothing_of_a_linted_tree_runs(hostile: Path, tmp_path: Path, command: list[str]) -> None:
    found = [line for line in audited(command, hostile, tmp_path) if line != "fork"]
    of_new = ["process git"] if command[0] == "new" else []
    assert [line for line in found if line not in of_new] == []
    assert not list(hostile.rglob("ran"))


def started(arguments: list[str], cwd: Path, tmp_path: Path, **more: str) -> tuple[str, list[str]]:
    """Start Python without a hook; return its output, and what hostile modules have written."""
    environment = {**os.environ, "RAN": str(tmp_path / "ran"), **more}
    done = subprocess.run([sys.executable, *arguments], cwd=cwd, env=environment, capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    return done.stdout, (tmp_path / "ran").read_text().splitlines() if (tmp_path / "ran").exists() else []


def forget_what_python_imports(folder: Path) -> None:
    """Remove what Python itself would import, before anything of ours is there (the latter by a .pth of setuptools)."""
    (folder / "sitecustomize.py").unlink()
    (folder / "_distutils_hack/__init__.py").unlink()
    (folder / "_distutils_hack").rmdir()


def with_current_folder() -> str:
    """Return PYTHONPATH with an empty entry at its end: the current folder."""
    return os.pathsep.join([*filter(None, [os.environ.get("PYTHONPATH", "")]), os.devnull, ""])


@pytest.mark.parametrize("how", ["-m", "empty entry"])
def test_modules_in_the_current_folder_are_not_ours(hostile: Path, tmp_path: Path, how: str) -> None:
    forget_what_python_imports(hostile)
    (tmp_path / "rospkg").write_text("import sys\nfrom rospkg_cli.__main__ import main\nsys.exit(main())\n")
    (hostile / "rospkg.toml").write_text("pedantic = true\n")
    command = ["lint", "--format", "json"]
    if how == "-m":
        shown, ran = started(["-m", "rospkg_cli", *command], hostile, tmp_path)
    else:
        shown, ran = started([str(tmp_path / "rospkg"), *command], hostile, tmp_path, PYTHONPATH=with_current_folder())
    assert ran == []
    assert json.loads(shown)["findings"]


def test_a_plugin_in_the_current_folder_is_not_installed(hostile: Path, tmp_path: Path) -> None:
    forget_what_python_imports(hostile)
    (hostile / "rospkg.toml").write_text('plugins = ["evil"]\n')
    environment = {**os.environ, "RAN": str(tmp_path / "ran"), "PYTHONPATH": with_current_folder()}
    done = subprocess.run(
        [sys.executable, "-m", "rospkg_cli", "lint"], cwd=hostile, env=environment, capture_output=True, text=True
    )
    assert (done.returncode, done.stdout) == (2, "")
    assert "there is no plugin `evil`" in done.stderr
    assert not (tmp_path / "ran").exists()


def many(folder: Path, write, clean) -> None:
    for number in range(44):
        files = {path: text.replace("my_pkg", f"pkg_{number}") for path, text in clean.items()}
        write(folder / f"pkg_{number}", {path.replace("my_pkg", f"pkg_{number}"): text for path, text in files.items()})


def test_no_worker_runs_it_either(hostile: Path, tmp_path: Path, write, clean) -> None:
    many(hostile.parent, write, clean)
    command = ["lint", "--jobs", "2", "--format", "json"]
    assert set(audited(command, hostile.parent, tmp_path)) == {"fork"}


@pytest.mark.skipif(sys.version_info < (3, 11), reason="Python 3.10 starts workers with the current folder in its path")
def test_a_worker_that_is_spawned_does_not_look_there(hostile: Path, tmp_path: Path, write, clean) -> None:
    many(hostile.parent, write, clean)
    write(hostile.parent, {"multiprocessing/__init__.py": RAN, "yaml.py": RAN})
    (tmp_path / "program.py").write_text(
        "import sys\nfrom rospkg_cli.__main__ import main\n"
        "from rospkg_cli.search_path import leave_out_current_folder\n"
        "if __name__ == '__main__':\n    leave_out_current_folder()\n"
        "    import multiprocessing\n    multiprocessing.set_start_method('spawn')\n    sys.exit(main())\n"
    )
    command = [str(tmp_path / "program.py"), "lint", "--jobs", "2", "--format", "json"]
    shown, ran = started(command, hostile.parent, tmp_path, PYTHONPATH=with_current_folder())
    assert ran == []
    assert "my_pkg" in shown
