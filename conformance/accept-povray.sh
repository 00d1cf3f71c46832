#!/usr/bin/env bash
# Renders the reference of every scene whose PNG is missing (or of all, with --all) with POV-Ray 3.7 at 80 x 60.
# A first line `// options: ...` gives more switches. The scenes under errors/ have no references.
set -euo pipefail
cd "$(dirname "$0")"
size=(+W80 +H60)
for scene in */*.pov; do
    [[ $scene == errors/* ]] && continue
    png=${scene%.pov}.png
    [[ -e $png && ${1:-} != --all ]] && continue
    read -ra options < <(sed -n '1s,^// options: *,,p' "$scene") || true
    [[ " ${options[*]} " == *" +A"* ]] || options+=(-A)
    if ! (cd "$(dirname "$scene")" && povray "+I$(basename "$scene")" "+O$(basename "$png")" \
            "${size[@]}" "${options[@]}" -D +WT1 +FN >/dev/null 2>"/tmp/accept-$$.log"); then
        echo "FAILED $scene"
        grep -a -A3 'rror' "/tmp/accept-$$.log" | head -5
    fi
done
rm -f "/tmp/accept-$$.log"
