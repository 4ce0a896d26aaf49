"""The corpus: real meshes with their sources and licences, verified, or fetched when wanted."""
