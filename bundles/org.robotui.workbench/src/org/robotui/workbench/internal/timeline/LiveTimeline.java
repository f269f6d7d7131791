package org.robotui.workbench.internal.timeline;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.api.host.Host.Subscription;
import org.robotui.api.replay.Timeline;
import org.robotui.api.replay.Timeline.LaneId;
import org.robotui.api.replay.TimelineState;
import org.robotui.api.replay.Track;

/**
 * The timeline, as windows see it: it may come and go, and what it tells is taken up on the display thread, once for
 * any number of changes that wait.
 */
public final class LiveTimeline {
  private final Executor display;
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private final AtomicBoolean waiting = new AtomicBoolean();
  private Optional<Timeline> timeline = Optional.empty();
  private Optional<Subscription> following = Optional.empty();
  private TimelineState state = TimelineState.EMPTY;
  private List<Track> tracks = List.of();
  private Optional<LaneId> stepped = Optional.empty();

  /** No timeline yet; {@code display} runs tasks on the display thread, later and one after another. */
  public LiveTimeline(Executor display) {
    this.display = display;
  }

  /** From now on it is this one, or none. Any thread. */
  public void follow(Optional<Timeline> next) {
    display.execute(() -> {
      following.ifPresent(Subscription::close);
      timeline = next;
      following = next.map(t -> t.listen(this::news));
      update();
    });
  }

  /** Has something run on the display thread after each change; running the result ends that. */
  public Runnable onChange(Runnable listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }

  /** The timeline, while recordings are open. Display thread. */
  public Optional<Timeline> timeline() {
    return timeline.filter(t -> !tracks.isEmpty());
  }

  /** As of the last change. Display thread. */
  TimelineState state() {
    return state;
  }

  /** As of the last change. Display thread. */
  List<Track> tracks() {
    return tracks;
  }

  /** By the messages of which topic it is stepped; by all where there is none. Display thread. */
  Optional<LaneId> stepped() {
    return stepped;
  }

  /** Steps by the messages of a topic, or, where it is chosen already, by all again. Display thread. */
  void stepBy(LaneId lane) {
    stepped = stepped.filter(lane::equals).isPresent() ? Optional.empty() : Optional.of(lane);
    listeners.forEach(Runnable::run);
  }

  /** Goes to the next or to the former message, of the topic that is chosen. Display thread. */
  public void step(boolean forward) {
    timeline().ifPresent(t -> t.step(forward, stepped));
  }

  private void news() {
    if (waiting.compareAndSet(false, true)) {
      display.execute(this::update);
    }
  }

  private void update() {
    waiting.set(false);
    state = timeline.map(Timeline::state).orElse(TimelineState.EMPTY);
    tracks = timeline.map(Timeline::tracks).orElse(List.of());
    stepped = stepped.filter(lane -> tracks.stream().anyMatch(t -> has(t, lane)));
    listeners.forEach(Runnable::run);
  }

  private static boolean has(Track track, LaneId lane) {
    return track.id().equals(lane.track()) && track.lanes().stream().anyMatch(l -> l.topic().equals(lane.topic()));
  }
}
