"""XML with exact places: elements, attributes, and what is wrong with a document."""
