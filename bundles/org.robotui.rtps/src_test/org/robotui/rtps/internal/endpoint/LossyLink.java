package org.robotui.rtps.internal.endpoint;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.IntPredicate;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.ParticipantLimits;
import org.robotui.rtps.Locators;
import org.robotui.rtps.Qos;
import org.robotui.rtps.internal.wire.SequenceSet;

/** Readers and writers on one link in memory that loses and delays, by a clock that the test moves. */
final class LossyLink {

  static final ParticipantLimits LIMITS = new ParticipantLimits(10, 10, 4 << 20, 8L << 20, 8L << 20);

  private final Random random;
  private final double loss;
  private final long delay;
  private final Deque<Sent> underWay = new ArrayDeque<>();
  private final Map<Guid, ReaderCore> readers = new HashMap<>();
  private final Map<Guid, WriterCore> writers = new HashMap<>();
  private final Map<Guid, List<Change>> delivered = new HashMap<>();
  private final AtomicInteger counts = new AtomicInteger();
  private long now = 1_000_000_000L;
  private boolean cut;
  private IntPredicate drops = datagram -> false;
  private int sent;
  private long room = Long.MAX_VALUE;

  final Timers timers = new Timers(() -> now);

  private record Sent(long arrives, int bytes, List<Runnable> submessages) {}

  LossyLink(long seed, double loss, long delayMillis) {
    random = new Random(seed);
    this.loss = loss;
    delay = delayMillis * 1_000_000;
  }

  static Guid guid(int participant, int key, EndpointKind kind) {
    return new Guid(new GuidPrefix(participant, 0), EntityId.user(key, kind, false));
  }

  static EndpointInfo info(Guid guid, Qos qos) {
    return new EndpointInfo(guid, guid.entity().writer() ? EndpointKind.WRITER : EndpointKind.READER, "rt/t", "T", qos,
        ByteBuffer.allocate(0), Locators.NONE, false);
  }

  static Destination destination(Guid of) {
    return new Destination(of.prefix(), List.of(new InetSocketAddress("127.0.0.1", 7411)), 1500);
  }

  WriterCore writer(Guid guid, Qos qos) {
    WriterCore writer = new WriterCore(guid, qos, LIMITS.cacheBytes(), timers, to -> new Wire(guid, to), counts);
    writers.put(guid, writer);
    return writer;
  }

  ReaderCore reader(Guid guid, Qos qos) {
    ReaderCore reader = new ReaderCore(guid, qos, LIMITS, timers, to -> new Wire(guid, to), counts);
    readers.put(guid, reader);
    delivered.put(guid, new ArrayList<>());
    return reader;
  }

  void match(Guid writer, Qos offered, Guid reader, Qos requested) {
    readers.get(reader).match(info(writer, offered), destination(writer));
    writers.get(writer).match(info(reader, requested), destination(reader));
  }

  List<Change> delivered(Guid reader) {
    return delivered.get(reader);
  }

  /** Takes a reader out of the network without a word, as a crash does. */
  void crash(Guid reader) {
    readers.remove(reader);
  }

  /** Loses all from now on, or nothing more than usual. */
  void cut(boolean all) {
    cut = all;
  }

  /** Loses these datagrams as well, counted from now on. */
  void drop(IntPredicate which) {
    sent = 0;
    drops = which;
  }

  /** Loses what does not fit into a buffer of so many bytes, which is emptied every millisecond. */
  void buffer(long bytes) {
    room = bytes;
  }

  long now() {
    return now;
  }

  /** Lets so much time pass, in steps of a millisecond. */
  void pass(long millis) {
    for (long i = 0; i < millis; i++) {
      now += 1_000_000;
      timers.runDue();
      while (!underWay.isEmpty() && underWay.peek().arrives() <= now) {
        underWay.poll().submessages().forEach(Runnable::run);
      }
    }
  }

  private void deliver(Guid reader, List<Change> changes) {
    delivered.get(reader).addAll(changes);
  }

  /** Carries submessages, a datagram for each batch as far as 1500 bytes go. */
  private final class Wire implements EndpointOutlet.Batch {
    private final Guid from;
    private final Destination to;
    private final List<Runnable> parts = new ArrayList<>();
    private int bytes;

    Wire(Guid from, Destination to) {
      this.from = from;
      this.to = to;
    }

    private void add(int size, Runnable part) {
      if (bytes + size > to.mostDatagram()) {
        close();
      }
      bytes += size;
      parts.add(part);
    }

    private void toReaders(EntityId reader, BiFunction<Guid, ReaderCore, List<Change>> action) {
      Map.copyOf(readers).forEach((guid, core) -> {
        boolean meant = reader.equals(EntityId.UNKNOWN) || guid.entity().equals(reader);
        if (meant && guid.prefix().equals(to.participant())) {
          deliver(guid, action.apply(guid, core));
        }
      });
    }

    private void toWriter(EntityId writer, Consumer<WriterCore> action) {
      WriterCore core = writers.get(new Guid(to.participant(), writer));
      if (core != null) {
        action.accept(core);
      }
    }

    private Guid self(EntityId entity) {
      return new Guid(from.prefix(), entity);
    }

    @Override
    public void data(EntityId reader, EntityId writer, Change change) {
      add(60 + change.size(), () -> toReaders(reader, (guid, core) -> core.data(self(writer), change)));
    }

    @Override
    public void fragment(EntityId reader, EntityId writer, Change change, int size, long number) {
      int begin = (int) (number - 1) * size;
      ByteBuffer slice = change.payload().slice(begin, Math.min(size, change.size() - begin));
      Change about = new Change(change.sequence(), change.kind(), ByteBuffer.allocate(0),
          change.sourceNanos(), change.related(), change.instance());
      Fragments fragments = new Fragments(number, 1, size, change.size(), about, slice);
      add(140 + slice.remaining(), () -> toReaders(reader, (guid, core) -> core.fragments(self(writer), fragments)));
    }

    @Override
    public void heartbeat(EntityId reader, EntityId writer, long first, long last, int count, boolean answer) {
      add(32, () -> toReaders(reader, (guid, core) -> core.heartbeat(self(writer), first, last, answer, false)));
    }

    @Override
    public void alive(EntityId reader, EntityId writer, long first, long last, int count) {
      add(32, () -> toReaders(reader, (guid, core) -> core.heartbeat(self(writer), first, last, false, true)));
    }

    @Override
    public void gap(EntityId reader, EntityId writer, long start, SequenceSet set) {
      add(60, () -> toReaders(reader, (guid, core) -> core.gap(self(writer), start, set)));
    }

    @Override
    public void acknowledge(EntityId reader, EntityId writer, SequenceSet missing, int count, boolean answer) {
      add(60, () -> toWriter(writer, core -> core.acknowledged(self(reader), missing, answer)));
    }

    @Override
    public void missingFragments(EntityId reader, EntityId writer, long sequence, SequenceSet missing, int count) {
      add(60, () -> toWriter(writer, core -> core.lacks(self(reader), sequence, missing)));
    }

    @Override
    public void close() {
      boolean full = room < Long.MAX_VALUE && underWay.stream().mapToLong(Sent::bytes).sum() + bytes > room;
      boolean lost = parts.isEmpty() || cut || full || drops.test(sent) || random.nextDouble() < loss;
      sent += parts.isEmpty() ? 0 : 1;
      if (!lost) {
        underWay.add(new Sent(now + delay, bytes, List.copyOf(parts)));
      }
      parts.clear();
      bytes = 0;
    }
  }
}
