package org.robotui.gl.internal.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.robotui.gl.internal.scene.Stage.at;
import static org.robotui.gl.internal.scene.Stage.colored;
import static org.robotui.gl.internal.scene.Stage.flat;
import static org.robotui.gl.internal.scene.Stage.part;
import static org.robotui.gl.internal.scene.Stage.points;
import static org.robotui.gl.internal.scene.Stage.request;
import static org.robotui.gl.internal.scene.Stage.square;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.RenderRequest.Selected;
import org.robotui.gl.render.Rendered.Picture;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Label;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.PointSet.Unit;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Texture;
import org.robotui.gl.shape.TriangleMesh;

/** What is seen in pictures, pixel by pixel. */
@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+", disabledReason = "no display: DISPLAY is not set")
class PictureTest {
  private static final int RED = 0xff0000;
  private static final int GREEN = 0x00ff00;

  private final Stage stage = new Stage();

  @AfterEach
  void close() throws InterruptedException {
    stage.close();
  }

  @Test
  void leftIsLeftAndUpIsUp() throws Exception {
    Picture picture = stage.picture(request(flat("p", points(3, 0, 0.295f, 0.395f), RED)));
    assertEquals(RED, at(picture, 20, 10));
    assertTrue(colored(picture) <= 16);
  }

  @Test
  void whatIsNearerHidesWhatIsFarther() throws Exception {
    Picture picture = stage.picture(request(flat("near", square(0, 0.1f), RED), flat("far", square(1, 0.3f), GREEN)));
    assertEquals(RED, at(picture, 50, 50));
    assertEquals(GREEN, at(picture, 30, 50));
  }

  @Test
  void whatIsOnTopIsSeenThroughTheRest() throws Exception {
    Part far = part("far", square(1, 0.1f), Material.flat(Rgba.of(RED)).onTop());
    assertEquals(RED, at(stage.picture(request(far, flat("near", square(0, 0.3f), GREEN))), 50, 50));
  }

  @Test
  void whatIsTranslucentMixesWithWhatLiesBehindFromTheBackToTheFront() throws Exception {
    Part near = part("a", square(0, 0.3f), Material.flat(Rgba.of(RED).withAlpha(0.5)));
    Part far = part("b", square(1, 0.3f), Material.flat(Rgba.of(GREEN).withAlpha(0.5)));
    int mixed = at(stage.picture(request(near, far)), 50, 50);
    assertEquals(128, mixed >> 16 & 0xff, 2);
    assertEquals(64, mixed >> 8 & 0xff, 2);
  }

  @Test
  void whatIsNoNumberIsNotDrawn() throws Exception {
    float nan = Float.NaN;
    PointSet broken = points(40, nan, 0, 0, 0, nan, 0, 0, 0, Float.POSITIVE_INFINITY, nan, nan, nan, 0, 0.3f, 0.3f);
    Picture picture = stage.picture(request(flat("p", broken, RED)));
    assertEquals(Stage.BLACK, at(picture, 50, 50));
    assertEquals(RED, at(picture, 20, 20));
  }

  @Test
  void cloudsAreThinnedInProportionAndThePictureSaysSo() throws Exception {
    float[] xyz = new float[3000];
    Picture picture = stage.picture(request(100, List.of(), flat("p", points(1, xyz), RED)));
    assertEquals(91, picture.figures().points(), "every 11th: an odd number takes other columns of each row");
    assertEquals(909, picture.figures().pointsLeftOut());
  }

  @Test
  void translucentPointsMixWithWhatLiesBehindAndAreThinnedToo() throws Exception {
    Part cloud = part("p", points(20, 0, 0, 0, 0, 0.3f, 0.3f, 0, 0, 0), Material.flat(Rgba.of(RED).withAlpha(0.5)));
    Picture picture = stage.picture(request(2, List.of(), cloud, flat("m", square(1, 0.4f), GREEN)));
    int mixed = at(picture, 50, 50);
    assertEquals(2, picture.figures().points());
    assertEquals(GREEN, at(picture, 20, 20));
    assertEquals(GREEN, at(picture, 80, 80));
    assertTrue((mixed >> 16 & 0xff) > 100 && (mixed >> 8 & 0xff) < 150, () -> Integer.toHexString(mixed));
  }

  /** A ball of many triangles, red before x = 0 and green behind. */
  private static TriangleMesh ball() {
    int around = 60;
    FloatBuffer xyz = FloatBuffer.allocate(3 * around * (around + 1));
    ByteBuffer rgba = ByteBuffer.allocate(4 * around * (around + 1));
    IntBuffer triangles = IntBuffer.allocate(6 * around * around);
    for (int row = 0; row <= around; row++) {
      for (int column = 0; column < around; column++) {
        double up = Math.PI * row / around;
        double turn = 2 * Math.PI * column / around;
        double x = 0.3 * Math.sin(up) * Math.cos(turn);
        xyz.put((float) x).put((float) (0.3 * Math.sin(up) * Math.sin(turn))).put((float) (-0.3 * Math.cos(up)));
        rgba.putInt(x < 0 ? 0xff0000ff : 0x00ff00ff);
        int here = row * around + column;
        int beside = row * around + (column + 1) % around;
        if (row < around) {
          triangles.put(here).put(beside).put(beside + around).put(here).put(beside + around).put(here + around);
        }
      }
    }
    return new TriangleMesh(xyz.flip(), Optional.empty(), Optional.empty(), Optional.of(rgba.flip()), triangles.flip(),
        Box3.around(xyz));
  }

  @Test
  void ofABodyTheSidesThatFaceTheEyeAreDrawnHoweverOftenAndHoweverFine() throws Exception {
    Part body = part("ball", ball(), Material.flat(Rgba.WHITE));
    for (int budget : new int[]{Integer.MAX_VALUE, Integer.MAX_VALUE, Integer.MAX_VALUE, Integer.MAX_VALUE, 1000,
        1000}) {
      Picture picture = stage.picture(request(budget, List.of(), body));
      assertEquals(RED, at(picture, 50, 50));
      assertEquals(RED, at(picture, 30, 50));
      assertEquals(RED, at(picture, 50, 70));
      assertEquals(2827, Stage.colored(picture), 150);
    }
  }

  @Test
  void aBodyLooksTheSameHoweverOftenItIsDrawn() throws Exception {
    assertLooksTheSame(part("ball", ball(), Material.lit(Rgba.WHITE)));
  }

  @Test
  void aBoxOfLargeTrianglesLooksTheSameHoweverOftenItIsDrawn() throws Exception {
    RigidTransform turned = new RigidTransform(Vector3.ZERO, Quaternion.fromRollPitchYaw(0.3, 0.4, 0.5));
    assertLooksTheSame(new Part("box", Meshes.cube(), turned, Material.lit(Rgba.of(RED)), Describer.of("")));
  }

  /** The first pictures are drawn by OpenGL, later ones are painted by the processor where OpenGL is software. */
  private void assertLooksTheSame(Part body) throws Exception {
    Picture first = stage.picture(request(body));
    Picture last = first;
    for (int i = 0; i < 5; i++) {
      last = stage.picture(request(body));
    }
    long sum = 0;
    for (int pixel = 0; pixel < first.rgb().length; pixel++) {
      for (int shift = 0; shift < 24; shift += 8) {
        sum += Math.abs((first.rgb()[pixel] >> shift & 0xff) - (last.rgb()[pixel] >> shift & 0xff));
      }
    }
    assertTrue(sum < 4 * colored(first), "mean difference " + (double) sum / colored(first));
  }

  /** Where nothing is left for OpenGL, the picture does not pass through it. */
  @Test
  void whatTheProcessorPaintsAloneIsThePictureThatItHasBesideOpenGl() throws Exception {
    Part cloud = flat("p", points(7, 0, 0, 0, 1, 0.2f, -0.3f, 2, -0.4f, 0.1f), RED);
    Part inTheCorner = flat("l", LineSet.of(LineSet.Kind.SEGMENTS, 1, 0, 0.49f, 0.49f, 0, 0.48f, 0.49f), GREEN);
    Picture alone = stage.picture(request(cloud));
    Picture beside = stage.picture(request(cloud, inTheCorner));
    assertTrue(colored(beside) > colored(alone));
    for (int row = 10; row < Stage.SIDE; row++) {
      for (int column = 0; column < Stage.SIDE; column++) {
        assertEquals(at(beside, column, row), at(alone, column, row), column + ", " + row);
      }
    }
  }

  @Test
  void pointsHideAndAreHiddenByMeshes() throws Exception {
    Part cloud = flat("p", points(6, 0, 0, 0, 2, 0.2f, 0.2f), RED);
    Picture picture = stage.picture(request(cloud, flat("m", square(1, 0.4f), GREEN)));
    assertEquals(RED, at(picture, 50, 50));
    assertEquals(GREEN, at(picture, 30, 30));
  }

  @Test
  void whatIsPaleIsMixedWithTheBackgroundAndHidesWhatIsBehind() throws Exception {
    Material pale = Material.flat(Rgba.of(RED)).paled(0.5f);
    Part wall = flat("wall", square(1, 0.4f), GREEN);
    Picture cloud = stage.picture(request(part("p", points(6, 0, 0, 0), pale), wall));
    Picture mesh = stage.picture(request(part("m", square(0, 0.1f), pale), wall));
    int half = at(mesh, 50, 50);
    assertEquals(0x7f, half >> 16 & 0xff, 1, "red on black");
    assertEquals(0, half & 0xffff, "nothing of what is behind");
    assertEquals(0x7f, at(cloud, 50, 50) >> 16 & 0xff, 1);
    assertEquals(0, at(cloud, 50, 50) & 0xffff);
    assertEquals(GREEN, at(cloud, 60, 60), "what is drawn after the points lies beside them");
  }

  @Test
  void pointsInMetresHaveTheirSize() throws Exception {
    PointSet one = PointSet.of(FloatBuffer.wrap(new float[3]), Optional.empty(), 0.2f, Unit.METRES);
    assertEquals(400, colored(stage.picture(request(flat("p", one, RED)))), 45);
  }

  @Test
  void whatIsSelectedLooksOtherwise() throws Exception {
    Part part = flat("p", square(0, 0.3f), GREEN);
    int plain = at(stage.picture(request(part)), 50, 50);
    assertNotEquals(plain, at(stage.picture(request(9, List.of(new Selected("display", "p")), part)), 50, 50));
  }

  @Test
  void whatIsOutsideIsNotSentThroughTheShaders() throws Exception {
    Part behind = new Part("p", square(0, 0.1f), new RigidTransform(new Vector3(-9, 0, 0), Quaternion.IDENTITY),
        Material.flat(Rgba.WHITE), Describer.of(""));
    assertEquals(0, stage.picture(request(behind)).figures().triangles());
    assertEquals(2, stage.picture(request(flat("p", square(0, 0.1f), RED))).figures().triangles());
  }

  @Test
  void aTextureLiesWithItsFirstRowAtTheTop() throws Exception {
    ByteBuffer rgba = ByteBuffer.allocate(8).putInt(0xff0000ff).putInt(0x00ff00ff).flip();
    float[] xyz = {0, 0.3f, 0.3f, 0, -0.3f, 0.3f, 0, 0.3f, -0.3f, 0, -0.3f, -0.3f};
    FloatBuffer uv = FloatBuffer.wrap(new float[]{0, 0, 1, 0, 0, 1, 1, 1});
    FloatBuffer corners = FloatBuffer.wrap(xyz);
    IntBuffer triangles = IntBuffer.wrap(new int[]{0, 1, 2, 1, 2, 3});
    TriangleMesh mesh =
        new TriangleMesh(corners, Optional.empty(), Optional.of(uv), Optional.empty(), triangles, Box3.around(corners));
    Picture picture = stage.picture(request(part("t", mesh, Material.picture(new Texture(1, 2, rgba, false), 1))));
    assertEquals(RED, at(picture, 50, 30));
    assertEquals(GREEN, at(picture, 50, 70));
  }

  @Test
  void oneColourPerPointMultipliesTheMaterial() throws Exception {
    FloatBuffer xyz = FloatBuffer.wrap(new float[]{0, 0.2f, 0, 0, -0.2f, 0});
    ByteBuffer rgba = ByteBuffer.allocateDirect(8).putInt(0xffffffff).putInt(0x00ff00ff).flip();
    PointSet two = PointSet.of(xyz, Optional.of(rgba), 6, Unit.PIXELS);
    Picture picture = stage.picture(request(flat("p", two, 0x80ff00)));
    assertEquals(0x80ff00, at(picture, 30, 50));
    assertEquals(GREEN, at(picture, 70, 50));
  }

  @Test
  void aPartWithoutColoursAfterOneWithColoursIsWhite() throws Exception {
    oneColourPerPointMultipliesTheMaterial();
    assertEquals(RED, at(stage.picture(request(flat("p", points(6, 0, 0, 0), RED))), 50, 50));
  }

  @Test
  void emptyShapesAndOddWordsDoNoHarm() throws Exception {
    TriangleMesh none = TriangleMesh.of(FloatBuffer.allocate(0), Optional.empty(), IntBuffer.allocate(0));
    Picture picture = stage.picture(request(
        flat("a", points(1), RED), flat("b", none, RED), flat("c", new Label("", 10, Unit.PIXELS), RED),
        flat("d", new Label("\u4e16\ud83d\ude00\n".repeat(300), 1, Unit.METRES), RED)));
    assertEquals(List.of(), picture.problems());
  }

  @Test
  void aKeyThatIsThereTwiceIsNamed() throws Exception {
    Picture picture = stage.picture(request(flat("twin", square(0, 0.1f), RED), flat("twin", square(0, 0.3f), GREEN)));
    assertTrue(picture.problems().getFirst().contains("twin"));
    assertEquals(RED, at(picture, 50, 50));
  }

  @Test
  void theSamePictureTwiceIsTheSame() throws Exception {
    Part part = flat("p", square(0, 0.1f), RED);
    assertArrayEquals(stage.picture(request(part)).rgb(), stage.picture(request(part)).rgb());
  }
}
