package org.robotui.uic.scene3d.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Framed;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.image.Image;
import org.robotui.data.marker.Color;
import org.robotui.data.marker.Marker;
import org.robotui.data.marker.MarkerSet;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.DisplayType;
import org.robotui.testkit.FakeFrames;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Health;
import org.robotui.ui.display.DisplayRow;
import org.robotui.ui.display.DisplaySpec;
import org.robotui.ui.display.SourceChoice;
import org.robotui.ui.scene.Commander;
import org.robotui.uic.scene3d.internal.SceneOptions;
import org.robotui.uic.scene3d.internal.ScenePorts;
import org.robotui.uic.scene3d.internal.waypoint.Tour;
import org.robotui.uic.scene3d.internal.waypoint.Waypoints;

class SceneModelTest {
  private static final FrameId MAP = new FrameId("a", "map");
  private static final FrameId BASE = new FrameId("a", "base_link");
  private static final SourceId POSE = new SourceId("base", "/pose");
  private static final SourceId OTHER = new SourceId("base", "/other");

  private final FakeUicContext context = new FakeUicContext("scene", SceneOptions.schema());
  private final FakeFrames frames = new FakeFrames();
  private final FakeInput<Data> input = context.input(ScenePorts.DATA);
  private final FakeKind grid = new FakeKind("grid", List.of());
  private final FakeKind pose = new FakeKind("pose", List.of(PoseEstimate.class, StampedPose.class));
  private final List<DisplayType> kinds = new ArrayList<>(List.of(grid, pose));
  private SceneModel model;
  private Edits edits;

  private void start() {
    context.frames(frames);
    model = new SceneModel(context, () -> List.copyOf(kinds), new DisplayContext() {
      @Override
      public Executor background() {
        return Runnable::run;
      }

      @Override
      public void wake() {
        // Each tick is made by hand.
      }

      @Override
      public CommandOutcome send(Data command) {
        return new CommandOutcome.Accepted();
      }
    }, new Waypoints(context.settings(), new Tour(new Commander(context, ScenePorts.GOAL, ScenePorts.INITIAL_POSE),
        context.output(ScenePorts.GOAL), context.principal(), told -> {})));
    edits = new Edits(context.settings(), model::specs);
  }

  private void offer(SourceId... sources) {
    input.candidates(List.of(sources).stream().map(s -> new Input.Candidate(s, "PoseEstimate")).toList());
  }

  private void put(SourceId source) {
    input.put(source, new PoseEstimate(BASE, RigidTransform.IDENTITY, Doubles.wrap(new double[0])), System.nanoTime(),
        Optional.empty());
  }

  private DisplayRow row(int number) {
    return model.stage().rows().get(number);
  }

  @Test
  void withoutDisplaysTheSceneShowsWhatTheRobotOffersOnce() {
    frames.fix(MAP, BASE, RigidTransform.IDENTITY);
    offer(POSE);
    start();
    assertTrue(model.tick(0));
    assertEquals(List.of("grid", "pose"), model.stage().rows().stream().map(r -> r.spec().type()).toList());
    assertEquals(Set.of(POSE), input.chosen());
    assertEquals(Optional.of(MAP), model.stage().fixed());
    put(POSE);
    assertTrue(model.tick(1));
    assertEquals(1, pose.ticks.getLast().arrived().size());
    assertEquals("1 lines", row(1).words());
    assertEquals(Health.OK, row(1).health());
    assertFalse(model.tick(2));
  }

  @Test
  void afterAJumpOfTheClockDisplaysAreGivenAgainWhatRobotsSayButOnce() {
    offer(POSE, OTHER);
    start();
    model.tick(0);
    input.put(POSE, new StampedPose(BASE, RigidTransform.IDENTITY), System.nanoTime(), Optional.empty());
    put(OTHER);
    model.tick(1);
    context.ruic().reset();
    model.tick(2);
    List<DisplayTick> last = pose.ticks.subList(pose.ticks.size() - 2, pose.ticks.size());
    assertTrue(last.stream().allMatch(DisplayTick::reset));
    assertEquals(List.of(OTHER), last.stream().flatMap(t -> t.arrived().stream()).map(e -> e.source()).toList());
    model.tick(3);
    assertFalse(pose.ticks.getLast().reset());
  }

  @Test
  void whatNobodyPublishesAnyMoreIsOldWhateverItsDisplayMakesOfIt() {
    offer(POSE);
    start();
    model.tick(0);
    put(POSE);
    model.tick(1);
    input.state(POSE, InputState.Stale.lost(20, "base.pose: nobody publishes /pose any more", 12));
    model.tick(2);
    assertEquals(Health.STALE, row(1).health());
    assertTrue(row(1).words().startsWith("lost for 12"), row(1).words());
    assertTrue(row(1).words().endsWith("nobody publishes /pose any more"), row(1).words());
  }

  @Test
  void twoSourcesGiveTwoDisplaysWithNames() {
    offer(POSE, OTHER);
    start();
    model.tick(0);
    assertEquals(List.of("Fake grid", "pose · Fake pose", "other · Fake pose"),
        model.stage().rows().stream().map(DisplayRow::name).toList());
    put(OTHER);
    model.tick(1);
    assertTrue(model.stage().parts().containsKey(row(2).spec().id()));
    assertFalse(model.stage().parts().containsKey(row(1).spec().id()));
  }

  @Test
  void anAddedDisplayTakesTheOnlySourceAndSaysWhichWhereThereAreSeveral() {
    offer(POSE, OTHER);
    start();
    edits.automatic();
    context.settings().set(SceneOptions.DISPLAYS, List.of(Map.of("type", "pose")));
    model.tick(0);
    assertEquals(Health.WAITING, row(0).health());
    assertEquals("several give PoseEstimate, choose one as source: base/pose, base/other", row(0).words());
    offer(POSE);
    model.tick(1);
    assertEquals(Set.of(POSE), input.chosen());
    offer();
    model.tick(2);
    assertTrue(row(0).words().startsWith("no PoseEstimate is offered"), row(0).words());
  }

  @Test
  void aDisplayThatIsSwitchedOffAsksForNothingAndHoldsNothing() {
    offer(POSE);
    start();
    model.tick(0);
    put(POSE);
    model.tick(1);
    edits.change(row(1).spec().id(), s -> s.show(false));
    model.tick(2);
    assertEquals(Set.of(), input.chosen());
    assertEquals(0, pose.open);
    assertEquals(0, row(1).bytes());
    assertEquals("switched off", row(1).words());
  }

  @Test
  void aDisplayThatThrowsIsSwitchedOffWithItsWordsAndTheOthersGoOn() {
    offer(POSE);
    start();
    pose.throwing = true;
    model.tick(0);
    assertEquals(Health.BAD, row(1).health());
    assertTrue(row(1).words().contains("the data bite"), row(1).words());
    assertEquals(0, pose.open);
    assertEquals(Health.OK, row(0).health());
    int before = pose.ticks.size();
    model.tick(1);
    assertEquals(before, pose.ticks.size());
    pose.throwing = false;
    edits.change(row(1).spec().id(), s -> s.show(false));
    model.tick(2);
    edits.change(row(1).spec().id(), s -> s.show(true));
    model.tick(3);
    assertEquals(Health.OK, row(1).health());
  }

  @Test
  void aMissingKindIsWaitedForAndRevives() {
    offer(POSE);
    kinds.remove(pose);
    start();
    context.settings().set(SceneOptions.DISPLAYS, List.of(Map.of("type", "pose", "name", "Mine")));
    model.tick(0);
    assertEquals("waits for a bundle that brings displays of type 'pose'", row(0).words());
    kinds.add(pose);
    model.tick(1);
    assertEquals("Mine", row(0).name());
    assertEquals(1, pose.open);
    kinds.remove(pose);
    model.tick(2);
    assertEquals(0, pose.open);
    FakeKind renewed = new FakeKind("pose", List.of(PoseEstimate.class));
    kinds.add(renewed);
    model.tick(3);
    assertEquals(1, renewed.open);
  }

  @Test
  void anotherOrderAndAnotherNameKeepWhatADisplayHolds() {
    offer(POSE, OTHER);
    start();
    model.tick(0);
    String second = row(2).spec().id();
    edits.move(second, -1);
    edits.change(second, s -> s.named("Mine"));
    model.tick(1);
    assertEquals(second, row(1).spec().id());
    assertEquals("Mine", row(1).name());
    assertEquals(2, pose.open);
  }

  @Test
  void wrongSettingsFallBackAndAreSaid() {
    start();
    context.settings().set(SceneOptions.DISPLAYS,
        List.of(Map.of("type", "grid", "settings", Map.of("size", 99L, "style", "round"))));
    model.tick(0);
    assertEquals(1.0, row(0).settings().orElseThrow().number("size"));
    assertEquals("round", row(0).settings().orElseThrow().text("style"));
    assertEquals("size is 99, must be a number from 0 to 10 in m", row(0).words());
    assertEquals(Health.WARNING, row(0).health());
  }

  @Test
  void robotsStandWhereTheConfigurationSays() {
    FrameId otherMap = new FrameId("b", "map");
    FrameId otherBase = new FrameId("b", "base_link");
    frames.fix(MAP, BASE, RigidTransform.planar(1, 0, 0));
    frames.fix(otherMap, otherBase, RigidTransform.planar(1, 0, 0));
    context.settings().set(SceneOptions.FIXED_FRAME, "a/map");
    context.settings().set(SceneOptions.FRAMES,
        List.of(Map.of("parent", "a/map", "child", "b/map", "y", 2.0, "yaw", Math.PI / 2)));
    start();
    model.tick(0);
    assertEquals(Optional.of(MAP), model.stage().fixed());
    List<Stage.Robot> robots = model.stage().robots();
    assertEquals(List.of("a", "b"), robots.stream().map(Stage.Robot::name).toList());
    assertEquals(1, robots.get(0).fixedFromBase().orElseThrow().translation().x(), 1e-12);
    assertEquals(0, robots.get(1).fixedFromBase().orElseThrow().translation().x(), 1e-12);
    assertEquals(3, robots.get(1).fixedFromBase().orElseThrow().translation().y(), 1e-12);
    assertFalse(robots.get(0).color().equals(robots.get(1).color()));
  }

  /** As a publisher of markers alone, without any transform. */
  private static MarkerSet marker(String frame) {
    Marker.Key key = new Marker.Key("things", 1);
    return new MarkerSet(false,
        List.of(new MarkerSet.Entry(key, Optional.of(new Marker(key, new FrameId("a", frame), Optional.empty(), 0,
            Marker.Type.CUBE, RigidTransform.IDENTITY, new Vector3(1, 1, 1), new Color(1, 0, 0, 1), 0, false,
            Floats.EMPTY, Bytes.EMPTY, "", "", false)))));
  }

  @Test
  void aFrameThatOnlyMarkersNameIsDrawnInAndCanBeChosen() {
    kinds.add(new FakeKind("markers", List.of(MarkerSet.class)));
    input.candidates(List.of(new Input.Candidate(OTHER, "MarkerSet")));
    start();
    model.tick(0);
    assertEquals(Optional.empty(), model.stage().fixed());
    input.put(OTHER, marker("world"), System.nanoTime(), Optional.empty());
    model.tick(1);
    assertEquals(Optional.of(new FrameId("a", "world")), model.stage().fixed());
    frames.fix(MAP, BASE, RigidTransform.IDENTITY);
    model.tick(2);
    assertEquals(Optional.of(MAP), model.stage().fixed());
    assertEquals(List.of("base_link", "map", "world"), model.stage().frames().stream().map(FrameId::name).toList());
    edits.fixedFrame("world");
    model.tick(3);
    assertEquals(Optional.of(new FrameId("a", "world")), model.stage().fixed());
  }

  @Test
  void withoutAnybodyLookingNothingIsAskedFor() {
    offer(POSE);
    start();
    model.tick(0);
    model.rest();
    assertEquals(Set.of(), input.chosen());
    assertEquals(0, pose.open);
    model.tick(1);
    assertEquals(Set.of(POSE), input.chosen());
  }

  @Test
  void aGeneralTypeTakesAllThatAreOfIt() {
    FakeKind image = new FakeKind("image", List.of(Image.class));
    input.candidates(List.of(new Input.Candidate(POSE, "RawImage"), new Input.Candidate(OTHER, "Path")));
    DisplaySpec spec = DisplaySpec.of("image", "image");
    assertEquals(Set.of(POSE), SourceChoice.of(spec, Kinds.of(image), input.candidates()).sources());
  }

  @Test
  void aSourceThatIsNamedDecidesWhichRobotTheOtherTypesComeFrom() {
    SourceId far = new SourceId("far", "/pose");
    SourceId farMore = new SourceId("far", "/more");
    List<Input.Candidate> offered =
        List.of(new Input.Candidate(POSE, "PoseEstimate"), new Input.Candidate(far, "PoseEstimate"),
            new Input.Candidate(OTHER, "StampedPose"), new Input.Candidate(farMore, "StampedPose"));
    SourceChoice choice =
        SourceChoice.of(DisplaySpec.of("pose", "pose").from(List.of("far/pose")), Kinds.of(pose), offered);
    assertEquals(Set.of(far, farMore), choice.sources());
    assertEquals(Set.of(far), choice.needed());
  }

  @Test
  void removingTheLastDisplayLeavesNone() {
    start();
    model.tick(0);
    edits.remove(row(0).spec().id());
    model.tick(1);
    assertEquals(List.of(), model.stage().rows());
    edits.automatic();
    model.tick(2);
    assertEquals(1, model.stage().rows().size());
  }

  /** A type of data that neither core nor the scene knows. */
  public record Spill(FrameId frame) implements Data, Framed {
    @Override
    public Stream<FrameId> frames() {
      return Stream.of(frame);
    }
  }

  @Test
  void aTypeThatNobodyKnewIsShownOnceABundleBringsADisplayForIt() {
    SourceId spill = new SourceId("base", "/spill");
    input.candidates(List.of(new Input.Candidate(spill, "Spill")));
    start();
    model.tick(0);
    assertEquals(Set.of(), input.chosen());
    FakeKind kind = new FakeKind("spill", List.of(Spill.class));
    kinds.add(kind);
    model.tick(1);
    assertEquals(Set.of(spill), input.chosen());
    input.put(spill, new Spill(MAP), System.nanoTime(), Optional.empty());
    model.tick(2);
    assertEquals(1, kind.ticks.getLast().arrived().size());
    assertEquals(Optional.of(MAP), model.stage().fixed(), "its frame can be shown");
    kinds.remove(kind);
    model.tick(3);
    assertEquals(Set.of(), input.chosen());
  }
}
