#!/usr/bin/env python3
"""A sweep as a job array of a real Slurm on this machine: a node dies, a task dies, the controller dies; nothing is lost, nothing is there twice.

    check.py EZY [--keep DIR]      EZY: the program; DIR: where its files stay

Starts a controller and two nodes of one core on the loopback, in a folder of its own. Needs Linux, root, and the packages slurm-wlm and
munge of Debian; without them it says so and checks nothing. Takes two to three minutes.
"""

import argparse
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

NODES = ("n1", "n2")
N_SHARES = 12
# 1,000 runs in parts of 25: each share has three or four parts
SWEEP = ["sweep", "ezyroller/driven", "--vary", "m0=1:5.9:0.1", "--vary", "omega=1:4.8:0.2", "--until", "UNTIL", "--keep", "C.x,seat.vx",
         "--part", "25"]
N_CASES = 1000
# seconds after which Slurm gives a silent node up
NODE_TIMEOUT = 10
PATIENCE_S = 300

CONFIGURATION = """
ClusterName=loop
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket
CredType=cred/munge
SlurmctldPort={port}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/controller.pid
SlurmdPidFile={folder}/%n.pid
SlurmctldLogFile={folder}/controller.log
SlurmdLogFile={folder}/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SchedulerType=sched/backfill
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SlurmdTimeout={timeout}
JobRequeue=1
NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={port1} CPUs=1 State=UNKNOWN
NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port={port2} CPUs=1 State=UNKNOWN
PartitionName=all Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
"""


def ran(*command, **options):
    """What a command prints."""
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True, **options).stdout


def free_ports(n):
    """Ports that nobody listens on."""
    sockets = [socket.socket() for _ in range(n)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Cluster:
    """Controller and nodes."""

    def __init__(self, folder):
        self.folder = folder
        folder.chmod(0o755)
        munge = folder / "munge"
        munge.mkdir()
        (munge / "key").write_bytes(os.urandom(1024))
        ran("chown", "-R", "munge:", munge)
        munge.chmod(0o755)
        (munge / "key").chmod(0o400)
        ran("runuser", "-u", "munge", "--", "munged", f"--key-file={munge}/key", f"--socket={munge}/socket", f"--pid-file={munge}/pid",
            f"--log-file={munge}/log", f"--seed-file={munge}/seed", "--force")
        for name in ("state", *(f"spool-{node}" for node in NODES)):
            (folder / name).mkdir()
        port, port1, port2 = free_ports(3)
        host = socket.gethostname().split(".")[0]
        self.configuration = folder / "slurm.conf"
        self.configuration.write_text(CONFIGURATION.format(folder=folder, host=host, port=port, port1=port1, port2=port2, timeout=NODE_TIMEOUT))
        os.environ["SLURM_CONF"] = str(self.configuration)
        self.start_controller()
        for node in NODES:
            self.start_node(node)
        self.wait("both nodes are idle", lambda: ran("sinfo", "-h", "-t", "idle", "-o", "%D").strip() == "2")

    def start_controller(self):
        ran("slurmctld", "-f", self.configuration)

    def start_node(self, node):
        file = self.folder / f"{node}.pid"
        file.unlink(missing_ok=True)
        ran("slurmd", "-f", self.configuration, "-N", node)
        self.wait(f"{node} runs", lambda: file.exists() and file.read_text().strip() != "")

    def kill_controller(self):
        """As by a power cut."""
        os.kill(int((self.folder / "controller.pid").read_text()), signal.SIGKILL)

    def processes(self, node):
        """Daemons and tasks of a node, and tasks alone."""
        all_of, tasks = [int((self.folder / f"{node}.pid").read_text())], []
        for entry in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                if f"SLURMD_NODENAME={node}".encode() in (entry / "environ").read_bytes().split(b"\0"):
                    tasks.append(int(entry.name))
                    status = (entry / "status").read_text()
                    parent = int(status.split("PPid:")[1].split()[0])
                    if pathlib.Path(f"/proc/{parent}/comm").read_text().startswith("slurmstepd"):
                        all_of.append(parent)
            except (OSError, IndexError):
                continue
        return all_of + tasks, tasks

    def kill_node(self, node):
        """As by a power cut: its daemon, its step daemons, its tasks."""
        for pid in self.processes(node)[0]:
            kill(pid)

    def n_tasks(self):
        """Tasks that wait or run; None when the controller does not answer."""
        done = subprocess.run(["squeue", "-h", "-r"], capture_output=True, text=True)
        return len(done.stdout.splitlines()) if done.returncode == 0 else None

    def wait(self, what, is_so):
        begin = time.time()
        while not is_so():
            if time.time() - begin > PATIENCE_S:
                raise SystemExit(f"FAILED: {what} does not come true in {PATIENCE_S} s")
            time.sleep(0.2)

    def stop(self):
        for pid in [pid for node in NODES for pid in self.processes(node)[0]]:
            kill(pid)
        for file in ("controller.pid", "munge/pid"):
            kill(int((self.folder / file).read_text()))


def kill(pid):
    """It may have ended."""
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


def files(folder):
    """Parts, complete ones and others, with their bytes."""
    return {path.name: path.read_bytes() for path in folder.glob("part-*")}


def n_rows(folder):
    """Rows that are whole lines, without headings."""
    return sum(max(content.count(b"\n") - 1, 0) for content in files(folder).values())


def check(ezy, folder):
    cluster = Cluster(folder)
    try:
        whole, out = folder / "whole", folder / "array"
        # as long as two nodes need about a minute
        begin = time.process_time() + os.times().children_user
        ran(ezy, *[word.replace("UNTIL", "60") for word in SWEEP], "--threads", "1", "--out", folder / "trial")
        seconds = os.times().children_user - begin
        until = str(max(60, round(60 * 80 / max(seconds, 0.1))))
        sweep = [word.replace("UNTIL", until) for word in SWEEP]
        print(f"{N_CASES} runs of {until} s in {N_SHARES} shares on {len(NODES)} nodes")
        printed = ran(ezy, *sweep, "--slurm", N_SHARES, "--out", out)
        submit = printed.split()
        assert submit[0] == "sbatch", printed
        ran(*submit)
        cluster.wait("rows are written", lambda: n_rows(out) > N_CASES // 20)

        # a node dies in mid-array
        before = n_rows(out)
        cluster.kill_node("n2")
        print(f"node n2 killed at {before} rows")
        cluster.wait("its task is queued again", lambda: "down" in ran("sinfo", "-h", "-n", "n2", "-o", "%T"))
        assert n_rows(out) >= before, "rows are lost"
        cluster.start_node("n2")
        cluster.wait("n2 works again", lambda: bool(cluster.processes("n2")[1]))

        # a task dies while it writes: Slurm counts it as failed, and does not queue it again
        before = n_rows(out)
        cluster.wait("the next row", lambda: n_rows(out) > before)
        for pid in cluster.processes("n1")[1]:
            kill(pid)
        print(f"task on n1 killed at {n_rows(out)} rows")

        # the controller dies, and comes back; tasks go on meanwhile
        cluster.kill_controller()
        before = n_rows(out)
        cluster.wait("tasks go on without a controller", lambda: n_rows(out) > before)
        cluster.start_controller()
        print(f"controller killed at {before} rows, back at {n_rows(out)}")

        cluster.wait("the array ends", lambda: cluster.n_tasks() == 0)
        missing = subprocess.run([str(ezy), "merge", str(out)], capture_output=True, text=True)
        print(f"after the array: {(missing.stderr or missing.stdout).splitlines()[0]}")
        assert missing.returncode == 1 and "parts are missing" in missing.stderr, missing
        ran(*submit)
        cluster.wait("the second array ends", lambda: cluster.n_tasks() == 0)

        print(f"after a second one: {ran(ezy, 'merge', out).splitlines()[0]}")
        ran(ezy, *sweep, "--out", whole)
        assert files(out) == files(whole), "the files are not those of a sweep on one machine"
        joined = folder / "joined.csv"
        ran(ezy, "merge", out, "--out", joined)
        cases = [int(line.split(",")[0]) for line in joined.read_text().splitlines()[1:]]
        assert cases == list(range(N_CASES)), "cases are missing, or there twice"
        logs = "".join(path.read_text() for path in sorted(out.glob("task-*.log")))
        computed = sum(int(line.split()[0]) for line in logs.splitlines() if "cases computed" in line)
        found = sum(int(line.split()[-3]) for line in logs.splitlines() if line.endswith("were there"))
        print(f"tasks that came to their end computed {computed} cases and found {found}; {N_CASES} in all, the same bytes as on one machine")
    finally:
        cluster.stop()


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("ezy", type=pathlib.Path)
    arguments.add_argument("--keep", type=pathlib.Path)
    arguments = arguments.parse_args()
    absent = [name for name in ("slurmctld", "slurmd", "sbatch", "munged", "runuser") if not shutil.which(name)]
    if absent or os.geteuid() != 0:
        print(f"skipped: {', '.join(absent) + ' not at hand' if absent else 'it takes root'}")
        return
    folder = arguments.keep or pathlib.Path(tempfile.mkdtemp(prefix="ezy-slurm-"))
    folder.mkdir(parents=True, exist_ok=True)
    try:
        check(arguments.ezy.resolve(), folder.resolve())
        print("0 failed")
    finally:
        if not arguments.keep:
            shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    sys.exit(main())
