package org.robotui.ros.internal.node;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.message.MessageCodec;
import org.robotui.message.MessageInfo;
import org.robotui.message.ServiceCodec;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.CloseableSet;
import org.robotui.net.socket.HostPort;
import org.robotui.net.thread.Workers;
import org.robotui.ros.GraphName;
import org.robotui.ros.MasterGraph;
import org.robotui.ros.MessageListener;
import org.robotui.ros.NameResolver;
import org.robotui.ros.NodeClock;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.Parameters;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.ServiceClient;
import org.robotui.ros.ServiceHandler;
import org.robotui.ros.ServiceIdentity;
import org.robotui.ros.ServiceServer;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.xmlrpc.XmlRpcLimits;
import org.robotui.ros.internal.xmlrpc.XmlRpcServer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A running node: puts the parts together and takes them apart again. */
public final class NodeRuntime implements RosNode {

  private static final Logger LOG = LoggerFactory.getLogger(NodeRuntime.class);
  private static final Duration MASTER_TIMEOUT = Duration.ofSeconds(5);

  private final NodeContext context;
  private final NameResolver names;
  private final RosApi master;
  private final Registrar registrar;
  private final TcpServer tcp;
  private final XmlRpcServer http;
  private final String uri;
  private final String rpcUri;
  private final NodeParts parts = new NodeParts();
  private final RecordFile record;
  private final NodeParameters parameters;
  private final RosClock clock;
  private final SlaveApi slave;
  /** Sockets of calls that belong to no topic or service of this node. */
  private final CloseableSet sockets = new CloseableSet();
  private final HostPort masterAddress;
  private final Unregistration leaving;
  private final AtomicBoolean closing = new AtomicBoolean();
  private final CompletableFuture<String> closed = new CompletableFuture<>();

  private NodeRuntime(RosEnvironment environment, GraphName name, NodeOptions options) throws IOException {
    names = NameResolver.of(name, environment.namespace(), environment.remappings());
    context = new NodeContext(name, options, new Workers(options.threads()));
    masterAddress = HostPort.ofUri(environment.masterUri().toString(), "http");
    master = new RosApi(masterAddress, "master", MASTER_TIMEOUT);
    registrar = new Registrar(context, master, environment.masterUri().toString());
    leaving = new Unregistration(context, registrar, masterAddress);
    LocalAddress address = LocalAddress.of(environment.host());
    tcp = new TcpServer(context, address.bind(), parts::serve);
    http = new XmlRpcServer(address.bind(), 0, XmlRpcLimits.standard(), context.workers(), "ros " + name);
    uri = address.uri("http", http.port()) + "/";
    rpcUri = address.uri("rosrpc", tcp.port());
    NodeRecord note =
        new NodeRecord(name.text(), uri, rpcUri, environment.masterUri().toString(), Owner.current(), List.of());
    record = new RecordFile(options.records(), note, http.port());
    parameters = new NodeParameters(names, master, registrar, uri, record);
    clock = new RosClock(this::subscribeClock);
    slave = slave(environment, address);
  }

  /** Opens a node. */
  public static RosNode open(RosEnvironment environment, GraphName name, NodeOptions options) throws IOException {
    GraphName wanted = environment.nodeName().orElse(name);
    NodeRuntime node =
        new NodeRuntime(environment, wanted.isGlobal() ? wanted : environment.namespace().join(wanted), options);
    node.warnIfUnreachable(environment);
    node.start(environment);
    return node;
  }

  private void warnIfUnreachable(RosEnvironment environment) {
    boolean remote = !masterAddress.host().matches("localhost|127\\..*|::1");
    if (remote && environment.host().isEmpty()) {
      LOG.warn("{} listens on loopback only: nodes on other machines cannot subscribe to it or call it; set ROS_IP or "
          + "ROS_HOSTNAME to this machine's address towards {}", name(), masterAddress);
    }
  }

  private SlaveApi slave(RosEnvironment environment, LocalAddress address) {
    XmlRpcValue endpoint =
        XmlRpcValue.of(XmlRpcValue.of("TCPROS"), XmlRpcValue.of(address.announced()), XmlRpcValue.of(tcp.port()));
    return new SlaveApi(parts, parameters, environment.masterUri().toString(), endpoint, this::shutDown);
  }

  private void start(RosEnvironment environment) {
    tcp.start();
    http.start(slave.methods());
    environment.parameters()
        .forEach((key, value) -> registrar.add(new InitialParameter(name(), names.resolve("~" + key), value)));
    parameters.subscribe("/use_sim_time", clock::useSimTime);
    record.write();
    registrar.start();
  }

  private Subscriber subscribeClock() {
    return subscriber("/clock", new ClockCodec(), SubscriberOptions.observing(),
        (nanos, reception) -> clock.tick(nanos));
  }

  @Override
  public GraphName name() {
    return context.name();
  }

  @Override
  public String uri() {
    return uri;
  }

  @Override
  public NameResolver names() {
    return names;
  }

  @Override
  public <T> Publisher<T> publisher(String topic, MessageCodec<T> codec, PublisherOptions options) {
    requireOpen();
    GraphName global = names.resolve(topic);
    if (codec.info().md5().equals(MessageInfo.ANY)) {
      throw new IllegalArgumentException("a publisher of " + global + " must say which type it sends");
    }
    PublishedTopic registration = new PublishedTopic(name(), global, codec.info().type(), uri);
    Publication<T> publication = new Publication<>(context, global, codec, options, ended -> {
      parts.remove(ended);
      registrar.remove(registration);
    });
    if (!parts.add(publication)) {
      throw new IllegalStateException(name() + " publishes " + global + " already");
    }
    registrar.add(registration);
    return publication;
  }

  @Override
  public <T> Subscriber subscriber(String topic, MessageCodec<T> codec, SubscriberOptions options,
      MessageListener<T> listener) {
    requireOpen();
    GraphName global = names.resolve(topic);
    synchronized (parts.topics()) {
      SubscribedTopic subscribed =
          parts.topics().computeIfAbsent(global.text(), key -> register(global, codec.info(), options));
      Subscription<T> subscription =
          new Subscription<>(context, subscribed, codec, options, listener, this::unsubscribe);
      subscribed.add(subscription);
      return subscription;
    }
  }

  private SubscribedTopic register(GraphName topic, MessageInfo info, SubscriberOptions options) {
    String type = options.announcesType() ? info.type() : MessageInfo.ANY;
    SubscribedTopic subscribed = new SubscribedTopic(context, topic, type, uri);
    registrar.add(subscribed);
    return subscribed;
  }

  private void unsubscribe(Subscription<?> subscription) {
    Optional<SubscribedTopic> unwanted;
    synchronized (parts.topics()) {
      unwanted = Optional.ofNullable(parts.topics().get(subscription.topic().text()))
          .filter(topic -> topic.remove(subscription));
      unwanted.ifPresent(topic -> {
        parts.topics().remove(subscription.topic().text());
        registrar.remove(topic);
      });
    }
    unwanted.ifPresent(SubscribedTopic::close);
  }

  @Override
  public <Q, R> ServiceServer serviceServer(String service, ServiceCodec<Q, R> codec, ServiceHandler<Q, R> handler) {
    requireOpen();
    GraphName global = names.resolve(service);
    OfferedService registration = new OfferedService(name(), global, rpcUri, uri);
    ServiceEndpoint<Q, R> endpoint = new ServiceEndpoint<>(context, global, codec, handler, ended -> {
      parts.remove(ended);
      registrar.remove(registration);
    });
    if (!parts.add(endpoint)) {
      throw new IllegalStateException(name() + " offers service " + global + " already");
    }
    registrar.add(registration);
    return endpoint;
  }

  @Override
  public <Q, R> ServiceClient<Q, R> serviceClient(String service, ServiceCodec<Q, R> codec, boolean persistent) {
    ServiceCaller<Q, R> caller = new ServiceCaller<>(context, finder(), names.resolve(service), codec,
        persistent);
    sockets.add(caller);
    return caller;
  }

  private ServiceFinder finder() {
    return new ServiceFinder(context, master, sockets);
  }

  @Override
  public Outcome<ServiceIdentity> probeService(String service, Duration timeout) {
    return finder().probe(names.resolve(service), timeout);
  }

  @Override
  public Parameters parameters() {
    return parameters;
  }

  @Override
  public MasterGraph master() {
    return new GraphClient(context, master, sockets);
  }

  @Override
  public NodeClock clock() {
    return clock;
  }

  @Override
  public boolean awaitRegistered(Duration timeout) {
    return registrar.awaitRegistered(timeout);
  }

  @Override
  public CompletionStage<String> whenClosed() {
    return closed.minimalCompletionStage();
  }

  /** The master asks: on a thread of its own, so that the master gets its answer. */
  private void shutDown(String reason) {
    if (!closing.get()) {
      context.start("shutdown", () -> close(reason));
    }
  }

  @Override
  public void leave() {
    leaving.begin();
  }

  @Override
  public void close() {
    close("closed by its owner");
  }

  private void close(String reason) {
    if (!closing.compareAndSet(false, true)) {
      return;
    }
    boolean forgotten = new NodeShutdown(context, leaving)
        .run(List.of(parts::close, tcp::close, http::close, sockets::close), master);
    registrar.withdrawUnregisterCalls();
    if (forgotten) {
      record.delete();
    }
    closed.complete(reason);
  }

  private void requireOpen() {
    if (closing.get()) {
      throw new IllegalStateException(name() + " is closed");
    }
  }
}
