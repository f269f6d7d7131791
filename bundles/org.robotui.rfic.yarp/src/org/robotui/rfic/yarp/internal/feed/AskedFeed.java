package org.robotui.rfic.yarp.internal.feed;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.Data;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.port.PortCall;

/**
 * A stream that is asked for, again and again while somebody looks at it, on a thread of its own.
 *
 * @param <D> what is made of answers
 */
final class AskedFeed<D extends Data> implements AutoCloseable {
  private static final Duration PATIENCE = Duration.ofMillis(1500);
  private static final long AGAIN_MILLIS = 1000;

  /**
   * Asks and makes data of the answer; nothing where there is nothing to say. An {@link IllegalArgumentException} or
   * {@link IOException} is told to whoever looks.
   *
   * @param <D> the data
   */
  interface Making<D> {
    Optional<D> ask(Questions questions) throws IOException;
  }

  /** Asks the port; an {@link IOException} says why there is no answer. */
  interface Questions {
    Bottle ask(Bottle question) throws IOException;
  }

  private final Wires wires;
  private final String name;
  private final Supplier<HostPort> where;
  private final Making<D> making;
  private final Duration pace;
  private final Publication<D> publication;
  private boolean demanded; // guarded by this, as the following
  private boolean running;
  private boolean closed;

  AskedFeed(Wires wires, String name, Supplier<HostPort> where, StreamPort<D> port, Duration pace, Making<D> making) {
    this.wires = wires;
    this.name = name;
    this.where = where;
    this.pace = pace;
    this.making = making;
    this.publication = wires.context().offers().stream(port, this::demand);
  }

  /** For a port of this name. */
  static <D extends Data> StreamPort<D> port(String port, Class<D> type, String help) {
    return new StreamPort<>(port, type, Arity.MANY, help);
  }

  private synchronized void demand(boolean now) {
    demanded = now;
    notifyAll();
    if (now && !running && !closed) {
      running = true;
      wires.workers().start("yarp asks " + name, this::run);
    }
  }

  private void run() {
    try {
      while (goesOn()) {
        String reason = "";
        try (PortCall call = PortCall.connect(where.get(), wires.own() + "/rpc", wires.options())) {
          talk(call);
        } catch (IOException e) {
          reason = e.getMessage();
        }
        if (!reason.isEmpty() && goesOn()) {
          publication.failed(name + ": " + reason);
        }
        rest(AGAIN_MILLIS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      synchronized (this) {
        running = false;
      }
    }
  }

  /** A thread that ends and a look that begins do not miss each other. */
  private synchronized boolean goesOn() {
    running = running && demanded && !closed;
    return running;
  }

  private void talk(PortCall call) throws IOException, InterruptedException {
    while (goesOn()) {
      try {
        making.ask(question -> answer(call, question)).ifPresent(this::publish);
      } catch (IllegalArgumentException e) {
        publication.failed(name + ": " + e.getMessage());
      }
      rest(pace.toMillis());
    }
  }

  private Bottle answer(PortCall call, Bottle question) throws IOException {
    Outcome<Bottle> outcome = call.ask(question, PATIENCE);
    wires.pulse().answered(System.nanoTime());
    return outcome.toOptional().orElseThrow(() -> new IOException(outcome.reason()));
  }

  void failed(String reason) {
    publication.failed(reason);
  }

  void publish(D value) {
    publication.failed("");
    publication.publish(value, Optional.empty());
  }

  private synchronized void rest(long millis) throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
    while (demanded && !closed && System.nanoTime() - end < 0) {
      TimeUnit.NANOSECONDS.timedWait(this, Math.max(1, end - System.nanoTime()));
    }
  }

  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    publication.close();
  }
}
