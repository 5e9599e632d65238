#!/usr/bin/env bash
# Opens the window on a virtual display with a software adapter, clicks through five scenes, drags a body, moves a
# slider, compares two settings, and takes a screenshot after each. Packages of Debian that are missing are installed.
#   crates/rapier_testbed3d/try-window.sh [FOLDER]      3D; DIM=2 for 2D
set -euo pipefail
cd "$(dirname "$0")/../.."

folder=${1:-target/try-window}
dim=${DIM:-3}
program=${CARGO_TARGET_DIR:-target}/release/all_examples$dim
mkdir -p "$folder"

needs=(xvfb xdotool imagemagick mesa-vulkan-drivers libgl1-mesa-dri libegl1 libvulkan1 libxkbcommon-x11-0 libxcursor1 libxi6 libxrandr2)
if ! command -v Xvfb xdotool import >/dev/null; then
    apt-get update && apt-get install --yes "${needs[@]}"
fi
[ -x "$program" ] || cargo build --release --bin "all_examples$dim"

export DISPLAY=:${TRY_DISPLAY:-97} XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-$(mktemp -d)} WGPU_BACKEND=${WGPU_BACKEND:-vulkan}
unset WAYLAND_DISPLAY
Xvfb "$DISPLAY" -screen 0 1360x840x24 &
display=$!
trap 'kill $window $display 2>/dev/null || true' EXIT
window=
sleep 1
"$program" --out "$folder/gallery" &
window=$!

shot() { import -window root "$folder/$1.png"; echo "$folder/$1.png"; }
# Without a window manager the window has no keyboard until it is given to it.
focus() { xdotool search --onlyvisible --name Testbed windowfocus; }
click() { xdotool mousemove "$1" "$2" sleep 0.5 click 1 sleep 0.5; }
# Drags from one place to another, slowly enough for a few frames a second.
drag() { xdotool mousemove "$1" "$2" sleep 0.5 mousedown 1 sleep 0.6 mousemove "$3" "$4" sleep 0.6 mouseup 1 sleep 0.6; }
# Chooses a scene through the search.
scene() {
    click 110 17; xdotool key ctrl+a sleep 0.3 type --delay 60 "$1"; sleep 1
    click 130 115; sleep "${2:-4}"
}

sleep "${START:-8}"
focus
shot 1-start

scene bridge; shot 2-bridge
scene dominoes; shot 3-dominoes
scene joints; shot 4-joints

# Drags a body: presses in the picture, moves in small steps, holds.
scene primitives 3
xdotool mousemove 600 420 mousedown 1
for i in $(seq 1 12); do xdotool mousemove $((600 + 8 * i)) $((420 - 18 * i)); sleep 0.1; done
sleep 1; shot 5-drag
xdotool mouseup 1

# Moves the slider of the speed, and goes back in time.
drag 543 801 500 801; shot 6-slow
drag 827 801 750 801; shot 7-back

# Two settings side by side, and the list of keys.
scene pyramid20 2
click 600 700; xdotool key c; sleep 4; shot 8-comparison
xdotool key h; sleep 1; shot 9-keys
xdotool key h
