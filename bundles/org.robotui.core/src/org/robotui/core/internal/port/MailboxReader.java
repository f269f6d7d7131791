package org.robotui.core.internal.port;

import java.util.function.Consumer;
import org.robotui.api.port.Envelope;
import org.robotui.data.Data;

/** Takes from a mailbox, which each publication fills from the moment on at which it is opened. */
final class MailboxReader<T extends Data> implements TapReader<T> {
  private final Fan<T> fan;
  private final Mailbox<T> mailbox;
  private final long since;
  private boolean open;
  private boolean closed;

  /**
   * Opens the mailbox at the first draining: for a view that only looks at the newest value, which never drains, no
   * publication merges anything.
   */
  MailboxReader(Fan<T> fan, Mailbox<T> mailbox, long since) {
    this.fan = fan;
    this.mailbox = mailbox;
    this.since = since;
  }

  /**
   * Opens it at once, as each value counts. A queue is filled before it is opened: it would give twice what is
   * published meanwhile.
   */
  static <T extends Data> MailboxReader<T> opened(Fan<T> fan, Mailbox<T> mailbox, long since) {
    MailboxReader<T> reader = new MailboxReader<>(fan, mailbox, since);
    reader.takeLast();
    reader.open();
    return reader;
  }

  private synchronized boolean open() {
    boolean opens = !open && !closed;
    if (opens) {
      open = true;
      fan.fill(mailbox);
    }
    return opens;
  }

  private void takeLast() {
    fan.last().filter(e -> e.sequence() >= since).ifPresent(mailbox::offer);
  }

  @Override
  public int drain(Consumer<? super Envelope<T>> consumer) {
    if (open()) {
      takeLast(); // after opening, so that none is missed in between; merged twice, it is the same
    }
    return mailbox.drain(consumer);
  }

  @Override
  public long dropped() {
    return mailbox.dropped();
  }

  @Override
  public synchronized void close() {
    closed = true;
    fan.cease(mailbox);
  }
}
