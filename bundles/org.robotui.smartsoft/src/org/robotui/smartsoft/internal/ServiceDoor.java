package org.robotui.smartsoft.internal;

import java.io.Closeable;
import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.message.CdrReader;
import org.robotui.message.MessageException;
import org.robotui.net.link.FrameLink;
import org.robotui.net.socket.HostPort;
import org.robotui.net.socket.Sockets;
import org.robotui.net.socket.TcpListener;
import org.robotui.net.thread.Workers;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.server.SmartServerOptions;
import org.robotui.smartsoft.wire.SmartCommand;
import org.robotui.smartsoft.wire.SmartFrame;
import org.robotui.smartsoft.wire.SmartFraming;

/** Where clients of one service connect and disconnect; what else they say is for a pattern. */
public final class ServiceDoor implements Closeable {

  /** What clients say to a service, on the thread of each. */
  public interface Pattern {

    /** A client that is connected has said something; what is thrown ends its link. */
    void said(SmartCommand command, SmartFrame frame, ServedClient client) throws IOException, MessageException;

    /** A client is gone. */
    default void left(ServedClient client) {}
  }

  private static final Duration END = Duration.ofSeconds(1);
  private static final int MOST_CLIENTS = 256;

  private final Pattern pattern;
  private final Workers workers;
  private final TcpListener listener;
  private final String identifier = UUID.randomUUID().toString();
  private final Map<FrameLink<SmartFrame>, ServedClient> clients = new ConcurrentHashMap<>();

  /** Listens at once. */
  public ServiceDoor(SmartServerOptions options, Pattern pattern) throws IOException {
    this.pattern = pattern;
    this.workers = new Workers(options.threads());
    this.listener = TcpListener.bind(options.address(), options.port());
    String name = "smartsoft service " + listener.port();
    workers.start(name, () -> listener.acceptAll(name, this::begin));
  }

  /** Where it is. */
  public ServiceAddress address() {
    String host = listener.address().getAddress().getHostAddress();
    return new ServiceAddress(new HostPort(host, listener.port()), identifier);
  }

  /** Who is connected. */
  public List<ServedClient> clients() {
    return clients.values().stream().filter(ServedClient::isTaken).toList();
  }

  private void begin(Socket socket) throws IOException {
    if (clients.size() >= MOST_CLIENTS) {
      throw new IOException("there are " + MOST_CLIENTS + " clients already");
    }
    Sockets.prepare(socket);
    FrameLink<SmartFrame> link = new FrameLink<>(socket, new SmartFraming(), new FromClient());
    clients.put(link, new ServedClient(link));
    link.start(workers, "smartsoft client " + socket.getRemoteSocketAddress());
    if (listener.isClosed()) {
      link.close();
    }
  }

  private final class FromClient implements FrameLink.Receiver<SmartFrame> {
    @Override
    public void received(SmartFrame frame, FrameLink<SmartFrame> link) throws IOException {
      ServedClient client = clients.get(link);
      Optional<SmartCommand> command = SmartCommand.of(frame.command());
      if (client == null || command.isEmpty()) {
        throw new IOException("nothing is known of the command " + frame.command());
      }
      try {
        take(command.get(), frame, client);
      } catch (MessageException e) {
        throw new IOException(e.getMessage(), e);
      }
    }

    @Override
    public void ended(FrameLink<SmartFrame> link, String reason) {
      ServedClient client = clients.remove(link);
      if (client != null) {
        pattern.left(client);
      }
    }
  }

  private void take(SmartCommand command, SmartFrame frame, ServedClient client)
      throws IOException, MessageException {
    switch (command) {
      case CONNECT -> connect(frame.reader(), client);
      case DISCARD -> client.link().finish();
      case DISCONNECT -> {
        pattern.left(client);
        client.send(SmartFrame.of(SmartCommand.ACK_DISCONNECT));
      }
      default -> {
        if (!client.isTaken()) {
          throw new IOException("a client that has not connected says " + command);
        }
        pattern.said(command, frame, client);
      }
    }
  }

  private void connect(CdrReader said, ServedClient client) throws MessageException {
    int number = said.int32("client");
    boolean meant = said.string("identifier").equals(identifier);
    if (meant) {
      client.take();
    }
    client.send(SmartFrame.of(SmartCommand.ACK_CONNECT,
        PatternData.of().i32(number).i32(meant ? SmartStatus.OK : SmartStatus.UNAVAILABLE).end()));
  }

  /** Tells all clients that the service ends, and ends their links. */
  @Override
  public void close() {
    listener.close();
    clients.values().forEach(client -> {
      client.send(SmartFrame.of(SmartCommand.SERVER_INITIATED_DISCONNECT, PatternData.of().i32(1).end()));
      client.link().finish();
    });
    clients.keySet().forEach(FrameLink::close);
    workers.join(System.nanoTime() + END.toNanos());
  }
}
