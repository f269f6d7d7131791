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
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The poses of a stream of a recording, in the order of time; of very many, those that are some time apart. */
public final class PoseSeries {
  private static final Logger LOG = LoggerFactory.getLogger(PoseSeries.class);
  private static final int MOST = 50_000;

  private final FrameId frame;
  private final long[] times;
  private final List<RigidTransform> poses;

  private PoseSeries(FrameId frame, List<Long> times, List<RigidTransform> poses) {
    this.frame = frame;
    this.times = times.stream().mapToLong(Long::longValue).toArray();
    this.poses = List.copyOf(poses);
  }

  /**
   * Reads it whole; what cannot be read is left out, as the recording itself says what is damaged. May take long.
   *
   * @param history of the stream
   * @param port its name
   * @return the poses, or none where there is none
   */
  public static Optional<PoseSeries> read(StreamHistory history, String port) {
    Taker taker = new Taker(history.span().length() / MOST);
    try {
      history.read(Set.of(port), history.span(), taker);
    } catch (IOException e) {
      LOG.info("the way of {} is not read to its end: {}", port, e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return taker.series();
  }

  /**
   * The frame in which the poses are.
   *
   * @return that of the first; those of other frames are left out
   */
  public FrameId frame() {
    return frame;
  }

  /**
   * The poses.
   *
   * @return at least one, in the order of time
   */
  public List<RigidTransform> poses() {
    return poses;
  }

  /**
   * When a pose was.
   *
   * @param index of the pose
   * @return nanoseconds, by the time of the recording
   */
  public long time(int index) {
    return times[index];
  }

  /**
   * Which pose is the newest at a time.
   *
   * @param time nanoseconds, by the time of the recording
   * @return its index; -1 before the first
   */
  public int lastUntil(long time) {
    int found = Arrays.binarySearch(times, time);
    return found >= 0 ? found : -found - 2;
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

    Optional<PoseSeries> series() {
      return frame.map(in -> new PoseSeries(in, times, poses));
    }
  }
}
