# Sourced by scripts/demo: where rviz draws, and a picture of it. Needs lib/processes.sh and $work.

# The display that there is, or one in memory, where Mesa draws for rviz on the processor.
open_display() {
  if [[ -n "${DISPLAY-}" ]] && xdpyinfo > /dev/null 2>&1; then return; fi
  start Xvfb -displayfd 3 -screen 0 1920x1080x24 -nolisten tcp 3> "$work/display" 2> "$work/xvfb.log"
  wait_until 20 test -s "$work/display" || fail "Xvfb does not start: $(tail -n 1 "$work/xvfb.log")"
  DISPLAY=":$(< "$work/display")"
  export DISPLAY LIBGL_ALWAYS_SOFTWARE=1
  say "there is no display: rviz draws in memory, on the processor"
}

draws_on_processor() { [[ -n "${LIBGL_ALWAYS_SOFTWARE-}" ]]; }

# photograph_rviz PICTURE.png
photograph_rviz() {
  local id geometry
  id="$(xwininfo -root -tree | awk '/- RViz"/ { print $1; exit }')"
  [[ -n "$id" ]] || fail "rviz has no window; see $log"
  geometry="$(xwininfo -id "$id" | awk '
    /Absolute upper-left X/ { x = $NF } /Absolute upper-left Y/ { y = $NF }
    /Width:/ { w = $NF } /Height:/ { h = $NF } END { print x "," y "," w "," h }')"
  scrot --autoselect "$geometry" --overwrite "$work/rviz.png"
  mv "$work/rviz.png" "$1"
}
