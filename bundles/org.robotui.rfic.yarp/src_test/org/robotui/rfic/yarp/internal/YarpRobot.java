package org.robotui.rfic.yarp.internal;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import javax.net.SocketFactory;
import org.robotui.api.Rfic;
import org.robotui.api.link.LinkState;
import org.robotui.data.Data;
import org.robotui.net.socket.HostPort;
import org.robotui.testkit.FakeRficContext;
import org.robotui.testkit.rfic.Peer;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.name.NameClient;
import org.robotui.yarp.name.NameServer;
import org.robotui.yarp.port.PortOptions;
import org.robotui.yarp.port.PortReader;
import org.robotui.yarp.port.YarpPort;
import org.robotui.yarp.wire.YarpStamp;

/** A name server, ports of a robot beside it, and the robot interface that looks at them. */
final class YarpRobot implements AutoCloseable {
  final FakeRficContext context = new FakeRficContext();
  final Map<String, YarpPort> ports = new HashMap<>();
  private final PortOptions options = PortOptions.of(Peer.THREADS);
  private NameServer server;
  private final int serverPort;
  private Optional<Rfic> rfic = Optional.empty();

  YarpRobot() throws IOException {
    server = new NameServer(InetAddress.getLoopbackAddress(), 0, Peer.THREADS);
    serverPort = server.port();
  }

  NameServer server() {
    return server;
  }

  NameClient names() {
    return new NameClient(new HostPort("127.0.0.1", serverPort), SocketFactory.getDefault(), options.patience());
  }

  void open(String name, PortReader reader) throws IOException {
    YarpPort port = new YarpPort(name, InetAddress.getLoopbackAddress(), 0, Optional.of(names()), reader, options);
    ports.put(name, port);
    server.register(name, new HostPort("127.0.0.1", port.port()));
  }

  void says(String name) throws IOException {
    open(name, arrival -> Optional.empty());
  }

  void say(String name, Bottle bottle) {
    ports.get(name).say(bottle, Optional.of(new YarpStamp(1, 1.7e9)));
  }

  void end(String name) {
    ports.remove(name).close();
  }

  void endServer() {
    server.close();
  }

  void restartServer() throws IOException {
    server = new NameServer(InetAddress.getLoopbackAddress(), serverPort, Peer.THREADS);
    ports.forEach((name, port) -> server.register(name, new HostPort("127.0.0.1", port.port())));
  }

  void look(Map<String, Object> settings) {
    Map<String, Object> all = new HashMap<>(settings);
    all.put("host", "127.0.0.1");
    all.put("port", (long) serverPort);
    Rfic started = YarpSessions.rfic(context, YarpPeer.settings(all));
    rfic = Optional.of(started);
    started.start();
    await("the link is made", () -> context.links.peekLast() instanceof LinkState.Connected);
  }

  void await(String what, BooleanSupplier condition) {
    long end = System.nanoTime() + Duration.ofSeconds(60).toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() - end < 0,
          () -> what + "; " + context.links.peekLast() + " " + context.streams.keySet() + " " + context.complaints);
      try {
        Thread.sleep(10);
      } catch (InterruptedException e) {
        throw new AssertionError(e);
      }
    }
  }

  /** The next of a stream, said again and again until it comes. */
  <D extends Data> D next(String port, Class<D> type, String name, Bottle said) {
    await(port + " is offered", () -> context.streams.containsKey(port));
    context.demand(port, true);
    int before = count(port);
    await("one of " + port, () -> {
      say(name, said);
      return count(port) > before;
    });
    return type.cast(context.published.get(port).peekLast().value());
  }

  private int count(String port) {
    return Optional.ofNullable(context.published.get(port)).map(all -> all.size()).orElse(0);
  }

  List<String> registered() {
    return server.ports().stream().map(a -> a.name()).filter(name -> name.startsWith("/robotui")).toList();
  }

  @Override
  public void close() {
    rfic.ifPresent(Rfic::close);
    ports.values().forEach(YarpPort::close);
    server.close();
  }
}
