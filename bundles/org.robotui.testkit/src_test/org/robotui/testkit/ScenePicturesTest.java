package org.robotui.testkit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Eye;
import org.robotui.gl.render.Eye.Projection.Parallel;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Label;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.PointSet.Style;
import org.robotui.gl.shape.PointSet.Unit;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Shape;

/** How each kind of shape looks, in both themes and both projections. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class ScenePicturesTest {
  private static final Eye ABOVE = ScenePictures.eye(new Vector3(-4, -3, 3), Vector3.ZERO);
  private static final Eye PLAN = new Eye(ABOVE.fixedFromEye(), new Parallel(5), 0.1, 50);
  @AutoClose
  private static final ScenePictures PICTURES = new ScenePictures();

  private static Part part(Object key, Shape shape, Material material) {
    return new Part(key, shape, RigidTransform.IDENTITY, material, Describer.of("test"));
  }

  private static Part grid() {
    float[] xyz = new float[11 * 2 * 6];
    for (int i = 0; i < 11; i++) {
      float at = (i - 5) * 0.4f;
      System.arraycopy(new float[]{at, -2, 0, at, 2, 0, -2, at, 0, 2, at, 0}, 0, xyz, 12 * i, 12);
    }
    return part("grid", LineSet.of(LineSet.Kind.SEGMENTS, 1, xyz), Material.flat(Rgba.of(0x7d8590).withAlpha(0.5)));
  }

  private static Part axes() {
    float[] xyz = {0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1};
    ByteBuffer rgba = ByteBuffer.allocate(24);
    for (int color : new int[]{0xe5484dff, 0x46a758ff, 0x3e8eedff}) {
      rgba.putInt(color).putInt(color);
    }
    FloatBuffer corners = FloatBuffer.wrap(xyz);
    return part("axes", new LineSet(corners, Optional.of(rgba.flip()), LineSet.Kind.SEGMENTS, 4, Box3.around(corners)),
        Material.flat(Rgba.WHITE));
  }

  /** A wave of points, coloured by height. */
  private static PointSet wave(int side, float size, Unit unit, Style style) {
    FloatBuffer xyz = FloatBuffer.allocate(3 * side * side);
    ByteBuffer rgba = ByteBuffer.allocate(4 * side * side);
    for (int i = 0; i < side * side; i++) {
      float x = (i % side) * 4f / side - 2;
      float y = (i / side) * 4f / side - 2;
      float z = (float) (Math.sin(3 * x) * Math.cos(2 * y)) * 0.4f;
      xyz.put(x).put(y).put(z);
      int level = Math.clamp((int) ((z + 0.4f) * 319), 0, 255);
      rgba.put((byte) level).put((byte) (255 - level)).put((byte) 200).put((byte) 255);
    }
    xyz.flip();
    return new PointSet(xyz, Optional.of(rgba.flip()), size, unit, style, Box3.around(xyz), Optional.empty());
  }

  @Test
  void pointsInPixels() {
    List<Part> parts =
        List.of(grid(), axes(), part("cloud", wave(120, 2, Unit.PIXELS, Style.SQUARE), Material.flat(Rgba.WHITE)));
    PICTURES.assertLike(getClass(), "points-pixels", ScenePictures.request(parts, ABOVE));
  }

  @Test
  void pointsInMetresAreSmallerFarAway() {
    List<Part> parts = List.of(part("cloud", wave(24, 0.12f, Unit.METRES, Style.DISC), Material.flat(Rgba.WHITE)));
    PICTURES.assertLike(getClass(), "points-metres", ScenePictures.request(parts, ABOVE, ScenePictures.LIGHT));
  }

  @Test
  void linesInBothProjections() {
    List<Part> parts = List.of(grid(), axes());
    PICTURES.assertLike(getClass(), "lines-perspective", ScenePictures.request(parts, ABOVE));
    PICTURES.assertLike(getClass(), "lines-parallel", ScenePictures.request(parts, PLAN, ScenePictures.LIGHT));
  }

  @Test
  void meshesInTheLight() {
    List<Part> parts = List.of(grid(), axes(), part("box", Solids.box(1, 0.6f, 0.8f), Material.lit(Rgba.of(0xd97f3d))));
    PICTURES.assertLike(getClass(), "mesh-dark", ScenePictures.request(parts, ABOVE));
    PICTURES.assertLike(getClass(), "mesh-light", ScenePictures.request(parts, PLAN, ScenePictures.LIGHT));
  }

  @Test
  void whatIsTranslucentShowsWhatLiesBehind() {
    Part glass = new Part("glass", Solids.box(1.6f, 1.6f, 0.2f), RigidTransform.planar(-0.6, -0.4, 0.3),
        Material.lit(Rgba.of(0x3e8eed).withAlpha(0.4)), Describer.of("glass"));
    List<Part> parts =
        List.of(glass, grid(), axes(), part("box", Solids.box(0.5f, 0.5f, 1.2f), Material.lit(Rgba.of(0xd97f3d))));
    PICTURES.assertLike(getClass(), "translucent", ScenePictures.request(parts, ABOVE));
  }

  @Test
  void oneMeshManyTimes() {
    FloatBuffer placings = FloatBuffer.allocate(25 * Instances.PLACING);
    ByteBuffer rgba = ByteBuffer.allocate(100);
    for (int i = 0; i < 25; i++) {
      double turn = i * 0.2;
      placings.put(i % 5 * 0.8f - 1.6f).put(i / 5 * 0.8f - 1.6f).put(0).put(0).put(0).put((float) Math.sin(turn))
          .put((float) Math.cos(turn));
      placings.put(1).put(0.5f).put(0.3f + 0.1f * (i % 7));
      rgba.putInt(0x4080ffff + (i * 9 << 24));
    }
    Instances many = Instances.of(Solids.box(0.4f, 0.4f, 0.4f), placings.flip(), Optional.of(rgba.flip()));
    PICTURES.assertLike(getClass(), "instances",
        ScenePictures.request(List.of(grid(), part("many", many, Material.lit(Rgba.WHITE))), ABOVE));
  }

  private static Part label(String text, float size, Unit unit, double z) {
    return new Part(text, new Label(text, size, unit), new RigidTransform(new Vector3(0, 0, z), Quaternion.IDENTITY),
        Material.flat(Rgba.of(0xffc857)), Describer.of(text));
  }

  @Test
  void wordsFaceTheCamera() {
    List<Part> parts = List.of(grid(), label("base_link 12.5 m/s", 18, Unit.PIXELS, 1.2),
        label("Keira: Wagen 3", 0.5f, Unit.METRES, 0));
    PICTURES.assertLike(getClass(), "labels", ScenePictures.request(parts, ABOVE));
  }

  @Test
  void aPictureOfOnePartShowsItsColourInTheMiddle() {
    SceneImage image = PICTURES.picture(
        ScenePictures.request(List.of(part("box", Solids.box(1, 1, 1), Material.flat(Rgba.of(0x40c080)))), ABOVE));
    assertEquals(0x40c080, image.at(160, 120));
    assertEquals(0x1b1e23, image.at(2, 2));
    assertTrue(image.count(0x40c080, 0) > 2000);
  }
}
