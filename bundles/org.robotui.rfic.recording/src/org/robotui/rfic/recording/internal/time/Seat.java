package org.robotui.rfic.recording.internal.time;

import java.util.Optional;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Track;

/**
 * The place of one recording on the timeline. Who reads the recording says which message it will deliver next, and the
 * timeline does not pass that time before it has. Times are those of the file here, unless they are said to be those of
 * the timeline. Safe for all threads.
 */
public final class Seat implements AutoCloseable {
  /** The time of the next message where there is none. */
  public static final long NEVER = Long.MAX_VALUE;
  /** The last time of a file that is played: in the year 2116. */
  public static final long FARTHEST = Long.MAX_VALUE / 2;

  private final SharedTimeline timeline;
  private final ReentrantLock lock;
  private final Condition changed;
  private final PlayedTrack track;
  private final long configured;
  private long offset;
  private long limit = NEVER;
  private Optional<Long> move = Optional.empty();
  private volatile boolean moving = true;
  private boolean departed;
  private boolean look;
  private boolean closed;

  Seat(SharedTimeline timeline, ReentrantLock lock, Condition changed, PlayedTrack track, long configured,
      long kept) {
    this.timeline = timeline;
    this.lock = lock;
    this.changed = changed;
    this.track = track;
    this.configured = configured;
    shift(configured + kept);
  }

  PlayedTrack track() {
    return track;
  }

  /** Its times on the timeline. */
  TimeRange span() {
    return new TimeRange(track.span().start() + offset, track.span().end() + offset);
  }

  Track described() {
    return new Track(track.id(), track.file(), span(), offset, track.lanes(), track.problems());
  }

  /** What was added to the configured offset. */
  long kept() {
    return offset - configured;
  }

  void shift(long to) {
    offset = Math.clamp(to, -FARTHEST, FARTHEST);
  }

  long toFile(long time) {
    return time - offset;
  }

  /** What lies in a very far future never comes. */
  long toTimeline(long time) {
    return time > FARTHEST ? NEVER : time + offset;
  }

  /**
   * Where the recording lies on the timeline.
   *
   * @return what is added to its times
   */
  public long offset() {
    lock.lock();
    try {
      return offset;
    } finally {
      lock.unlock();
    }
  }

  /** As far as the timeline may pass, by the time of the timeline. */
  long limit() {
    return limit;
  }

  /** Has joined where the timeline is, and waits for being moved. */
  void join(long time) {
    limit = time;
  }

  /** Is to be taken to a time of the timeline; it does not go on before. */
  void depart(long time) {
    moving = true;
    departed = true;
    move = Optional.empty();
    limit = time;
  }

  /** Whether others have to wait for it. */
  boolean isOnItsWay() {
    return moving && departed;
  }

  /** The clocks of all robots are there: what holds then may be delivered. */
  void moved(long time) {
    move = Optional.of(time);
  }

  /**
   * Whether it is on its way to another time: what was read for the time before is void.
   *
   * @return true until what holds there was delivered
   */
  public boolean isMoving() {
    return moving;
  }

  /**
   * Waits until there is something to do. Only for the thread that reads the recording.
   *
   * @param next the time of the next message to be delivered; {@link #NEVER} where there is none
   * @return what is to be done
   * @throws InterruptedException where the thread shall end
   */
  public Turn await(long next) throws InterruptedException {
    lock.lockInterruptibly();
    try {
      limit = moving ? limit : toTimeline(next);
      while (true) {
        Optional<Turn> turn = turn(next);
        if (turn.isPresent()) {
          return turn.get();
        }
        changed.awaitNanos(timeline.realNanosUntil(toTimeline(next)));
      }
    } finally {
      lock.unlock();
    }
  }

  private Optional<Turn> turn(long next) {
    if (closed) {
      return Optional.of(new Turn.Over());
    }
    if (move.isPresent()) {
      long time = toFile(move.get());
      move = Optional.empty();
      look = false;
      return Optional.of(new Turn.Moved(time));
    }
    if (moving) {
      return Optional.empty();
    }
    if (look) {
      look = false;
      return Optional.of(new Turn.Look());
    }
    return next != NEVER && timeline.hasReached(toTimeline(next)) ? Optional.of(new Turn.Deliver()) : Optional.empty();
  }

  /**
   * What holds at the time to which it was moved has been delivered. Only for the thread that reads the recording.
   *
   * @param next the time of the next message to be delivered; {@link #NEVER} where there is none
   */
  public void arrived(long next) {
    lock.lock();
    try {
      limit = toTimeline(next);
      moving = false;
      timeline.arrived();
    } finally {
      lock.unlock();
    }
  }

  /**
   * Has the timeline stand until the next {@link #await}, so that it passes nothing that was not wanted before. Only
   * for the thread that reads the recording.
   *
   * @return until which time all has been delivered
   */
  public long hold() {
    lock.lock();
    try {
      limit = Math.min(timeline.position(), limit == NEVER ? limit : limit - 1);
      return toFile(limit);
    } finally {
      lock.unlock();
    }
  }

  /** Other topics are wanted than before. */
  public void look() {
    lock.lock();
    try {
      look = true;
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /** Leaves the timeline; {@link #await} answers that it is over. */
  @Override
  public void close() {
    lock.lock();
    try {
      closed = true;
      changed.signalAll();
    } finally {
      lock.unlock();
    }
    timeline.remove(this);
  }
}
