package org.robotui.gl.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.FloatBuffer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

class MeshesTest {
  @Test
  void bodiesHaveTheVolumeOfTheirName() {
    assertEquals(1, volume(Meshes.cube()), 1e-6);
    assertEquals(Math.PI / 6, volume(Meshes.sphere()), 0.02);
    assertEquals(Math.PI / 6, volume(Meshes.coarseSphere()), 0.08);
    assertEquals(Math.PI / 4, volume(Meshes.cylinder()), 0.03);
    assertEquals(Math.PI / 12, volume(Meshes.cone()), 0.01);
  }

  @ParameterizedTest
  @MethodSource("all")
  void normalsAreOfUnitLengthAndLookOutOfTheTriangles(TriangleMesh mesh) {
    for (int i = 0; i < mesh.elements(); i++) {
      Vector3 across = across(mesh, i);
      assertTrue(across.norm() > 1e-6, "triangle " + i + " has no area");
      for (int k = 0; k < 3; k++) {
        Vector3 normal = at(mesh.normals().orElseThrow(), mesh.triangles().get(3 * i + k));
        assertEquals(1, normal.norm(), 1e-5);
        assertTrue(normal.dot(across) > 0, "triangle " + i + ", corner " + k);
      }
    }
  }

  @Test
  void theyReachAsFarAsTheySay() {
    assertBounds(Meshes.cube(), new Vector3(-0.5, -0.5, -0.5), new Vector3(0.5, 0.5, 0.5));
    assertBounds(Meshes.cylinder(), new Vector3(-0.5, -0.5, -0.5), new Vector3(0.5, 0.5, 0.5));
    assertBounds(Meshes.cone(), new Vector3(0, -0.5, -0.5), new Vector3(1, 0.5, 0.5));
    assertBounds(Meshes.arrow(), new Vector3(0, -1, -1), new Vector3(1, 1, 1));
    assertBounds(Meshes.arrow(2, 0.1, 1, 0.4), new Vector3(0, -0.2, -0.2), new Vector3(3, 0.2, 0.2));
    assertBounds(Meshes.quad(), Vector3.ZERO, new Vector3(1, 1, 0));
  }

  @Test
  void theSameObjectComesEachTime() {
    assertSame(Meshes.arrow(), Meshes.arrow());
    assertEquals(320, Meshes.sphere().elements());
    assertEquals(80, Meshes.coarseSphere().elements());
  }

  @Test
  void axesAreColouredAndOthersTakeTheMaterial() {
    assertTrue(Meshes.axes().rgba().isPresent());
    assertTrue(Meshes.cube().rgba().isEmpty());
  }

  @Test
  void placingsLeaveOutWhatIsNotFinite() {
    Vector3 one = new Vector3(1, 1, 1);
    Placings placings = new Placings(3)
        .add(RigidTransform.planar(1, 2, 0), one)
        .add(new RigidTransform(new Vector3(Double.NaN, 0, 0), Quaternion.IDENTITY), one)
        .add(RigidTransform.IDENTITY, one, Rgba.of(0xff0000));
    Instances instances = placings.of(Meshes.cube());
    assertEquals(2, instances.elements());
    assertEquals(0xff0000ff, instances.rgba().orElseThrow().getInt(4));
    assertEquals(-1, instances.rgba().orElseThrow().getInt(0));
    assertTrue(new Placings(0).of(Meshes.cube()).bounds().isEmpty());
  }

  static Stream<TriangleMesh> all() {
    return Stream.of(Meshes.cube(), Meshes.sphere(), Meshes.coarseSphere(), Meshes.cylinder(), Meshes.cone(),
        Meshes.disc(), Meshes.arrow(),
        Meshes.axes(), Meshes.quad(), Meshes.arrow(1, 0.1, 0.2, 0.3));
  }

  private static double volume(TriangleMesh mesh) {
    double sixfold = 0;
    for (int i = 0; i < mesh.elements(); i++) {
      sixfold += corner(mesh, i, 0).dot(corner(mesh, i, 1).cross(corner(mesh, i, 2)));
    }
    return sixfold / 6;
  }

  private static Vector3 across(TriangleMesh mesh, int triangle) {
    Vector3 a = corner(mesh, triangle, 0);
    return corner(mesh, triangle, 1).minus(a).cross(corner(mesh, triangle, 2).minus(a));
  }

  private static Vector3 corner(TriangleMesh mesh, int triangle, int corner) {
    return at(mesh.xyz(), mesh.triangles().get(3 * triangle + corner));
  }

  private static Vector3 at(FloatBuffer numbers, int corner) {
    return new Vector3(numbers.get(3 * corner), numbers.get(3 * corner + 1), numbers.get(3 * corner + 2));
  }

  private static void assertBounds(TriangleMesh mesh, Vector3 low, Vector3 high) {
    Box3 box = mesh.bounds().orElseThrow();
    assertEquals(0, box.low().minus(low).norm(), 1e-6, box.toString());
    assertEquals(0, box.high().minus(high).norm(), 1e-6, box.toString());
  }
}
