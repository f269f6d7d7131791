package org.robotui.sim.internal.player;

import java.util.Optional;
import org.robotui.player.interfaces.PlayerMap;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.ZlibBytes;
import org.robotui.sim.internal.world.GridMap;

/** {@code map:0}, in tiles as clients ask for them. */
final class Maps implements Part {
  private static final int RANGE = 1;

  private final GridMap map;

  Maps(Bench bench) {
    map = bench.robot().map();
    bench.add("map", 0, bench.handler()
        .on(PlayerMap.GET_INFO, none -> Optional.of(new PlayerMap.Info(
            (float) map.resolution(), map.width(), map.height(), new Pose2d(map.originX(), map.originY(), 0))))
        .on(PlayerMap.GET_TILE, this::tile));
  }

  /** Nothing, which refuses, where the tile is not within the map. */
  private Optional<PlayerMap.Tile> tile(PlayerMap.Tile asked) {
    boolean within = asked.column() + asked.width() <= map.width() && asked.row() + asked.height() <= map.height();
    return Optional.of(asked).filter(tile -> within && tile.width() > 0 && tile.height() > 0)
        .map(tile -> new PlayerMap.Tile(tile.column(), tile.row(), tile.width(), tile.height(), RANGE,
            compressed(tile)));
  }

  private byte[] compressed(PlayerMap.Tile tile) {
    int width = (int) tile.width();
    byte[] cells = new byte[width * (int) tile.height()];
    for (int i = 0; i < cells.length; i++) {
      cells[i] = cell(map.at((int) tile.column() + i % width, (int) tile.row() + i / width));
    }
    return ZlibBytes.of(cells);
  }

  private static byte cell(byte occupancy) {
    return (byte) (occupancy == GridMap.FREE ? -RANGE : occupancy == GridMap.OCCUPIED ? RANGE : 0);
  }

  @Override
  public void step(long step, RobotState state, double stamp) {
    // a map that does not change is asked for
  }
}
