package org.robotui.recorder.internal.capture;

import java.lang.ref.WeakReference;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Set;
import org.robotui.api.port.RawMessage;

/**
 * Tells messages that several ports give from those that come for the first time: ports of one device, mappings of one
 * channel, transforms that robots share. What nobody holds any more cannot come again. For one thread.
 */
final class SeenMessages {
  private static final int MOST = 1 << 14;

  /** Messages are compared by what they are, not by what is in them. */
  private static final class Ref extends WeakReference<RawMessage> {
    private final int hash;

    Ref(RawMessage message) {
      super(message);
      hash = System.identityHashCode(message);
    }

    @Override
    public int hashCode() {
      return hash;
    }

    @Override
    public boolean equals(Object other) {
      return this == other || other instanceof Ref ref && get() != null && get() == ref.get();
    }
  }

  private final Set<Ref> seen = new HashSet<>();
  private final Deque<Ref> order = new ArrayDeque<>();

  /** Whether it was not here before. */
  boolean first(RawMessage message) {
    Ref ref = new Ref(message);
    if (!seen.add(ref)) {
      return false;
    }
    order.add(ref);
    if (order.size() > MOST) {
      seen.remove(order.poll());
    }
    return true;
  }
}
