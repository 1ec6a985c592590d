#!/usr/bin/env bash
# Builds Vantage and lets it scan the sample mug: takes views with the simulated scanner until nothing is left to see,
# and writes the model. Arguments go to `vantage-cli acquire`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/install_dependencies.sh
source packaging/build.sh

install_dependencies
build_release vantage-cli
build/release/bin/vantage-cli acquire --object resources/objects/mug.ply \
  --scanner resources/scanners/rotating_stripe.json --out out/mug --threads "$(nproc)" "$@"

echo
echo "The sample mug was scanned:"
for file in model.ply model.stl report.json session.vantage; do
  if [[ -e out/mug/$file ]]; then echo "  $PWD/out/mug/$file"; fi
done
