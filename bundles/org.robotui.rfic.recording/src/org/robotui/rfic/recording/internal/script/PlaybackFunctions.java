package org.robotui.rfic.recording.internal.script;

import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Reference;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Timeline;
import org.robotui.api.replay.Timeline.LaneId;
import org.robotui.api.replay.TimelineState;
import org.robotui.api.replay.Track;
import org.robotui.api.script.ActionWatch;
import org.robotui.api.script.ScriptCall;
import org.robotui.api.script.ScriptFailure;
import org.robotui.api.script.ScriptFunction;
import org.robotui.api.script.ScriptFunctions;
import org.robotui.rfic.recording.internal.time.SharedTimeline;

/**
 * What scripts can do with recordings. Times are seconds from the start of the earliest one, or written as ISO 8601.
 */
@Component
public final class PlaybackFunctions implements ScriptFunctions {
  private static final double NANOS = 1e9;
  private static final Duration LOOK = Duration.ofMillis(10);
  private static final long PATIENCE_NANOS = Duration.ofSeconds(60).toNanos();

  private final SharedTimeline timeline;

  /** What moves the timeline. */
  @FunctionalInterface
  private interface Deed {
    void apply(ScriptCall call, TimeRange span) throws ScriptFailure;
  }

  /**
   * Called by declarative services.
   *
   * @param timeline is moved
   */
  @Activate
  public PlaybackFunctions(@Reference SharedTimeline timeline) {
    this.timeline = timeline;
  }

  @Override
  public List<ScriptFunction> functions() {
    return List.of(
        deed("play()", "Plays the recordings that are open.", (call, span) -> timeline.play()),
        deed("pause()", "Has the recordings stand.", (call, span) -> timeline.pause()),
        deed("seek(time)",
            "Moves the recordings, and waits until views can show that time: seconds from their start, or "
                + "such as \"2026-11-27T10:00:00Z\".",
            (call, span) -> timeline.seek(time(call, 0, span))),
        deed("step(forward?, topic?)", "Has the recordings stand, and goes to the next message, or with false to the "
            + "former one, of any topic or of this one.", this::step),
        deed("playbackSpeed(factor)", "Sets how fast recordings are played: 0.01 to 100 times.", this::speed),
        deed("playbackLoop(again)", "Sets whether recordings begin again at their end.",
            (call, span) -> timeline.loop(call.argument(0).filter(Boolean.TRUE::equals).isPresent())),
        deed("playbackRange(from?, to?)", "Sets which part is played; without times all of it.", this::range),
        deed("bookmark(note?, time?)", "Notes the time at which the recordings are, or another one.",
            (call, span) -> timeline.mark(new Bookmark(
                call.argument(1).isEmpty() ? timeline.state().position() : time(call, 1, span),
                call.textIf(0).orElse("")))),
        ScriptFunction.of("position()", "Tells where the recordings are.", "seconds from their start",
            call -> (state().position() - span().start()) / NANOS),
        ScriptFunction.of("playback()", "Tells how recordings are played.",
            "{position, length, time, playing, speed, loop, lagging, bookmarks, recordings}", call -> described()));
  }

  @Override
  public Optional<ActionWatch> watch() {
    return Optional.of(new PlaybackWatch(timeline::state, System::nanoTime));
  }

  private ScriptFunction deed(String signature, String help, Deed deed) {
    return ScriptFunction.of(signature, help, "", call -> {
      deed.apply(call, span());
      long until = System.nanoTime() + PATIENCE_NANOS;
      while (!timeline.isThere() && System.nanoTime() - until < 0) {
        call.pause(LOOK);
      }
      return null;
    });
  }

  private TimelineState state() throws ScriptFailure {
    TimelineState state = timeline.state();
    if (state.span().isEmpty()) {
      throw new ScriptFailure("no recording is open; waitForLink() waits until one is");
    }
    return state;
  }

  private TimeRange span() throws ScriptFailure {
    return state().span().orElseThrow();
  }

  private static long time(ScriptCall call, int index, TimeRange span) throws ScriptFailure {
    if (!(call.argument(index).orElse(0.0) instanceof String written)) {
      return span.start() + Math.round(call.number(index) * NANOS);
    }
    try {
      Instant time = Instant.parse(written);
      return Math.addExact(Math.multiplyExact(time.getEpochSecond(), 1_000_000_000L), time.getNano());
    } catch (DateTimeException | ArithmeticException e) {
      throw new ScriptFailure(
          "'" + written + "' is no time; write seconds from the start, or such as \"2026-11-27T10:00:00Z\"");
    }
  }

  private void speed(ScriptCall call, TimeRange span) throws ScriptFailure {
    double factor = call.number(0);
    if (factor < Timeline.SLOWEST || factor > Timeline.FASTEST) {
      throw new ScriptFailure("playbackSpeed: " + factor + " is not from 0.01 to 100");
    }
    timeline.speed(factor);
  }

  private void step(ScriptCall call, TimeRange span) throws ScriptFailure {
    boolean forward = call.argument(0).filter(Boolean.FALSE::equals).isEmpty();
    Optional<String> topic = call.textIf(1);
    Optional<LaneId> lane = topic.flatMap(name -> timeline.tracks().stream()
        .filter(track -> track.lanes().stream().anyMatch(each -> each.topic().equals(name))).findFirst()
        .map(track -> new LaneId(track.id(), name)));
    if (topic.isPresent() && lane.isEmpty()) {
      throw new ScriptFailure("no recording has the topic " + topic.get());
    }
    timeline.step(forward, lane);
  }

  private void range(ScriptCall call, TimeRange span) throws ScriptFailure {
    if (call.argument(0).isEmpty() && call.argument(1).isEmpty()) {
      timeline.range(Optional.empty());
      return;
    }
    long from = call.argument(0).isEmpty() ? span.start() : time(call, 0, span);
    long to = call.argument(1).isEmpty() ? span.end() : time(call, 1, span);
    if (to < from) {
      throw new ScriptFailure("playbackRange: it ends before it begins");
    }
    timeline.range(Optional.of(new TimeRange(from, to)));
  }

  private Map<String, Object> described() throws ScriptFailure {
    TimelineState state = state();
    TimeRange span = state.span().orElseThrow();
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("position", (state.position() - span.start()) / NANOS);
    all.put("length", span.length() / NANOS);
    all.put("time", written(state.position()));
    all.put("playing", state.playing());
    all.put("speed", state.speed());
    all.put("loop", state.looping());
    all.put("lagging", state.lagging());
    all.put("bookmarks", state.bookmarks().stream().map(each -> Map.of("position",
        (each.time() - span.start()) / NANOS, "note", each.note())).toList());
    all.put("recordings", timeline.tracks().stream().map(PlaybackFunctions::described).toList());
    return all;
  }

  private static Map<String, Object> described(Track track) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("robot", track.id().robot());
    all.put("instance", track.id().instance());
    all.put("file", track.file().toString());
    all.put("start", written(track.span().start()));
    all.put("end", written(track.span().end()));
    all.put("topics", track.lanes().stream().map(lane -> lane.topic()).toList());
    all.put("problems", track.problems());
    return all;
  }

  private static String written(long nanos) {
    return Instant.ofEpochSecond(Math.floorDiv(nanos, 1_000_000_000L), Math.floorMod(nanos, 1_000_000_000L)).toString();
  }
}
