package org.robotui.entity.odometry.internal.colored;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Function;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamField;
import org.robotui.api.replay.StreamHistory;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.geometry.Pose;
import org.robotui.gl.display.ColorScale;

/**
 * The way of a robot with the value that was newest at each place: as it goes, or, of a recording, whole. Worker
 * thread.
 */
public final class ColoredTrail {
  private final Class<? extends Pose> type;
  private final Executor background;
  private final Function<SourceId, Optional<StreamHistory>> histories;
  private final ValuedWay way = new ValuedWay();
  private Optional<StreamField> field = Optional.empty();
  private Optional<NewestValue> newest = Optional.empty();
  private Optional<SourceId> source = Optional.empty();
  private Optional<FrameId> frame = Optional.empty();
  private Optional<WholeWay> whole = Optional.empty();
  private Optional<Look> look = Optional.empty();
  private Optional<Seen> seen = Optional.empty();
  private long version;

  /** What is seen was made of this. */
  private record Look(ColorBy by, Object way, String unit, Optional<String> problem) {}

  /**
   * What is to be seen.
   *
   * @param way the places
   * @param scale what the colours mean; none where there is no value yet
   * @param problem why there is no value
   */
  public record Seen(WayPoints way, Optional<ColorScale> scale, Optional<String> problem) {}

  /** Of poses of a type; given what reads recordings, and which there are. */
  public ColoredTrail(Class<? extends Pose> type, Executor background,
      Function<SourceId, Optional<StreamHistory>> histories) {
    this.type = type;
    this.background = background;
    this.histories = histories;
  }

  /**
   * Takes what came.
   *
   * @param by with a field
   * @param length of the way to keep as the robot goes, metres
   * @param reset forget what was collected
   */
  public Optional<Seen> update(List<Envelope<? extends Data>> arrived, ColorBy by, double length, boolean reset) {
    if (reset || !by.field().equals(field)) {
      clear();
      field = by.field();
      newest = field.map(NewestValue::new);
      whole = Optional.empty();
    }
    arrived.stream().sorted(Comparator.comparingLong(Envelope::receivedNanos)).forEach(this::take);
    way.cut(length);
    Optional<WholeWay.Read> read = by.whole() ? whole() : Optional.empty();
    Optional<Look> next = read.map(r -> new Look(by, r.way(), r.unit(), r.problem())).or(() -> newest
        .filter(value -> frame.isPresent()).map(value -> new Look(by, version, value.unit(), value.problem())));
    if (!next.equals(look)) {
      look = next;
      seen = next.map(n -> seen(n, read.map(WholeWay.Read::way).orElseGet(() -> way.points(frame.orElseThrow()))));
    }
    return seen;
  }

  private static Seen seen(Look look, WayPoints points) {
    return new Seen(points, look.by.scale(points, look.unit), look.problem);
  }

  /** Whether the way is made of the poses of a source. */
  public boolean follows(SourceId from) {
    return source.map(from::equals).orElse(true);
  }

  /** Forgets the way. */
  public void clear() {
    way.clear();
    frame = Optional.empty();
    version++;
  }

  private void take(Envelope<? extends Data> envelope) {
    boolean colors = field.filter(f -> f.source().equals(envelope.source())).isPresent();
    if (colors) {
      newest.orElseThrow().take(envelope.value(), envelope::record);
    }
    if (type.isInstance(envelope.value()) && isMine(envelope.source(), colors)) {
      Pose pose = type.cast(envelope.value());
      if (!frame.equals(Optional.of(pose.frame())) || !source.equals(Optional.of(envelope.source()))) {
        clear();
        frame = Optional.of(pose.frame());
        source = Optional.of(envelope.source());
      }
      if (way.add(pose.pose().translation(), newest.map(NewestValue::value).orElse(Double.NaN))) {
        version++;
      }
    }
  }

  /** Whether poses of a source make the way: what colours it is not meant where there is another one. */
  private boolean isMine(SourceId from, boolean colors) {
    boolean before = source.filter(s -> field.filter(f -> f.source().equals(s)).isEmpty()).isPresent();
    return source.map(from::equals).orElse(true) || !colors && !before;
  }

  /** The way of a recording, which is read when it is wanted for the first time. */
  private Optional<WholeWay.Read> whole() {
    Optional<WholeWay.Key> key = source.flatMap(at -> histories.apply(at).flatMap(poses -> field
        .flatMap(f -> histories.apply(f.source()).map(values -> new WholeWay.Key(poses, at, values, f)))));
    if (!whole.map(WholeWay::key).equals(key)) {
      whole = key.map(k -> WholeWay.begin(k, background));
    }
    return whole.flatMap(WholeWay::found);
  }
}
