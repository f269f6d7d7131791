package org.robotui.rfic.yarp.internal.feed;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.name.YarpAddress;
import org.robotui.yarp.port.PortArrival;
import org.robotui.yarp.port.PortReader;

/**
 * The ports that a name server knows of the robot, and what was made of them. Used by the thread that follows, but for
 * reading and closing; messages come on reading threads.
 */
public final class YarpDevices implements PortReader, AutoCloseable {
  /** More are no robot's. */
  private static final int MOST = 2048;
  private static final int PINGS = 3;

  private final Wires wires;
  private final DeviceMaker maker;
  private final Map<String, YarpDevice> kinds = new ConcurrentSkipListMap<>();
  private final Map<String, HostPort> addresses = new ConcurrentSkipListMap<>();
  private final Map<String, PortFeed> feeds = new ConcurrentSkipListMap<>();
  private final List<AutoCloseable> drivers = new CopyOnWriteArrayList<>();
  private volatile Optional<String> answers = Optional.empty();
  private volatile long heardAt = System.nanoTime();
  private volatile boolean closed;
  private Set<String> seen = Set.of(); // only on the thread that follows

  public YarpDevices(Wires wires) {
    this.wires = wires;
    this.maker = new DeviceMaker(wires, this);
  }

  /**
   * Looks what is registered now; blocks. A port counts when it was there the last time as well, since those beside it
   * tell what it is, and a device registers them one after another. False where our own port is not, or elsewhere.
   */
  public boolean discover(HostPort own) throws IOException {
    List<YarpAddress> listed = wires.names().list();
    Map<String, HostPort> there = new HashMap<>();
    for (YarpAddress address : listed) {
      boolean ours = address.name().startsWith(wires.settings().prefix()) && address.carrier().equals("tcp");
      if (ours && there.size() < MOST) {
        there.put(address.name(), address.where());
      }
    }
    addresses.putAll(there);
    there.forEach((name, where) -> Optional.ofNullable(feeds.get(name)).ifPresent(feed -> feed.at(where)));
    Set<String> all = Set.copyOf(there.keySet());
    for (String name : new TreeSet<>(seen)) {
      if (all.contains(name) && !kinds.containsKey(name)) {
        kinds.put(name, found(name, YarpDevice.of(name, all, wires.settings().types())));
      }
    }
    seen = all;
    return listed.stream().anyMatch(a -> a.name().equals(wires.own()) && a.where().equals(own));
  }

  private synchronized YarpDevice found(String name, YarpDevice kind) {
    if (!closed) {
      maker.make(name, kind);
    }
    return kind;
  }

  void add(String name, PortFeed feed) {
    feeds.put(name, feed);
  }

  void add(AutoCloseable driver) {
    drivers.add(driver);
  }

  /** Where a port was last. */
  Optional<HostPort> address(String name) {
    return Optional.ofNullable(addresses.get(name));
  }

  /** What all ports are taken for, by their names. */
  public Map<String, YarpDevice> kinds() {
    return kinds;
  }

  /** Where ports listen, by their names. */
  public Map<String, HostPort> addresses() {
    return addresses;
  }

  /** Lets ports say to ours what is wanted, and no more; may block. */
  public void tick(Set<String> connected) {
    boolean carry = wires.tree().wanted() || feeds.values().stream().anyMatch(PortFeed::placedAndWanted);
    maker.tick();
    for (Map.Entry<String, PortFeed> each : feeds.entrySet()) {
      YarpDevice kind = kinds.getOrDefault(each.getKey(), YarpDevice.NONE);
      boolean carries = carry && (kind == YarpDevice.ODOMETRY || kind == YarpDevice.PLACE);
      if (closed) {
        return;
      }
      each.getValue().tick(each.getValue().wanted() || carries, connected.contains(each.getKey()));
    }
  }

  /** How long nothing has come. */
  public long silentNanos() {
    return System.nanoTime() - heardAt;
  }

  /** Whether any of some ports answers; blocks. The one that did last time is asked first. */
  public Outcome<String> ping() {
    List<String> names = new ArrayList<>();
    answers.ifPresent(names::add);
    kinds.entrySet().stream().filter(e -> e.getValue() != YarpDevice.NONE).map(Map.Entry::getKey)
        .filter(name -> !names.contains(name)).forEach(names::add);
    Outcome<String> last = new Outcome.Failed<>("no port of a robot is registered"
        + (wires.settings().prefix().isEmpty() ? "" : " whose name begins with " + wires.settings().prefix())
        + "; start the robot's devices (yarprobotinterface, yarpdev)");
    for (String name : names.subList(0, Math.min(PINGS, names.size()))) {
      if (closed) {
        break;
      }
      last = wires.admin().ping(addresses.get(name));
      if (last instanceof Outcome.Done) {
        answers = Optional.of(name);
        return last;
      }
      last = new Outcome.Failed<>(name + " is registered, but does not answer: " + last.reason());
      answers = Optional.empty();
    }
    return last;
  }

  @Override
  public Optional<Bottle> received(PortArrival arrival) {
    heardAt = System.nanoTime();
    Optional.ofNullable(feeds.get(arrival.from())).ifPresent(feed -> feed.received(arrival));
    return Optional.empty();
  }

  @Override
  public void unreadable(String from, String reason) {
    Optional.ofNullable(feeds.get(from)).ifPresent(feed -> feed.unreadable(reason));
  }

  @Override
  public void ended(String from, String reason) {
    if (!closed && reason.contains("cannot be used")) {
      unreadable(from, reason);
    }
  }

  /** What each port was told to say to ours is to be ended; each of these blocks. */
  public List<Runnable> farewells() {
    return feeds.values().stream().map(feed -> (Runnable) feed::letGo).toList();
  }

  /** Stops what we drive, and withdraws all. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
    }
    for (AutoCloseable driver : drivers) {
      try {
        driver.close();
      } catch (Exception e) {
        throw new IllegalStateException(e);
      }
    }
    maker.close();
    feeds.values().forEach(PortFeed::close);
  }
}
