package org.robotui.entity.odometry.internal.colored;

import java.io.IOException;
import java.util.Arrays;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamField;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.StreamHistory;
import org.robotui.data.record.DataRecord;
import org.robotui.ui.scene.PoseSeries;

/** The way that a robot went in a recording, with the value that was newest at each place. Read in the background. */
final class WholeWay {
  private final Key key;
  private volatile Optional<Read> read = Optional.empty();

  /**
   * What it is read of.
   *
   * @param poses where the robot was
   * @param source its port
   * @param values the recording of the value, which may be another one
   * @param field the value
   */
  record Key(StreamHistory poses, SourceId source, StreamHistory values, StreamField field) {}

  /** What was read, the unit of the value, and why there is none. */
  record Read(WayPoints way, String unit, Optional<String> problem) {}

  private WholeWay(Key key) {
    this.key = key;
  }

  static WholeWay begin(Key key, Executor background) {
    WholeWay whole = new WholeWay(key);
    background.execute(whole::read);
    return whole;
  }

  Key key() {
    return key;
  }

  /** None while it is being read, and where the recording has no pose. */
  Optional<Read> found() {
    return read;
  }

  private void read() {
    PoseSeries.read(key.poses, key.source.port()).ifPresent(series -> {
      NewestValue newest = new NewestValue(key.field);
      double[] values = values(series, newest);
      ValuedWay way = new ValuedWay();
      for (int i = 0; i < values.length; i++) {
        way.add(series.poses().get(i).translation(), values[i]);
      }
      boolean none = Arrays.stream(values).allMatch(Double::isNaN);
      read = Optional.of(new Read(way.points(series.frame()), newest.unit(),
          none ? newest.problem() : Optional.empty()));
    });
  }

  /** The newest value at each pose. */
  private double[] values(PoseSeries series, NewestValue newest) {
    double[] values = new double[series.poses().size()];
    Arrays.fill(values, Double.NaN);
    boolean[] known = new boolean[values.length];
    long later = key.values.offset() - key.poses.offset();
    read(value -> {
      double number = newest.take(value.value(),
          () -> value.raw().flatMap(RawMessage::record).orElseGet(() -> DataRecord.of(value.value())));
      int next = series.lastUntil(value.placed() + later - 1) + 1; // the first pose from then on
      if (next < values.length) {
        values[next] = number;
        known[next] = true;
      }
    });
    for (int i = 1; i < values.length; i++) {
      values[i] = known[i] ? values[i] : values[i - 1];
    }
    return values;
  }

  private void read(HistoryTaker taker) {
    try {
      key.values.read(Set.of(key.field.source().port()), key.values.span(), taker);
    } catch (IOException e) {
      // What was read stays; the recording itself says what is damaged.
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
