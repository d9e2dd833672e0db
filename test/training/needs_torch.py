"""Imported first by every test of training/: skips it where torch is not installed."""

import os

import pytest

REASON = "training is not tested: docker/install_training_dependencies.sh installs what it needs"

os.environ.setdefault("OMP_WAIT_POLICY", "passive")  # cores are shared with other tests
torch = pytest.importorskip("torch", reason=REASON)
cv2 = pytest.importorskip("cv2", reason=REASON)
pytest.importorskip("yaml", reason=REASON)
torch.set_num_threads(1)
cv2.setNumThreads(1)
