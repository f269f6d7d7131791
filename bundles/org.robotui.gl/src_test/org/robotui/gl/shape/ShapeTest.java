package org.robotui.gl.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

class ShapeTest {
  private static final FloatBuffer TWO = FloatBuffer.wrap(new float[]{0, 0, 0, 1, 2, 3});

  @Test
  void aBoxHoldsTheFinitePointsOnly() {
    FloatBuffer xyz = FloatBuffer.wrap(new float[]{Float.NaN, 9, 9, 1, 2, 3, -1, 0, Float.POSITIVE_INFINITY, -1, 5, 0});
    assertEquals(Optional.of(new Box3(new Vector3(-1, 2, 0), new Vector3(1, 5, 3))), Box3.around(xyz));
    assertEquals(Optional.empty(), Box3.around(FloatBuffer.wrap(new float[]{Float.NaN, 0, 0})));
  }

  @Test
  void aTurnedBoxIsWiderAndHoldsItsCorners() {
    Box3 box = new Box3(new Vector3(-1, -1, 0), new Vector3(1, 1, 1));
    Box3 turned = box.in(RigidTransform.planar(10, 0, Math.PI / 4));
    assertEquals(10 + Math.sqrt(2), turned.high().x(), 1e-12);
    assertEquals(new Vector3(10, 0, 0.5).x(), turned.center().x(), 1e-12);
    assertEquals(1, turned.high().z(), 1e-12);
  }

  @Test
  void sizesThatDoNotFitAreRefused() {
    Optional<ByteBuffer> three = Optional.of(ByteBuffer.allocate(12));
    assertThrows(IllegalArgumentException.class, () -> PointSet.of(TWO, three, 1, PointSet.Unit.PIXELS));
    assertThrows(IllegalArgumentException.class, () -> LineSet.of(LineSet.Kind.STRIP, 1, 1, 2));
    assertThrows(IllegalArgumentException.class, () -> new Texture(2, 2, ByteBuffer.allocate(15), false));
    assertThrows(IllegalArgumentException.class, () -> new Texture(Texture.MOST + 1, 1, ByteBuffer.allocate(4), false));
  }

  @Test
  void anIndexOutsideTheCornersIsRefused() {
    IntBuffer outside = IntBuffer.wrap(new int[]{0, 1, 2});
    assertThrows(IllegalArgumentException.class, () -> TriangleMesh.of(TWO, Optional.empty(), outside));
    assertThrows(IllegalArgumentException.class,
        () -> TriangleMesh.of(TWO, Optional.empty(), IntBuffer.wrap(new int[]{0, -1, 1})));
  }

  @Test
  void elementsAreWhatCanBePicked() {
    assertEquals(2, PointSet.of(TWO, Optional.empty(), 1, PointSet.Unit.PIXELS).elements());
    assertEquals(2, LineSet.of(LineSet.Kind.STRIP, 1, 0, 0, 0, 1, 0, 0, 2, 0, 0).elements());
    assertEquals(1, LineSet.of(LineSet.Kind.SEGMENTS, 1, 0, 0, 0, 1, 0, 0).elements());
    assertEquals(0, LineSet.of(LineSet.Kind.STRIP, 1).elements());
  }

  @Test
  void instancesLieWhereEachIsPlacedTurnedAndScaled() {
    TriangleMesh mesh = TriangleMesh.of(FloatBuffer.wrap(new float[]{0, 0, 0, 1, 0, 0, 0, 1, 0}), Optional.empty(),
        IntBuffer.wrap(new int[]{0, 1, 2}));
    float half = (float) Math.sqrt(0.5);
    FloatBuffer placings = FloatBuffer.wrap(new float[]{
        5, 0, 0, 0, 0, 0, 1, 3, 1, 1,
        0, 2, 0, 0, 0, half, half, 4, 1, 1,
        Float.NaN, 0, 0, 0, 0, 0, 1, 90, 90, 90});
    Box3 bounds = Instances.of(mesh, placings, Optional.empty()).bounds().orElseThrow();
    assertEquals(0, bounds.low().minus(new Vector3(-1, 0, 0)).norm(), 1e-5, bounds.toString());
    assertEquals(0, bounds.high().minus(new Vector3(8, 6, 0)).norm(), 1e-5, bounds.toString());
  }

  @Test
  void aShapeDoesNotMoveWithTheBuffersItWasGiven() {
    FloatBuffer xyz = FloatBuffer.wrap(new float[]{0, 0, 0, 1, 2, 3});
    PointSet set = PointSet.of(xyz, Optional.empty(), 1, PointSet.Unit.METRES);
    xyz.position(3);
    assertEquals(2, set.elements());
  }
}
