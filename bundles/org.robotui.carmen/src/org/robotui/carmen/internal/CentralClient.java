package org.robotui.carmen.internal;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.robotui.carmen.wire.IpcFrame;
import org.robotui.net.link.FrameLink;

/**
 * A module as a central sees it: what it handles, and what it has not handled yet. More than a few messages are not
 * sent to it at once; the others wait, of each name as many as the module says. Guarded by the books of the central.
 */
public final class CentralClient {

  private static final int CAPACITY = 4;
  private static final int MOST_WAITING = 1000;

  private final FrameLink<IpcFrame> link;
  private final Map<Integer, Long> outstanding = new HashMap<>();
  private final ArrayDeque<Delivery> waiting = new ArrayDeque<>();
  private final Map<String, Integer> limits = new HashMap<>();
  private final Set<Integer> named = new HashSet<>();
  private volatile String name = "";
  private String host = "";
  private int port;

  /** A message on its way to it. */
  private record Delivery(String message, int handler, int kind, int reference, ByteOrder order, ByteBuffer body) {}

  /** Of a link that was accepted. */
  public CentralClient(FrameLink<IpcFrame> link) {
    this.link = link;
  }

  /** How it calls itself; empty before it has said so. */
  public String name() {
    return name;
  }

  void introduce(String called, String at) {
    name = called;
    host = at;
  }

  void listens(int at) {
    port = at;
  }

  String host() {
    return host;
  }

  int port() {
    return port;
  }

  FrameLink<IpcFrame> link() {
    return link;
  }

  void limit(String message, int most) {
    limits.put(message, Math.clamp(most, 1, MOST_WAITING));
  }

  /** Sends a message, or lets it wait in place of the oldest of its name where there are too many. */
  void deliver(String message, int handler, int kind, int reference, IpcFrame from) {
    Delivery delivery = new Delivery(message, handler, kind, reference, from.order(), from.body());
    waiting.add(delivery);
    long same = waiting.stream().filter(each -> each.message().equals(message)).count();
    if (same > limits.getOrDefault(message, MOST_WAITING)) {
      waiting.remove(waiting.stream().filter(each -> each.message().equals(message)).findFirst().orElseThrow());
    }
    pump();
  }

  /** It has handled a message. */
  void completed(int reference) {
    outstanding.remove(reference);
    pump();
  }

  private void pump() {
    while (outstanding.size() < CAPACITY && !waiting.isEmpty()) {
      Delivery next = waiting.remove();
      outstanding.put(next.reference(), System.nanoTime());
      String first = named.add(next.handler()) ? next.message() : "";
      link.send(new IpcFrame(IpcFrame.NONE, next.handler(), next.kind(), IpcFrame.NONE, next.reference(), first,
          next.order(), next.body()));
    }
  }
}
