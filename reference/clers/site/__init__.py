"""The specification as a site: static pages to read and search, made of the same Markdown."""
