package org.robotui.entity.robotmodel.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.RobotDescription;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Rgba;

class RobotModelDisplayTest {
  private static final String URDF = """
      <robot name="mast">
        <link name="base"><visual><geometry><box size="1 1 0.2"/></geometry><material name="m"><color rgba="1 0 0 1"/></material></visual>
          <inertial><mass value="6"/><inertia ixx="1" iyy="1" izz="1"/></inertial></link>
        <link name="arm"><visual><geometry><mesh filename="package://mast/arm.stl" scale="2 2 2"/></geometry></visual>
          <collision><geometry><sphere radius="0.1"/></geometry></collision></link>
        <joint name="lift" type="prismatic"><parent link="base"/><child link="arm"/><origin xyz="0 0 1"/><axis xyz="0 0 1"/>
          <limit lower="0" upper="0.5" effort="1" velocity="1"/></joint>
      </robot>
      """;
  private static final String SRDF = "<robot name='mast'><group name='hand'><link name='arm'/></group></robot>";
  private static final String STL =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";

  @TempDir
  private Path folder;
  private final Bench bench = new Bench();

  private RobotDescription description() {
    return new RobotDescription(Bench.ROBOT, "/robot_description", URDF, SRDF, List.of(folder.toString()));
  }

  private Bench withMesh() {
    try {
      Files.createDirectories(folder.resolve("mast"));
      Files.writeString(folder.resolve("mast/arm.stl"), STL);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
    return bench.give(description());
  }

  private static JointState lift(double position) {
    return new JointState(List.of(new JointState.Joint("lift", position, Double.NaN, Double.NaN),
        new JointState.Joint("other", 1, 0, 0)));
  }

  private static <T extends DisplayStatus> String words(Class<T> kind, DisplayResult result) {
    return assertInstanceOf(kind, result.status()).words();
  }

  @Test
  void saysWhatItWaitsFor() {
    assertTrue(words(DisplayStatus.NoData.class, bench.tick()).contains("robot_description"));
    assertTrue(words(DisplayStatus.NoData.class, withMesh().tick()).contains("being read"));
  }

  @Test
  void standsWhereTransformsSayAndNamesTheMissingOne() {
    bench.frames.put("base", RigidTransform.planar(1, 2, 0));
    DisplayResult half = withMesh().settled();
    assertTrue(
        words(DisplayStatus.Partly.class, half).contains("1 of 2 links have no place: there is no link to robby:arm"));
    assertEquals(new Vector3(1, 2, 0), Bench.part(half, "base").fixedFromShape().translation());
    bench.frames.put("arm", RigidTransform.planar(0, 5, 0));
    DisplayResult all = bench.tick();
    assertTrue(words(DisplayStatus.Shown.class, all).startsWith("2 links"));
    assertEquals(new Vector3(0, 5, 0), Bench.part(all, "arm").fixedFromShape().translation());
    assertEquals(new Rgba(1, 0, 0, 1), Bench.part(all, "base").material().color());
    assertEquals(2, Bench.part(all, "arm").shape().bounds().orElseThrow().high().x(), 1e-6);
    assertTrue(bench.wakes > 0);
  }

  @Test
  void saysThatItHasNoPlaceAtAll() {
    bench.settings.set(RobotModelType.POSES, "tf");
    assertTrue(words(DisplayStatus.NoFrame.class, withMesh().settled()).contains("no link to robby:base"));
  }

  @Test
  void movesByJointStatesWithTheSameShapes() {
    bench.frames.put("base", RigidTransform.planar(1, 0, 0));
    DisplayResult before = withMesh().give(lift(0.25)).settled();
    assertEquals(new Vector3(1, 0, 1.25), Bench.part(before, "arm").fixedFromShape().translation());
    DisplayResult after = bench.give(lift(0.5)).tick();
    assertEquals(new Vector3(1, 0, 1.5), Bench.part(after, "arm").fixedFromShape().translation());
    assertSame(Bench.part(before, "arm").shape(), Bench.part(after, "arm").shape());
    assertSame(Bench.part(before, "base").shape(), Bench.part(after, "base").shape());
    assertEquals(Bench.part(before, "arm").key(), Bench.part(after, "arm").key());
    assertTrue(words(DisplayStatus.Partly.class, bench.later(9).tick()).contains("9 s old"));
  }

  @Test
  void aRobotWithoutAnyTransformStandsInTheMiddle() {
    DisplayResult result = withMesh().give(lift(0)).settled();
    assertInstanceOf(DisplayStatus.Shown.class, result.status());
    assertEquals(new Vector3(0, 0, 1), Bench.part(result, "arm").fixedFromShape().translation());
  }

  @Test
  void namesAMissingMeshAndShowsWhatCanTouchInItsPlace() {
    DisplayResult result = bench.give(description()).give(lift(0)).settled();
    String words = words(DisplayStatus.Partly.class, result);
    assertTrue(words.contains("the package 'mast' is not in") && words.contains("add the folder"), words);
    assertTrue(Bench.part(result, "PLACEHOLDER").material().color().alpha() < 0.5);
  }

  @Test
  void readsNoMeshOutsideOfItsPackage() throws IOException {
    withMesh();
    Files.writeString(folder.resolve("secret.stl"), STL);
    String urdf =
        "<robot name='r'><link name='a'><visual><geometry><mesh filename='package://mast/../secret.stl'/></geometry></visual></link></robot>";
    DisplayResult result = bench.give(new RobotDescription(Bench.ROBOT, "p", urdf, "", List.of(folder.toString())))
        .give(lift(0)).settled();
    assertTrue(words(DisplayStatus.Partly.class, result).contains("leads out of its package"));
    assertEquals(List.of(), result.parts());
  }

  @Test
  void saysWhereTheTextIsWrong() {
    RobotDescription broken =
        new RobotDescription(Bench.ROBOT, "/robot_description", "<robot name='r'>\n<link/></robot>", "", List.of());
    assertEquals("The model cannot be read: /robot_description, line 2: <link> has no name, write <link name=\"...\">",
        words(DisplayStatus.Unfit.class, bench.give(broken).settled()));
  }

  @Test
  void showsWhatSettingsAskFor() {
    bench.settings.set(RobotModelType.VISUAL, false);
    bench.settings.set(RobotModelType.COLLISION, true);
    bench.settings.set(RobotModelType.INERTIA, true);
    bench.settings.set(RobotModelType.NAMES, true);
    bench.settings.set(RobotModelType.AXES, true);
    DisplayResult result = withMesh().give(lift(0)).settled();
    assertEquals(List.of("AXES", "COLLISION", "INERTIA", "NAMES"), result.parts().stream()
        .map(part -> part.key().toString().replaceAll(".*what=(\\w+).*", "$1").toUpperCase(Locale.ROOT)).distinct()
        .sorted().collect(Collectors.toList()));
    // moments of 1 with a mass of 6 are those of a cube with edges of 1
    assertEquals(0.5, Bench.part(result, "INERTIA").shape().bounds().orElseThrow().high().x(), 1e-6);
  }

  @Test
  void coloursByRobotAndMarksGroupsAndIsTransparent() {
    bench.settings.set(RobotModelType.COLOR, "robot");
    bench.settings.set(RobotModelType.OPACITY, 0.5);
    DisplayResult plain = withMesh().give(lift(0)).settled();
    assertEquals(Bench.ROBOT_COLOR.withAlpha(0.5), Bench.part(plain, "base").material().color());
    bench.settings.set(RobotModelType.GROUP, "hand");
    DisplayResult marked = bench.tick();
    assertNotSame(Bench.part(plain, "arm").material().color(), Bench.part(marked, "arm").material().color());
    assertEquals(Bench.part(plain, "base").material(), Bench.part(marked, "base").material());
    bench.settings.set(RobotModelType.GROUP, "foot");
    assertTrue(words(DisplayStatus.Partly.class, bench.tick()).contains("no group 'foot': there are [hand]"));
  }

  @Test
  void saysOfALinkWhatMovesIt() {
    DisplayResult result = withMesh().give(lift(0.25)).settled();
    Properties arm = Bench.part(result, "arm").describer().describe(0, Vector3.ZERO);
    assertEquals("arm", arm.title());
    assertTrue(arm.entries().contains(new Properties.Entry("Position", "0.2500 m")), arm.toString());
    assertTrue(arm.entries().contains(new Properties.Entry("Limits", "0.000 to 0.5000 m")), arm.toString());
    Properties base = Bench.part(result, "base").describer().describe(0, Vector3.ZERO);
    assertTrue(base.entries().contains(new Properties.Entry("Mass", "6.000 kg")), base.toString());
  }
}
