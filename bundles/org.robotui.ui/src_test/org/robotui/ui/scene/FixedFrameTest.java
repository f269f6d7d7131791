package org.robotui.ui.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.testkit.FakeFrames;

class FixedFrameTest {
  private static final FrameId MAP = frame("map");
  private static final FrameId ODOM = frame("odom");
  private static final FrameId WORLD = frame("world");
  private static final FrameId BASE = frame("base_link");
  private final FakeFrames frames = new FakeFrames();

  @Test
  void mapComesBeforeOdom() {
    frames.fix(MAP, ODOM, RigidTransform.IDENTITY);
    assertEquals(Optional.of(MAP), auto(List.of()));
  }

  @Test
  void ofTheMapsOfSeveralRobotsTheOneThatCarriesTheOthersIsTaken() {
    FrameId natalies = new FrameId("Natalie", "map");
    frames.fix(natalies, MAP, RigidTransform.IDENTITY);
    frames.fix(MAP, ODOM, RigidTransform.IDENTITY);
    frames.fix(WORLD, natalies, RigidTransform.IDENTITY);
    assertEquals(Optional.of(natalies), auto(List.of()));
  }

  @Test
  void odomIsTakenWhereOnlyTheDataNameAMap() {
    frames.fix(ODOM, BASE, RigidTransform.IDENTITY);
    assertEquals(Optional.of(ODOM), auto(List.of(MAP)));
  }

  @Test
  void elseTheFirstRootIsTaken() {
    frames.fix(WORLD, BASE, RigidTransform.IDENTITY);
    assertEquals(Optional.of(WORLD), auto(List.of()));
  }

  @Test
  void withoutTransformsTheFramesOfTheDataServe() {
    assertEquals(Optional.of(MAP), auto(List.of(frame("laser"), MAP)));
    assertEquals(Optional.of(frame("laser")), auto(List.of(frame("laser"))));
    assertEquals(Optional.empty(), auto(List.of()));
    assertEquals(Optional.empty(), auto(List.of(frame(""))));
  }

  @Test
  void theUsersChoiceWinsAlsoBeforeItIsThere() {
    frames.fix(MAP, ODOM, RigidTransform.IDENTITY);
    assertEquals(Optional.of(ODOM), FixedFrame.choose(Optional.of("odom"), frames, List.of()));
    assertEquals(Optional.of(ODOM), FixedFrame.choose(Optional.of("Keira:odom"), frames, List.of()));
    assertEquals(Optional.of(frame("utm")), FixedFrame.choose(Optional.of("utm"), frames, List.of()));
  }

  private Optional<FrameId> auto(List<FrameId> named) {
    return FixedFrame.choose(Optional.empty(), frames, named);
  }

  private static FrameId frame(String name) {
    return new FrameId("Keira", name);
  }
}
