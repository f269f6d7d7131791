package org.robotui.workbench.internal.timeline;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;
import org.robotui.api.replay.FoundEvent;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.TimelineState;
import org.robotui.api.replay.Track;
import org.robotui.api.time.PointedTime;
import org.robotui.workbench.internal.timeline.LaneRows.Row;

/**
 * What the bar of one window shows, and how the user looks at it: what is zoomed and folded. One thread only.
 */
public final class BarState {
  /** A recording of one message has no length, and all the same a place on the screen. */
  private static final long LEAST_SPAN = TimeWords.SECOND;
  /** Most of the room is that of the time. */
  private static final int MOST_LABEL = 320;
  private static final int EDGE = 14;

  private final Set<String> folded = new HashSet<>();
  private final PointedTime pointed;
  private TimelineState state = TimelineState.EMPTY;
  private List<Track> tracks = List.of();
  private LaneRows rows = LaneRows.of(List.of(), Set.of());
  private Optional<TimeRange> zoom = Optional.empty();
  private OptionalInt pointer = OptionalInt.empty();
  private boolean expanded;
  private List<FoundEvent> events = List.of();
  private List<FoundRow> found = List.of();
  private List<Track> placed = List.of();

  /**
   * Shows all of the time.
   *
   * @param pointed the time at which the user points, here and in views
   */
  public BarState(PointedTime pointed) {
    this.pointed = pointed;
  }

  /** Takes up how things stand. */
  void take(TimelineState now, List<Track> open) {
    state = now;
    if (!open.equals(tracks)) {
      tracks = open;
      rows = LaneRows.of(tracks, folded);
    }
    zoom = zoom.filter(z -> z.start() <= all().end() && z.end() >= all().start());
    if (now.playing()) {
      zoom = zoom.map(z -> new TimeScale(z, 0, 1).paged(now.position(), all()));
    }
  }

  /** Takes up what was found, as the recordings lie now. */
  void take(List<FoundEvent> now, List<Track> open) {
    if (!now.equals(events) || !open.equals(placed)) {
      events = now;
      placed = open;
      found = FoundRow.of(events, open);
    }
  }

  /** What was found, by time. */
  List<FoundRow> found() {
    return found;
  }

  TimelineState state() {
    return state;
  }

  List<Track> tracks() {
    return tracks;
  }

  LaneRows rows() {
    return rows;
  }

  /** All of the time of the recordings. */
  TimeRange all() {
    TimeRange span = state.span().orElse(new TimeRange(0, 0));
    return span.length() > 0 ? span : new TimeRange(span.start(), span.start() + LEAST_SPAN);
  }

  /** Which time lies where in a control of a width. */
  TimeScale scale(int width) {
    int left = expanded ? labelWidth(width) : EDGE;
    return new TimeScale(zoom.orElse(all()), left, width - left - EDGE);
  }

  /** How wide the names of the lanes are, left of the time. */
  static int labelWidth(int width) {
    return Math.min(MOST_LABEL, width * 2 / 5);
  }

  void zoom(TimeRange wanted) {
    zoom = Optional.of(wanted).filter(w -> !w.equals(all()));
  }

  boolean isZoomed() {
    return zoom.isPresent();
  }

  boolean isExpanded() {
    return expanded;
  }

  void expand(boolean now) {
    expanded = now;
  }

  /** Shows the topics of a robot's recordings, or only the recordings. */
  void fold(String robot) {
    if (!folded.remove(robot)) {
      folded.add(robot);
    }
    rows = LaneRows.of(tracks, folded);
  }

  /** Where the pointer is, over the time. */
  OptionalInt pointer() {
    return pointer;
  }

  /** The pointer is at a place, which is told to views. */
  void point(OptionalInt x, TimeScale scale) {
    pointer = x;
    x.ifPresentOrElse(at -> pointed.point(this, scale.time(at)), this::leave);
  }

  /** The user points nowhere any more. */
  void leave() {
    pointer = OptionalInt.empty();
    pointed.leave(this);
  }

  /** Where the time lies at which the user points in a view, within what is shown. */
  OptionalInt elsewhere(TimeScale scale) {
    OptionalLong time = pointed.elsewhere(this);
    return time.isPresent() && pointer.isEmpty() && scale.shown().nearest(time.getAsLong()) == time.getAsLong()
        ? OptionalInt.of(scale.x(time.getAsLong()))
        : OptionalInt.empty();
  }

  /** The time at which the user points. */
  PointedTime pointed() {
    return pointed;
  }

  /** What could not be read, with the name of the file where there are several. */
  List<String> problems() {
    return tracks.stream().flatMap(
        t -> t.problems().stream().map(p -> tracks.size() > 1 ? t.file().getFileName() + ": " + p : p)).toList();
  }

  /** What a row says, for screen readers. */
  static String words(Row row) {
    return switch (row) {
      case Row.Head head -> head.track().id().robot() + ", recording " + head.track().file().getFileName() + ", offset "
          + TimeWords.offset(head.track().offset()) + " s";
      case Row.Topic topic -> topic.of().lane().topic() + ", " + topic.of().lane().type() + ", " + count(topic);
    };
  }

  static String count(Row.Topic topic) {
    long count = topic.of().lane().count();
    return count < 0 ? "not counted yet" : TimeWords.messages(count);
  }
}
