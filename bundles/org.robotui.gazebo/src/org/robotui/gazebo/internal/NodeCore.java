package org.robotui.gazebo.internal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.gazebo.GazeboGraph;
import org.robotui.gazebo.GazeboListener;
import org.robotui.gazebo.GazeboOptions;
import org.robotui.gazebo.GazeboReceiver;
import org.robotui.gazebo.GazeboResponder;
import org.robotui.gazebo.OfferedService;
import org.robotui.gazebo.internal.DiscoveryMessage.Announcement;
import org.robotui.gazebo.internal.DiscoveryMessage.Ends;
import org.robotui.gazebo.internal.DiscoveryMessage.Scope;
import org.robotui.gazebo.internal.Reception.Identity;
import org.robotui.gazebo.internal.Reception.Wanted;
import org.robotui.net.call.Outcome;
import org.robotui.net.thread.Uninterruptibles;
import org.robotui.net.thread.Workers;
import org.robotui.web.ArrivalSubscription;
import org.robotui.web.Arrivals;
import org.zeromq.ZMQ;

/** All parts of a node. Safe for all threads. */
public final class NodeCore implements AutoCloseable {
  private static final int VERSION = 10;
  private static final int WITH_STATISTICS = 100;
  private static final int AT_ONCE = 100;
  private static final long MOST_BYTES = 1 << 25;
  private static final Duration END = Duration.ofSeconds(2);

  private final Identity own = new Identity(UUID.randomUUID().toString(), UUID.randomUUID().toString());
  private final GraphState graph;
  private final SocketLoop loop = new SocketLoop();
  private final NodeSockets sockets;
  private final PendingSends pending = new PendingSends();
  private final Requests requests;
  private final Services services;
  private final Reception reception;
  private final Arrivals arrivals;
  private final Discovery topicDiscovery;
  private final Discovery serviceDiscovery;
  private final PublishedFrames published;
  private final Workers workers;
  private final CountDownLatch socketsClosed = new CountDownLatch(1);
  private final AtomicBoolean closed = new AtomicBoolean();

  /**
   * Begins.
   *
   * @param options where, and as what
   * @param listener hears what happens
   * @throws IOException where the addresses cannot be used; says why
   */
  public NodeCore(GazeboOptions options, GazeboListener listener) throws IOException {
    this.graph = new GraphState(options.partition());
    DiscoverySocket first =
        new DiscoverySocket(options.address(), options.ports().group(), options.ports().topics());
    DiscoverySocket second = second(options, first);
    this.sockets = sockets(options, first, second);
    this.requests = new Requests(loop, sockets, pending, own.node());
    this.services = new Services(sockets, pending);
    this.reception = new Reception(loop, sockets, pending, own);
    this.arrivals = new Arrivals(options.threads());
    this.published = new PublishedFrames(sockets.ends().publishing(), options.statistics());
    TopicEvents events = new TopicEvents(graph, reception, loop, sockets, listener);
    int version = VERSION + (options.statistics() ? WITH_STATISTICS : 0);
    this.topicDiscovery = new Discovery(first, own.process(), version, events);
    this.serviceDiscovery = new Discovery(second, own.process(), version, events);
    reception.tellBy(topicDiscovery);
    this.workers = new Workers(options.threads());
    workers.start("gazebo sockets", this::runSockets);
    topicDiscovery.start(workers, "gazebo topics");
    serviceDiscovery.start(workers, "gazebo services");
  }

  private static DiscoverySocket second(GazeboOptions options, DiscoverySocket first) throws IOException {
    try {
      return new DiscoverySocket(options.address(), options.ports().group(), options.ports().services());
    } catch (IOException e) {
      first.close();
      throw e;
    }
  }

  private NodeSockets sockets(GazeboOptions options, DiscoverySocket first, DiscoverySocket second)
      throws IOException {
    try {
      return new NodeSockets(options.address(), own.process(), options.threads());
    } catch (IOException e) {
      first.close();
      second.close();
      loop.close();
      throw e;
    }
  }

  private void runSockets() {
    try (ZMQ.Poller poller = sockets.poller()) {
      loop.run(poller, this::turn);
    } finally {
      sockets.close();
      loop.close();
      socketsClosed.countDown();
    }
  }

  private boolean turn(ZMQ.Poller poller) {
    boolean more = reception.take(sockets.subscriber(), AT_ONCE);
    requests.take(sockets.responses());
    services.take(sockets.replier());
    sockets.takeFilters();
    return pending.tick(System.nanoTime()) | more;
  }

  /** What there is now. */
  public GazeboGraph graph() {
    Set<String> processes = new LinkedHashSet<>(topicDiscovery.processes());
    processes.addAll(serviceDiscovery.processes());
    return graph.graph(List.copyOf(processes));
  }

  /** Receives a topic, by its full name. */
  public ArrivalSubscription subscribe(String topic, String type, int most, GazeboReceiver receiver) {
    Arrivals.Source<Reception.Received> source = arrivals.source(most, MOST_BYTES, each -> each.payload().remaining(),
        each -> receiver.received(each.sender(), each.payload(), each.nanos()));
    Wanted wanted = new Wanted(topic, type, source);
    reception.add(wanted, graph.publishers(topic));
    return new ArrivalSubscription(source, () -> reception.remove(wanted));
  }

  /** Announces a topic; answers what it is called in discovery. */
  Announcement announced(String topic, String address, Ends ends) {
    return new Announcement(topic, address, own.process(), own.node(), Scope.ALL, ends);
  }

  /** Announces a topic of ours, or takes it back. */
  public void publishes(String topic, String type, boolean begin) {
    Announcement said = announced(topic, sockets.ends().publishing(), new Ends.Messages(own.process(), type));
    if (begin) {
      topicDiscovery.advertise(said);
    } else {
      topicDiscovery.unadvertise(said);
    }
  }

  /** Leaves a message to be sent; answers whether there was room. */
  public boolean publish(String topic, String type, byte[] payload) {
    return loop.leave(() -> sockets.publish(published.of(topic, type, payload)));
  }

  /** How many nodes of others receive what we publish. */
  public int subscribers(String topic, String type) {
    return sockets.isHeard(topic) ? graph.subscribers(topic, type, own.process()) : 0;
  }

  /** Asks, which blocks. */
  public Outcome<ByteBuffer> ask(OfferedService service, byte[] request, Duration patience)
      throws InterruptedException {
    return requests.ask(service, request, patience);
  }

  /** Answers a service from now on; answers what ends that. */
  public Runnable serve(String service, String request, String response, GazeboResponder responder) {
    Services.Form form = new Services.Form(service, request, response);
    services.add(form, responder);
    Announcement said =
        announced(service, sockets.ends().replier(), new Ends.Requests(sockets.ends().replierId(), request, response));
    serviceDiscovery.advertise(said);
    return () -> {
      serviceDiscovery.unadvertise(said);
      services.remove(form);
    };
  }

  /** Where we publish. */
  public String address() {
    return sockets.ends().publishing();
  }

  @Override
  public void close() {
    if (closed.getAndSet(true)) {
      return;
    }
    long deadline = System.nanoTime() + END.toNanos();
    reception.end();
    requests.end("the connection was closed");
    arrivals.close();
    loop.end();
    Uninterruptibles.await(deadline, nanos -> socketsClosed.await(Math.max(0, nanos), TimeUnit.NANOSECONDS));
    topicDiscovery.close(); // what was published has been sent by now: who hears of the end may not wait for it
    serviceDiscovery.close();
    workers.join(deadline);
  }
}
