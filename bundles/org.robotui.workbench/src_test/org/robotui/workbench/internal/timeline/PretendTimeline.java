package org.robotui.workbench.internal.timeline;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.IntStream;
import org.robotui.api.host.Host.Subscription;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.Lane;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Timeline;
import org.robotui.api.replay.TimelineState;
import org.robotui.api.replay.Track;
import org.robotui.api.replay.TrackId;

/** A timeline that keeps what it is told, and notes what it was asked for. */
final class PretendTimeline implements Timeline {
  static final long SECOND = 1_000_000_000L;
  static final long BEGIN = 1_700_000_000L * SECOND;
  static final TrackId KEIRA = new TrackId("Keira", "base");
  static final TrackId HUSKY = new TrackId("Husky", "base");

  final List<String> asked = new ArrayList<>();
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private List<Track> tracks = List.of();
  private TimelineState state = TimelineState.EMPTY;

  /** Two recordings of some minutes, one of them damaged and begun later. */
  PretendTimeline filled() {
    tracks = List.of(
        track(HUSKY, "husky.mcap", 60, 240, 0, List.of("the last chunk is cut off at byte 1048576"), "/odom", "/imu"),
        track(KEIRA, "keira-with-a-rather-long-name_2026-11-27.bag", 0, 300, 0, List.of(), "/base_scan", "/cmd_vel",
            "/front/camera/image_raw/compressed", "/map", "/odom", "/robot_pose_ekf/odom_combined", "/rosout", "/tf"));
    state = new TimelineState(Optional.of(new TimeRange(BEGIN, BEGIN + 300 * SECOND)), BEGIN, false, 1, false,
        Optional.empty(), List.of(), false);
    return this;
  }

  private static Track track(TrackId id, String file, int from, int to, long offset, List<String> problems,
      String... topics) {
    Random random = new Random(1);
    List<Lane> lanes = IntStream.range(0, topics.length)
        .mapToObj(i -> new Lane(topics[i], "sensor_msgs/Type" + i, 1000L * i + 7, counts(random, i))).toList();
    return new Track(id, Path.of("/recordings", file), new TimeRange(BEGIN + from * SECOND, BEGIN + to * SECOND),
        offset,
        lanes, problems);
  }

  private static List<Integer> counts(Random random, int lane) {
    return IntStream.range(0, 500).map(i -> i > 120 && i < 180 || lane % 3 == 1 && i % 40 != 0 ? 0
        : 3 + random.nextInt(lane * 4 + 2)).boxed().toList();
  }

  /** Another state, as if it had changed by itself. */
  void set(TimelineState next) {
    state = next;
    listeners.forEach(Runnable::run);
  }

  /** No recording any more. */
  void empty() {
    tracks = List.of();
    set(TimelineState.EMPTY);
  }

  private void told(String what, TimelineState next) {
    asked.add(what);
    set(next);
  }

  private TimelineState with(long position, boolean playing, double speed, boolean looping, Optional<TimeRange> range,
      List<Bookmark> marks) {
    return new TimelineState(state.span(), position, playing, speed, looping, range, marks, state.lagging());
  }

  @Override
  public TimelineState state() {
    return state;
  }

  @Override
  public List<Track> tracks() {
    return tracks;
  }

  @Override
  public void play() {
    told("play", with(state.position(), true, state.speed(), state.looping(), state.range(), state.bookmarks()));
  }

  @Override
  public void pause() {
    told("pause", with(state.position(), false, state.speed(), state.looping(), state.range(), state.bookmarks()));
  }

  @Override
  public void seek(long time) {
    told("seek " + (time - BEGIN),
        with(time, state.playing(), state.speed(), state.looping(), state.range(), state.bookmarks()));
  }

  @Override
  public void advance(long time) {
    told("advance " + (time - BEGIN),
        with(time, false, state.speed(), state.looping(), state.range(), state.bookmarks()));
  }

  @Override
  public boolean isThere() {
    return true;
  }

  @Override
  public void step(boolean forward, Optional<LaneId> lane) {
    told("step " + (forward ? "on" : "back") + lane.map(l -> " " + l.topic()).orElse(""), state);
  }

  @Override
  public void speed(double factor) {
    told("speed " + factor,
        with(state.position(), state.playing(), factor, state.looping(), state.range(), state.bookmarks()));
  }

  @Override
  public void loop(boolean again) {
    told("loop " + again,
        with(state.position(), state.playing(), state.speed(), again, state.range(), state.bookmarks()));
  }

  @Override
  public void range(Optional<TimeRange> part) {
    told("range", with(state.position(), state.playing(), state.speed(), state.looping(), part, state.bookmarks()));
  }

  @Override
  public void shift(TrackId track, long offset) {
    tracks = tracks.stream()
        .map(t -> t.id().equals(track)
            ? new Track(t.id(), t.file(), t.span(), offset, t.lanes(), t.problems())
            : t)
        .toList();
    told("shift " + track.robot() + " " + offset, state);
  }

  @Override
  public void mark(Bookmark bookmark) {
    List<Bookmark> marks = new ArrayList<>(state.bookmarks());
    marks.removeIf(m -> m.time() == bookmark.time());
    marks.add(bookmark);
    marks.sort(Comparator.comparingLong(Bookmark::time));
    told("mark", with(state.position(), state.playing(), state.speed(), state.looping(), state.range(), marks));
  }

  @Override
  public void unmark(long time) {
    told("unmark", with(state.position(), state.playing(), state.speed(), state.looping(), state.range(),
        state.bookmarks().stream().filter(m -> m.time() != time).toList()));
  }

  @Override
  public Subscription listen(Runnable changed) {
    listeners.add(changed);
    return () -> listeners.remove(changed);
  }
}
