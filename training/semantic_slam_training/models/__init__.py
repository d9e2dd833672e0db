"""Networks, all with random weights at first. Third-party weights are never loaded."""
