package org.robotui.ros.internal.node;

import java.util.concurrent.atomic.AtomicLong;

/** Counts what one thread sends or receives; any thread may read it, and may read it a moment late. */
final class Traffic {

  private final AtomicLong messages = new AtomicLong();
  private final AtomicLong bytes = new AtomicLong();

  void count(int newMessages, long newBytes) {
    messages.lazySet(messages.get() + newMessages);
    bytes.lazySet(bytes.get() + newBytes);
  }

  long messages() {
    return messages.get();
  }

  long bytes() {
    return bytes.get();
  }
}
