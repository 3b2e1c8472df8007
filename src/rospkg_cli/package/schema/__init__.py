"""The schema's verdict on a package.xml, explained."""
