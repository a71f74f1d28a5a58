"""How long a mesh of a million triangles takes from its file, in the child process, beside trimesh.

Run with ``pytest tests/bench/test_meshes_bench.py --benchmark-enable -s``.
"""

import io
import resource
import time
from pathlib import Path

import numpy as np
import pytest
import trimesh

from tests.bench.waves import wavy_sphere
from workbench.exchange.meshes import obj, ply
from workbench.exchange.reading import Job, Reading

HEAD = """ply
format binary_little_endian 1.0
element vertex {vertices}
property float x
property float y
property float z
element face {faces}
property list uchar int vertex_indices
end_header
"""


def binary_ply(mesh):
    triangles = mesh.faces.corners.reshape(-1, 3)
    rows = np.zeros(len(triangles), [("count", "u1"), ("corners", "<i4", 3)])
    rows["count"], rows["corners"] = 3, triangles
    head = HEAD.format(vertices=len(mesh.vertices), faces=len(triangles)).encode()
    return head + mesh.vertices.astype("<f4").tobytes() + rows.tobytes()


WRITERS = {"binary.ply": binary_ply, "text.ply": lambda mesh: ply(*mesh), "text.obj": lambda mesh: obj(*mesh)}


def worked_by_children():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def peak_of_children():
    """The largest memory of a child so far, MB; 0 where the system does not tell."""
    texts = [file.read_text() for file in Path("/proc/self/task").glob("*/children")]
    lines = [Path(f"/proc/{child}/status").read_text() for text in texts for child in text.split()]
    return max((int(line.split("VmHWM:")[1].split()[0]) / 1024 for line in lines), default=0.0)


@pytest.mark.parametrize(("name", "allowed"), [("binary.ply", 1.5), ("text.ply", 5), ("text.obj", 4)])
def test_a_mesh_is_read(benchmark, tmp_path, name, allowed):
    """Wall time, processor time of the child and trimesh's, the child's largest memory so far."""
    mesh = wavy_sphere(1_000_000 if not benchmark.disabled else 1_000)
    content = WRITERS[name](mesh)
    path = tmp_path / name
    path.write_bytes(content)
    shares, peaks = [], []

    def follow(share):
        shares.append(share)
        peaks.append(peak_of_children())

    worked = worked_by_children()
    start = time.perf_counter()
    read = benchmark.pedantic(lambda: Reading(Job("mesh", str(path))).follow(follow), rounds=1)
    took = time.perf_counter() - start
    after = worked_by_children()
    assert np.array_equal(read.mesh.faces.corners, mesh.faces.corners)
    assert len(shares) > 1 or benchmark.disabled
    work = time.process_time()
    trimesh.load(io.BytesIO(content), file_type=path.suffix[1:], process=False)
    peer = time.process_time() - work
    print(f"\n{name}, {len(mesh.faces):,} triangles: {took:.2f} s, {allowed} allowed; the child worked")
    print(f"{after - worked:.2f} s, trimesh {peer:.2f}, ratio {peer / (after - worked):.2f}")
    print(f"the child took {max(peaks, default=0):.0f} MB, 1,200 allowed")
    benchmark.extra_info.update(seconds=took, child=after - worked)
