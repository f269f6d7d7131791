package org.robotui.rfic.recording.internal.time;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Timeline;

/**
 * How time passes, from the first recording that is opened to the last that is closed. It never passes a message that
 * was not delivered. Guarded by its timeline.
 */
final class Passage {
  private static final long LATE_NANOS = TimeUnit.MILLISECONDS.toNanos(100);
  private static final long TOGETHER_NANOS = TimeUnit.SECONDS.toNanos(10);
  private static final long TOLD_LATE_NANOS = TimeUnit.SECONDS.toNanos(1);

  private final LongSupplier real;
  private final Seats seats;
  private final PlayClock clock = new PlayClock();
  private Optional<TimeRange> range = Optional.empty();
  private boolean looping;
  private boolean touched;
  private long begun;
  private Optional<Long> wanted = Optional.empty();
  private Optional<Long> target = Optional.empty();
  private long toldLateUntil;

  Passage(LongSupplier real, Seats seats) {
    this.real = real;
    this.seats = seats;
    this.toldLateUntil = real.getAsLong();
  }

  /**
   * One more is there. Those of one configuration are opened one after another, and are begun together at the start.
   */
  void joined(Seat seat, PlaySettings settings, boolean first) {
    begun = first ? real.getAsLong() : begun;
    boolean together = first || !touched && real.getAsLong() - begun < TOGETHER_NANOS;
    looping |= settings.loops();
    clock.play(clock.isPlaying() || settings.plays() && !touched, real.getAsLong());
    seat.join(position());
    wanted = Optional.of(together ? seats.span().start() : shown());
  }

  /** What is played: a part, or all. */
  TimeRange played() {
    return range.orElseGet(seats::span);
  }

  Optional<TimeRange> range() {
    return range;
  }

  void range(Optional<TimeRange> part) {
    TimeRange span = seats.span();
    range = part.map(p -> new TimeRange(span.nearest(p.start()), span.nearest(p.end())));
  }

  boolean isLooping() {
    return looping;
  }

  void loop(boolean again) {
    looping = again;
  }

  /** From now on a user says what plays. */
  void touch() {
    touched = true;
  }

  /** Where it is, not beyond what was delivered. */
  long position() {
    return target.orElseGet(() -> seats.span().nearest(Math.min(passed(), seats.bound())));
  }

  /** Where users want it, or have it. */
  long shown() {
    return wanted.map(seats.span()::nearest).orElseGet(this::position);
  }

  /** Where it would be if all were delivered: not beyond the end of what is played. */
  private long passed() {
    return clock.at(real.getAsLong(), played().end());
  }

  boolean hasReached(long time) {
    return target.isEmpty() && passed() >= time;
  }

  /** How long until then, at most as given. */
  long realNanosUntil(long time, long most) {
    return Math.min(most, clock.realNanosUntil(time, real.getAsLong()));
  }

  /** Whether all up to where it stands was delivered. */
  boolean isDelivered() {
    return clock.isPlaying() || seats.bound() > passed();
  }

  boolean isPlaying() {
    return clock.isPlaying();
  }

  double speed() {
    return clock.speed();
  }

  void speed(double factor) {
    clock.speed(Double.isNaN(factor) ? 1 : Math.clamp(factor, Timeline.SLOWEST, Timeline.FASTEST), real.getAsLong());
  }

  void play() {
    long at = shown();
    if (at >= played().end() || at < played().start()) {
      wanted = Optional.of(played().start());
    }
    clock.play(true, real.getAsLong());
  }

  void pause() {
    long now = real.getAsLong();
    clock.place(position(), now);
    clock.play(false, now);
  }

  /** Is to be moved. */
  void want(long time) {
    wanted = Optional.of(seats.span().nearest(time));
  }

  boolean isWanted() {
    return wanted.isPresent();
  }

  boolean isMoving() {
    return target.isPresent();
  }

  /** Goes on to a time that is near, where all that lies before it is delivered. */
  void goOn(long time) {
    clock.place(time, real.getAsLong());
  }

  /** Only the newest of all wishes is worked on, and only when the one before has been done. */
  boolean begin() {
    if (wanted.isEmpty() || target.isPresent()) {
      return false;
    }
    long to = seats.span().nearest(wanted.get());
    target = Optional.of(to);
    wanted = Optional.empty();
    seats.all().forEach(seat -> seat.depart(to));
    return true;
  }

  /** Where all recordings are where they were moved to, time passes again. */
  void arrived() {
    if (target.isPresent() && seats.areThere()) {
      clock.place(target.get(), real.getAsLong());
      target = Optional.empty();
    }
  }

  boolean isLate() {
    return clock.isPlaying() && real.getAsLong() - toldLateUntil < 0;
  }

  /** Looks whether it is late or at the end; answers whether it ended. */
  boolean pass() {
    if (target.isPresent() || wanted.isPresent() || !clock.isPlaying()) {
      return false;
    }
    long now = real.getAsLong();
    long bound = seats.bound();
    if ((clock.at(now) - (double) bound) / clock.speed() > LATE_NANOS) {
      clock.place(bound, now);
      toldLateUntil = now + TOLD_LATE_NANOS;
    }
    long end = played().end();
    boolean ends = clock.at(now) >= end && bound > end;
    if (ends) {
      end(end, now);
    }
    return ends;
  }

  private void end(long end, long now) {
    boolean again = looping && played().length() > 0;
    clock.place(end, now);
    clock.play(again, now);
    wanted = again ? Optional.of(played().start()) : Optional.empty();
  }
}
