package org.robotui.rfic.carmen.internal.feed;

import java.io.IOException;
import java.nio.ByteOrder;
import java.time.Duration;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcForm;
import org.robotui.carmen.module.IpcAnswer;
import org.robotui.data.navigation.GridMap;
import org.robotui.net.call.Outcome;
import org.robotui.rfic.carmen.internal.convert.CarmenGrids;

/** Asks for the map when somebody begins to look at it: the program map says it to nobody unasked. */
final class MapFetching {
  static final String ANSWER = "carmen_grid_map_message";
  private static final String REQUEST = "carmen_gridmap_request";
  private static final Duration PATIENCE = Duration.ofMillis(1500);
  private static final long AGAIN_NANOS = Duration.ofSeconds(5).toNanos();

  private final Shared shared;
  private final MessageFeed<GridMap> feed;
  private boolean fetched;
  private long askedAt = System.nanoTime() - AGAIN_NANOS;

  @SuppressWarnings("unchecked")
  MapFetching(Shared shared, MessageFeed<?> feed) {
    this.shared = shared;
    this.feed = (MessageFeed<GridMap>) feed;
  }

  /** On the thread that follows the central, which waits for the answer. */
  void tick() throws IOException {
    if (!feed.wanted()) {
      fetched = false;
    } else if (!fetched && System.nanoTime() - askedAt >= AGAIN_NANOS) {
      askedAt = System.nanoTime();
      fetch();
    }
  }

  private void fetch() throws IOException {
    IpcForm request = shared.forms().get(REQUEST);
    IpcRecord question =
        request.make().number("timestamp", shared.now()).text("host", shared.module().name()).build();
    Outcome<IpcAnswer> outcome = shared.module().sender(request).query(question, PATIENCE);
    if (outcome instanceof Outcome.Done<IpcAnswer> done) {
      try {
        IpcRecord map = done.value().record();
        feed.publish(CarmenGrids.of(map, ByteOrder.LITTLE_ENDIAN, shared.frames().map()),
            shared.stamp(map.number("timestamp")));
        fetched = true;
        feed.failed("");
      } catch (IllegalArgumentException e) {
        feed.failed(e.getMessage());
      }
    } else {
      feed.failed(outcome.reason());
    }
  }
}
