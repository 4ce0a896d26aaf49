"""Chapter 3: simplicial complexes; here the oriented surfaces that Edgebreaker walks on."""
