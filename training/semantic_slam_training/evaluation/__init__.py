"""How good a network is, measured while it trains; the programs evaluate_* have the last word."""
