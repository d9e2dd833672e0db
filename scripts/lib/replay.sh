# Sourced by scripts/demo: a recording through the nodes, at the sensor's rate. Needs lib/processes.sh, lib/display.sh
# and the variables of scripts/demo.

choose_config() {
  [[ -z "$config" ]] || return 0
  if [[ -f "$recording/camera.yaml" ]]; then
    config="$recording/camera.yaml"
  elif [[ "$(basename "$recording")" =~ (freiburg|fr)([123]) ]]; then
    config="$repository/config/tum_freiburg${BASH_REMATCH[2]}.yaml"
  else
    fail "the name of $recording does not tell the camera; give --config"
  fi
}

# Folders become bags, and the bags are kept.
choose_bag() {
  bag="$recording"
  if [[ -f "$bag" ]]; then return; fi
  bag="$output/cache/$(basename "$recording")-$(cksum <<< "$recording" | cut -d ' ' -f 1).bag"
  if [[ "$bag" -nt "$recording/rgb.txt" ]]; then return; fi
  say "making a bag of $recording"
  "$programs/tum_to_bag" "$recording" "$bag"
}

# Whether the network of a card is at hand.
has_network() {
  local file
  file="$(sed -n 's/^file: *//p' "$1")"
  [[ -f "${SEMANTIC_SLAM_SHARED:-$repository/../shared}/models/$file" || -f "$repository/models/$file" ]]
}

# Networks that were trained on photographs go first on recordings.
choose_networks() {
  if [[ -z "$segmentation_card" ]]; then
    segmentation_card="$own_segmentation"
    if has_network "$photo_segmentation"; then segmentation_card="$photo_segmentation"; fi
  fi
  if [[ -z "$detection_card" ]]; then
    detection_card="$own_detection"
    if has_network "$photo_detection"; then detection_card="$photo_detection"; fi
  fi
  say "networks: $(basename "$segmentation_card" .yaml), $(basename "$detection_card" .yaml)"
}

# rviz in memory takes what tracking needs where there are few cores.
choose_rate() {
  [[ -z "$rate" ]] || return 0
  rate=1
  if draws_on_processor && (($(nproc) < 4)); then rate=0.5; fi
}

is_played() { grep -q '\[bag-[0-9]*\] process has finished cleanly' "$log"; }

# Waits for the end of the bag; on a terminal it shows how far playing is.
watch_bag() {
  local recorded all begin=$SECONDS
  recorded="$(rosbag info --yaml --key=duration "$bag")"
  all="$(awk -v recorded="$recorded" -v rate="$rate" 'BEGIN { print int(recorded / rate) + 5 }')"  # start-up: 5 s
  until is_played; do
    if has_failed; then fail "playing ended early: $(reason); see $log"; fi
    ((SECONDS - begin < 2 * all + 60)) || fail "playing does not come to an end; see $log"
    if [[ -t 1 ]]; then printf '\rdemo: %d of about %d s ' $((SECONDS - begin)) "$all"; fi
    sleep 0.5
  done
  if [[ -t 1 ]]; then echo; fi
}

# The figure of camera, segmentation, cloud and map: replay keeps an image that shows much.
draw_overview() {
  say "drawing the overview"
  "$programs/replay" --dataset "$bag" --config "$config" --labels "$repository/config/labels.yaml" \
    --segmentation "$segmentation_card" --stages tracking,semantic --out "$work/overview" > "$work/replay.log" 2>&1 \
    || fail "replay failed: $(tail -n 1 "$work/replay.log")"
  mv "$work/overview/overview.png" "$output/overview.png"
  pictures+=(overview.png)
}

play_recording() {
  choose_bag
  choose_networks
  forget_results
  open_display
  choose_rate
  say "playing $bag at rate $rate"
  start_launch tum_replay.launch "bag:=$bag" "camera_config:=$config" \
    "segmentation_card:=$segmentation_card" \
    "detection_card:=$detection_card" "output:=$output" "rate:=$rate" rviz:=true exit_after_bag:=false
  watch_bag
  finish_launch
  draw_overview
}
