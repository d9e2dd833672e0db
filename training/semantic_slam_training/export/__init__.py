"""Networks as OpenCV 4.6 and the rest of the package want them: ONNX, class names, model card."""
