package org.robotui.rfic.recording.internal.time;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.LongSupplier;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.host.Host.Subscription;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Timeline;
import org.robotui.api.replay.TimelineState;
import org.robotui.api.replay.Track;
import org.robotui.api.replay.TrackId;

/**
 * The timeline of this process. One lock guards it; what may take long, and what tells others, is done without it on
 * the thread of the timeline, which there is while a recording is open. Who reads slowly makes it late, and loses
 * nothing.
 */
@Component(service = {Timeline.class, SharedTimeline.class})
public final class SharedTimeline implements Timeline {
  /** A message further away is not worth delivering all that lies before it. */
  private static final long FAR_NANOS = TimeUnit.SECONDS.toNanos(2);
  private static final long TICK_NANOS = TimeUnit.MILLISECONDS.toNanos(20);
  private static final long IDLE_NANOS = TimeUnit.SECONDS.toNanos(1);
  private static final long TELL_NANOS = TimeUnit.MILLISECONDS.toNanos(90);

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private final LongSupplier real;
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private final Seats seats = new Seats();
  private final TimelineNotes notes = new TimelineNotes();
  private Passage passage;
  private Optional<StepWish> step = Optional.empty();
  private boolean stepping;
  private boolean news;
  private long toldAt;
  private Optional<TimelineThread> thread = Optional.empty();

  /**
   * What one turn has to do without the lock.
   *
   * @param seats the recordings that are open
   * @param at where the timeline is
   * @param moves whether they are to be moved there
   * @param step a wish for a message beside it
   * @param told whether listeners are to be told
   */
  private record Work(List<Seat> seats, long at, boolean moves, Optional<StepWish> step, boolean told) {}

  /** Without recordings. */
  @Activate
  public SharedTimeline() {
    this(System::nanoTime);
  }

  /**
   * With another clock, for tests.
   *
   * @param real as {@link System#nanoTime()}
   */
  public SharedTimeline(LongSupplier real) {
    this.real = real;
    this.passage = new Passage(real, seats);
    this.toldAt = real.getAsLong();
  }

  /**
   * Adds a recording. Where it is the first, the timeline begins at its start.
   *
   * @param track the recording
   * @param settings how it comes
   * @param folder where offsets and bookmarks are kept
   * @return its place, to be closed by who reads it
   */
  public Seat add(PlayedTrack track, PlaySettings settings, Path folder) {
    notes.read(folder);
    lock.lock();
    try {
      Seat seat = new Seat(this, lock, changed, track, settings.offset(), notes.offset(track.identity()));
      boolean first = seats.isEmpty();
      seats.add(seat);
      notes.load(seat);
      passage.joined(seat, settings, first);
      if (first) {
        thread = Optional.of(TimelineThread.start(this::turn));
      }
      tell();
      return seat;
    } finally {
      lock.unlock();
    }
  }

  /** A recording is closed; with the last one all is forgotten but what is kept in files. */
  void remove(Seat seat) {
    Optional<TimelineThread> ended = Optional.empty();
    lock.lock();
    try {
      seats.remove(seat);
      if (seats.isEmpty()) {
        ended = thread;
        thread = Optional.empty();
        passage = new Passage(real, seats);
        step = Optional.empty();
        notes.clear();
      }
      arrived();
      tell();
    } finally {
      lock.unlock();
    }
    if (ended.isPresent()) {
      ended.get().end(this::wake);
      notes.save();
      listeners.forEach(Runnable::run);
    }
  }

  @Override
  public boolean isThere() {
    lock.lock();
    try {
      return seats.isEmpty() || !stepping && step.isEmpty() && !passage.isWanted() && !passage.isMoving()
          && passage.isDelivered();
    } finally {
      lock.unlock();
    }
  }

  private void wake() {
    lock.lock();
    try {
      tell();
    } finally {
      lock.unlock();
    }
  }

  private void tell() {
    news = true;
    changed.signalAll();
  }

  long position() {
    return passage.position();
  }

  boolean hasReached(long time) {
    return passage.hasReached(time);
  }

  /** A clock of a test is moved without telling anybody: it is looked at again and again while it plays. */
  long realNanosUntil(long time) {
    return passage.realNanosUntil(time, passage.isPlaying() ? TICK_NANOS : IDLE_NANOS);
  }

  /** One of the recordings is where it was moved to. */
  void arrived() {
    passage.arrived();
    changed.signalAll();
  }

  /** What the thread of the timeline does again and again. */
  private void turn() {
    Work work = nextWork();
    notes.save();
    if (work.moves()) {
      move(work.seats(), work.at());
    } else {
      work.seats().forEach(seat -> seat.track().passed(seat.toFile(work.at())));
    }
    work.step().ifPresent(wish -> go(work.seats(), wish, work.at()));
    if (work.told()) {
      listeners.forEach(Runnable::run);
    }
  }

  private Work nextWork() {
    lock.lock();
    try {
      if (!news && (passage.isMoving() || !passage.isWanted() && step.isEmpty())) {
        changed.awaitNanos(passage.isPlaying() || passage.isMoving() ? TICK_NANOS : IDLE_NANOS);
      }
      news |= passage.pass();
      boolean moves = passage.begin();
      Optional<StepWish> next = passage.isMoving() ? Optional.empty() : step;
      stepping = next.isPresent();
      step = next.isPresent() ? Optional.empty() : step;
      return new Work(seats.all(), position(), moves, next, takeNews());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return new Work(List.of(), 0, false, Optional.empty(), false);
    } finally {
      lock.unlock();
    }
  }

  private boolean takeNews() {
    long now = real.getAsLong();
    boolean told = news || passage.isPlaying() && now - toldAt > TELL_NANOS;
    news = false;
    toldAt = told ? now : toldAt;
    return told;
  }

  /** All clocks first: two recordings of one robot UI would else forget what the other one has said already. */
  private void move(List<Seat> all, long to) {
    all.forEach(seat -> seat.track().moved(seat.toFile(to)));
    lock.lock();
    try {
      all.forEach(seat -> seat.moved(to));
      arrived();
    } finally {
      lock.unlock();
    }
  }

  /** Goes to the next or the former message; the file is read without the lock. */
  private void go(List<Seat> all, StepWish wish, long at) {
    Optional<Long> nearest = wish.nearest(all, at);
    lock.lock();
    try {
      stepping = false;
      nearest.filter(time -> !passage.isWanted() && !passage.isPlaying()).ifPresent(time -> take(time, at));
    } finally {
      lock.unlock();
    }
  }

  private void take(long time, long at) {
    if (time > at && time - at < FAR_NANOS) {
      passage.goOn(time);
    } else {
      passage.want(time);
    }
    tell();
  }

  @Override
  public TimelineState state() {
    lock.lock();
    try {
      return seats.isEmpty() ? TimelineState.EMPTY
          : new TimelineState(Optional.of(seats.span()), passage.shown(), passage.isPlaying(), passage.speed(),
              passage.isLooping(), passage.range(), notes.bookmarks(), passage.isLate());
    } finally {
      lock.unlock();
    }
  }

  @Override
  public List<Track> tracks() {
    lock.lock();
    try {
      return seats.all().stream().map(Seat::described).toList();
    } finally {
      lock.unlock();
    }
  }

  /**
   * The recordings that are open.
   *
   * @return sorted by robot and instance
   */
  public List<PlayedTrack> open() {
    lock.lock();
    try {
      return seats.all().stream().map(Seat::track).toList();
    } finally {
      lock.unlock();
    }
  }

  /**
   * A recording that is open.
   *
   * @param wanted which one
   * @return where it is read
   * @throws IllegalArgumentException where it is not open any more
   */
  public PlayedTrack open(TrackId wanted) {
    return open().stream().filter(each -> each.id().equals(wanted)).findFirst().orElseThrow(
        () -> new IllegalArgumentException("the recording of " + wanted.robot() + " is not open any more"));
  }

  /** What a user does; nothing where no recording is open. */
  private void act(Runnable deed) {
    lock.lock();
    try {
      if (!seats.isEmpty()) {
        passage.touch();
        deed.run();
        tell();
      }
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void play() {
    act(() -> passage.play());
  }

  @Override
  public void pause() {
    act(() -> passage.pause());
  }

  @Override
  public void seek(long time) {
    act(() -> {
      step = Optional.empty();
      passage.want(time);
    });
  }

  @Override
  public void advance(long time) {
    act(() -> {
      passage.pause();
      step = Optional.empty();
      long to = seats.span().nearest(time);
      if (!passage.isWanted() && !passage.isMoving() && to >= passage.position()) {
        passage.goOn(to);
      } else {
        passage.want(to);
      }
    });
  }

  @Override
  public void step(boolean forward, Optional<LaneId> lane) {
    act(() -> {
      passage.pause();
      step = Optional.of(new StepWish(forward, lane));
    });
  }

  @Override
  public void speed(double factor) {
    act(() -> passage.speed(factor));
  }

  @Override
  public void loop(boolean again) {
    act(() -> passage.loop(again));
  }

  @Override
  public void range(Optional<TimeRange> part) {
    act(() -> passage.range(part));
  }

  @Override
  public void shift(TrackId track, long offset) {
    act(() -> {
      long at = passage.shown();
      seats.all().stream().filter(seat -> seat.track().id().equals(track)).forEach(seat -> {
        seat.shift(offset);
        notes.shifted(seat);
      });
      passage.want(at);
    });
  }

  @Override
  public void mark(Bookmark bookmark) {
    act(() -> notes.mark(bookmark, seats.all()));
  }

  @Override
  public void unmark(long time) {
    act(() -> notes.unmark(time, seats.all()));
  }

  @Override
  public Subscription listen(Runnable changes) {
    Runnable own = changes::run;
    listeners.add(own);
    return () -> listeners.remove(own);
  }
}
