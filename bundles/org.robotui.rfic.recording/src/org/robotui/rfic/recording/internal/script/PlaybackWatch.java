package org.robotui.rfic.recording.internal.script;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.TimelineState;
import org.robotui.api.script.ActionWatch;
import org.robotui.api.script.ScriptLine;

/** What users do with the timeline. A position is said once it is kept: while one drags there are many. */
final class PlaybackWatch implements ActionWatch {
  private static final double NANOS = 1e9;
  /** How far the position of what is played may be from where it would be; beyond, somebody has moved it. */
  private static final double SLACK_SECONDS = 1;

  private final Supplier<TimelineState> timeline;
  private final LongSupplier nanoTime;
  private TimelineState before;
  private long asked;
  private boolean moved;

  PlaybackWatch(Supplier<TimelineState> timeline, LongSupplier nanoTime) {
    this.timeline = timeline;
    this.nanoTime = nanoTime;
    this.before = timeline.get();
    this.asked = nanoTime.getAsLong();
  }

  @Override
  public List<String> next() {
    TimelineState now = timeline.get();
    TimelineState then = before;
    long nanos = nanoTime.getAsLong();
    double passed = (nanos - asked) / NANOS;
    before = now;
    asked = nanos;
    if (now.span().isEmpty() || !now.span().equals(then.span())) {
      moved = false;
      return List.of();
    }
    List<String> lines = new ArrayList<>();
    settings(then, now, lines);
    marks(then, now, lines);
    position(then, now, passed, lines);
    if (now.playing() != then.playing()) {
      lines.add(ScriptLine.call(now.playing() ? "play" : "pause"));
    }
    return lines;
  }

  private static void settings(TimelineState then, TimelineState now, List<String> lines) {
    if (now.speed() != then.speed()) {
      lines.add(ScriptLine.call("playbackSpeed", now.speed()));
    }
    if (now.looping() != then.looping()) {
      lines.add(ScriptLine.call("playbackLoop", now.looping()));
    }
    if (!now.range().equals(then.range())) {
      Optional<TimeRange> range = now.range();
      lines.add(range.map(r -> ScriptLine.call("playbackRange", seconds(now, r.start()), seconds(now, r.end())))
          .orElseGet(() -> ScriptLine.call("playbackRange")));
    }
  }

  private static void marks(TimelineState then, TimelineState now, List<String> lines) {
    for (Bookmark mark : now.bookmarks()) {
      if (!then.bookmarks().contains(mark)) {
        lines.add(ScriptLine.call("bookmark", mark.note(), seconds(now, mark.time())));
      }
    }
  }

  private void position(TimelineState then, TimelineState now, double passed, List<String> lines) {
    double went = (now.position() - then.position()) / NANOS;
    boolean away = now.playing() && then.playing() ? isAway(now, went, passed)
        : !now.playing() && !then.playing() && went != 0;
    if (away) {
      moved = true;
    } else if (moved) {
      moved = false;
      lines.add(ScriptLine.call("seek", seconds(now, now.position())));
    }
  }

  /** Beginning again at the end is nothing that a user does. */
  private static boolean isAway(TimelineState now, double went, double passed) {
    boolean again = now.looping() && went < 0;
    double most = (passed + SLACK_SECONDS) * Math.max(1, now.speed());
    return !again && (went < 0 || went > most);
  }

  /** To the millisecond, as nobody means more by moving a hand. */
  private static double seconds(TimelineState state, long time) {
    return Math.round((time - state.span().orElseThrow().start()) / 1e6) / 1e3;
  }
}
