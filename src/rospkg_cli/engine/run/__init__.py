"""One run: read, link, check, build findings; in one process or several."""
