"""XML with exact positions: elements, attributes, and errors."""
