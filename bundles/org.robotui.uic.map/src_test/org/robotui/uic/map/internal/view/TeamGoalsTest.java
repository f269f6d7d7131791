package org.robotui.uic.map.internal.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.SourceId;
import org.robotui.data.FrameId;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeFrames;
import org.robotui.testkit.FakeOutput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.uic.map.internal.MapOptions;
import org.robotui.uic.map.internal.MapPorts;

class TeamGoalsTest {
  private static final FrameId HALL = new FrameId("hall", "map");

  private final FakeUicContext context = new FakeUicContext("map", MapOptions.schema());
  private final FakeFrames frames = new FakeFrames();
  private final Map<String, FakeAuthority> robots = new LinkedHashMap<>();
  private final FakeOutput<NavigationGoal> output = context.output(MapPorts.GOALS);
  private final TeamGoals goals = new TeamGoals(context);

  @BeforeEach
  void gather() {
    for (int i = 1; i <= 3; i++) {
      robots.put("base" + i, new FakeAuthority("r" + i));
      frames.fix(HALL, new FrameId("r" + i, "map"), RigidTransform.planar(0, 10 * (i - 1), 0));
    }
    context.frames(frames);
    context.ruic().team(robots);
    targets("base1.goal", "base2.goal", "base3.goal");
  }

  private void targets(String... ports) {
    output.targets(List.of(ports).stream()
        .map(p -> new SourceId(p.substring(0, p.indexOf('.')), p.substring(p.indexOf('.') + 1))).toList());
  }

  @Test
  void eachGetsASpotOfItsOwnInAFrameOfItsOwn() {
    TeamGoals.Sent sent = goals.send(List.of("r1", "r3"), HALL, RigidTransform.planar(5, 20, 0), 1);
    assertEquals("Goal sent to 2 robots", sent.told().text());
    assertEquals(2, output.sent().size());
    NavigationGoal first = output.sent().getFirst().command();
    NavigationGoal last = output.sent().getLast().command();
    assertEquals(List.of(new SourceId("base3", "goal")), output.sent().getLast().targets());
    assertEquals(new FrameId("r3", "map"), last.frame());
    assertEquals(1, Math.abs(first.pose().translation().y() - (last.pose().translation().y() + 20)), 1e-9,
        "a metre from one another");
    assertEquals(Optional.of(FakeAuthority.YOU), robots.get("base1").holder());
    assertEquals(Optional.empty(), robots.get("base2").holder());
  }

  @Test
  void whatOneCannotDoesNotKeepTheOthers() {
    robots.get("base2").take(FakeAuthority.ANNA, false);
    targets("base1.goal", "base2.goal");
    TeamGoals.Sent sent = goals.send(List.of("r1", "r2", "r3"), HALL, RigidTransform.IDENTITY, 1);
    assertEquals("Goal sent to r1, but not to r2: Anna controls it; r3: it takes no goals", sent.told().text());
    assertEquals(Set.of("r1"), sent.spots().keySet());
    assertEquals(Set.of("r1", "r2"), goals.robots());
  }

  @Test
  void ofSeveralKindsOfGoalsTheUsualOneIsTaken() {
    targets("base1.move_base_simple/goal", "base1.dock");
    goals.send(List.of("r1"), HALL, RigidTransform.IDENTITY, 1);
    assertEquals("move_base_simple/goal", output.sent().getFirst().targets().getFirst().port());
    targets("base1.dock", "base1.charge");
    assertTrue(
        goals.send(List.of("r1"), HALL, RigidTransform.IDENTITY, 1).told().text().contains("map.goals: base1.dock"));
  }

  @Test
  void whoIsNotJoinedCannotBeSentThere() {
    FrameId elsewhere = new FrameId("r9", "odom");
    assertTrue(goals.send(List.of("r1"), elsewhere, RigidTransform.IDENTITY, 1).told().text()
        .contains("write it under 'frames'"));
  }

  @Test
  void spotsAreApartAndAroundThePlace() {
    for (int count = 1; count <= 50; count++) {
      List<RigidTransform> spots = TeamGoals.spots(count, RigidTransform.planar(7, 3, 1), 0.8);
      assertEquals(count, spots.size());
      Set<Vector3> places = new HashSet<>();
      spots.forEach(s -> places.add(s.translation()));
      assertEquals(count, places.size());
      for (Vector3 a : places) {
        assertTrue(places.stream().allMatch(b -> a == b || a.minus(b).norm() > 0.79));
        assertTrue(a.minus(new Vector3(7, 3, 0)).norm() < 0.8 * Math.sqrt(count) + 0.01);
      }
    }
  }

  @Test
  void oneIsToldWhereItIsInAFrameOfItsOwn() {
    FakeOutput<PoseEstimate> poses = context.output(MapPorts.INITIAL_POSES);
    poses.targets(List.of(new SourceId("base1", "initialpose"), new SourceId("base2", "initialpose"),
        new SourceId("base2", "other_pose")));

    assertEquals("Pose sent to r2", goals.place("r2", HALL, RigidTransform.planar(5, 20, 1)).text());

    FakeOutput.Sent<PoseEstimate> sent = poses.sent().getFirst();
    assertEquals(List.of(new SourceId("base2", "initialpose")), sent.targets());
    assertEquals(new FrameId("r2", "map"), sent.command().frame());
    assertEquals(10, sent.command().pose().translation().y(), 1e-9);
    assertEquals("Not sent. r3: it takes no poses", goals.place("r3", HALL, RigidTransform.planar(5, 20, 1)).text());
    assertEquals(0, output.sent().size());
  }
}
