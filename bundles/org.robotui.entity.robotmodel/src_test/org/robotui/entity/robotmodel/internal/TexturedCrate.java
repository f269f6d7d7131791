package org.robotui.entity.robotmodel.internal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.robotui.data.joint.RobotDescription;
import org.robotui.testkit.SceneImage;
import org.robotui.testkit.ScenePictures;

/** A package with a crate: planks on its sides, and a lid of one colour. */
final class TexturedCrate {
  private static final String OBJ = """
      mtllib crate.mtl
      v -0.5 -0.5 0
      v 0.5 -0.5 0
      v 0.5 0.5 0
      v -0.5 0.5 0
      v -0.5 -0.5 1
      v 0.5 -0.5 1
      v 0.5 0.5 1
      v -0.5 0.5 1
      vt 0 0
      vt 2 0
      vt 2 1
      vt 0 1
      usemtl planks
      f 1/1 2/2 6/3 5/4
      f 2/1 3/2 7/3 6/4
      f 3/1 4/2 8/3 7/4
      f 4/1 1/2 5/3 8/4
      usemtl lid
      f 5 6 7 8
      """;
  private static final int SIZE = 64;

  private final Path folder;

  TexturedCrate(Path folder) {
    this.folder = folder;
    text("crate/meshes/crate.obj", OBJ);
    mtl("../textures/planks.png");
    ScenePictures.write(made("crate/textures/planks.png"), planks());
  }

  /** Says which picture the sides have. */
  TexturedCrate mtl(String picture) {
    text("crate/meshes/crate.mtl",
        "newmtl planks\nKd 0.6 0.4 0.2\nmap_Kd " + picture + "\nnewmtl lid\nKd 0.2 0.5 0.8\n");
    return this;
  }

  TexturedCrate text(String file, String words) {
    try {
      Files.writeString(made(file), words);
      return this;
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  RobotDescription description() {
    String urdf =
        "<robot name='crate'><link name='crate'><visual><geometry><mesh filename='package://crate/meshes/crate.obj'/></geometry></visual></link></robot>";
    return new RobotDescription(Bench.ROBOT, "crate", urdf, "", List.of(folder.toString()));
  }

  private Path made(String file) {
    try {
      Path path = folder.resolve(file);
      Files.createDirectories(path.getParent());
      return path;
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  /**
   * Four planks upright, the first one red and the upper edge white, so that a picture that is mirrored or on its head
   * is seen.
   */
  private static SceneImage planks() {
    int[] rgb = new int[SIZE * SIZE];
    for (int y = 0; y < SIZE; y++) {
      for (int x = 0; x < SIZE; x++) {
        int plank = x < SIZE / 4 ? 0xc0392b : x / (SIZE / 4) % 2 == 0 ? 0x8d6e4a : 0xb08d5e;
        rgb[y * SIZE + x] = y < SIZE / 8 ? 0xffffff : x % (SIZE / 4) == 0 ? 0x3b2c1c : plank;
      }
    }
    return new SceneImage(SIZE, SIZE, rgb);
  }
}
