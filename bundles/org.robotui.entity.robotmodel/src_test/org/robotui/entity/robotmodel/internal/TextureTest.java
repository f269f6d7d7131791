package org.robotui.entity.robotmodel.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.RobotDescription;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Texture;
import org.robotui.gl.shape.TriangleMesh;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;

/** Pictures on the meshes of a model. */
class TextureTest {
  @TempDir
  private Path folder;
  private final Bench bench = new Bench();
  private TexturedCrate crate;

  @BeforeEach
  void pack() {
    crate = new TexturedCrate(folder);
  }

  private DisplayResult shown() {
    return bench.give(crate.description()).give(new JointState(List.of())).settled();
  }

  private static List<Texture> textures(DisplayResult result) {
    return result.parts().stream().flatMap(part -> part.material().texture().stream()).toList();
  }

  private static String partly(DisplayResult result) {
    return assertInstanceOf(DisplayStatus.Partly.class, result.status(), result.status().words()).words();
  }

  @Test
  @EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
  void aCrateWithPlanksAndALid() {
    try (ScenePictures pictures = new ScenePictures()) {
      pictures.assertLike(TextureTest.class, "textured", ScenePictures.request(shown().parts(),
          ScenePictures.eye(new Vector3(1.3, -1.6, 1.6), new Vector3(0, 0, 0.45))));
    }
  }

  @Test
  void eachPictureIsASurfaceOfItsOwn() {
    DisplayResult result = shown();
    assertInstanceOf(DisplayStatus.Shown.class, result.status());
    assertEquals(2, result.parts().size());
    assertEquals(1, textures(result).size());
    assertTrue(textures(result).getFirst().repeats());
    Part sides =
        result.parts().stream().filter(part -> part.material().texture().isPresent()).findFirst().orElseThrow();
    TriangleMesh mesh = (TriangleMesh) sides.shape();
    assertEquals(8, mesh.elements());
    assertEquals(1f, mesh.uv().orElseThrow().get(1), "the bottom of the picture is its last row");
    assertSame(textures(result).getFirst(), textures(bench.tick()).getFirst(), "the same object at each tick");
  }

  @Test
  void inTheColourOfTheRobotThereIsNoPicture() {
    bench.settings.set(RobotModelType.COLOR, "robot");
    DisplayResult result = shown();
    assertEquals(List.of(), textures(result));
    assertEquals(List.of(Bench.ROBOT_COLOR),
        result.parts().stream().map(part -> part.material().color()).distinct().toList());
  }

  @Test
  void aMissingPictureLeavesTheColourAndAWord() {
    crate.mtl("none.png");
    DisplayResult missing = shown();
    assertTrue(partly(missing).contains("its picture 'none.png' is not shown: there is no such file in its package"),
        partly(missing));
    assertEquals(List.of(), textures(missing));
    assertEquals(new Rgba(0.6f, 0.4f, 0.2f, 1).packed(),
        ((TriangleMesh) missing.parts().getFirst().shape()).rgba().orElseThrow().getInt(0));
  }

  @Test
  void aBrokenPictureIsNamed() {
    crate.mtl("broken.png").text("crate/meshes/broken.png", "no picture");
    assertTrue(partly(shown()).contains("'broken.png' is not shown: it is neither PNG nor JPEG"));
  }

  @Test
  void noPictureIsReadOutsideOfThePackage() throws IOException {
    Files.copy(folder.resolve("crate/textures/planks.png"), folder.resolve("secret.png"));
    for (String outside : List.of("../../secret.png", folder.resolve("secret.png").toString(), "..\\..\\secret.png",
        "%2e%2e/%2e%2e/secret.png")) {
      Bench other = new Bench();
      DisplayResult result = other.give(crate.mtl(outside).description()).give(new JointState(List.of())).settled();
      assertEquals(List.of(), textures(result), outside);
      assertTrue(partly(result).contains("is not shown"), partly(result));
    }
  }

  @Test
  void theTextureOfAMaterialIsOnWhatTheFileLeavesOpen() {
    crate.text("crate/meshes/plain.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n");
    String urdf = """
        <robot name='crate'><link name='crate'><visual><geometry><mesh filename='package://crate/meshes/plain.obj'/></geometry>
          <material name='m'><texture filename='package://crate/textures/planks.png'/></material></visual></link></robot>
        """;
    DisplayResult result = bench.give(new RobotDescription(Bench.ROBOT, "crate", urdf, "", List.of(folder.toString())))
        .give(new JointState(List.of())).settled();
    assertEquals(1, textures(result).size());
  }
}
