#!/usr/bin/python3
"""Plays a bag through the nodes and prints what each of them costs: processor time, memory, drops.

  benchmark/node_load.py BAG [--json] [ARGUMENT:=VALUE...]

Every stage runs as a process of its own, so that its share can be told; the arguments go to
tum_replay.launch. Source build/devel/setup.bash first.
"""

import argparse
import json
import os
import pathlib
import re
import socket
import subprocess
import sys
import tempfile
import time

TICKS_PER_S = os.sysconf("SC_CLK_TCK")


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


class Node:
    """One process of the graph, as /proc tells of it."""

    def __init__(self, pid, name):
        self.pid, self.name = pid, name
        self.cpu_s = 0.0
        self.peak_mb = 0.0

    def look(self):
        """Reads the counters; False once the process has gone."""
        try:
            fields = pathlib.Path(f"/proc/{self.pid}/stat").read_text().rsplit(")", 1)[1].split()
            status = pathlib.Path(f"/proc/{self.pid}/status").read_text()
        except OSError:
            return False
        self.cpu_s = (int(fields[11]) + int(fields[12])) / TICKS_PER_S
        peak = re.search(r"VmHWM:\s+(\d+) kB", status)
        if peak:
            self.peak_mb = int(peak[1]) / 1024
        return True


def nodes_of(master):
    """The processes that roslaunch has started for this master, by pid."""
    found = {}
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            command = (folder / "cmdline").read_bytes().split(b"\0")
            environment = (folder / "environ").read_bytes()
        except OSError:
            continue
        name = next((word[8:].decode() for word in command if word.startswith(b"__name:=")), None)
        if name and f"ROS_MASTER_URI={master}".encode() in environment:
            found[int(folder.name)] = Node(int(folder.name), name)
    return found


def listen_to_diagnostics():
    """The newest values by node, filled in the background."""
    import diagnostic_msgs.msg
    import rospy

    latest = {}

    def keep(message):
        for status in message.status:
            latest[status.name] = {value.key: value.value for value in status.values}

    rospy.init_node("node_load", anonymous=True, disable_signals=True)
    rospy.Subscriber("/diagnostics", diagnostic_msgs.msg.DiagnosticArray, keep, queue_size=100)
    return latest


def measure(bag, arguments):
    """Plays `bag` and returns (nodes, diagnostics, seconds)."""
    port = free_port()
    master = f"http://localhost:{port}"
    os.environ.update(ROS_MASTER_URI=master, ROS_HOSTNAME="localhost")
    command = ["roslaunch", "--port", str(port), "semantic_slam", "tum_replay.launch", f"bag:={bag}",
               "nodelet:=false", *arguments]
    with tempfile.TemporaryFile() as log:
        launch = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT)
        begin = time.monotonic()
        try:
            wait_for(port)
            diagnostics = listen_to_diagnostics()
            nodes = {}
            while launch.poll() is None:
                for pid, node in nodes_of(master).items():
                    nodes.setdefault(pid, node)
                for node in nodes.values():
                    node.look()
                time.sleep(0.25)
        finally:
            if launch.poll() is None:
                launch.terminate()
        if launch.returncode != 0:
            log.seek(0)
            sys.exit("node_load.py: roslaunch failed\n" + log.read().decode(errors="replace")[-2000:])
    return list(nodes.values()), diagnostics, time.monotonic() - begin


def wait_for(port):
    deadline = time.monotonic() + 30
    while time.monotonic() < deadline:
        with socket.socket() as probe:
            if probe.connect_ex(("localhost", port)) == 0:
                return
        time.sleep(0.1)
    sys.exit("node_load.py: roslaunch does not start")


def report(nodes, diagnostics, seconds):
    rows = []
    for node in sorted(nodes, key=lambda node: -node.cpu_s):
        values = next((v for name, v in diagnostics.items() if name.split(":")[0].strip("/ ") == node.name), {})
        rows.append({
            "node": node.name,
            "cpu_s": round(node.cpu_s, 1),
            "cores": round(node.cpu_s / seconds, 2),
            "peak_mb": round(node.peak_mb),
            "latency_median_ms": values.get("latency median [ms]"),
            "latency_95_ms": values.get("latency 95 % [ms]"),
            "dropped": {key[len("dropped: "):]: int(value) for key, value in values.items()
                        if key.startswith("dropped: ")},
        })
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bag")
    parser.add_argument("arguments", nargs="*", metavar="ARGUMENT:=VALUE")
    parser.add_argument("--json", action="store_true")
    given = parser.parse_args()
    if not pathlib.Path(given.bag).is_file():
        sys.exit(f"node_load.py: no such file: {given.bag}")
    rows = report(*measure(os.path.abspath(given.bag), given.arguments))
    if given.json:
        print(json.dumps(rows, indent=2))
        return
    print(f"{'node':<22} {'CPU s':>7} {'cores':>6} {'peak MB':>8} {'median ms':>10} {'95 % ms':>8}  dropped")
    for row in rows:
        drops = ", ".join(f"{count} {cause}" for cause, count in row["dropped"].items())
        print(f"{row['node']:<22} {row['cpu_s']:>7.1f} {row['cores']:>6.2f} {row['peak_mb']:>8} "
              f"{row['latency_median_ms'] or '':>10} {row['latency_95_ms'] or '':>8}  {drops}")


if __name__ == "__main__":
    main()
