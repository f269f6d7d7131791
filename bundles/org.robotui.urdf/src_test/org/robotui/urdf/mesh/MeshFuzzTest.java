package org.robotui.urdf.mesh;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.urdf.Mutator;

/** Whatever bytes come, the answer is a mesh that is whole, or words. */
class MeshFuzzTest {
  private static final int ROUNDS = 1500;

  @Test
  void brokenFilesAreRefusedInWordsOrReadWhole() {
    Map<String, byte[]> samples =
        Map.of("a.stl", MeshSamples.bytes(MeshSamples.ASCII_STL), "b.stl", MeshSamples.binaryStl(4, 4),
            "c.obj", MeshSamples.bytes(MeshSamples.OBJ), "d.dae", MeshSamples.triangles());
    Random random = new Random(20261122);
    samples.forEach((name, bytes) -> {
      for (int round = 0; round < ROUNDS; round++) {
        byte[] broken = Mutator.bytes(bytes, random);
        int number = round;
        MeshRead read =
            assertDoesNotThrow(() -> MeshReader.read(name, broken, MeshSamples::mtl), () -> name + " round " + number);
        if (read instanceof MeshRead.Ok ok) {
          assertWhole(ok.mesh());
        }
      }
    });
  }

  private static void assertWhole(Mesh mesh) {
    int corners = mesh.xyz().remaining() / 3;
    for (int i = 0; i < mesh.triangles().remaining(); i++) {
      assertTrue(mesh.triangles().get(i) >= 0 && mesh.triangles().get(i) < corners);
    }
    for (int i = 0; i < mesh.normals().remaining(); i++) {
      assertTrue(Float.isFinite(mesh.normals().get(i)) && Float.isFinite(mesh.xyz().get(i)));
    }
  }
}
