#!/usr/bin/env bash
# Includes point downwards; see layers.py.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/layers.py"
