package org.robotui.xbot.internal;

import java.io.IOException;
import java.lang.ref.Cleaner;
import java.lang.ref.Reference;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import org.robotui.xbot.Board;
import org.robotui.xbot.HostReading;
import org.robotui.xbot.StateFrame;
import org.robotui.xbot.Timing;

/**
 * The mapped memory of a running control. It is unmapped when nobody can reach this any more, and not before: reading
 * memory that is not mapped would end the process. After the control has gone it stays as it was.
 */
public final class Segments implements CycleMemory {
  private static final Cleaner CLEANER = Cleaner.create();

  private record Detach(long attachment) implements Runnable {
    @Override
    public void run() {
      NativeLink.detach(attachment);
    }
  }

  /** How each kind of memory is read. */
  public record Readers(StateReader state, BoardReader board, HostReader host) {
    /** For this layout. */
    public static Readers of(Layout layout) {
      return new Readers(new StateReader(layout), new BoardReader(layout), new HostReader(layout));
    }
  }

  private final Readers readers;
  private final Memory state;
  private final Memory board;
  private final List<Memory> hosts = new ArrayList<>();
  private final AtomicReference<FrameCopy> spare = new AtomicReference<>();
  private volatile Optional<KnownBoard> known = Optional.empty();

  private record KnownBoard(long version, Board board) {}

  Segments(long attachment, Readers readers) throws IOException {
    CLEANER.register(this, new Detach(attachment));
    this.readers = readers;
    this.state = new Memory(NativeLink.state(attachment));
    this.board = new Memory(NativeLink.board(attachment));
    for (int i = 0; i < NativeLink.hosts(attachment); i++) {
      hosts.add(new Memory(NativeLink.host(attachment, i)));
    }
  }

  @Override
  public long newestCycle() {
    try {
      return readers.state().newest(state);
    } finally {
      Reference.reachabilityFence(this);
    }
  }

  /** The newest state. */
  public Optional<StateFrame> state() {
    return reading(copy -> readers.state().read(state, copy));
  }

  @Override
  public Optional<StateFrame> state(long cycle) {
    return reading(copy -> readers.state().read(state, cycle, copy));
  }

  /** With the room of the reading before; with new one where another thread reads now, since nobody waits here. */
  private Optional<StateFrame> reading(Function<FrameCopy, Optional<StateFrame>> read) {
    try {
      FrameCopy copy = Optional.ofNullable(spare.getAndSet(null)).orElseGet(readers.state()::newCopy);
      Optional<StateFrame> found = read.apply(copy);
      spare.set(copy);
      return found;
    } finally {
      Reference.reachabilityFence(this);
    }
  }

  @Override
  public long oldestCycle(long newest) {
    return readers.state().oldest(newest);
  }

  /** How the loop at the hardware keeps its time. */
  public Timing loop() {
    try {
      return readers.state().loop(state);
    } finally {
      Reference.reachabilityFence(this);
    }
  }

  /**
   * What there is: read again only where something else was written, since it is long, rarely new, and asked for often.
   */
  public Optional<Board> board() {
    try {
      long version = readers.board().version(board);
      Optional<KnownBoard> before = known;
      if (before.isEmpty() || before.get().version() != version) {
        // A version from before the reading: what is written meanwhile is read at the next asking.
        known = readers.board().read(board).map(read -> new KnownBoard(version, read));
      }
      return known.map(KnownBoard::board);
    } finally {
      Reference.reachabilityFence(this);
    }
  }

  /** What the processes of plugins say, by index. */
  public List<HostReading> hosts() {
    try {
      return hosts.stream().map(readers.host()::read).toList();
    } finally {
      Reference.reachabilityFence(this);
    }
  }
}
