package org.robotui.rfic.recording.internal.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.api.replay.TimeRange;
import org.robotui.data.image.Image;

/** Some pictures of a camera, spread evenly over the time. For one thread. */
final class CameraPictures {
  /**
   * A picture.
   *
   * @param time when it was recorded
   * @param image as it was sent
   */
  record Taken(long time, Image image) {}

  private static final int MOST = 4;

  private final String port;
  private final List<Taken> taken = new ArrayList<>();
  private final TimeRange range;
  private Optional<Taken> newest = Optional.empty();

  CameraPictures(String port, TimeRange range) {
    this.port = port;
    this.range = range;
  }

  /** Keeps the first one, and each that is the first behind the next of the places that are spread evenly. */
  void take(long time, Image image) {
    Taken next = new Taken(time, image);
    newest = Optional.of(next);
    long place = range.start() + range.length() / (MOST - 1) * taken.size();
    if (taken.isEmpty() || taken.size() < MOST - 1 && time >= place) {
      taken.add(next);
    }
  }

  String port() {
    return port;
  }

  /** In the order of time; the last one that came is one of them. */
  List<Taken> all() {
    List<Taken> all = new ArrayList<>(taken);
    newest.filter(last -> !all.contains(last)).ifPresent(all::add);
    return all;
  }
}
