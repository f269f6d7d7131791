package org.robotui.roblets.brain;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.net.log.LogThrottle;
import org.robotui.roblets.body.BodyEntry;
import org.robotui.roblets.body.Bodymap;
import org.robotui.roblets.internal.DatagramEndpoint;
import org.robotui.roblets.internal.SenderRun;
import org.robotui.roblets.internal.RobletRegister;
import org.robotui.roblets.internal.RuleThread;
import org.robotui.roblets.internal.WatcherRegister;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.RecordMessage;
import org.robotui.roblets.wire.ArrivalOrder;
import org.robotui.roblets.wire.BodyDatagram;
import org.robotui.roblets.wire.DatagramKind;
import org.robotui.roblets.wire.RobletForm;
import org.robotui.roblets.wire.RobletStatus;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The brain of one robot. It hosts the bodymap, answers beacons, gives what roblets say to who watches, passes on what
 * watchers ask for, and acts by rules. A roblet is heard only from where its beacons come. Safe for all threads.
 */
public final class Brain implements AutoCloseable {
  /** By what name it speaks. */
  public static final String NAME = "brain";

  private static final Logger LOG = LoggerFactory.getLogger(Brain.class);
  private static final long ROSTER_NANOS = Duration.ofMillis(500).toNanos();

  private final BrainOptions options;
  private final Bodymap bodymap;
  private final RobletRegister roblets = new RobletRegister();
  private final WatcherRegister watchers = new WatcherRegister();
  private final ArrivalOrder order = new ArrivalOrder();
  private final ArrivalOrder requests = new ArrivalOrder();
  private final List<BrainRule> rules = new CopyOnWriteArrayList<>();
  private final SenderRun sender = SenderRun.of(NAME);
  private final LogThrottle throttle = new LogThrottle();
  private final DatagramEndpoint endpoint;
  private final RuleThread thinking;
  private long rosterAt = System.nanoTime(); // only on the reading thread

  /**
   * Listens from now on.
   *
   * @param options where
   * @throws IOException where its port is taken; says which
   */
  public Brain(BrainOptions options) throws IOException {
    this.options = options;
    this.bodymap = new Bodymap(options.history());
    try {
      this.endpoint = DatagramEndpoint.bound(options.own(), "brain of " + options.robot(), options.threads());
    } catch (IOException e) {
      throw new IOException("a brain cannot listen at " + options.own() + ": " + e.getMessage(), e);
    }
    this.thinking = new RuleThread("brain of " + options.robot() + " thinks", options.threads());
    endpoint.open(new Received());
  }

  /**
   * Where it listens.
   *
   * @return the port
   */
  public int port() {
    return endpoint.port();
  }

  /**
   * What all roblets say.
   *
   * @return the bodymap
   */
  public Bodymap bodymap() {
    return bodymap;
  }

  /**
   * The roblets that it knows.
   *
   * @return sorted by their names, also those that have gone
   */
  public List<RobletStatus> roblets() {
    return roblets.statuses(order, System.nanoTime());
  }

  /**
   * Who watches.
   *
   * @return their names
   */
  public Set<String> watchers() {
    return watchers.names();
  }

  /**
   * How many look at what a roblet says.
   *
   * @param roblet its name
   * @return how many
   */
  public int watchersOf(String roblet) {
    return watchers.wanting(roblet).size();
  }

  /**
   * Acts by one rule more.
   *
   * @param rule what to do, and when
   * @return ends it
   */
  public Runnable rule(BrainRule rule) {
    rules.add(rule);
    Runnable end = bodymap.listen(rule.when(),
        change -> thinking.run(rule.name(), () -> rule.action().act(change, this)));
    return () -> {
      rules.remove(rule);
      end.run();
    };
  }

  /**
   * The rules by which it acts.
   *
   * @return in the order in which they came
   */
  public List<BrainRule> rules() {
    return List.copyOf(rules);
  }

  /**
   * Says something to a roblet.
   *
   * @param roblet its name
   * @param message what
   * @return false where there is no such roblet; whether it hears it is not told
   */
  public boolean say(String roblet, BodyElement message) {
    Optional<InetSocketAddress> there = roblets.address(roblet);
    there.ifPresent(address -> endpoint.say(sender, DatagramKind.MESSAGE, roblet, Optional.of(message), address));
    return there.isPresent();
  }

  /**
   * Says something to a roblet.
   *
   * @param roblet its name
   * @param message what
   * @return as above
   */
  public boolean say(String roblet, Record message) {
    return say(roblet, RecordMessage.ofRecord(message));
  }

  @Override
  public void close() {
    endpoint.close();
    thinking.close();
  }

  /** What is done with datagrams, on the reading thread. */
  private final class Received implements DatagramEndpoint.Handler {
    @Override
    public void arrived(BodyDatagram datagram, byte[] bytes, InetSocketAddress from, long nowNanos) {
      switch (datagram.kind()) {
        case BEACON -> beacon(datagram, from, nowNanos);
        case MESSAGE -> message(datagram, bytes, from, nowNanos);
        case WATCH -> watch(datagram, from, nowNanos);
        case REQUEST -> request(datagram, from, nowNanos);
        case LEAVE -> {
          watchers.leave(from);
          roblets.leave(datagram.from(), from);
        }
        case WELCOME, ROSTER -> {
          // those are said by brains
        }
      }
    }

    private void beacon(BodyDatagram datagram, InetSocketAddress from, long nowNanos) {
      if (!order.judge(datagram, nowNanos).isNew() || datagram.from().equals(NAME)) {
        return;
      }
      if (!roblets.beacon(datagram, from, nowNanos)) {
        complain("there are " + Bodymap.MOST_ROBLETS + " roblets already; " + datagram.from() + " is not taken");
        return;
      }
      RobletForm form = roblets.form(datagram.from()).orElseThrow();
      welcome(datagram.from(), roblets.neighbours(form), from);
    }

    private void welcome(String to, List<BodyElement> neighbours, InetSocketAddress address) {
      BodyElement welcome = BodyElement.of("welcome").with("robot", options.robot());
      endpoint.say(sender, DatagramKind.WELCOME, to, Optional.of(welcome.with(neighbours)), address);
    }

    private void message(BodyDatagram datagram, byte[] bytes, InetSocketAddress from, long nowNanos) {
      if (!roblets.isFrom(datagram.from(), from) || !order.judge(datagram, nowNanos).isNew()
          || datagram.body().isEmpty()) {
        return;
      }
      BodyEntry entry = new BodyEntry(datagram.body().get(), nowNanos, datagram.stampNanos(), datagram.sequence());
      if (!bodymap.put(datagram.from(), entry)) {
        complain(datagram.from() + " says more different messages than the " + Bodymap.MOST_MESSAGES
            + " that are kept; '" + entry.element().name() + "' is left out");
        return;
      }
      watchers.wanting(datagram.from()).forEach(watcher -> endpoint.send(bytes, watcher));
    }

    private void watch(BodyDatagram datagram, InetSocketAddress from, long nowNanos) {
      BodyElement watch = datagram.body().orElse(BodyElement.of("watch"));
      boolean fresh = !watchers.knows(from);
      if (watchers.watch(datagram.from(), watch, from, nowNanos)) {
        welcome(datagram.from(), List.of(), from);
        if (fresh) {
          tell(from);
        }
      } else {
        complain("too many watch already; " + datagram.from() + " is not told anything");
      }
    }

    private void tell(InetSocketAddress watcher) {
      if (!watchers.knows(watcher)) {
        return; // it has gone meanwhile
      }
      roblets().forEach(status -> endpoint.say(sender, DatagramKind.ROSTER, watchers.name(watcher),
          Optional.of(status.element()), watcher));
    }

    private void request(BodyDatagram datagram, InetSocketAddress from, long nowNanos) {
      boolean takes = datagram.body()
          .filter(body -> roblets.form(datagram.to()).flatMap(form -> form.input(body.name())).isPresent()).isPresent();
      if (!watchers.knows(from) || !requests.judge(datagram, nowNanos).isNew()) {
        return;
      }
      if (!takes || !say(datagram.to(), datagram.body().orElseThrow())) {
        complain(datagram.from() + " asks " + datagram.to() + " for what it does not take");
      }
    }

    private void complain(String what) {
      if (throttle.admit()) {
        LOG.warn("{} ({} so far)", what, throttle.count());
      }
    }

    @Override
    public void idle(long nowNanos) {
      if (nowNanos - rosterAt >= 0) {
        rosterAt = nowNanos + ROSTER_NANOS;
        watchers.expire(nowNanos);
        watchers.all().forEach(this::tell);
      }
    }
  }
}
