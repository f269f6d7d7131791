package org.robotui.uic.scene3d.internal.waypoint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Handle;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Ray;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.ScenePictures;
import org.robotui.testkit.display.FakePlaces;
import org.robotui.ui.Health;
import org.robotui.ui.scene.Commander;
import org.robotui.uic.scene3d.internal.SceneOptions;
import org.robotui.uic.scene3d.internal.ScenePorts;

class WaypointsTest {
  private static final FrameId MAP = FakePlaces.frame("map");

  private final FakeUicContext context = new FakeUicContext("scene", SceneOptions.schema());
  private final FakePlaces places = new FakePlaces();
  private final Waypoints waypoints = made();

  private Waypoints made() {
    return new Waypoints(context.settings(), new Tour(new Commander(context, ScenePorts.GOAL, ScenePorts.INITIAL_POSE),
        context.output(ScenePorts.GOAL), context.principal(), told -> {}));
  }

  private void add(double x, double y, double yaw) {
    waypoints.add(MAP, RigidTransform.planar(x, y, yaw));
    waypoints.tick(places);
  }

  private static Part part(List<Part> parts, String what, int index) {
    return parts.stream().filter(p -> p.key().equals(new WaypointLook.Key(what, index))).findFirst().orElseThrow();
  }

  private static List<Double> xs(Route route) {
    return route.poses().stream().map(pose -> pose.translation().x()).toList();
  }

  /** Straight down on a place. */
  private static Ray over(double x, double y) {
    return new Ray(new Vector3(x, y, 5), new Vector3(0, 0, -1));
  }

  private void drag(Handle handle, double fromX, double fromY, double toX, double toY) {
    handle.press(over(fromX, fromY), new Vector3(fromX, fromY, 0));
    handle.drag(over(toX, toY));
    waypoints.tick(places);
  }

  @Test
  void eachHasADiscAnArrowAndANumberAndALineGoesThroughAll() {
    add(1, 0, 0);
    add(2, 1, 0.5);
    List<Part> parts = waypoints.tick(places);
    assertEquals(7, parts.size());
    assertEquals(2, part(parts, "disc", 1).fixedFromShape().translation().x(), 1e-9);
    assertEquals(1, part(parts, "line", 0).shape().elements());
    assertEquals("Waypoint 2 of 2", part(parts, "arrow", 1).describer().describe(0, Vector3.ZERO).title());
    List<Part> again = waypoints.tick(places);
    for (int i = 0; i < parts.size(); i++) {
      assertSame(parts.get(i).shape(), again.get(i).shape(), parts.get(i).key().toString());
    }
  }

  @Test
  void areKeptInTheSettingsAndReadAgain() {
    add(1.23456, 2, 0.5);
    Waypoints other = made();
    other.tick(places);
    assertEquals(Optional.of(MAP), other.route().frame());
    assertEquals(1.2346, other.route().poses().getFirst().translation().x(), 1e-9);
    assertEquals(0.5, other.route().poses().getFirst().rotation().yaw(), 1e-9);
    assertEquals("waypoint_frame: robot/map\nwaypoints:\n  - {x: 1.2346, y: 2.0, z: 0.0, yaw: 0.5}\n",
        other.route().yaml());
  }

  @Test
  void wrongSettingsDoNoHarm() {
    context.settings().set(SceneOptions.WAYPOINTS, List.of("x", Map.of("x", "far"), Map.of("y", 3)));
    waypoints.tick(places);
    assertEquals(3, waypoints.route().poses().size());
    assertEquals(Optional.of(MAP), waypoints.route().frame(), "where none is written it is the fixed frame");
  }

  @Test
  void comeInAnotherOrderAndGoAndComeBack() {
    add(1, 0, 0);
    add(2, 0, 0);
    add(3, 0, 0);
    waypoints.move(2, -1);
    assertEquals(List.of(1.0, 3.0, 2.0), xs(Route.read(context.settings().current())));
    waypoints.move(0, -1);
    waypoints.remove(0);
    assertEquals(List.of(3.0, 2.0), xs(Route.read(context.settings().current())));
    waypoints.clear();
    waypoints.undo();
    waypoints.undo();
    assertEquals(List.of(1.0, 3.0, 2.0), xs(Route.read(context.settings().current())));
    waypoints.undo();
    assertEquals(List.of(1.0, 2.0, 3.0), xs(Route.read(context.settings().current())));
    for (int i = 0; i < 3; i++) {
      assertEquals(Health.OK, waypoints.undo().health());
    }
    assertEquals(Health.NONE, waypoints.undo().health());
    assertEquals(List.of(), waypoints.tick(places));
  }

  @Test
  void aDiscMovesAnArrowTurnsAndBothAreOneChange() {
    add(1, 0, 0);
    List<Part> parts = waypoints.tick(places);
    Handle disc = part(parts, "disc", 0).handle().orElseThrow();
    drag(disc, 1.1, 0, 2.1, 3);
    assertEquals(2, waypoints.route().poses().getFirst().translation().x(), 1e-9, "it is seen while it is dragged");
    assertEquals(1.0, Route.read(context.settings().current()).poses().getFirst().translation().x(), 1e-9,
        "and kept when it is let go");
    disc.drag(over(3.1, 3));
    disc.release(false);
    Handle arrow = part(waypoints.tick(places), "arrow", 0).handle().orElseThrow();
    drag(arrow, 3.5, 3, 3, 5);
    arrow.release(false);
    waypoints.tick(places);
    assertEquals(Math.PI / 2, waypoints.route().poses().getFirst().rotation().yaw(), 1e-3);
    waypoints.undo();
    waypoints.undo();
    assertEquals(List.of(1.0), xs(Route.read(context.settings().current())));
  }

  @Test
  void aRayThatMissesTheFloorMovesNothing() {
    add(1, 0, 0);
    Handle disc = part(waypoints.tick(places), "disc", 0).handle().orElseThrow();
    disc.press(over(1, 0), new Vector3(1, 0, 0));
    disc.drag(new Ray(new Vector3(0, 0, 5), new Vector3(1, 0, 0)));
    disc.drag(new Ray(new Vector3(0, 0, 5), new Vector3(0, 0, 1)));
    disc.release(false);
    assertEquals(List.of(1.0), xs(Route.read(context.settings().current())));
  }

  @Test
  void stayWhereTheyAreWhenAnotherFrameIsFixed() {
    add(1, 0, 0);
    places.put("map", RigidTransform.planar(10, 0, 0));
    places.fix("odom");
    assertEquals(11, part(waypoints.tick(places), "disc", 0).fixedFromShape().translation().x(), 1e-9);
    waypoints.add(FakePlaces.frame("odom"), RigidTransform.planar(12, 0, 0));
    assertEquals(List.of(1.0, 2.0), xs(Route.read(context.settings().current())));
  }

  @Test
  void whereTheirFrameIsUnknownNothingIsDrawnOrAdded() {
    context.settings().set(SceneOptions.WAYPOINT_FRAME, "robot/lost");
    context.settings().set(SceneOptions.WAYPOINTS, List.of(Map.of("x", 1)));
    assertEquals(List.of(), waypoints.tick(places));
    assertTrue(waypoints.add(MAP, RigidTransform.IDENTITY).text().contains("not known where the frame"));
    assertEquals(1, waypoints.route().poses().size());
  }

  @Test
  void theMenuOfAWaypointRemovesAndReorders() {
    add(1, 0, 0);
    add(2, 0, 0);
    Handle first = part(waypoints.tick(places), "disc", 0).handle().orElseThrow();
    assertEquals(List.of("Remove (Del)", "Later (Page down)", "Drive from here on"),
        first.menu().stream().map(Handle.Choice::label).toList());
    first.choose(first.menu().get(1).id());
    assertEquals(List.of(2.0, 1.0), xs(Route.read(context.settings().current())));
    first.choose(first.menu().getFirst().id());
    assertEquals(List.of(1.0), xs(Route.read(context.settings().current())));
  }

  @Test
  void thereAreNotTooMany() {
    waypoints.tick(places);
    for (int i = 0; i < Route.MOST; i++) {
      waypoints.add(MAP, RigidTransform.planar(i, 0, 0));
    }
    waypoints.tick(places);
    assertEquals(Health.BAD, waypoints.add(MAP, RigidTransform.IDENTITY).health());
    assertEquals(Route.MOST, waypoints.route().poses().size());
  }

  @Test
  void thoseOfAFileTakeThePlaceOfWhatThereIsAndCanBeTakenBack() {
    RouteText.Outcome.Read read =
        new RouteText.Outcome.Read(Optional.of("odom"), List.of(RigidTransform.planar(5, 6, 0)));
    assertEquals(Health.BAD, waypoints.take(read).health(), "no frame is known yet");
    add(1, 0, 0);
    add(2, 0, 0);
    assertEquals("1 waypoint loaded in odom \u00b7 Ctrl+Z undoes it", waypoints.take(read).text());
    assertEquals(List.of(5.0), xs(Route.read(context.settings().current())));
    assertEquals(Optional.of(FakePlaces.frame("odom")), Route.read(context.settings().current()).frame());
    waypoints.tick(places);
    waypoints.undo();
    assertEquals(List.of(1.0, 2.0), xs(Route.read(context.settings().current())));
    assertEquals(Health.BAD, waypoints.take(new RouteText.Outcome.Read(Optional.empty(), List.of())).health());
    assertEquals(List.of(1.0, 2.0), xs(Route.read(context.settings().current())));
  }

  @Test
  @EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
  void theyLookAsTheyDid() {
    add(0, 0, 0);
    add(1, 0.8, Math.PI / 2);
    add(1.6, -0.3, -0.5);
    try (ScenePictures pictures = new ScenePictures()) {
      pictures.assertLike(WaypointsTest.class, "waypoints", ScenePictures.request(waypoints.tick(places),
          ScenePictures.eye(new Vector3(-1.2, -0.6, 1.8), new Vector3(0.8, 0.2, 0))));
    }
  }
}
