"""One run: read, link, check, stamp; in one process or several."""
