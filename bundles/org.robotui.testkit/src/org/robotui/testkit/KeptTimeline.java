package org.robotui.testkit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.api.host.Host.Subscription;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Timeline;
import org.robotui.api.replay.TimelineState;
import org.robotui.api.replay.Track;
import org.robotui.api.replay.TrackId;

/** A timeline that is where it was sought, and notes that. */
public final class KeptTimeline implements Timeline {
  /** Where it was sought, oldest first, in nanoseconds. */
  public final List<Long> sought = new ArrayList<>();
  private volatile long position;

  @Override
  public TimelineState state() {
    return new TimelineState(Optional.of(new TimeRange(0, Long.MAX_VALUE)), position, false, 1, false,
        Optional.empty(), List.of(), false);
  }

  @Override
  public List<Track> tracks() {
    return List.of();
  }

  @Override
  public void seek(long time) {
    sought.add(time);
    position = time;
  }

  @Override
  public void play() {
    throw new UnsupportedOperationException();
  }

  @Override
  public void pause() {
    throw new UnsupportedOperationException();
  }

  @Override
  public void step(boolean forward, Optional<LaneId> lane) {
    throw new UnsupportedOperationException();
  }

  @Override
  public void speed(double factor) {
    throw new UnsupportedOperationException();
  }

  @Override
  public void loop(boolean again) {
    throw new UnsupportedOperationException();
  }

  @Override
  public void range(Optional<TimeRange> part) {
    throw new UnsupportedOperationException();
  }

  @Override
  public void advance(long time) {
    seek(time);
  }

  @Override
  public boolean isThere() {
    return true;
  }

  @Override
  public void shift(TrackId track, long offset) {
    throw new UnsupportedOperationException();
  }

  @Override
  public void mark(Bookmark bookmark) {
    throw new UnsupportedOperationException();
  }

  @Override
  public void unmark(long time) {
    throw new UnsupportedOperationException();
  }

  @Override
  public Subscription listen(Runnable changed) {
    throw new UnsupportedOperationException();
  }
}
