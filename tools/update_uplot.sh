#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fetches uPlot, which draws the plots of report.html, and replaces src/report/web/uplot/. Needs npm; nothing else does.
# For another version change the two lines below: `npm view uplot@VERSION dist.integrity` prints the checksum.
set -euo pipefail
version=1.6.32
integrity=sha512-KIMVnG68zvu5XXUbC4LQEPnhwOxBuLyW1AHtpm6IKTXImkbLgkMy+jabjLgSLMasNuGGzQm/ep3tOkyTxpiQIw==

root=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm pack --silent "uplot@$version" >/dev/null
found=sha512-$(openssl dgst -sha512 -binary "uplot-$version.tgz" | openssl base64 -A)
if [[ $found != "$integrity" ]]; then
  echo "uplot-$version.tgz: the checksum is $found, not $integrity; nothing was replaced" >&2
  exit 1
fi
tar xzf "uplot-$version.tgz"
cp package/dist/uPlot.iife.min.js package/dist/uPlot.min.css package/LICENSE "$root/src/report/web/uplot/"
echo "src/report/web/uplot: uPlot $version"
