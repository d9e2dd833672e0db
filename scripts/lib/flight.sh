# Sourced by scripts/demo: a tour of a simulated world, flown live through the nodes in lockstep. Needs
# lib/processes.sh, lib/display.sh and the variables of scripts/demo.

# Who says what is in the images, and what of that is counted when the maps are compared with the world.
choose_labels() {
  networks=false
  counted=()
  if [[ "$labels" == renderer ]]; then
    say "labels and boxes are the renderer's, with errors put in:"
    scripts/describe_network_errors.py config/simulator.yaml | sed 's/^/  /'
    return
  fi
  networks=true
  say "networks: $(basename "$segmentation_card" .yaml), $(basename "$detection_card" .yaml)"
  if [[ "$segmentation_card" == "$own_segmentation" ]]; then counted+=(--voxel-classes training/classes/indoor.yaml); fi
  if [[ "$detection_card" == "$own_detection" ]]; then counted+=(--object-classes training/classes/furniture.yaml); fi
}

# What rviz shows: the whole building. The map begins where the tour does; the view in the file is the home's. Where the
# processor draws, it draws less often: it has better things to do.
choose_view() {
  local changes=()
  markers_period=1.0
  if [[ "$world" == office ]]; then
    changes+=(-e 's/^      Distance: .*/      Distance: 26/' -e 's/Focal Point: .*/Focal Point: {X: 5, Y: 1.2, Z: -1}/'
      -e 's/Yaw: .*/Yaw: 4.54/')
  fi
  if draws_on_processor; then
    changes+=(-e 's/Frame Rate: .*/Frame Rate: 1/')
    markers_period=5.0
  fi
  view="$work/view.rviz"
  sed -e '' "${changes[@]}" config/rviz/simulation.rviz > "$view"
}

# Waits for the end of the tour; on a terminal it shows how far the flight is.
watch_flight() {
  local watcher
  start scripts/watch_flight.py
  watcher="${groups[-1]}"
  while kill -0 "$watcher" 2> /dev/null; do
    if has_failed; then fail "the flight ended early: $(reason); see $log"; fi
    sleep 0.5
  done
  wait "$watcher" || fail "the flight did not come to its end; see $log"
}

# How far the maps are from the world: numbers for the table, and a picture.
evaluate_flight() {
  "$programs/evaluate_maps" "$world" "$output" "${counted[@]}" --json --plot "$output/evaluation.png" \
    > "$work/evaluation.json"
  mv "$work/evaluation.json" "$output/evaluation.json"
  pictures+=(evaluation.png)
}

fly_tour() {
  results+=(groundtruth.txt)
  [[ -n "$tour" ]] || tour="$repository/config/tours/$world.yaml"
  : "${segmentation_card:=$own_segmentation}" "${detection_card:=$own_detection}"
  choose_labels
  forget_results
  open_display
  choose_view
  say "flying $tour by the $pose pose"
  start_launch simulation.launch "world:=$world" "tour:=$tour" "pose:=$pose" rate:=0 exit_when_done:=false \
    "segmentation:=$networks" "detection:=$networks" "segmentation_card:=$segmentation_card" \
    "detection_card:=$detection_card" "output:=$output" rviz:=true "rviz_config:=$view" \
    "markers_period:=$markers_period"
  watch_flight
  finish_launch
  evaluate_flight
}
