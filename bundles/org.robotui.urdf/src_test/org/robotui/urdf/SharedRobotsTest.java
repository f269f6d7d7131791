package org.robotui.urdf;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.urdf.mesh.MeshRead;
import org.robotui.urdf.mesh.MeshReader;
import org.robotui.urdf.pack.PackageFile;
import org.robotui.urdf.pack.PackageFolders;

/** Models of real robots. */
class SharedRobotsTest {
  private static RobotModel model(String path) {
    Parsed<RobotModel> read = Urdf.parse(SharedRobots.text(path));
    return read.found().orElseThrow(() -> new AssertionError(read));
  }

  private static double mass(RobotModel model) {
    return model.links().stream().flatMap(link -> link.inertial().stream()).mapToDouble(Inertial::mass).sum();
  }

  @Test
  void everyModelLoadsWithAllItsMeshes() throws IOException {
    PackageFolders folders = new PackageFolders(List.of(SharedRobots.folder()));
    for (Path file : SharedRobots.all(".urdf")) {
      RobotModel model = model(file.toString());
      Set<String> uris = new TreeSet<>();
      model.links().forEach(link -> {
        link.visuals().forEach(v -> uri(v.geometry(), uris));
        link.collisions().forEach(c -> uri(c.geometry(), uris));
      });
      assertFalse(uris.isEmpty() && !file.toString().contains("collision"));
      for (String uri : uris) {
        PackageFile.Found found = assertInstanceOf(PackageFile.Found.class, folders.find(uri), uri);
        MeshRead read = MeshReader.read(uri, found.bytes(),
            name -> folders.beside(found, name).found().map(SharedRobotsTest::bytes));
        MeshRead.Ok ok = assertInstanceOf(MeshRead.Ok.class, read, () -> uri + ": " + read);
        assertEquals(List.of(), ok.warnings(), uri);
      }
    }
  }

  @Test
  void thePandaStandsWhereItsMakerSays() {
    RobotModel panda = model("panda_description/urdf/panda.urdf");
    assertEquals(13, panda.links().size());
    assertEquals(12, panda.joints().size());
    assertEquals(17.4519, mass(panda), 1e-4);
    Kinematics kinematics = new Kinematics(panda);
    KinematicsTest.assertNear(0.088, 0, 0.926, relative(kinematics, Map.of(), "panda_link0", "panda_link8"), 1e-6);
    Map<String, Double> bent = Map.of("panda_joint2", -0.785398, "panda_joint4", -2.356194, "panda_joint6", 1.570796,
        "panda_joint7", 0.785398);
    KinematicsTest.assertNear(0.306891, 0, 0.590282, relative(kinematics, bent, "panda_link0", "panda_link8"), 1e-5);
    SemanticModel semantics =
        Srdf.parse(SharedRobots.text("panda_description/srdf/panda.srdf"), panda).found().orElseThrow();
    assertEquals(8, semantics.group("arm_and_hand").orElseThrow().joints().size());
  }

  @Test
  void theHuskyStandsOnItsWheels() {
    RobotModel husky = model("husky_description/urdf/husky.urdf");
    assertEquals(15, husky.links().size());
    assertEquals(56.582, mass(husky), 1e-3);
    KinematicsTest.assertNear(0.256, 0.2854, 0.03282,
        relative(new Kinematics(husky), Map.of(), "base_link", "front_left_wheel_link"), 1e-6);
  }

  @Test
  void theHumanoidHasItsHome() {
    RobotModel coman = model("coman_urdf/urdf/coman.urdf");
    assertEquals(68, coman.links().size());
    assertEquals(32.0539, mass(coman), 1e-4);
    Kinematics kinematics = new Kinematics(coman);
    KinematicsTest.assertNear(0, 0.0726, -0.5168, relative(kinematics, Map.of(), "Waist", "l_sole"), 1e-4);
    SemanticModel semantics = Srdf.parse(SharedRobots.text("coman_urdf/srdf/coman.srdf"), coman).found().orElseThrow();
    Map<String, Double> home =
        semantics.states().stream().filter(s -> s.name().equals("home")).findFirst().orElseThrow().positions();
    assertEquals(29, home.size());
    KinematicsTest.assertNear(0.0914, 0.211909, 0.076352, relative(kinematics, home, "Waist", "l_wrist"), 1e-5);
    Set<String> groups = semantics.groups().stream().map(SemanticModel.Group::name).collect(Collectors.toSet());
    assertEquals(true, groups.containsAll(Set.of("left_arm", "right_arm", "left_leg", "right_leg", "torso")),
        groups.toString());
  }

  @Test
  void brokenRealModelsAreRefusedInWordsOrRead() {
    Random random = new Random(7);
    for (Path file : SharedRobots.all(".urdf")) {
      String text = SharedRobots.text(file.toString());
      for (int round = 0; round < 60; round++) {
        String broken = Mutator.text(text, random);
        assertDoesNotThrow(() -> Urdf.parse(broken), file::toString);
      }
    }
  }

  private static Vector3 relative(Kinematics kinematics, Map<String, Double> joints, String from, String to) {
    Map<String, RigidTransform> places = kinematics.rootFromLinks(joints, Map.of());
    return places.get(from).inverse().times(places.get(to)).translation();
  }

  private static void uri(Geometry geometry, Set<String> into) {
    if (geometry instanceof Geometry.MeshFile mesh) {
      into.add(mesh.uri());
    }
  }

  private static byte[] bytes(PackageFile.Found file) {
    try {
      return Files.readAllBytes(file.file());
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }
}
