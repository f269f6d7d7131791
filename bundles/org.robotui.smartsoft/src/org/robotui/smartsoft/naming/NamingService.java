package org.robotui.smartsoft.naming;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.ThreadFactory;
import org.robotui.message.CdrReader;
import org.robotui.message.CdrWriter;
import org.robotui.message.MessageException;
import org.robotui.net.link.FrameLink;
import org.robotui.net.socket.Sockets;
import org.robotui.net.socket.TcpListener;
import org.robotui.net.thread.Workers;
import org.robotui.smartsoft.wire.NamingCommand;
import org.robotui.smartsoft.wire.SmartFrame;
import org.robotui.smartsoft.wire.SmartFraming;

/** A naming service that is open from its making until it is closed, and forgets all then. Safe for all threads. */
public final class NamingService implements Closeable {

  private static final Duration END = Duration.ofSeconds(2);
  private static final int MOST_LINKS = 256;
  private static final int MOST_ENTRIES = 4096;
  private static final String ANYWHERE = "0.0.0.0:";

  private final Workers workers;
  private final TcpListener listener;
  private final Map<String, Entry> entries = new ConcurrentSkipListMap<>();
  private final Map<FrameLink<SmartFrame>, String> links = new ConcurrentHashMap<>();

  private record Entry(String value, String type) {}

  /**
   * Listens at once.
   *
   * @param threads makes its threads
   * @param address of which network interface
   * @param port 0 for a free one
   * @throws IOException where the port cannot be had
   */
  public NamingService(ThreadFactory threads, InetAddress address, int port) throws IOException {
    this.workers = new Workers(threads);
    this.listener = TcpListener.bind(address, port);
    String name = "smartsoft naming " + port();
    workers.start(name, () -> listener.acceptAll(name, this::begin));
  }

  /**
   * Where it listens.
   *
   * @return the port that it has
   */
  public int port() {
    return listener.port();
  }

  /**
   * What is entered.
   *
   * @return the names of services
   */
  public Set<String> names() {
    return new TreeSet<>(entries.keySet());
  }

  private void begin(Socket socket) throws IOException {
    if (links.size() >= MOST_LINKS) {
      throw new IOException("there are " + MOST_LINKS + " links already");
    }
    Sockets.prepare(socket);
    FrameLink<SmartFrame> link = new FrameLink<>(socket, new SmartFraming(), new Asked());
    links.put(link, socket.getInetAddress().getHostAddress() + ":");
    link.start(workers, "smartsoft naming client " + socket.getRemoteSocketAddress());
    if (listener.isClosed()) {
      link.close();
    }
  }

  private final class Asked implements FrameLink.Receiver<SmartFrame> {
    @Override
    public void received(SmartFrame frame, FrameLink<SmartFrame> link) throws IOException {
      CdrReader said = frame.reader();
      try {
        switch (frame.command()) {
          case NamingCommand.BIND, NamingCommand.REBIND -> bind(frame.command(), said, link);
          case NamingCommand.UNBIND -> status(link, frame.command(),
              entries.remove(said.string("name")) == null ? -1 : 0);
          case NamingCommand.RESOLVE -> resolve(said.string("name"), link);
          case NamingCommand.LIST -> list(said.string("types"), link);
          default -> throw new IOException("nothing is known of the command " + frame.command());
        }
      } catch (MessageException e) {
        throw new IOException(e.getMessage(), e);
      }
    }

    @Override
    public void ended(FrameLink<SmartFrame> link, String reason) {
      links.remove(link);
    }
  }

  private void bind(int command, CdrReader said, FrameLink<SmartFrame> link) throws MessageException {
    String name = said.string("name");
    String value = said.string("value");
    String from = links.getOrDefault(link, ANYWHERE);
    Entry entry = new Entry(value.startsWith(ANYWHERE) ? from + value.substring(ANYWHERE.length()) : value,
        said.string("type"));
    boolean room = entries.size() < MOST_ENTRIES || entries.containsKey(name);
    boolean free = command == NamingCommand.REBIND || !entries.containsKey(name);
    if (room && free) {
      entries.put(name, entry);
    }
    status(link, command, room && free ? 0 : -1);
  }

  private void resolve(String name, FrameLink<SmartFrame> link) {
    Entry entry = entries.get(name);
    if (entry == null) {
      say(link, NamingCommand.BIND, texts("", "", ""));
    } else {
      say(link, NamingCommand.RESOLVE, texts("", entry.value(), entry.type()));
    }
  }

  private void list(String types, FrameLink<SmartFrame> link) {
    entries.forEach((name, entry) -> {
      if (entry.type().startsWith(types)) {
        say(link, NamingCommand.LIST, texts(name, entry.value(), entry.type()));
      }
    });
    say(link, NamingCommand.END_OF_LIST, texts("", "", ""));
  }

  private static CdrWriter texts(String name, String value, String type) {
    CdrWriter said = SmartFrame.data();
    said.string(name).string(value).string(type);
    return said;
  }

  private static void status(FrameLink<SmartFrame> link, int command, int status) {
    CdrWriter said = SmartFrame.data();
    said.i32(status).i32(0);
    say(link, command, said);
  }

  private static void say(FrameLink<SmartFrame> link, int command, CdrWriter said) {
    link.send(new SmartFrame(command, ByteOrder.LITTLE_ENDIAN, said.view(), ByteBuffer.allocate(0)));
  }

  /** Ends all links. */
  @Override
  public void close() {
    listener.close();
    links.keySet().forEach(FrameLink::finish);
    links.keySet().forEach(FrameLink::close);
    workers.join(System.nanoTime() + END.toNanos());
  }
}
