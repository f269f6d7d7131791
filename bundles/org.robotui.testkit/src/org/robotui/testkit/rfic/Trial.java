package org.robotui.testkit.rfic;

import java.io.IOException;
import java.time.Duration;
import java.util.Collection;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.Rfic;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.data.Data;
import org.robotui.testkit.FakeRficContext;

/** One robot interface at one robot. Closing it ends both. */
final class Trial implements AutoCloseable {
  /** Two seconds are allowed; the rest is for machines that others use as well. */
  static final Duration END = Duration.ofSeconds(5);
  /** Long enough for what shall not happen to happen, mostly. */
  static final Duration MOMENT = Duration.ofMillis(500);
  private static final Duration LOOK = Duration.ofMillis(20);

  final FakeRficContext context = new FakeRficContext();
  /** Nothing was received before; what came while it was being connected may be brought later. */
  final long made = System.nanoTime();
  final Peer peer;
  final Rfic rfic;
  private boolean ended;

  /** With a robot that is away. */
  Trial(Supplier<? extends Peer> peers) {
    peer = peers.get();
    rfic = peer.create(context);
  }

  /** With a robot that is there, and connected to it. */
  static Trial connected(Supplier<? extends Peer> peers) throws IOException, InterruptedException {
    Trial trial = new Trial(peers);
    try {
      trial.peer.start();
      trial.begin();
      trial.awaitConnected();
      return trial;
    } catch (IOException | InterruptedException | AssertionError | RuntimeException e) {
      trial.close();
      throw e;
    }
  }

  // Life.

  /** Starts it, as core does. */
  void begin() {
    long before = System.nanoTime();
    rfic.start();
    within("starting", before);
  }

  /** Ends it, as core does, and looks at what is left of it. */
  void end() throws IOException, InterruptedException {
    ended = true;
    long before = System.nanoTime();
    rfic.close();
    within("closing", before);
    await("no thread is left of it", () -> context.alive().isEmpty(), () -> context.alive().toString());
  }

  private static void within(String what, long beforeNanos) {
    Duration took = Duration.ofNanos(System.nanoTime() - beforeNanos);
    require(took.compareTo(END) < 0, what + " took " + took.toMillis() + " ms");
  }

  @Override
  public void close() {
    try (peer) {
      if (!ended) {
        rfic.close();
      }
    }
  }

  // Link.

  LinkState link() {
    return Optional.ofNullable(context.links.peekLast()).orElseGet(LinkState.Disconnected::new);
  }

  boolean everConnected() {
    return context.links.stream().anyMatch(LinkState.Connected.class::isInstance);
  }

  /** Waits, while the robot speaks. */
  void awaitConnected() throws IOException, InterruptedException {
    awaitSaying("the link is connected", () -> link() instanceof LinkState.Connected, () -> link().toString());
  }

  // Data.

  Sample first() {
    return peer.samples().getFirst();
  }

  void want(Sample sample, boolean wanted) throws IOException, InterruptedException {
    awaitSaying(sample + " is offered", () -> context.streams.containsKey(sample.port()),
        () -> context.streams.keySet().toString());
    context.demand(sample.port(), wanted);
  }

  int brought(Sample sample) {
    return Optional.ofNullable(context.published.get(sample.port())).map(Collection::size).orElse(0);
  }

  /** The next value of a stream. */
  FakeRficContext.Published next(Sample sample) throws IOException, InterruptedException {
    int before = brought(sample);
    await(sample + " brings something", () -> {
      peer.say(sample);
      return brought(sample) > before;
    }, () -> link() + ", " + context.complaints.get(sample.port()));
    return context.published.get(sample.port()).stream().skip(before).findFirst().orElseThrow();
  }

  List<String> complaints() {
    return context.complaints.values().stream().flatMap(Deque::stream).filter(c -> !c.isBlank()).toList();
  }

  // Commands.

  @SuppressWarnings("unchecked")
  Sent send(Data command) {
    return ((CommandSink<Data>) context.sinks.get(peer.motionPort())).send(command);
  }

  /** Drives until the robot has heard it: the first may be refused while it is being linked. */
  void drive() throws IOException, InterruptedException {
    awaitSaying(peer.motionPort() + " is offered", () -> context.commands.containsKey(peer.motionPort()),
        () -> context.commands.keySet().toString());
    int before = peer.heard().size();
    Sent[] last = new Sent[1];
    awaitSaying("the robot hears a motion", () -> {
      if (!(last[0] instanceof Sent.Out)) {
        last[0] = send(peer.motion());
      }
      return peer.heard().size() > before;
    }, () -> String.valueOf(last[0]));
  }

  void awaitStopped() throws IOException, InterruptedException {
    await("the last that the robot hears is a stop", () -> !peer.heard().isEmpty()
        && Alike.difference(peer.motion().stopped(), peer.heard().getLast()).isEmpty(), () -> peer.heard().toString());
  }

  // Waiting.

  /** What a test looks at. */
  @FunctionalInterface
  interface Condition {
    boolean holds() throws IOException;
  }

  void awaitSaying(String what, Condition condition, Supplier<String> instead)
      throws IOException, InterruptedException {
    await(what, () -> {
      peer.say(first());
      return condition.holds();
    }, instead);
  }

  void await(String what, Condition condition, Supplier<String> instead) throws IOException, InterruptedException {
    long end = System.nanoTime() + peer.patience().toNanos();
    while (!condition.holds()) {
      if (System.nanoTime() > end) {
        throw new AssertionError("waited in vain until " + what + "; instead: " + instead.get());
      }
      Thread.sleep(LOOK);
      context.match();
    }
  }

  /** Lets time pass, while the robot speaks. */
  void saying(Duration time) throws IOException, InterruptedException {
    pass(time, () -> peer.say(first()));
  }

  /** Lets time pass. */
  static void pass(Duration time) throws IOException, InterruptedException {
    pass(time, () -> {});
  }

  /** In short turns, none of which is left out: on a busy machine it takes longer, as all else does. */
  private static void pass(Duration time, Turn turn) throws IOException, InterruptedException {
    for (long left = time.toMillis(); left > 0; left -= LOOK.toMillis()) {
      turn.take();
      Thread.sleep(LOOK);
    }
  }

  /** What is done while time passes. */
  @FunctionalInterface
  private interface Turn {
    void take() throws IOException;
  }

  static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new AssertionError(otherwise);
    }
  }
}
