package org.robotui.yarp.port;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.net.socket.HostPort;
import org.robotui.net.thread.Workers;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.BottleCodec;
import org.robotui.yarp.bottle.BottleText;
import org.robotui.yarp.bottle.YarpFormatException;
import org.robotui.yarp.internal.PortDoor;
import org.robotui.yarp.internal.Served;
import org.robotui.yarp.internal.TextLines;
import org.robotui.yarp.name.NameClient;
import org.robotui.yarp.name.YarpAddress;
import org.robotui.yarp.wire.YarpCarrier;
import org.robotui.yarp.wire.YarpMessage;
import org.robotui.yarp.wire.YarpStamp;

/**
 * A port of our own: it listens, takes what others say, and says things to those whom it is connected to, by itself or
 * because it was told so. Registering it with a name server is done apart from that, as tests have none.
 */
public final class YarpPort implements AutoCloseable {
  /** The carriers by which it is reached. */
  public static final Set<String> ACCEPTS = Set.of("tcp", "fast_tcp", "udp", "mcast", "text", "text_ack");

  private static final Duration END = Duration.ofSeconds(1);
  private static final String SEPARATOR = "://";

  private final String name;
  private final PortReader reader;
  private final PortOptions options;
  private final Optional<NameClient> names;
  private final Workers workers;
  private final PortDoor door;
  private final Map<String, PortStream> targets = new ConcurrentSkipListMap<>();
  private final Collection<String> sources = new CopyOnWriteArrayList<>();
  private final Map<String, YarpCarrier> carriers = new ConcurrentHashMap<>();
  private Optional<YarpAddress> group = Optional.empty(); // guarded by carriers
  private volatile boolean closed;

  /**
   * Listens at once.
   *
   * @param name of the port
   * @param address of which network interface
   * @param port 0 for any that is free
   * @param names finds the ports that it is told to connect to; empty where it is told so by nobody
   * @param reader takes what it is told
   * @param options of its threads and connections
   * @throws IOException where it cannot listen there
   */
  public YarpPort(String name, InetAddress address, int port, Optional<NameClient> names, PortReader reader,
      PortOptions options) throws IOException {
    this.name = name;
    this.reader = reader;
    this.options = options;
    this.names = names;
    this.workers = new Workers(options.threads());
    this.door = new PortDoor(address, port, workers, new Side());
  }

  /**
   * How it is called.
   *
   * @return a name that begins with /
   */
  public String name() {
    return name;
  }

  /**
   * Where it listens.
   *
   * @return the port that it has
   */
  public int port() {
    return door.port();
  }

  /**
   * Who is connected to it, by another carrier than text. Who says something by datagrams may have gone unnoticed.
   *
   * @return names of ports, or words
   */
  public Set<String> sources() {
    return Set.copyOf(sources);
  }

  /**
   * To whom it says what it says.
   *
   * @return names of ports
   */
  public List<String> targets() {
    return targets.entrySet().stream().filter(e -> e.getValue().over().isEmpty()).map(Map.Entry::getKey).toList();
  }

  /**
   * Connects to a port. What is said from then on is said to it, too.
   *
   * @param target the name of the other port
   * @param where it listens
   * @param carrier by which
   * @throws IOException where no name server gives a group that mcast needs
   */
  public void connect(String target, HostPort where, YarpCarrier carrier) throws IOException {
    if (closed) {
      return;
    }
    Optional<InetSocketAddress> shared =
        carrier == YarpCarrier.MCAST ? Optional.of(group()) : Optional.empty();
    carriers.put(target, carrier);
    PortStream before = targets.put(target, new PortStream(where, carrier, shared, name, options, workers));
    if (before != null) {
      before.close();
    }
  }

  private InetSocketAddress group() throws IOException {
    NameClient server = names.orElseThrow(() -> new IOException("mcast needs a name server"));
    synchronized (carriers) {
      if (group.isEmpty()) {
        group = Optional.of(server.group());
      }
      HostPort where = group.get().where();
      return new InetSocketAddress(InetAddress.getByName(where.host()), where.port());
    }
  }

  /**
   * Says nothing more to a port.
   *
   * @param target the name of the other port
   * @return false where it was not connected to it
   */
  public boolean disconnect(String target) {
    PortStream before = targets.remove(target);
    if (before != null) {
      before.close();
    }
    return before != null;
  }

  /**
   * Says something to all whom it is connected to; does not block. Who has not taken the last one gets this one in its
   * place.
   *
   * @param bottle what is said
   * @param stamp its envelope; without one it is a command
   */
  public void say(Bottle bottle, Optional<YarpStamp> stamp) {
    targets.values().removeIf(target -> target.over().isPresent());
    if (targets.isEmpty()) {
      return;
    }
    byte[] bytes = BottleCodec.bytes(bottle);
    YarpMessage message =
        stamp.map(envelope -> YarpMessage.of(envelope, bytes)).orElseGet(() -> YarpMessage.of(bytes));
    boolean shared = false; // one stream says it to the whole group
    for (Map.Entry<String, PortStream> target : targets.entrySet()) {
      boolean mcast = carriers.get(target.getKey()) == YarpCarrier.MCAST;
      if (!mcast || !shared) {
        target.getValue().post(name, message, Duration.ZERO);
      }
      shared |= mcast;
    }
  }

  /** What its door calls. */
  private final class Side implements Served {
    @Override
    public String name() {
      return name;
    }

    @Override
    public Optional<Bottle> data(String from, YarpMessage message) {
      try {
        Bottle bottle = BottleCodec.read(message.data());
        return reader.received(new PortArrival(from, bottle, message.data(), message.stamp()));
      } catch (YarpFormatException | IllegalArgumentException | ArithmeticException e) {
        reader.unreadable(from, String.valueOf(e.getMessage()));
        return Optional.empty();
      }
    }

    @Override
    public String text(String from, String line) {
      try {
        Bottle bottle = BottleText.parse(line);
        return reader.received(new PortArrival(from, bottle, BottleCodec.bytes(bottle), Optional.empty()))
            .map(reply -> BottleText.format(reply) + TextLines.END).orElse("");
      } catch (YarpFormatException | IllegalArgumentException e) {
        reader.unreadable(from, String.valueOf(e.getMessage()));
        return "";
      }
    }

    @Override
    public String command(String line) {
      if (line.startsWith("/")) {
        return add(line) + TextLines.END;
      }
      if (line.startsWith("!")) {
        return remove(line.substring(1)) + TextLines.END;
      }
      if (line.startsWith("~")) {
        return hush(line.substring(1)) + TextLines.END;
      }
      return line.startsWith("*") ? status() : "";
    }

    private String status() {
      StringBuilder lines = new StringBuilder("This is " + name + " at tcp://:" + port() + TextLines.END);
      targets().forEach(target -> lines.append("There is an output connection from ").append(name).append(" to ")
          .append(target).append(" using ").append(carriers.get(target).word()).append(TextLines.END));
      sources().forEach(source -> lines.append("There is an input connection from ").append(source).append(" to ")
          .append(name).append(TextLines.END));
      return lines.toString();
    }

    @Override
    public String admin(String line) {
      try {
        Bottle command = BottleText.parse(line);
        String other = command.get(command.size() - 1).text();
        return switch (command.get(0).text()) {
          case "add" -> answer(add(other), "Added");
          case "del" -> answer(disconnect(other) ? removed(other) : hush(other), "Removed");
          case "list" -> list(command);
          case "help" -> "[add] [del] [list] [help]";
          default -> "-1 \"this port takes [add], [del] and [list]\"";
        };
      } catch (YarpFormatException e) {
        return "-1 \"no command\"";
      }
    }

    private static String answer(String line, String good) {
      return BottleText.format(Bottle.of(line.startsWith(good) ? 0 : -1, line + TextLines.END));
    }

    private String list(Bottle command) {
      boolean in = command.get(1).text().equals("in");
      String asked = command.get(2).text();
      if (asked.isEmpty()) {
        return BottleText.format(Bottle.of((in ? sources() : targets()).toArray()));
      }
      boolean there = !in && targets().contains(asked);
      return there ? BottleText.format(Bottle.of(List.of("from", name), List.of("to", asked),
          List.of("carrier", carriers.get(asked).word()))) : "";
    }

    /** {@code /target} or {@code carrier://target}, which may have a / before it. */
    private String add(String written) {
      int separator = written.indexOf(SEPARATOR);
      String carrier = separator < 0 ? "tcp" : written.substring(0, separator).replace("/", "");
      String target = separator < 0 ? written : written.substring(separator + SEPARATOR.length() - 1);
      Optional<YarpAddress> found = find(target);
      Optional<YarpCarrier> by = List.of(YarpCarrier.values()).stream().filter(c -> c.word().equals(carrier)).findAny();
      if (found.isEmpty() || by.isEmpty()) {
        return "Do not know how to connect to " + written;
      }
      try {
        connect(target, found.get().where(), by.get());
      } catch (IOException e) {
        return "Cannot connect to " + written + ": " + e.getMessage();
      }
      return "Added connection from " + name + " to " + written;
    }

    private Optional<YarpAddress> find(String target) {
      try {
        return names.isPresent() ? names.get().query(target) : Optional.empty();
      } catch (IOException | IllegalArgumentException e) {
        return Optional.empty();
      }
    }

    private String remove(String target) {
      return disconnect(target) ? removed(target) : "Could not find an outgoing connection to " + target;
    }

    private String removed(String target) {
      return "Removed connection from " + name + " to " + target;
    }

    /** Who says something by datagrams tells in this way that it ends. */
    private String hush(String source) {
      return door.end(source) ? "Removed connection from " + source + " to " + name
          : "Could not find a connection with " + source;
    }

    @Override
    public Optional<String> names(String line) {
      return Optional.empty();
    }

    @Override
    public void opened(String from) {
      sources.add(from);
    }

    @Override
    public void lost(String from, String reason) {
      reader.unreadable(from, reason);
    }

    @Override
    public void ended(String from, String reason) {
      sources.remove(from);
      reader.ended(from, reason);
    }
  }

  /** What is heard and said from its threads ends, too; bounded. */
  @Override
  public void close() {
    closed = true;
    door.close();
    synchronized (carriers) {
      group.ifPresent(shared -> workers.start("yarp forgets " + shared.name(), () -> forget(shared)));
    }
    List<PortStream> open = new ArrayList<>(targets.values());
    targets.clear();
    open.forEach(PortStream::close);
    workers.join(System.nanoTime() + END.toNanos());
  }

  private void forget(YarpAddress shared) {
    try {
      names.orElseThrow().unregister(shared.name());
    } catch (IOException e) {
      // a name server that is gone has forgotten it
    }
  }
}
