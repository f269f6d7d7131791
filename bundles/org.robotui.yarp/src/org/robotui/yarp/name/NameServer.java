package org.robotui.yarp.name;

import java.io.IOException;
import java.net.InetAddress;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import org.robotui.net.socket.HostPort;
import org.robotui.net.thread.Workers;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.BottleCodec;
import org.robotui.yarp.bottle.YarpFormatException;
import org.robotui.yarp.internal.NameBooks;
import org.robotui.yarp.internal.PortDoor;
import org.robotui.yarp.internal.Served;
import org.robotui.yarp.wire.YarpMessage;

/** A small name server, open from its making until it is closed. Safe for all threads. */
public final class NameServer implements AutoCloseable {
  private static final String NAME = "/root";
  private static final Duration END = Duration.ofSeconds(1);

  private final NameBooks books = new NameBooks();
  private final Workers workers;
  private final PortDoor door;

  /**
   * Listens at once.
   *
   * @param address of which network interface
   * @param port 0 for any that is free
   * @param threads makes its threads
   * @throws IOException where it cannot listen there
   */
  public NameServer(InetAddress address, int port, ThreadFactory threads) throws IOException {
    workers = new Workers(threads);
    door = new PortDoor(address, port, workers, new Side());
    books.put(new YarpAddress(NAME, new HostPort(address.getHostAddress(), door.port()), "tcp"));
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
   * What is registered.
   *
   * @return its own port among them, by their names
   */
  public List<YarpAddress> ports() {
    return books.all();
  }

  /**
   * Registers a port, as it would do itself.
   *
   * @param name of the port
   * @param where it listens
   */
  public void register(String name, HostPort where) {
    books.put(new YarpAddress(name, where, "tcp"));
  }

  /** What its door calls. */
  private final class Side implements Served {
    @Override
    public String name() {
      return NAME;
    }

    @Override
    public Optional<Bottle> data(String from, YarpMessage message) {
      try {
        return Optional.of(books.answer(BottleCodec.read(message.data())));
      } catch (YarpFormatException e) {
        return Optional.of(Bottle.of(Bottle.vocabs("nak")));
      }
    }

    @Override
    public String text(String from, String line) {
      return books.answer(line);
    }

    @Override
    public String command(String line) {
      return "";
    }

    @Override
    public String admin(String line) {
      return "-1 \"a name server connects to nobody\"";
    }

    @Override
    public Optional<String> names(String line) {
      return Optional.of(books.answer(line));
    }

    @Override
    public void opened(String from) {
      // nothing is kept of who asks
    }

    @Override
    public void lost(String from, String reason) {
      // whoever asks by datagrams is not answered
    }

    @Override
    public void ended(String from, String reason) {
      // nothing is kept of who asks
    }
  }

  /** Ends all connections. */
  @Override
  public void close() {
    door.close();
    workers.join(System.nanoTime() + END.toNanos());
  }
}
