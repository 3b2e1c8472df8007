"""Rules of package.xml (XML)."""
