package org.robotui.rfic.yarp.internal.feed;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.robotui.api.port.CommandSink;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointMode;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;
import org.robotui.rfic.yarp.internal.convert.BoardModel;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.YarpValue;
import org.robotui.yarp.port.PortCall;

/**
 * Drives the joints of a control board by questions to it: a joint is put into the control mode that is needed, and
 * then told where to go or how fast. A thread of its own asks while there is something to tell; newer references
 * replace older ones, and what is too old is dropped.
 */
final class BoardDriver implements CommandSink<JointCommand>, AutoCloseable {
  private static final Duration PATIENCE = Duration.ofMillis(500);
  private static final long LASTS_NANOS = Duration.ofMillis(500).toNanos();
  private static final long IDLE_MILLIS = 2000;
  private static final long FLUSH_MILLIS = 400;
  private static final Set<JointMode> POSITION = Set.of(JointMode.POSITION);
  private static final Set<JointMode> VELOCITY = Set.of(JointMode.VELOCITY);

  private enum Verb {
    MOVE("pos", "pos"), SPEED("vel", "vmo"), HALT("", "sto");

    private final String mode;
    private final String word;

    Verb(String mode, String word) {
      this.mode = mode;
      this.word = word;
    }
  }

  private record Told(Verb verb, double value, long until) {}

  private final Wires wires;
  private final Supplier<HostPort> rpc;
  private final Supplier<Optional<BoardModel>> model;
  private final Map<Integer, Double> targets = new ConcurrentHashMap<>();
  private final Map<Integer, Told> waiting = new LinkedHashMap<>(); // guarded by this, as the following
  private final Map<Integer, Verb> driven = new LinkedHashMap<>();
  private final Map<Integer, String> modes = new ConcurrentHashMap<>();
  private boolean running;
  private boolean closed;
  private Optional<String> fault = Optional.empty();

  BoardDriver(Wires wires, Supplier<HostPort> rpc, Supplier<Optional<BoardModel>> model) {
    this.wires = wires;
    this.rpc = rpc;
    this.model = model;
  }

  /** Where joints were sent, SI units. */
  Map<Integer, Double> targets() {
    return targets;
  }

  /** The control modes that the board says. */
  void seen(List<String> words) {
    for (int i = 0; i < words.size(); i++) {
      modes.put(i, words.get(i));
    }
  }

  @Override
  public Sent send(JointCommand command) {
    Optional<BoardModel> known = model.get();
    if (known.isEmpty()) {
      return new Sent.Refused("the joints are not known yet; look at them first");
    }
    return command.joints().isEmpty() ? halt() : move(known.get(), command);
  }

  @Override
  public Sent stop(JointCommand zero, boolean ours) {
    synchronized (this) {
      if (driven.isEmpty()) {
        return new Sent.Unneeded();
      }
    }
    return halt();
  }

  private Sent move(BoardModel board, JointCommand command) {
    Map<Integer, Told> told = new LinkedHashMap<>();
    for (JointCommand.Joint joint : command.joints()) {
      OptionalInt index = board.index(joint.name());
      boolean speed = joint.modes().equals(VELOCITY);
      if (index.isEmpty() || !speed && !joint.modes().equals(POSITION)) {
        return new Sent.Refused(index.isEmpty() ? board.chain() + " has no joint '" + joint.name() + "'"
            : joint.name() + " is driven by its position or its velocity, not by " + joint.modes());
      }
      double si = speed ? joint.reference().velocity() : joint.reference().position();
      told.put(index.getAsInt(), new Told(speed ? Verb.SPEED : Verb.MOVE, board.said(index.getAsInt(), si),
          System.nanoTime() + LASTS_NANOS));
      if (speed) {
        targets.remove(index.getAsInt());
      } else {
        targets.put(index.getAsInt(), si);
      }
    }
    Optional<String> refused = refusal();
    return refused.<Sent>map(Sent.Refused::new).orElseGet(() -> put(told));
  }

  /** Why the board did not do what it was told before; said once. */
  private synchronized Optional<String> refusal() {
    Optional<String> reason = fault;
    fault = Optional.empty();
    return reason;
  }

  /** What we sent on its way stays where it is; joints that we did not move are left alone. */
  private synchronized Sent halt() {
    targets.clear();
    waiting.clear();
    Map<Integer, Told> told = new LinkedHashMap<>();
    driven.forEach((joint, verb) -> told.put(joint, new Told(verb == Verb.SPEED ? Verb.SPEED : Verb.HALT, 0, 0)));
    Sent sent = put(told);
    driven.clear();
    return sent;
  }

  private synchronized Sent put(Map<Integer, Told> told) {
    if (closed) {
      return new Sent.Refused("the robot is no longer connected");
    }
    told.forEach((joint, what) -> {
      driven.put(joint, what.verb());
      waiting.put(joint, what);
    });
    if (!running && !waiting.isEmpty()) {
      running = true;
      wires.workers().start("yarp board " + rpc.get(), this::run);
    }
    notifyAll();
    return new Sent.Out();
  }

  private void run() {
    try (PortCall call = PortCall.connect(rpc.get(), wires.own() + "/rpc", wires.options())) {
      for (Map<Integer, Told> next = take(); !next.isEmpty(); next = take()) {
        for (Map.Entry<Integer, Told> each : next.entrySet()) {
          tell(call, each.getKey(), each.getValue());
        }
      }
    } catch (IOException e) {
      failed(e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      failed("it was closed");
    }
  }

  private synchronized void failed(String reason) {
    fault = Optional.of(String.valueOf(reason));
    waiting.clear();
    running = false;
    notifyAll();
  }

  private synchronized Map<Integer, Told> take() throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(IDLE_MILLIS);
    while (waiting.isEmpty() && !closed && System.nanoTime() - end < 0) {
      notifyAll();
      TimeUnit.NANOSECONDS.timedWait(this, Math.max(1, end - System.nanoTime()));
    }
    long now = System.nanoTime();
    Map<Integer, Told> next = new LinkedHashMap<>(waiting);
    next.values().removeIf(told -> told.until() != 0 && told.until() - now < 0);
    waiting.clear();
    running = !next.isEmpty();
    notifyAll();
    return next;
  }

  private void tell(PortCall call, int joint, Told told) throws IOException {
    if (!told.verb().mode.isEmpty() && !told.verb().mode.equals(modes.get(joint))) {
      ask(call, List.of("set", "icmd", "cmod"), joint, List.of(YarpValue.Vocab.of(told.verb().mode)));
      modes.put(joint, told.verb().mode);
    }
    ask(call, List.of("set", told.verb().word), joint, told.verb() == Verb.HALT ? List.of()
        : List.of(new YarpValue.Real(told.value(), Double.SIZE)));
  }

  private static void ask(PortCall call, List<String> words, int joint, List<YarpValue> rest) throws IOException {
    List<YarpValue> question = new ArrayList<>(Bottle.vocabs(words.toArray(String[]::new)));
    question.add(new YarpValue.Whole(joint, Integer.SIZE));
    question.addAll(rest);
    Outcome<Bottle> outcome = call.ask(Bottle.of(question), PATIENCE);
    Bottle answer = outcome.toOptional().orElseThrow(() -> new IOException(outcome.reason()));
    if (!answer.get(0).text().equals("ok")) {
      throw new IOException("the board refuses '" + Bottle.of(question) + "': " + answer);
    }
  }

  /** Stops what we drive, where the board takes it within a moment. */
  @Override
  public void close() {
    halt();
    synchronized (this) {
      long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(FLUSH_MILLIS);
      try {
        while (!waiting.isEmpty() && running && System.nanoTime() - end < 0) {
          TimeUnit.NANOSECONDS.timedWait(this, Math.max(1, end - System.nanoTime()));
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      closed = true;
      notifyAll();
    }
  }
}
