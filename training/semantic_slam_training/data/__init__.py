"""Images and their truth, read from folders, varied at random, and put into batches."""
