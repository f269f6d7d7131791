package org.robotui.rfic.yarp.internal;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.robotui.api.RficContext;
import org.robotui.api.link.LinkState;
import org.robotui.api.link.Pulse;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Offer;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.api.session.LinkChanges;
import org.robotui.api.session.PlacedFrames;
import org.robotui.api.session.RobotFrames;
import org.robotui.api.session.RobotSession;
import org.robotui.data.joint.RobotDescription;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;
import org.robotui.net.thread.Workers;
import org.robotui.rfic.yarp.internal.call.YarpBrowser;
import org.robotui.rfic.yarp.internal.call.YarpCalls;
import org.robotui.rfic.yarp.internal.call.YarpPorts;
import org.robotui.rfic.yarp.internal.feed.ModelFile;
import org.robotui.rfic.yarp.internal.feed.Wires;
import org.robotui.rfic.yarp.internal.feed.YarpDevices;
import org.robotui.yarp.name.NameClient;
import org.robotui.yarp.name.YarpAddress;
import org.robotui.yarp.port.PortOptions;
import org.robotui.yarp.port.YarpPort;

/** One port of ours, which the robot's ports say their messages to, and all that is offered through it. */
final class YarpSession implements RobotSession {
  private static final String OWN = "/robotui/";
  private static final long LOOK_MILLIS = 50;
  private static final long FIRST_NANOS = Duration.ofMillis(200).toNanos();
  private static final long DISCOVER_NANOS = Duration.ofMillis(1000).toNanos();
  private static final long PING_NANOS = Duration.ofMillis(2000).toNanos();
  private static final long GOODBYE_MILLIS = 1200;
  private static final int MOST_LEFT = 16;
  private static final int REFUSED_MILLIS = 200;

  private final NameClient names;
  private final YarpSettings settings;
  private final LinkChanges link;
  private final Workers workers;
  private final Pulse pulse = new Pulse();
  private final PlacedFrames tree;
  private final YarpDevices devices;
  private final YarpPort port;
  private final HostPort where;
  private final Offer services;
  private final Offer graph;
  private final Optional<Publication<RobotDescription>> description;
  private volatile boolean closed;
  private long discoverAt = System.nanoTime(); // only on the thread that follows, as the following
  private long pingAt = System.nanoTime();
  private int looks;
  private Outcome<String> answered = new Outcome.Failed<>("no port was asked yet");

  YarpSession(RficContext context, YarpSettings settings, NameClient names, InetAddress near, PortOptions options)
      throws IOException {
    this.names = names;
    this.settings = settings;
    this.link = new LinkChanges(context.link());
    this.workers = new Workers(context.threads());
    RobotFrames frames = settings.frames().of(context.robot());
    this.tree = new PlacedFrames(context, "yarp", frames.base());
    String own = OWN + context.robot().replaceAll("[^A-Za-z0-9_-]", "_") + "/" + ProcessHandle.current().pid() + "-"
        + context.instance().replaceAll("[^A-Za-z0-9_-]", "_");
    Wires wires = new Wires(context, settings, names, options, workers, own, frames, tree, pulse);
    this.devices = new YarpDevices(wires);
    this.port = new YarpPort(own, near, 0, Optional.empty(), devices, options);
    this.where = new HostPort(near.getHostAddress(), port.port());
    this.services = context.offers().call(YarpPorts.SERVICES, new YarpCalls(wires, devices));
    this.graph = context.offers().browse(YarpPorts.GRAPH, new YarpBrowser(wires, devices));
    this.description = settings.model().map(model -> describe(context, model));
  }

  private static Publication<RobotDescription> describe(RficContext context, ModelFile model) {
    Publication<RobotDescription> publication = context.offers().stream(new StreamPort<>("robot_description",
        RobotDescription.class, Arity.MANY, "how the robot is built, by the file of the configuration"), now -> {});
    try {
      publication.publish(model.read(context.robot()), Optional.empty());
    } catch (IOException | IllegalArgumentException e) {
      publication.failed(String.valueOf(e.getMessage()));
    }
    return publication;
  }

  @Override
  public Optional<String> follow(BooleanSupplier over) throws IOException, InterruptedException {
    tidy();
    while (!over.getAsBoolean() && !closed) {
      look();
      Thread.sleep(LOOK_MILLIS);
    }
    return Optional.empty();
  }

  /** A workbench that was killed left its port with the name server: where nobody listens there, it is forgotten. */
  private void tidy() throws IOException {
    List<YarpAddress> left = names.list().stream()
        .filter(a -> a.name().startsWith(OWN) && a.where().host().equals(where.host())
            && a.where().port() != where.port())
        .limit(MOST_LEFT).toList();
    for (YarpAddress address : left) {
      if (!closed && !listens(address.where())) {
        names.unregister(address.name());
      }
    }
  }

  private static boolean listens(HostPort where) {
    try (Socket socket = new Socket()) {
      where.connect(socket, Duration.ofMillis(REFUSED_MILLIS));
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  private void look() {
    long now = System.nanoTime();
    try {
      if (now - discoverAt >= 0) {
        if (!devices.discover(where) && !closed) {
          names.register(port.name(), where, YarpPort.ACCEPTS);
        }
        pulse.answered(System.nanoTime());
        discoverAt = System.nanoTime() + (looks++ == 0 ? FIRST_NANOS : DISCOVER_NANOS);
      }
      devices.tick(port.sources());
      report(now);
    } catch (IOException e) {
      link.report(new LinkState.Degraded(settings.peer(), e.getMessage() + "; what is shown may be old"));
    }
  }

  private void report(long now) {
    if (looks < 2) {
      return;
    }
    if (now - pingAt >= 0) {
      boolean heard = devices.silentNanos() < PING_NANOS && answered instanceof Outcome.Done;
      answered = heard ? answered : devices.ping();
      pingAt = System.nanoTime() + (answered instanceof Outcome.Done ? PING_NANOS : DISCOVER_NANOS);
    }
    link.report(answered instanceof Outcome.Done ? new LinkState.Connected(settings.peer())
        : new LinkState.Degraded(settings.peer(), answered.reason()));
  }

  /** Stops what we drive, ends what ports were told to say to ours, and forgets our port; bounded. */
  @Override
  public void close() {
    closed = true;
    services.close();
    graph.close();
    description.ifPresent(Publication::close);
    List<Runnable> goodbyes = new ArrayList<>(devices.farewells());
    devices.close();
    goodbyes.add(this::forget);
    CountDownLatch said = new CountDownLatch(goodbyes.size());
    for (Runnable goodbye : goodbyes) {
      workers.start("yarp goodbye " + settings.peer(), () -> {
        goodbye.run();
        said.countDown();
      });
    }
    try {
      said.await(GOODBYE_MILLIS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    port.close();
    tree.close();
    workers.join(System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(LOOK_MILLIS));
  }

  private void forget() {
    try {
      names.unregister(port.name());
    } catch (IOException e) {
      // a name server that hangs is tidied at the next start
    }
  }
}
