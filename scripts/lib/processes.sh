# Sourced by scripts/demo: programs in the background that go with the script, and the one launch file among them.
# Needs $log, where that writes, and $work, a temporary folder.

groups=()  # process groups that were started
launch=""  # the one that is watched

# wait_until SECONDS COMMAND...: fails if COMMAND has not succeeded by then.
wait_until() {
  local deadline=$((SECONDS + $1))
  shift
  until "$@"; do
    ((SECONDS < deadline)) || return 1
    sleep 0.2
  done
}

# Starts a program in the background, at the head of a process group that ends as a whole.
start() {
  set -m
  "$@" &
  set +m
  groups+=("$!")
}

has_gone() { ! kill -0 -- "-$1" 2> /dev/null; }

stop() {
  kill -INT -- "-$1" 2> /dev/null || return 0
  wait_until 20 has_gone "$1" || kill -KILL -- "-$1" 2> /dev/null || true
}

clean_up() {
  trap - EXIT INT TERM
  local index
  for ((index = ${#groups[@]} - 1; index >= 0; --index)); do stop "${groups[index]}"; done
  rm -rf "$work"
}

free_port() {
  /usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("localhost", 0)); print(s.getsockname()[1])'
}

# start_launch FILE ARGUMENT...: one of the package's launch files, with a ROS master of its own.
start_launch() {
  local port
  port="$(free_port)"
  export ROS_MASTER_URI="http://localhost:$port" ROS_HOSTNAME=localhost ROS_HOME="$work/ros"
  export PYTHONUNBUFFERED=1  # the log is watched
  start roslaunch --port "$port" semantic_slam "$@" > "$log" 2>&1
  launch="${groups[-1]}"
}

has_failed() { ! kill -0 "$launch" 2> /dev/null || grep -q 'process has died' "$log"; }

# The line of the log that tells most.
reason() { grep -E 'FATAL|ERROR|died|RLException|Invalid' "$log" | head -n 1 | sed 's/\x1b\[[0-9;]*m//g'; }
