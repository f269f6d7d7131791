package org.robotui.urdf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robotui.geometry.Vector3;

class UrdfTest {
  static RobotModel arm() {
    return Urdf.parse(Samples.ARM).found().orElseThrow();
  }

  @Test
  void readsLinksWithWhatIsSeenAndTouchedAndWeighed() {
    Link base = arm().link("base").orElseThrow();
    assertEquals(new Geometry.Cylinder(0.1, 0.2), base.visuals().get(0).geometry());
    assertEquals(new Vector3(0, 0, -0.1), base.visuals().get(1).linkFromForm().translation());
    assertEquals(Math.PI / 2, base.visuals().get(1).linkFromForm().rotation().yaw(), 1e-12);
    assertEquals(List.of(new Geometry.Sphere(0.3)), base.collisions().stream().map(Collision::geometry).toList());
    assertEquals(4, base.inertial().orElseThrow().mass());
    assertEquals(3, base.inertial().orElseThrow().izz());
  }

  @Test
  void putsMaterialsOfTheRobotInPlaceOfTheirNames() {
    List<Visual> visuals = arm().link("base").orElseThrow().visuals();
    assertEquals(Optional.of(new Color(0, 0, 1, 0.5f)), visuals.get(0).surface().flatMap(Surface::color));
    assertEquals(Optional.empty(), visuals.get(1).surface());
  }

  @Test
  void knowsAMaterialEverywhereOnceAVisualDefinedIt() {
    String text = """
        <robot name="r"><link name="a">
        <visual><geometry><sphere radius="1"/></geometry><material name="m"/></visual>
        <visual><geometry><sphere radius="1"/></geometry><material name="m"><color rgba="1 0 0 1"/></material></visual>
        </link></robot>""";
    assertEquals(List.of(), assertInstanceOf(Parsed.Ok.class, Urdf.parse(text)).warnings());
    assertEquals(new Color(1, 0, 0, 1), Urdf.parse(text).found().orElseThrow().links().get(0).visuals().get(0).surface()
        .orElseThrow().color().orElseThrow());
  }

  @Test
  void warnsOfAMaterialThatNobodyDefines() {
    Parsed.Ok<?> read = assertInstanceOf(Parsed.Ok.class, Urdf.parse(
        "<robot name='r'><link name='a'>\n<visual><geometry><sphere radius='1'/></geometry><material name='gray'/></visual></link></robot>"));
    assertEquals(2, read.warnings().get(0).line());
    assertTrue(read.warnings().get(0).message().contains("'gray'"));
  }

  @Test
  void ordersJointsFromTheRootAndKeepsLimits() {
    RobotModel arm = arm();
    assertEquals("base", arm.root());
    assertEquals(List.of("turn", "free", "lift", "grip"), arm.joints().stream().map(Joint::name).toList());
    Joint lift = arm.joint("lift").orElseThrow();
    assertEquals(new Joint.Limits(0, 0.5, 100, 0.2), lift.limits().orElseThrow());
    assertEquals(new Vector3(0, 0, 1), lift.axis());
    assertEquals(new Joint.Mimic("lift", -2, 0.1), arm.joint("grip").orElseThrow().mimic().orElseThrow());
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
      "<robot name='r'><link name='a'/><link name='a'/></robot> | second <link> has the name 'a'",
      "<robot name='r'><link name='a'/><link name='b'/></robot> | 'a' and 'b' have no parent both",
      "<robot name='r'/> | has no <link>",
      "<sdf/> | must be <robot",
      "<robot name='r'><link/></robot> | <link> has no name",
      "<robot name='r'><link name='a'><visual/></link></robot> | has no <geometry>",
      "<robot name='r'><link name='a'><visual><geometry/></visual></link></robot> | must have one of <box>",
      "<robot name='r'><link name='a'><visual><geometry><box size='1 2'/></geometry></visual></link></robot> | must be 3 numbers",
      "<robot name='r'><link name='a'><visual><geometry><sphere radius='NaN'/></geometry></visual></link></robot> | no finite number",
      "<robot name='r'><link name='a'><visual><geometry><sphere radius='-1'/></geometry></visual></link></robot> | negative",
      "<robot name='r'><link name='a'/><joint name='j' type='hinge'><parent link='a'/><child link='a'/></joint></robot> | must be revolute",
      "<robot name='r'><link name='a'/><joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint></robot> | the child 'b', but there is no such",
      "<robot name='r'><link name='a'/><joint name='j' type='fixed'><parent link='a'/><child link='a'/></joint></robot> | carries itself, by the joint 'j'",
      "<robot name='r'><link name='a'/> | not well-formed",
  })
  void saysWhatIsWrong(String text, String words) {
    Parsed.Refused<?> refused = assertInstanceOf(Parsed.Refused.class, Urdf.parse(text));
    assertTrue(refused.problem().toString().contains(words), refused.problem().toString());
    assertTrue(refused.problem().line() == 1, refused.problem().toString());
  }

  @Test
  void namesWhatMakesACycle() {
    String text = """
        <robot name="r"><link name="root"/><link name="a"/><link name="b"/>
        <joint name="ab" type="fixed"><parent link="a"/><child link="b"/></joint>
        <joint name="ba" type="fixed"><parent link="b"/><child link="a"/></joint></robot>""";
    Parsed.Refused<?> refused = assertInstanceOf(Parsed.Refused.class, Urdf.parse(text));
    assertTrue(refused.problem().message().contains("'a' carries itself"), refused.problem().toString());
    assertEquals(2, refused.problem().line());
  }

  @Test
  void namesBothParentsOfALink() {
    String text = """
        <robot name="r"><link name="root"/><link name="a"/>
        <joint name="one" type="fixed"><parent link="root"/><child link="a"/></joint>
        <joint name="two" type="fixed"><parent link="root"/><child link="a"/></joint></robot>""";
    Parsed.Refused<?> refused = assertInstanceOf(Parsed.Refused.class, Urdf.parse(text));
    assertTrue(refused.problem().message().contains("child of both joints 'one' and 'two'"),
        refused.problem().toString());
    assertEquals(3, refused.problem().line());
  }

  @Test
  void refusesJointsThatMimicEachOther() {
    String text = """
        <robot name="r"><link name="root"/><link name="a"/><link name="b"/>
        <joint name="one" type="revolute"><parent link="root"/><child link="a"/><mimic joint="two"/></joint>
        <joint name="two" type="revolute"><parent link="root"/><child link="b"/><mimic joint="one"/></joint></robot>""";
    Parsed.Refused<?> refused = assertInstanceOf(Parsed.Refused.class, Urdf.parse(text));
    assertTrue(refused.problem().message().contains("mimics itself"), refused.problem().toString());
  }
}
