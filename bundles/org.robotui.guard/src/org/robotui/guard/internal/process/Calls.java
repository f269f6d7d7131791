package org.robotui.guard.internal.process;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.channels.Selector;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.HashSet;
import java.util.Set;

/** Says farewells: some at a time, and all in bounded time, also where nobody is there to hear them. */
final class Calls {
  private static final int AT_ONCE = 16;

  /** Words for somebody. */
  record Farewell(InetSocketAddress to, byte[] words) {}

  private final Selector selector;
  private final Limits limits;
  private final Deque<Farewell> waiting = new ArrayDeque<>();
  private final Set<Call> running = new HashSet<>();
  private final Set<InetSocketAddress> dead = new HashSet<>();
  private long deadline;

  Calls(Selector selector, Limits limits) {
    this.selector = selector;
    this.limits = limits;
  }

  void say(Collection<Farewell> farewells, long now) {
    dead.clear();
    waiting.clear();
    waiting.addAll(farewells);
    deadline = now + limits.calls().toNanos();
  }

  boolean areDone() {
    return waiting.isEmpty() && running.isEmpty();
  }

  /** Begins what can be begun, ends what takes too long. */
  void tick(long now) {
    if (now - deadline > 0) {
      waiting.clear();
    }
    Set.copyOf(running).forEach(call -> call.tick(now));
    while (running.size() < AT_ONCE && !waiting.isEmpty()) {
      Farewell next = waiting.poll();
      if (!dead.contains(next.to())) {
        begin(next, now);
      }
    }
  }

  private void begin(Farewell farewell, long now) {
    try {
      running.add(new Call(selector, farewell, now + limits.call().toNanos(), this));
    } catch (IOException | RuntimeException e) {
      dead.add(farewell.to());
    }
  }

  /** Who did not take its words gets no more of them: the others would wait as long. */
  void ended(Call call, boolean heard) {
    if (running.remove(call) && !heard) {
      dead.add(call.to());
    }
  }
}
