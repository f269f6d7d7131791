package org.robotui.rfic.player.internal.convert;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.util.List;
import java.util.zip.Deflater;
import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.player.interfaces.Fiducial;
import org.robotui.player.interfaces.Localize;
import org.robotui.player.interfaces.Planner;
import org.robotui.player.interfaces.PlayerMap;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Pose3d;

class PlayerPlacesTest {
  private static final FrameId MAP = new FrameId("r", "map");
  private static final double[] COVARIANCE = {1, 2, 3, 4, 5, 6};

  @Test
  void theBestGuessIsTheEstimate() {
    Localize.Hypotheses guesses = new Localize.Hypotheses(0, 0, List.of(
        new Localize.Hypothesis(new Pose2d(1, 1, 1), new double[6], 0.2),
        new Localize.Hypothesis(new Pose2d(2, 3, 0.5), COVARIANCE, 0.7)));
    PoseEstimate best = PlayerPlaces.estimate(guesses, MAP).orElseThrow();
    assertEquals(3, best.pose().translation().y());
    assertEquals(1, best.covariance().get(0));
    assertEquals(2, best.covariance().get(7));
    assertEquals(3, best.covariance().get(35));
    assertEquals(4, best.covariance().get(6));
    assertEquals(5, best.covariance().get(11));
    assertEquals(6, best.covariance().get(30));
    assertArrayEquals(COVARIANCE, PlayerPlaces.estimate(best).covariance(), "and back");
    assertEquals(0.5, PlayerPlaces.estimate(best).mean().yaw(), 1e-12);
    assertEquals(2, PlayerPlaces.guesses(guesses, MAP).poses().size());
    assertTrue(PlayerPlaces.estimate(new Localize.Hypotheses(3, 1, List.of()), MAP).isEmpty());
  }

  @Test
  void waysMarkersAndParticlesAreInTheirFrames() {
    assertEquals(2, PlayerPlaces.way(new Planner.Waypoints(3, List.of(new Pose2d(0, 0, 0), new Pose2d(1, 0, 0))), MAP)
        .poses().size());
    assertEquals(1, PlayerPlaces.particles(new Localize.Particles(new Pose2d(0, 0, 0), 1,
        List.of(new Localize.Particle(new Pose2d(4, 5, 0), 1))), MAP).poses().size());
    Pose3d pose = new Pose3d(1, 2, 3, 0, 0, 0);
    assertEquals(3, PlayerPlaces.markers(new Fiducial.Scan(List.of(new Fiducial.Marker(7, pose, pose))), MAP).poses()
        .getFirst().translation().z());
  }

  @Test
  void whatCannotBeAMountCountsAsZero() {
    assertEquals(0, Poses.mounted(new Pose3d(1e300, Double.NaN, 1, Double.NEGATIVE_INFINITY, 0, 0)).translation().x());
    assertEquals(1, Poses.mounted(new Pose3d(1e300, Double.NaN, 1, Double.NEGATIVE_INFINITY, 0, 0)).translation().z());
  }

  private static byte[] packed(int... cells) {
    byte[] plain = new byte[cells.length];
    for (int i = 0; i < cells.length; i++) {
      plain[i] = (byte) cells[i];
    }
    Deflater deflater = new Deflater();
    deflater.setInput(plain);
    deflater.finish();
    byte[] out = new byte[100 + cells.length];
    int size = deflater.deflate(out);
    deflater.end();
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    bytes.write(out, 0, size);
    return bytes.toByteArray();
  }

  @Test
  void tilesMakeAMap() {
    PlayerMap.Info info = new PlayerMap.Info(0.5f, 3, 2, new Pose2d(-1, -2, 0));
    Maps.check(info);
    byte[] cells = new byte[6];
    Maps.put(new PlayerMap.Tile(0, 0, 2, 2, 1, packed(-1, 0, 1, -1)), info, cells);
    Maps.put(new PlayerMap.Tile(2, 0, 1, 2, 10, packed(10, 5)), info, cells);
    GridMap map = Maps.of(info, cells, MAP);
    assertEquals(0, map.cell(0, 0));
    assertEquals(GridMap.UNKNOWN, map.cell(1, 0));
    assertEquals(100, map.cell(2, 0));
    assertEquals(100, map.cell(0, 1));
    assertEquals(75, map.cell(2, 1));
    assertEquals(-1, map.origin().translation().x());
    assertEquals(0.5, map.resolution());
  }

  @Test
  void hostileTilesAreRefused() {
    PlayerMap.Info info = new PlayerMap.Info(0.5f, 3, 2, new Pose2d(0, 0, 0));
    byte[] cells = new byte[6];
    assertThrows(IllegalArgumentException.class,
        () -> Maps.put(new PlayerMap.Tile(2, 0, 2, 2, 1, packed(1, 1, 1, 1)), info, cells));
    assertThrows(IllegalArgumentException.class,
        () -> Maps.put(new PlayerMap.Tile(0xffffffffL, 0, 1, 1, 1, packed(1)), info, cells));
    assertThrows(IllegalArgumentException.class,
        () -> Maps.put(new PlayerMap.Tile(0, 0, 2, 2, 1, packed(1, 1)), info, cells));
    assertThrows(IllegalArgumentException.class,
        () -> Maps.put(new PlayerMap.Tile(0, 0, 2, 2, 1, new byte[]{1, 2, 3, 4}), info, cells));
    assertThrows(IllegalArgumentException.class,
        () -> Maps.put(new PlayerMap.Tile(0, 0, 2, 2, 1, new byte[0]), info, cells));
    assertThrows(IllegalArgumentException.class, () -> Maps.check(new PlayerMap.Info(0, 3, 2, new Pose2d(0, 0, 0))));
    assertThrows(IllegalArgumentException.class,
        () -> Maps.check(new PlayerMap.Info(1, 0xffffffffL, 0xffffffffL, new Pose2d(0, 0, 0))));
  }
}
