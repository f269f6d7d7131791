package org.robotui.core.internal.port;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Intake;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.api.time.RateMeter;
import org.robotui.data.Conflation;
import org.robotui.data.Data;
import org.robotui.data.DataType;
import org.robotui.data.Late;
import org.robotui.data.Stamp;

/**
 * Hands the values of one source to any number of consumers, and remembers the newest. A consumer of samples reads what
 * is remembered; one of events has a mailbox from the moment on at which it joins, and one of keyed values from its
 * first draining on. Publishing is lock-free; consumers come and go while it goes on.
 */
public final class Fan<T extends Data> {
  private final SourceId source;
  private final DataType type;
  private final AtomicLong sequence = new AtomicLong();
  private final AtomicReference<Merged<T>> last = new AtomicReference<>();
  private final List<Tap<T>> taps = new CopyOnWriteArrayList<>();
  private final List<Mailbox<T>> mailboxes = new CopyOnWriteArrayList<>();
  private final RateMeter rate;
  private volatile boolean messages;

  /** A fan that starts counting at a moment of the monotonic clock. */
  public Fan(SourceId source, DataType type, long now) {
    this.source = source;
    this.type = type;
    this.rate = new RateMeter(now);
  }

  /** Hands out a value. */
  public void publish(T value, Optional<Stamp> stamp, long receivedNanos, Optional<RawMessage> raw) {
    publish(value, stamp, receivedNanos, raw, receivedNanos);
  }

  /** Hands out a value whose rate is measured on another clock. */
  void publish(T value, Optional<Stamp> stamp, long receivedNanos, Optional<RawMessage> raw, long markedNanos) {
    Envelope<T> envelope = new Envelope<>(value, source, sequence.getAndIncrement(), stamp, receivedNanos, raw);
    messages = raw.isPresent();
    rate.mark(markedNanos);
    last.updateAndGet(held -> conflate(held, envelope));
    for (Mailbox<T> mailbox : mailboxes) {
      mailbox.offer(envelope);
    }
  }

  /** Forgets what is remembered, and what consumers have not taken yet. */
  void forget() {
    last.set(null);
    mailboxes.forEach(mailbox -> mailbox.drain(envelope -> {}));
  }

  private Merged<T> conflate(Merged<T> held, Envelope<T> other) {
    boolean keyed = type.conflation() == Conflation.KEYED;
    return keyed || held == null ? Merged.of(held, other) : new Merged<>(Envelopes.newest(held.envelope(), other), 0);
  }

  /** Adds a consumer of what conflation leaves; it is given at once what late consumers of the type get. */
  public Tap<T> join() {
    return join(Intake.MATCHED);
  }

  /** Adds a consumer; it is given at once what late consumers of the type get. */
  public Tap<T> join(Intake intake) {
    return join(intake, () -> {});
  }

  /** Adds a consumer that is told of what comes, where each value counts for it. */
  Tap<T> join(Intake intake, Runnable filled) {
    boolean late = type.late() != Late.NONE;
    long since = late ? 0 : sequence.get();
    Tap<T> tap =
        new Tap<>(this, reader(intake == Intake.CHOSEN ? Conflation.EVENT : type.conflation(), filled, since), since);
    taps.add(tap);
    return tap;
  }

  private TapReader<T> reader(Conflation conflation, Runnable filled, long since) {
    return switch (conflation) {
      case SAMPLE -> new SampleReader<>(this, since);
      case KEYED -> new MailboxReader<>(this, new KeyedMailbox<>(), since);
      case EVENT -> MailboxReader.opened(this, new EventMailbox<>(filled), since);
    };
  }

  /** Has a mailbox filled by what is published from now on. */
  void fill(Mailbox<T> mailbox) {
    mailboxes.add(mailbox);
  }

  /** Has a mailbox filled no more. */
  void cease(Mailbox<T> mailbox) {
    mailboxes.remove(mailbox);
  }

  void leave(Tap<T> tap) {
    taps.remove(tap);
  }

  /** The newest value, merged for keyed types. */
  public Optional<Envelope<T>> last() {
    return Optional.ofNullable(last.get()).map(Merged::envelope);
  }

  /** Whether its values come with the messages that they are made of, which merged values lack. */
  boolean hasMessages() {
    return messages;
  }

  /** Where the values come from. */
  public SourceId source() {
    return source;
  }

  /** How they are delivered. */
  public DataType type() {
    return type;
  }

  /** How often they come. */
  public RateMeter rate() {
    return rate;
  }

  /** What the consumers there are now have lost, and the keys that are not remembered. */
  public long dropped() {
    long forgotten = Optional.ofNullable(last.get()).map(Merged::dropped).orElse(0L);
    return forgotten + taps.stream().mapToLong(Tap::dropped).sum();
  }
}
