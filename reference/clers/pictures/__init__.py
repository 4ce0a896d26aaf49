"""Pictures of the Edgebreaker walk, in the manner of the tutorial's Figures 14 to 23."""
