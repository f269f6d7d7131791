package org.robotui.rfic.player.internal.device;

import java.util.function.Consumer;
import org.robotui.data.FrameId;
import org.robotui.data.navigation.GridMap;
import org.robotui.player.interfaces.PlayerMap;
import org.robotui.rfic.player.internal.convert.Maps;

/** Fetches a map tile by tile when somebody looks at it, and again when the server says that it has changed. */
final class MapFetch {
  private static final int RANGE = 1;

  private final DeviceFeed feed;
  private final Outlet<GridMap> outlet;
  private final FrameId frame;
  private volatile boolean looked;
  private volatile Fetch under =
      new Fetch(new PlayerMap.Info(1, 0, 0, new org.robotui.player.interfaces.Pose2d(0, 0, 0)), new byte[0]);

  /** One map on its way; a later one takes its place. */
  private record Fetch(PlayerMap.Info info, byte[] cells) {
    @Override
    public boolean equals(Object other) {
      return this == other;
    }

    @Override
    public int hashCode() {
      return System.identityHashCode(this);
    }
  }

  MapFetch(DeviceFeed feed) {
    this.feed = feed;
    this.outlet = feed.outlet("", GridMap.class, "the map");
    this.frame = feed.around().tree().names().map();
    feed.on(PlayerMap.INFO, outlet, (m, r) -> begin(m));
    feed.onOpen(() -> looked = false);
    feed.onTick(now -> look());
  }

  private void look() {
    boolean wanted = outlet.wanted();
    if (wanted && !looked) {
      feed.ask(PlayerMap.GET_INFO, this::begin, this::failed);
    }
    looked = wanted;
  }

  private void failed(String reason) {
    outlet.failed(reason + " (lines of a map can be asked for by the call " + feed.name() + "/get_vector)");
  }

  private void begin(PlayerMap.Info info) {
    Maps.check(info);
    Fetch fetch = new Fetch(info, new byte[(int) (info.width() * info.height())]);
    under = fetch;
    next(fetch, 0, 0);
  }

  private void next(Fetch fetch, long column, long row) {
    PlayerMap.Info info = fetch.info();
    if (!under.equals(fetch)) {
      return;
    }
    if (column >= info.width() || row >= info.height()) {
      outlet.publish(Maps.of(info, fetch.cells(), frame), Reception.now());
      return;
    }
    long width = Math.min(Maps.TILE, info.width() - column);
    long height = Math.min(Maps.TILE, info.height() - row);
    Consumer<PlayerMap.Tile> answered = tile -> {
      if (tile.column() != column || tile.row() != row || tile.width() != width || tile.height() != height) {
        throw new IllegalArgumentException("another tile came than was asked for");
      }
      Maps.put(tile, info, fetch.cells());
      boolean rowDone = column + width >= info.width();
      next(fetch, rowDone && row + height < info.height() ? 0 : column + width, rowDone ? row + height : row);
    };
    feed.ask(PlayerMap.GET_TILE, new PlayerMap.Tile(column, row, width, height, RANGE, new byte[0]), answered,
        outlet::failed);
  }
}
