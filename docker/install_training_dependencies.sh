#!/usr/bin/env bash
# Installs what training/ needs, from Debian 12's own package archive: about 50 MB to download, 340 MB on disk.
# Building and running semantic_slam needs none of it; without it the tests of training/ are skipped.
set -euo pipefail

packages=(
  python3-torch   # 1.13, for the CPU; a torch for GPUs from elsewhere serves as well
  python3-opencv  # reads images, and is the OpenCV that will run the networks
  python3-yaml
  python3-numpy
)

as_root=()
if ((EUID != 0)); then as_root=(sudo); fi
"${as_root[@]}" apt-get update -q
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -q -y --no-install-recommends "${packages[@]}"
