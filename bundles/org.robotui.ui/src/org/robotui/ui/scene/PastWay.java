package org.robotui.ui.scene;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.RecordedValue;
import org.robotui.api.replay.StreamHistory;
import org.robotui.data.FrameId;
import org.robotui.data.geometry.Pose;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The way of a robot as a recording has it. Read by one thread, asked by another. */
final class PastWay {
  private static final Logger LOG = LoggerFactory.getLogger(PastWay.class);
  private static final int MOST = 50_000;
  private static final int DRAWN = 1000;
  /** Before the first and after the last value the robot stood there for so long, in nanoseconds. */
  private static final long BESIDE = 1_000_000_000L;

  private volatile Optional<Known> known = Optional.empty();

  private record Known(FrameId frame, long[] times, List<RigidTransform> poses, List<Vector3> drawn) {}

  /** Where the robot was, by a time of the recording; none while that is not read. */
  Optional<PastSpot> at(long time) {
    return known.filter(way -> time >= way.times[0] - BESIDE && time <= way.times[way.times.length - 1] + BESIDE)
        .map(way -> new PastSpot(way.frame, pose(way, time), way.drawn));
  }

  private static RigidTransform pose(Known way, long time) {
    int found = Arrays.binarySearch(way.times, time);
    int next = Math.min(found >= 0 ? found : -found - 1, way.times.length - 1);
    int before = Math.max(0, next - 1);
    if (way.times[next] <= way.times[before] || time <= way.times[before]) {
      return way.poses.get(before);
    }
    double share = (double) (time - way.times[before]) / (way.times[next] - way.times[before]);
    return way.poses.get(before).interpolate(way.poses.get(next), Math.min(1, share));
  }

  /** Reads it whole; what cannot be read is left out, as the recording itself says what is damaged. */
  void read(StreamHistory history, String port) {
    Taker taker = new Taker(history.span().length() / MOST);
    try {
      history.read(Set.of(port), history.span(), taker);
    } catch (IOException e) {
      LOG.info("the way of {} is not read to its end: {}", port, e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    known = taker.known();
  }

  /** Keeps poses that are some time apart. */
  private static final class Taker implements HistoryTaker {
    private final long apart;
    private final List<Long> times = new ArrayList<>();
    private final List<RigidTransform> poses = new ArrayList<>();
    private Optional<FrameId> frame = Optional.empty();

    Taker(long apart) {
      this.apart = apart;
    }

    @Override
    public void take(RecordedValue value) {
      if (value.value() instanceof Pose pose && pose.pose().translation().isFinite()) {
        FrameId in = frame.orElse(pose.frame());
        long time = value.placed();
        boolean later = times.isEmpty() || time > times.getLast() && time >= times.getLast() + apart;
        if (later && in.equals(pose.frame())) {
          frame = Optional.of(in);
          times.add(time);
          poses.add(pose.pose());
        }
      }
    }

    @Override
    public void unreadable(String port, String reason) {
      // the recording says so itself
    }

    @Override
    public boolean reached(long time) {
      return true;
    }

    Optional<Known> known() {
      int step = Math.max(1, poses.size() / DRAWN);
      List<Vector3> drawn = new ArrayList<>();
      for (int i = 0; i < poses.size(); i += step) {
        drawn.add(poses.get(i).translation());
      }
      return frame.map(in -> new Known(in, times.stream().mapToLong(Long::longValue).toArray(), List.copyOf(poses),
          List.copyOf(drawn)));
    }
  }
}
