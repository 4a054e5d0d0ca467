"""Scenes for POV-Ray and icespar alike, and what the two make of them."""
