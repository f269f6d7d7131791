package org.robotui.ui.scene;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.Executor;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.StreamHistory;
import org.robotui.api.time.PointedTime;
import org.robotui.data.Data;

/**
 * Where robots were at the time at which the user points, for views that show places: of recordings alone, whose ways
 * are read once, when the user points for the first time. One thread.
 */
public final class PastWays {
  private final PointedTime pointed;
  private final Executor background;
  private final Map<SourceId, Read> read = new HashMap<>();

  private record Read(StreamHistory history, PastWay way) {}

  /**
   * Without ways.
   *
   * @param pointed the time at which the user points
   * @param background reads recordings
   */
  public PastWays(PointedTime pointed, Executor background) {
    this.pointed = pointed;
    this.background = background;
  }

  /**
   * Where the robots were.
   *
   * @param input gives the sources
   * @param sources odometry or poses, those that count first
   * @return by the names of the robots; empty while nobody points, and for live robots
   */
  public Map<String, PastSpot> spots(Input<? extends Data> input, List<SourceId> sources) {
    OptionalLong time = pointed.elsewhere(this);
    if (time.isEmpty()) {
      return Map.of();
    }
    read.keySet().retainAll(Set.copyOf(sources));
    Map<String, PastSpot> spots = new LinkedHashMap<>();
    for (SourceId source : sources) {
      input.history(source).flatMap(history -> way(source, history).at(time.getAsLong() - history.offset()))
          .ifPresent(spot -> spots.putIfAbsent(spot.frame().robot(), spot));
    }
    return spots;
  }

  private PastWay way(SourceId source, StreamHistory history) {
    return Optional.ofNullable(read.get(source)).filter(each -> each.history().equals(history)).map(Read::way)
        .orElseGet(() -> {
          PastWay way = new PastWay();
          read.put(source, new Read(history, way));
          background.execute(() -> way.read(history, source.port()));
          return way;
        });
  }
}
