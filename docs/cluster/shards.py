#!/usr/bin/env python3
"""A verification, or a map, in shards, by Dask: shards.py ARMTOL SHARDS WORKERS ARGUMENT... prints the merged answer.

A worker that dies takes its shard with it; Dask gives that shard to another one, and the tallies that are there are
kept.
--kill N, before ARMTOL, kills the worker that draws shard N once, to show it. Here the workers are processes of this
machine: for a cluster, connect the Client to its scheduler. The workers have to share the folder.
"""
import os
import signal
import subprocess
import sys

from dask.distributed import Client, LocalCluster


def draw(armtol, arguments, shard, shards, kill):
    if kill and not os.path.exists("killed"):
        open("killed", "w").close()
        os.kill(os.getpid(), signal.SIGKILL)
    tally = f"tallies/{shard}"
    subprocess.run([armtol, *arguments, "--threads", "1", "--shard", f"{shard}/{shards}", "--tally", tally],
                   check=True, stdout=subprocess.DEVNULL)
    return tally


def main():
    words = sys.argv[1:]
    kill = 0
    if words[0] == "--kill":
        kill = int(words[1])
        words = words[2:]
    armtol, shards, workers, *arguments = words
    os.makedirs("tallies", exist_ok=True)
    with LocalCluster(n_workers=int(workers), threads_per_worker=1, dashboard_address=None) as cluster:
        with Client(cluster) as client:
            drawn = [client.submit(draw, armtol, arguments, shard, shards, shard == kill, pure=False)
                     for shard in range(1, int(shards) + 1)]
            tallies = client.gather(drawn)
    subprocess.run([armtol, "merge", *tallies], check=True)


if __name__ == "__main__":
    main()
