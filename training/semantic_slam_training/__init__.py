"""Trains the networks of semantic_slam: segmentation, detection and appearance, from nothing."""
