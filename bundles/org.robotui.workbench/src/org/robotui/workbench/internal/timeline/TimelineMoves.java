package org.robotui.workbench.internal.timeline;

import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Timeline;
import org.robotui.api.replay.TimelineState;
import org.robotui.api.replay.Track;

/** What buttons, keys and commands do with a timeline. Safe for all threads, as the timeline is. */
public final class TimelineMoves {
  /** The speeds to choose from. */
  static final List<Double> SPEEDS =
      List.of(0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0);

  private final Timeline timeline;

  /** Moves of a timeline. */
  public TimelineMoves(Timeline timeline) {
    this.timeline = timeline;
  }

  /** Plays where it stands still, and the other way round. */
  public void toggle() {
    if (timeline.state().playing()) {
      timeline.pause();
    } else {
      timeline.play();
    }
  }

  /** Goes on or back. */
  public void jump(double seconds) {
    TimelineState state = timeline.state();
    state.span().ifPresent(
        span -> timeline.seek(span.nearest(state.position() + Math.round(seconds * TimeWords.SECOND))));
  }

  /** Goes to the start or to the end of what is played. */
  public void end(boolean last) {
    played(timeline.state()).ifPresent(played -> timeline.seek(last ? played.end() : played.start()));
  }

  /** Goes to the next or to the former bookmark; nowhere where there is none. */
  public void bookmark(boolean next) {
    TimelineState state = timeline.state();
    List<Long> times = state.bookmarks().stream().map(Bookmark::time).sorted().toList();
    Optional<Long> wanted = next ? times.stream().filter(t -> t > state.position()).findFirst()
        : times.reversed().stream().filter(t -> t < state.position()).findFirst();
    wanted.ifPresent(timeline::seek);
  }

  /** Plays faster or slower, to the next of the usual speeds. */
  public void faster(boolean more) {
    double now = timeline.state().speed();
    DoubleStream speeds = SPEEDS.stream().mapToDouble(Double::doubleValue);
    (more ? speeds.filter(s -> s > now).min() : speeds.filter(s -> s < now).max()).ifPresent(timeline::speed);
  }

  /** Begins or ends what is played at a time, and leaves the other end where it is if it can. */
  public void limit(boolean start, long time) {
    TimelineState state = timeline.state();
    state.span().ifPresent(span -> {
      TimeRange now = state.range().orElse(span);
      long at = span.nearest(time);
      TimeRange wanted = start ? new TimeRange(at, Math.max(at, now.end()))
          : new TimeRange(Math.min(at, now.start()), at);
      timeline.range(wanted.equals(span) ? Optional.empty() : Optional.of(wanted));
    });
  }

  /** Has a recording begin where the earliest begins, for those that were not made at the same time. */
  void align(Track track) {
    timeline.state().span()
        .ifPresent(span -> timeline.shift(track.id(), track.offset() + span.start() - track.span().start()));
  }

  /** What is played: the part that was chosen, else all. */
  static Optional<TimeRange> played(TimelineState state) {
    return state.range().or(state::span);
  }
}
