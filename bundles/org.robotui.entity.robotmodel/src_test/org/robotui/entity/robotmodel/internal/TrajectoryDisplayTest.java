package org.robotui.entity.robotmodel.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.data.array.Doubles;
import org.robotui.data.joint.DisplayedTrajectory;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.JointTrajectory;
import org.robotui.data.joint.RobotDescription;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Properties;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;

class TrajectoryDisplayTest {
  private final DisplayProbe probe = new DisplayProbe(new TrajectoryType(new ModelShelf()));

  TrajectoryDisplayTest() {
    probe.places().put("base", RigidTransform.planar(1, 0, 0));
  }

  @AfterEach
  void end() {
    probe.close();
  }

  private DisplayResult give(Data... data) {
    probe.tick(Arm.description());
    return probe.tick(data);
  }

  private static <T extends DisplayStatus> String words(Class<T> kind, DisplayResult result) {
    return assertInstanceOf(kind, result.status(), () -> result.status().words()).words();
  }

  private static Optional<Part> find(DisplayResult result, String key) {
    return result.parts().stream().filter(part -> part.key().toString().contains(key)).findFirst();
  }

  private static Vector3 place(DisplayResult result, String link) {
    return find(result, "figure=0, link=" + link).orElseThrow().fixedFromShape().translation();
  }

  private static void near(Vector3 expected, Vector3 actual) {
    assertEquals(0, expected.minus(actual).norm(), 1e-6, actual.toString());
  }

  @Test
  void saysWhatItWaitsFor() {
    assertEquals("asking for base/plan",
        words(DisplayStatus.NoData.class, probe.state(new InputState.Waiting("asking for base/plan")).tick()));
    assertTrue(
        words(DisplayStatus.NoData.class, probe.state(new InputState.Live(1, 0)).tick()).contains("No trajectory yet"));
    assertTrue(words(DisplayStatus.NoData.class, probe.tick(Arm.sweep(3))).contains("robot_description"));
    assertInstanceOf(DisplayStatus.Shown.class, probe.tick(Arm.description()).status());
  }

  @Test
  void movesAGhostOfTheMovingLinksAlongThePlan() {
    DisplayResult start = give(Arm.sweep(3));
    assertEquals("3 points, 2.0 s; no joint states to compare with", words(DisplayStatus.Shown.class, start));
    assertTrue(find(start, "link=base").isEmpty(), "what does not move is not shown twice");
    near(new Vector3(1.75, 0, 0.5), place(start, "tool"));
    DisplayResult later = start;
    for (int i = 0; i < 10; i++) {
      later = probe.tick();
    }
    near(new Vector3(1 + 0.75 * Math.sqrt(0.5), 0.75 * Math.sqrt(0.5), 0.75), place(later, "tool"));
    assertSame(find(start, "link=beam").orElseThrow().shape(), find(later, "link=beam").orElseThrow().shape());
    assertEquals(0.4, find(later, "link=beam").orElseThrow().material().color().alpha(), 1e-6);
  }

  @Test
  void repeatsStopsOrStandsAtTheEnd() {
    DisplayResult result = give(Arm.sweep(3));
    probe.set(TrajectoryType.SPEED, 10.0);
    for (int i = 0; i < 3; i++) {
      result = probe.tick();
    }
    near(new Vector3(1.75, 0, 0.5), place(result, "tool"));
    probe.set(TrajectoryType.REPEAT, "once");
    near(new Vector3(1, 0.75, 1), place(probe.tick(), "tool"));
    near(new Vector3(1, 0.75, 1), place(probe.tick(), "tool"));
    probe.set(TrajectoryType.REPEAT, "end");
    near(new Vector3(1, 0.75, 1), place(give(Arm.sweep(3)), "tool"));
  }

  @Test
  void drawsTheWayOfALinkAndATrail() {
    DisplayResult result = give(Arm.sweep(9));
    LineSet way = (LineSet) find(result, "path").orElseThrow().shape();
    assertEquals(8, way.elements());
    assertEquals(0.75, way.xyz().get(0), 1e-6, "the tool lies behind the beam that the last joint moves");
    probe.set(TrajectoryType.LINK, "mast").set(TrajectoryType.TRAIL, 4L);
    DisplayResult other = probe.tick();
    assertEquals(0, ((LineSet) find(other, "path").orElseThrow().shape()).xyz().get(0), 1e-6,
        "the mast turns where it stands");
    assertEquals(List.of(1, 2, 3),
        other.parts().stream().map(Part::key).map(Object::toString).filter(key -> key.contains("link=tool"))
            .map(key -> Integer.parseInt(key.replaceAll(".*figure=(\\d+).*", "$1"))).filter(figure -> figure > 0)
            .toList());
    probe.set(TrajectoryType.LINK, "finger");
    assertTrue(words(DisplayStatus.Partly.class, probe.tick()).contains("no link 'finger'"));
  }

  @Test
  void comparesWhatWasExecuted() {
    give(Arm.at(0, 0), Arm.sweep(9));
    for (int i = 0; i <= 20; i++) {
      // half a turn behind its height: the plan rises with the turn, the robot first turns and then rises
      probe.tick(Arm.at(Math.PI / 2 * Math.min(1, i / 10.0), 0.5 * Math.max(0, i / 10.0 - 1)));
    }
    DisplayResult result = probe.tick();
    assertTrue(find(result, "executed").orElseThrow().shape().elements() > 10);
    String words = words(DisplayStatus.Shown.class, result);
    assertTrue(words.matches("9 points, 2\\.0 s; at most 0\\.\\d{3} (m|rad) off \\((lift|turn)\\)"), words);
    Properties said = find(result, "executed").orElseThrow().describer().describe(0, Vector3.ZERO);
    assertEquals("Executed path of tool", said.title());
    assertTrue(
        said.entries().stream().anyMatch(entry -> entry.name().equals("lift") && entry.value().endsWith(" m off")),
        said.toString());
    assertTrue(
        said.entries().stream().anyMatch(entry -> entry.name().equals("turn") && entry.value().endsWith(" rad off")),
        said.toString());
    assertTrue(find(give(Arm.sweep(9)), "executed").isEmpty(), "another plan begins anew");
  }

  @Test
  void aWholeTurnIsNoDeviationAndOnTheWayNothingDeviates() {
    give(Arm.at(2 * Math.PI, 0), Arm.sweep(9));
    probe.tick(Arm.at(2 * Math.PI + Math.PI / 4, 0.25));
    assertEquals("9 points, 2.0 s; at most 0.000 rad off (turn)", words(DisplayStatus.Shown.class, probe.tick()));
  }

  @Test
  void aDisplayedTrajectoryGoesOnPartByPartFromItsStart() {
    JointTrajectory second = new JointTrajectory(List.of("lift"), List.of(Arm.point(1, 0.4), Arm.point(2, 0.1)));
    DisplayResult result = give(new DisplayedTrajectory("arm", List.of(Arm.joint("lift", 0.2)),
        List.of(new JointTrajectory(List.of("turn"), List.of(Arm.point(0, 0), Arm.point(1, Math.PI))), second)));
    assertEquals("4 points, 3.0 s; no joint states to compare with", words(DisplayStatus.Shown.class, result));
    near(new Vector3(1.75, 0, 0.7), place(result, "tool"));
    probe.set(TrajectoryType.REPEAT, "end");
    near(new Vector3(0.25, 0, 0.6), place(probe.tick(), "tool"));
  }

  @Test
  void aTrajectoryThatBeginsLaterComesFromWhereTheRobotIs() {
    DisplayResult result = give(Arm.at(0, 0.3), Arm.way(Arm.point(1, 0, 0.5)));
    assertTrue(words(DisplayStatus.Shown.class, result).startsWith("2 points, 1.0 s"));
    near(new Vector3(1.75, 0, 0.8), place(result, "tool"));
  }

  @Test
  void saysWhyNothingIsSeen() {
    assertTrue(words(DisplayStatus.NoData.class, give(Arm.way())).contains("no points"));
    assertEquals("nothing is planned",
        words(DisplayStatus.Shown.class, give(new DisplayedTrajectory("arm", List.of(), List.of()))));
    assertEquals(
        "Nothing of the trajectory can be shown: the model 'arm' has no movable joint 'elbow' (and 1 more of the trajectory).",
        words(DisplayStatus.Unfit.class,
            give(new JointTrajectory(List.of("elbow", "mount"), List.of(Arm.point(0, 1, 1))))));
    assertTrue(words(DisplayStatus.Unfit.class, give(new JointTrajectory(List.of(), List.of(Arm.point(0)))))
        .contains("names no joints"));
    assertEquals("The times of the trajectory do not increase: point 2 is at 0.5 s, the one before at 1.0 s.",
        words(DisplayStatus.Unfit.class, give(Arm.way(Arm.point(0, 0, 0), Arm.point(1, 0, 0), Arm.point(0.5, 0, 0)))));
    assertTrue(words(DisplayStatus.Unfit.class, give(Arm.way(Arm.point(0, 0, 0), Arm.point(1))))
        .contains("Point 1 of the trajectory has no positions"));
  }

  @Test
  void aClockThatJumpsBackEndsIt() {
    give(Arm.sweep(2));
    assertTrue(words(DisplayStatus.NoData.class, probe.reset()).contains("No trajectory yet"));
  }

  @Test
  void saysThatItsRootHasNoPlace() {
    DisplayProbe lost = new DisplayProbe(new TrajectoryType(new ModelShelf()));
    lost.tick(Arm.description());
    assertTrue(words(DisplayStatus.NoFrame.class, lost.tick(Arm.sweep(2))).contains("from base to map"));
    lost.close();
  }

  @Test
  void isShownOnlySoLong() {
    probe.set(TrajectoryType.TIMEOUT, 0.25);
    assertInstanceOf(DisplayStatus.Shown.class, give(Arm.sweep(2)).status());
    probe.tick();
    probe.tick();
    assertTrue(words(DisplayStatus.TooOld.class, probe.tick()).contains("s ago"));
  }

  @Test
  void hostileNumbersAreRefused() {
    for (double wrong : new double[]{Double.NaN, Double.POSITIVE_INFINITY}) {
      assertTrue(words(DisplayStatus.Unfit.class, give(Arm.way(Arm.point(0, wrong, 0)))).contains("no finite number"));
      assertTrue(words(DisplayStatus.Unfit.class, give(Arm.way(Arm.point(0, 0, 0), Arm.point(wrong, 0, 0))))
          .contains("do not increase"));
    }
    assertInstanceOf(DisplayStatus.Shown.class,
        give(new JointState(List.of(Arm.joint("turn", Double.NaN))), Arm.sweep(2)).status());
    assertTrue(
        words(DisplayStatus.Unfit.class, give(new RobotDescription(FakePlaces.ROBOT, "p", "<robot/>", "", List.of())))
            .contains("cannot be read"));
  }

  @Test
  void ofAMillionPointsSomeThousandsAreKept() {
    DisplayResult result = give(Arm.sweep(1_000_000));
    assertEquals("Shown in part: of 1000000 points every 100th is shown.", words(DisplayStatus.Partly.class, result));
    probe.set(TrajectoryType.TRAIL, 1L);
    assertTrue(probe.tick().parts().size() <= (Ghost.MOST_FIGURES + 1) * 3 + 2);
    JointTrajectory one = Arm.way(Arm.point(0, 0, 0));
    DisplayResult many = give(new DisplayedTrajectory("", List.of(), Collections.nCopies(50_000, one)));
    assertTrue(words(DisplayStatus.Partly.class, many).contains("every 5th"));
  }

  @Test
  void pointsWithoutTimesAreSpread() {
    DisplayResult result = give(Arm.way(Arm.point(0, 0, 0), Arm.point(0, 1, 0), Arm.point(0, 2, 0)));
    assertTrue(words(DisplayStatus.Partly.class, result).contains("tell no times"));
  }

  @Test
  void whatTheModelLacksIsNamedAndTheRestIsShown() {
    DisplayResult result = give(new JointTrajectory(List.of("lift", "grip"),
        List.of(new JointTrajectory.Point(0, Doubles.of(0.1, 9), Doubles.EMPTY,
            Doubles.EMPTY, Doubles.EMPTY))));
    assertTrue(words(DisplayStatus.Partly.class, result).contains("no movable joint 'grip'"));
    near(new Vector3(1.75, 0, 0.6), place(result, "tool"));
  }
}
