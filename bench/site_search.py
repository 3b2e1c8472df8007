"""Whether the search of the built site leads from what was printed to the page of symptoms, in a real browser.

    .venv/bin/pip install -e '.[docs,test]' && .venv/bin/python -m bench.site_search [FILE…]

Typed are the headings of docs/symptoms.md, the parts of messages of tests/test_symptoms.py, whole messages with names
of somebody's own, and each line of the files.
Told are those for which none of the first results is on that page, or none is there at all.
"""

from __future__ import annotations

import functools
import re
import subprocess
import sys
import tempfile
import threading
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from urllib.parse import quote

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT / "tests/real"), str(ROOT / "tests")]
FIRST = 3
WHOLE = (
    'Could not find a package configuration file provided by "our_robot_things" with any of the following names:',
    """[ERROR] [launch]: Caught exception in launch: "package 'our_robot' not found, searching: ['/opt/ros/jazzy']\"""",
    "file 'up.launch.py' was not found in the share directory of package 'our_robot' which is at '/ws/install'",
    "ModuleNotFoundError: No module named 'our_robot.driver'",
    "error: option --editable not recognized",
)
LINKS = "return [...document.querySelectorAll('.md-search-result__link')].map((link) => link.href)"
DONE = "return !/Initializing|Type to start/.test(document.querySelector('.md-search-result__meta').textContent)"


class QuietHandler(SimpleHTTPRequestHandler):
    def log_message(self, format: str, *args: object) -> None:
        pass


def symptoms(files: list[str]) -> list[str]:
    from test_symptoms import SEARCHED  # type: ignore[import-not-found]

    page = (ROOT / "docs/symptoms.md").read_text("utf-8")
    lines = [line for file in files for line in Path(file).read_text("utf-8").splitlines() if line.strip()]
    return list(dict.fromkeys([*re.findall(r"^### `(.*)`$", page, re.MULTILINE), *SEARCHED, *WHOLE, *lines]))


def main() -> int:
    from chromium import started_browser  # type: ignore[import-not-found]

    with tempfile.TemporaryDirectory() as folder, started_browser() as browser:
        subprocess.run(["mkdocs", "build", "--strict", "--site-dir", folder], cwd=ROOT, check=True)
        server = ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(QuietHandler, directory=folder))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        phrases, missed = symptoms(sys.argv[1:]), 0
        for phrase in phrases:
            browser.driver.get(f"http://127.0.0.1:{server.server_port}/?q={quote(phrase)}")
            browser.wait(lambda: browser.run(DONE))
            pages = list(dict.fromkeys(link.partition("#")[0].partition("?")[0] for link in browser.run(LINKS)))
            place = next((at for at, link in enumerate(pages, 1) if link.endswith("/symptoms/")), 0)
            if not 0 < place <= FIRST:
                missed += 1
                print(f"{f'{place}th' if place else 'not found'} of {len(pages)} pages: {phrase}")
        server.shutdown()
    print(f"{len(phrases) - missed} of {len(phrases)} messages lead to the symptoms among the first {FIRST} pages")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
