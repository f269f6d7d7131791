package org.robotui.rfic.carmen.internal.feed;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Publication;
import org.robotui.api.port.RawDefinition;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.RawOrigin;
import org.robotui.api.port.StreamPort;
import org.robotui.carmen.format.IpcFormatException;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcForm;
import org.robotui.carmen.module.Handling;
import org.robotui.carmen.module.IpcAnswer;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;
import org.robotui.rfic.carmen.internal.convert.CarmenRecord;

/**
 * A message as a stream. It is subscribed to only while somebody wants it, as a central sends to each who does.
 * Messages come on the reading thread; {@link #tick} is for the thread that follows the central.
 *
 * @param <D> what is made of it
 */
public final class MessageFeed<D extends Data> implements Handling, AutoCloseable {
  static final String ENCODING = "carmen";
  private static final int LATEST = 1;

  /**
   * Makes data of a message, on the reading thread. What it throws is told to whoever looks.
   *
   * @param <D> the data
   */
  interface Making<D> {
    D of(IpcRecord record, ByteBuffer body, Optional<Stamp> stamp);
  }

  private final Shared shared;
  private final IpcForm form;
  private final Making<D> making;
  private final boolean placed;
  private final Publication<D> publication;
  private volatile boolean demanded;
  private volatile boolean closed;
  private Optional<AutoCloseable> subscription = Optional.empty(); // only on the thread that follows

  /** A stream of the port's name; placed where it says something only to those who know where the robot is. */
  MessageFeed(Shared shared, IpcForm form, String port, Class<D> type, String help, boolean placed,
      Making<D> making) {
    this.shared = shared;
    this.form = form;
    this.making = making;
    this.placed = placed;
    this.publication = shared.context().offers().stream(new StreamPort<>(port, type, Arity.MANY, help),
        now -> demanded = now);
  }

  /** All fields of a message that nothing else is made of. */
  static MessageFeed<DynamicRecord> records(Shared shared, IpcForm form, String port) {
    return new MessageFeed<>(shared, form, port, DynamicRecord.class, form.name() + ", as the robot says it", false,
        (record, body, stamp) -> new CarmenRecord(form.name(), record));
  }

  /** Of which message. */
  public IpcForm form() {
    return form;
  }

  boolean wanted() {
    return demanded && !closed;
  }

  boolean placedAndWanted() {
    return placed && wanted();
  }

  /** Acts on what is wanted now, which may block. */
  void tick(boolean needed) throws IOException {
    if (needed && subscription.isEmpty() && !closed) {
      subscription = Optional.of(shared.module().subscribe(form, LATEST, this));
    } else if (!needed && subscription.isPresent()) {
      AutoCloseable before = subscription.get();
      subscription = Optional.empty();
      end(before);
    }
  }

  private static void end(AutoCloseable subscription) throws IOException {
    try {
      subscription.close();
    } catch (IOException e) {
      throw e;
    } catch (Exception e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  @Override
  public Optional<IpcAnswer> handle(IpcRecord record, ByteBuffer body) {
    long now = System.nanoTime();
    shared.pulse().heard(now);
    if (!closed) {
      Optional<Stamp> stamp = shared.stamp(record.number("timestamp"));
      D value = making.of(record, body, stamp);
      if (demanded) {
        publication.publish(value, stamp, now, Optional.of(raw(body)));
      }
    }
    return Optional.empty();
  }

  @Override
  public void unreadable(String reason) {
    publication.lost(1, shared.settings().peer() + ": " + reason);
  }

  void failed(String reason) {
    publication.failed(reason);
  }

  /** What was asked for in place of being subscribed to. */
  void publish(D value, Optional<Stamp> stamp) {
    publication.publish(value, stamp, System.nanoTime(), Optional.empty());
  }

  private RawMessage raw(ByteBuffer body) {
    return new RawMessage(form.name(), ENCODING, Bytes.wrap(body), bytes -> read(body),
        new RawOrigin(form.name(), shared.settings().peer(), false, () -> Optional.of(new RawDefinition(form.name(),
            ENCODING, Bytes.of(form.format().toString().getBytes(StandardCharsets.UTF_8))))));
  }

  private Optional<DynamicRecord> read(ByteBuffer body) {
    try {
      return Optional.of(new CarmenRecord(form.name(), form.read(body)));
    } catch (IpcFormatException e) {
      return Optional.empty();
    }
  }

  @Override
  public void close() {
    closed = true;
    publication.close();
  }
}
