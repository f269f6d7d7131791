package org.robotui.uic.map.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.FrameId;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.geometry.RigidTransform;
import org.robotui.testkit.FakeFrames;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Health;
import org.robotui.ui.layer.LayerNote;
import org.robotui.ui.scene.Layer;
import org.robotui.uic.map.internal.DemoRoom;
import org.robotui.uic.map.internal.LayerKinds;
import org.robotui.uic.map.internal.MapOptions;
import org.robotui.uic.map.internal.MapPorts;

class MapModelTest {
  private static final SourceId SCAN = new SourceId("base", "scan");
  private final FakeUicContext context = new FakeUicContext("map", MapOptions.schema());
  private final FakeFrames frames = new FakeFrames();
  private long now = System.nanoTime();

  @Test
  void withoutInputsItIsUnconnectedAndSaysWhatItShows() {
    MapModel model = model();
    tick(model);
    InputState.Unconnected state = assertInstanceOf(InputState.Unconnected.class, model.snapshot().state());
    assertTrue(state.explanation().contains("laser scans"), state.explanation());
  }

  @Test
  void everySourceGetsALayerOfItsOwnInOrder() {
    DemoRoom.fill(context, now);
    MapModel model = new MapModel(context, () -> LayerKinds.ALL);
    tick(model);
    assertEquals(List.of("grid", "map:base.map", "sonar:base.sonar", "scan:base.scan", "trail:base.odom",
        "path:base.plan", "robot", "bumper:base.bumper"), model.scene().layers().stream().map(Layer::id).toList());
    assertTrue(model.scene().layers().stream().allMatch(Layer::visible));
    assertEquals(List.of(), model.snapshot().notes());
    assertEquals(Optional.of(DemoRoom.MAP), model.snapshot().fixed());
  }

  @Test
  void nothingNewMeansNothingToShow() {
    DemoRoom.fill(context, now);
    MapModel model = new MapModel(context, () -> LayerKinds.ALL);
    assertTrue(tick(model));
    assertFalse(tick(model));
    context.input(MapPorts.SCAN).put(SCAN, DemoRoom.scan(), now, Optional.empty());
    assertTrue(tick(model));
  }

  @Test
  void aLayerWithoutATransformIsNotShownAndSaysWhy() {
    frames.fix(DemoRoom.ODOM, DemoRoom.BASE, RigidTransform.IDENTITY);
    MapModel model = model();
    context.input(MapPorts.SCAN).put(SCAN, DemoRoom.scan(), now, Optional.empty());
    tick(model);
    LayerNote note = model.snapshot().notes().getFirst();
    assertEquals(Health.WARNING, note.health());
    assertTrue(note.text().startsWith("scan: no transform odom \u2190 laser: "), note.text());
    assertFalse(layer(model, "scan:base.scan").visible());
  }

  @Test
  void whatNavigationSaysOfAFailedGoalIsKept() {
    MapModel model = model();
    navigation(NavigationStatus.State.ACTIVE, "");
    tick(model);
    assertEquals(List.of(), model.snapshot().failures());
    long said = now;
    navigation(NavigationStatus.State.ABORTED, "Failed to find a valid plan.");
    assertTrue(tick(model));
    assertEquals(List.of(new GoalFailure(said, "aborted: Failed to find a valid plan.")), model.snapshot().failures());
    navigation(NavigationStatus.State.REJECTED, "");
    tick(model);
    assertEquals("rejected by navigation", model.snapshot().failures().getFirst().words());
  }

  private void navigation(NavigationStatus.State state, String text) {
    context.input(MapPorts.NAVIGATION)
        .put(new SourceId("base", "move_base/result"), new NavigationStatus("1", state, text), now, Optional.empty());
  }

  @Test
  void theSameTroubleOfManyIsOneLine() {
    MapModel model = model();
    for (int i = 1; i <= 50; i++) {
      context.input(MapPorts.SCAN).put(new SourceId("base", "r" + i + "/scan"), DemoRoom.scan(), now, Optional.empty());
    }
    frames.fix(DemoRoom.ODOM, DemoRoom.BASE, RigidTransform.IDENTITY);
    tick(model);
    assertEquals(1, model.snapshot().notes().size(), () -> model.snapshot().notes().toString());
    String text = model.snapshot().notes().getFirst().text();
    assertTrue(text.startsWith("scan: 50 of 50 without a transform, for example scan r1/scan: no transform "), text);
  }

  @Test
  void aPathThatHasNotComeYetIsNoTroubleAndAScanIsNamedOnce() {
    DemoRoom.fill(context, now);
    MapModel model = new MapModel(context, () -> LayerKinds.ALL);
    SourceId planned = new SourceId("sam", "plan");
    SourceId scan = new SourceId("sam", "scan");
    context.input(MapPorts.PATH).state(planned, new InputState.Waiting("sam.plan: no data yet"));
    context.input(MapPorts.SCAN).state(scan, new InputState.Waiting("sam.scan: no data yet"));
    tick(model);
    assertEquals(List.of("scan: sam.scan: no data yet"),
        model.snapshot().notes().stream().map(LayerNote::text).toList());
  }

  @Test
  void twoRobotsWithEqualPortsAreToldApart() {
    MapModel model = model();
    frames.fix(DemoRoom.ODOM, DemoRoom.BASE, RigidTransform.IDENTITY);
    for (String robot : List.of("natalie", "otto")) {
      context.input(MapPorts.SCAN).put(new SourceId(robot, "scan"), DemoRoom.scan(), now, Optional.empty());
    }
    tick(model);
    assertEquals(List.of("scan natalie.scan", "scan otto.scan"),
        model.snapshot().notes().stream().map(n -> n.text().substring(0, n.text().indexOf(':'))).toList());
  }

  @Test
  void theLayerAppearsWhenTheTransformComes() {
    frames.fix(DemoRoom.ODOM, DemoRoom.BASE, RigidTransform.IDENTITY);
    MapModel model = model();
    context.input(MapPorts.SCAN).put(SCAN, DemoRoom.scan(), now, Optional.empty());
    tick(model);
    frames.fix(DemoRoom.BASE, DemoRoom.LASER, RigidTransform.IDENTITY);
    assertTrue(tick(model));
    assertTrue(layer(model, "scan:base.scan").visible());
    assertEquals(List.of(), model.snapshot().notes());
  }

  @Test
  void staleDataFadesAndSaysItsAge() {
    DemoRoom.fill(context, now);
    MapModel model = new MapModel(context, () -> LayerKinds.ALL);
    tick(model);
    context.input(MapPorts.SCAN).state(SCAN, new InputState.Stale(2.1, "the link is lost"));
    assertTrue(tick(model));
    assertTrue(layer(model, "scan:base.scan").faded());
    assertEquals(List.of(new LayerNote(Health.STALE, "scan stale 2.1\u00a0s")), model.snapshot().notes());
  }

  @Test
  void aSourceThatGoesTakesItsLayerAlong() {
    DemoRoom.fill(context, now);
    MapModel model = new MapModel(context, () -> LayerKinds.ALL);
    tick(model);
    context.input(MapPorts.SCAN).remove(SCAN);
    assertTrue(tick(model));
    assertTrue(model.scene().find("scan:base.scan").isEmpty());
    assertTrue(model.layers().detail("scan:base.scan", now).isEmpty());
  }

  @Test
  void layersAreShownAndHiddenBySettings() {
    DemoRoom.fill(context, now);
    MapModel model = new MapModel(context, () -> LayerKinds.ALL);
    tick(model);
    context.settings().set(MapOptions.show("sonar"), false);
    context.settings().set(MapOptions.HIDDEN, List.of("scan:base.scan"));
    assertTrue(tick(model));
    assertFalse(layer(model, "sonar:base.sonar").visible());
    assertFalse(layer(model, "scan:base.scan").visible());
    assertTrue(layer(model, "map:base.map").visible());
  }

  @Test
  void theRobotIsFoundByTransformsAndElseByOdometry() {
    DemoRoom.fill(context, now);
    MapModel model = new MapModel(context, () -> LayerKinds.ALL);
    tick(model);
    RigidTransform found = model.snapshot().robots().getFirst().fixedFromBase();
    assertEquals(0, found.translation().minus(DemoRoom.ROBOT_AT.translation()).norm(), 1e-9);
    assertEquals(Math.toRadians(20), found.rotation().yaw(), 1e-9);
    FakeUicContext bare = new FakeUicContext("map", MapOptions.schema());
    bare.frames(frames);
    bare.input(MapPorts.ODOM).put(DemoRoom.odometry(RigidTransform.planar(3, 0, 0)));
    MapModel byOdometry = new MapModel(bare, () -> LayerKinds.ALL);
    byOdometry.tick(now, options(bare));
    assertEquals(RigidTransform.planar(3, 0, 0), byOdometry.snapshot().robots().getFirst().fixedFromBase());
    assertEquals(Optional.of(DemoRoom.ODOM), byOdometry.snapshot().fixed());
  }

  @Test
  void bumpersAreOnTheRimOfTheRobotAboveItsBody() {
    DemoRoom.fill(context, now);
    MapModel model = new MapModel(context, () -> LayerKinds.ALL);
    tick(model);
    Layer bumpers = layer(model, "bumper:base.bumper");
    assertTrue(bumpers.visible());
    assertTrue(bumpers.order() > layer(model, "robot").order());
    double bearing = Math.toRadians(20 - 45);
    double x = DemoRoom.ROBOT_AT.translation().x() + 0.25 * Math.cos(bearing);
    double y = DemoRoom.ROBOT_AT.translation().y() + 0.25 * Math.sin(bearing);
    assertEquals("bumper 1: pressed", bumpers.entity().describeAt(x, y, 0.01).orElseThrow().text());
    context.settings().set(MapOptions.show("bumper"), false);
    assertTrue(tick(model));
    assertFalse(bumpers.visible());
  }

  @Test
  void anotherFixedFrameMovesAllLayers() {
    DemoRoom.fill(context, now);
    MapModel model = new MapModel(context, () -> LayerKinds.ALL);
    tick(model);
    context.settings().set(MapOptions.FIXED_FRAME, "base_link");
    assertTrue(tick(model));
    assertEquals(Optional.of(new FrameId(DemoRoom.ROBOT, "base_link")), model.snapshot().fixed());
    assertEquals(0, model.snapshot().robots().getFirst().fixedFromBase().translation().norm(), 1e-9);
  }

  @Test
  void layersKnowTheirSourceAndAge() {
    DemoRoom.fill(context, now);
    MapModel model = new MapModel(context, () -> LayerKinds.ALL);
    tick(model);
    assertEquals("base.scan  \u00b7  2.0\u00a0s ago",
        model.layers().detail("scan:base.scan", now + 2_000_000_000L).orElseThrow());
    assertTrue(model.layers().detail("grid", now).isEmpty());
  }

  private MapModel model() {
    context.frames(frames);
    return new MapModel(context, () -> LayerKinds.ALL);
  }

  private boolean tick(MapModel model) {
    now += 33_000_000;
    return model.tick(now, options(context));
  }

  private static MapOptions options(FakeUicContext context) {
    return MapOptions.of(context.settings().current());
  }

  private static Layer layer(MapModel model, String id) {
    return model.scene().find(id).orElseThrow();
  }
}
