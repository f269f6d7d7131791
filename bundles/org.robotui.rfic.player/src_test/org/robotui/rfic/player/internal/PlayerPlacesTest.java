package org.robotui.rfic.player.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.zip.Deflater;
import org.junit.jupiter.api.Test;
import org.robotui.api.link.LinkState;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.sensor.Bumpers;
import org.robotui.player.interfaces.Bumper;
import org.robotui.player.interfaces.Localize;
import org.robotui.player.interfaces.Planner;
import org.robotui.player.interfaces.PlayerMap;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Pose3d;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.server.ServedDevice;
import org.robotui.player.server.TypedHandler;

/** Maps, ways, localisation and what the configuration says of frames. */
class PlayerPlacesTest extends PlayerRficCase {
  private static final Pose2d NOWHERE = new Pose2d(0, 0, 0);
  private static final Position2d.State STATE = new Position2d.State(new Pose2d(1, 0, 0), NOWHERE, false);
  private static final int WIDTH = 1000;
  private static final int HEIGHT = 700;

  private final AtomicInteger tiles = new AtomicInteger();

  /** Every cell tells where it is. */
  private static byte cell(long column, long row) {
    return (byte) ((column * 7 + row * 3) % 3 - 1);
  }

  private Optional<PlayerMap.Tile> tile(PlayerMap.Tile asked) {
    tiles.incrementAndGet();
    byte[] plain = new byte[(int) (asked.width() * asked.height())];
    for (int i = 0; i < plain.length; i++) {
      plain[i] = cell(asked.column() + i % asked.width(), asked.row() + i / asked.width());
    }
    Deflater deflater = new Deflater();
    deflater.setInput(plain);
    deflater.finish();
    byte[] packed = new byte[plain.length + 100];
    int size = deflater.deflate(packed);
    deflater.end();
    return Optional.of(new PlayerMap.Tile(asked.column(), asked.row(), asked.width(), asked.height(), 1,
        java.util.Arrays.copyOf(packed, size)));
  }

  @Test
  void aMapComesInTilesAndAgainWhenItChanges() {
    PlayerMap.Info info = new PlayerMap.Info(0.1f, WIDTH, HEIGHT, new Pose2d(-5, -6, 0));
    ServedDevice device = add("map:0",
        handler("map:0").on(PlayerMap.GET_INFO, q -> Optional.of(info)).on(PlayerMap.GET_TILE, this::tile));
    startConnected();
    want("map:0");
    GridMap map = assertInstanceOf(GridMap.class, first("map:0").value());
    assertEquals(4, tiles.get());
    assertEquals(WIDTH, map.width());
    for (int[] at : new int[][]{{0, 0}, {639, 639}, {640, 0}, {999, 699}, {0, 699}, {640, 640}}) {
      int expected = switch (cell(at[0], at[1])) {
        case -1 -> 0;
        case 0 -> GridMap.UNKNOWN;
        default -> 100;
      };
      assertEquals(expected, map.cell(at[0], at[1]), at[0] + ", " + at[1]);
    }
    device.publish(PlayerMap.INFO, new PlayerMap.Info(0.1f, 10, 10, NOWHERE), STAMP);
    await("the new map came", () -> ((GridMap) context.published.get("map:0").getLast().value()).width() == 10);
  }

  @Test
  void aMapThatCannotBeIsTold() {
    add("map:0", handler("map:0").on(PlayerMap.GET_INFO,
        q -> Optional.of(new PlayerMap.Info(0.1f, 0xffffffffL, 0xffffffffL, NOWHERE))));
    startConnected();
    want("map:0");
    await("it is told", () -> context.complaints.get("map:0").stream().anyMatch(c -> c.contains("larger than")));
  }

  @Test
  void theWayIsAskedForWhenThereIsOne() {
    AtomicInteger asked = new AtomicInteger();
    ServedDevice planner = add("planner:0", handler("planner:0").on(Planner.GET_WAYPOINTS, q -> {
      asked.incrementAndGet();
      return Optional.of(new Planner.Waypoints(2, List.of(NOWHERE, new Pose2d(2, 0, 0))));
    }));
    startConnected();
    want("planner:0");
    planner.publish(Planner.STATE, new Planner.State(false, false, NOWHERE, NOWHERE, NOWHERE, -1, 0), STAMP);
    assertEquals(List.of(), ((Path) first("planner:0").value()).poses(), "no path");
    planner.publish(Planner.STATE, new Planner.State(true, false, NOWHERE, new Pose2d(2, 0, 0), NOWHERE, 0, 2), STAMP);
    await("the way came", () -> ((Path) context.published.get("planner:0").getLast().value()).poses().size() == 2);
    assertEquals("map", ((Path) context.published.get("planner:0").getLast().value()).frame().name());
    planner.publish(Planner.STATE, new Planner.State(true, true, NOWHERE, new Pose2d(2, 0, 0), NOWHERE, 0, 2), STAMP);
    await("the state came", () -> context.published.get("planner:0/state").size() == 3);
    assertEquals(1, asked.get(), "the same way is not asked for again");
  }

  @Test
  void localisationCarriesTheOdometry() {
    ServedDevice base = add("position2d:0", handler("position2d:0"));
    ServedDevice localize = add("localize:0", handler("localize:0").on(Localize.GET_PARTICLES, q -> Optional.of(
        new Localize.Particles(NOWHERE, 1,
            List.of(new Localize.Particle(NOWHERE, 1), new Localize.Particle(NOWHERE, 1))))));
    startConnected();
    want("localize:0");
    await("the base is open as well", () -> clients.getOrDefault("position2d:0", 0) > 0);
    base.publish(Position2d.STATE, STATE, STAMP);
    await("the base was heard", () -> context.transforms.stream().anyMatch(t -> t.child().name().equals("base_link")));
    Localize.Hypothesis guess = new Localize.Hypothesis(new Pose2d(5, 5, Math.PI / 2), new double[6], 1);
    localize.publish(Localize.HYPOTHESES, new Localize.Hypotheses(0, 0, List.of(guess)), STAMP);
    assertEquals(5, ((PoseEstimate) first("localize:0").value()).pose().translation().x());
    await("the map carries the odometry",
        () -> context.transforms.stream().anyMatch(t -> t.parent().name().equals("map")
            && t.child().name().equals("odom") && Math.abs(t.parentFromChild().translation().x() - 5) < 1e-9
            && Math.abs(t.parentFromChild().translation().y() - 4) < 1e-9));
    context.demand("localize:0/particles", true);
    assertEquals(2, ((PoseArray) first("localize:0/particles").value()).poses().size());
  }

  @Test
  void framesAreCalledAsConfigured() {
    add("position2d:0", handler("position2d:0"));
    ServedDevice second = add("position2d:1", handler("position2d:1"));
    start(Map.of("base", "position2d:1", "base_frame", "rump", "odom_frame", "world", "map_frame", "world"));
    want("position2d:1");
    second.publish(Position2d.STATE, STATE, STAMP);
    Odometry odometry = (Odometry) first("position2d:1").value();
    assertEquals("world", odometry.frame().name());
    assertEquals("rump", odometry.childFrame().name());
    await("it moves the base", () -> context.transforms.stream().anyMatch(t -> t.child().name().equals("rump")));
    assertTrue(context.streams.containsKey("position2d:1/footprint"));
    assertTrue(!context.streams.containsKey("position2d:0/footprint"));
  }

  @Test
  void aBaseThatIsNotThereIsTold() {
    add("position2d:0", handler("position2d:0"));
    start(Map.of("base", "position2d:7"));
    await("it is told", () -> link() instanceof LinkState.Degraded d && d.reason().contains("position2d:7"));
  }

  @Test
  void dataAreFetchedWhereConfigured() {
    ServedDevice base = add("position2d:0", handler("position2d:0"));
    start(Map.of("data", "pull", "rate", 50.0));
    want("position2d:0");
    base.publish(Position2d.STATE, STATE, STAMP);
    first("position2d:0");
  }

  @Test
  void onlyTheNewestWaitsWhereConfigured() {
    ServedDevice base = add("position2d:0", handler("position2d:0"));
    start(Map.of("data", "pull", "rate", 1.0));
    want("position2d:0");
    base.publish(Position2d.STATE, STATE, STAMP);
    first("position2d:0");
    int before = context.published.get("position2d:0").size();
    for (int i = 0; i < 20; i++) {
      base.publish(Position2d.STATE, new Position2d.State(new Pose2d(i, 0, 0), NOWHERE, false), STAMP);
    }
    await("the newest comes",
        () -> ((Odometry) context.published.get("position2d:0").getLast().value()).pose().translation().x() == 19);
    assertTrue(context.published.get("position2d:0").size() - before < 20, "older ones were replaced");
  }

  @Test
  void bumpersAreAroundTheRobot() {
    Bumpers told = bumpers(handler("bumper:0").on(Bumper.GET_GEOMETRY, q -> Optional.of(
        new Bumper.Geometry(List.of(new Bumper.Part(new Pose3d(0.2, 0, 0, 0, 0, 0), 0.3f, 0))))));
    assertEquals("base_link", told.frame().name());
    assertEquals(0.3, told.bumpers().getFirst().length(), 1e-6);
    assertTrue(told.bumpers().getFirst().pressed());
    assertEquals("bumper/state", first("bumper:0").raw().orElseThrow().schema());
    assertTrue(first("bumper:0").stamp().isPresent());
  }

  @Test
  void whichBumpersArePressedIsToldAlsoWhereTheirPlaceIsNot() {
    Bumpers told = bumpers(handler("bumper:0"));
    assertEquals(0, told.bumpers().getFirst().length());
    assertTrue(told.bumpers().getFirst().pressed());
  }

  private Bumpers bumpers(TypedHandler device) {
    ServedDevice bumpers = add("bumper:0", device);
    startConnected();
    want("bumper:0");
    await("they come", () -> {
      bumpers.publish(Bumper.STATE, new Bumper.State(new byte[]{1}), STAMP);
      return !context.published.get("bumper:0").isEmpty();
    });
    return (Bumpers) first("bumper:0").value();
  }
}
