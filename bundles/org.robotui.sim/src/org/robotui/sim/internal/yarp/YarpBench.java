package org.robotui.sim.internal.yarp;

import java.io.IOException;
import java.net.InetAddress;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.net.SocketFactory;
import org.robotui.net.socket.HostPort;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.name.NameClient;
import org.robotui.yarp.name.NameServer;
import org.robotui.yarp.port.PortArrival;
import org.robotui.yarp.port.PortOptions;
import org.robotui.yarp.port.PortReader;
import org.robotui.yarp.port.YarpPort;
import org.robotui.yarp.wire.YarpStamp;

/** The ports of one robot, registered with its name server. */
final class YarpBench implements AutoCloseable {
  private final String prefix;
  private final NameServer server;
  private final NameClient names;
  private final PortOptions options;
  private final Map<String, YarpPort> ports = new HashMap<>();
  private final AtomicInteger sequence = new AtomicInteger();

  YarpBench(String prefix, NameServer server, ThreadFactory threads) {
    this.prefix = prefix;
    this.server = server;
    this.options = PortOptions.of(threads);
    this.names =
        new NameClient(new HostPort("127.0.0.1", server.port()), SocketFactory.getDefault(), options.patience());
  }

  private void open(String name, PortReader reader) throws IOException {
    YarpPort port = new YarpPort(prefix + "/" + name, InetAddress.getLoopbackAddress(), 0, Optional.of(names), reader,
        options);
    ports.put(name, port);
    server.register(port.name(), new HostPort("127.0.0.1", port.port()));
  }

  /** A port that says something. */
  void says(String name) throws IOException {
    open(name, arrival -> Optional.empty());
  }

  /** A port that is told something. */
  void hears(String name, Consumer<PortArrival> action) throws IOException {
    open(name, arrival -> {
      action.accept(arrival);
      return Optional.empty();
    });
  }

  /** A port that is asked, and answers. */
  void asked(String name, Function<PortArrival, Bottle> answer) throws IOException {
    open(name, arrival -> Optional.of(answer.apply(arrival)));
  }

  boolean isHeard(String name) {
    return !ports.get(name).targets().isEmpty();
  }

  void say(String name, Bottle what, double seconds) {
    ports.get(name).say(what, Optional.of(new YarpStamp(sequence.incrementAndGet(), seconds)));
  }

  void sayIfHeard(String name, Supplier<Bottle> what, double seconds) {
    if (isHeard(name)) {
      say(name, what.get(), seconds);
    }
  }

  /** The four ports of a control board. */
  void board(String part, ControlBoard board) throws IOException {
    says(part + "/state:o");
    says(part + "/stateExt:o");
    asked(part + "/rpc:i", asked -> board.asked(asked.bottle()));
    hears(part + "/command:i", told -> board.told(told.bottle()));
  }

  void say(String part, ControlBoard board, double seconds) {
    sayIfHeard(part + "/state:o", board::positions, seconds);
    sayIfHeard(part + "/stateExt:o", board::extended, seconds);
  }

  @Override
  public void close() {
    ports.values().forEach(YarpPort::close);
  }
}
