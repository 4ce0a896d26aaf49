"""Chapter 4: operators on surfaces, each with its effect on components, genus and curves."""
