package org.robotui.smartsoft.naming;

import java.io.Closeable;
import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.net.SocketFactory;
import org.robotui.message.CdrReader;
import org.robotui.message.CdrWriter;
import org.robotui.message.MessageException;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.HostPort;
import org.robotui.net.socket.Sockets;
import org.robotui.smartsoft.wire.NamingCommand;
import org.robotui.smartsoft.wire.SmartFrame;
import org.robotui.smartsoft.wire.SmartFraming;
import org.robotui.smartsoft.wire.SmartSoftException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * A link to a naming service. All but closing blocks until an answer is there, for a bounded time; after an error the
 * link is closed, and another has to be made. Safe for all threads.
 */
public final class NamingClient implements Closeable {

  /** What the addresses of services of ACE are entered as. */
  public static final String TYPE = "smartip";
  private static final String TYPES = "smart";
  private static final int BUFFER = 1 << 14;
  private static final int MOST_ENTRIES = 4096;

  private final HostPort at;
  private final Duration patience;
  private final Socket socket;
  private final DeadlineInput in;
  private final SmartFraming framing = new SmartFraming();

  private NamingClient(HostPort at, Duration patience, Socket socket) throws IOException {
    this.at = at;
    this.patience = patience;
    this.socket = socket;
    this.in = new DeadlineInput(socket, BUFFER);
  }

  /**
   * Links to a naming service.
   *
   * @param at where it listens
   * @param sockets makes the connection
   * @param patience how long connecting, and later each answer, may take
   * @return linked
   * @throws IOException where it is not reached
   */
  public static NamingClient connect(HostPort at, SocketFactory sockets, Duration patience) throws IOException {
    Socket socket = sockets.createSocket();
    try {
      at.connect(socket, patience);
      Sockets.prepare(socket);
      return new NamingClient(at, patience, socket);
    } catch (IOException | RuntimeException e) {
      Sockets.closeQuietly(socket);
      throw e;
    }
  }

  /**
   * All services that are entered. Entries that cannot be read are left out.
   *
   * @return in the order of the naming service
   * @throws IOException where no list comes
   */
  public synchronized List<NamedService> list() throws IOException {
    List<NamedService> found = new ArrayList<>();
    send(NamingCommand.LIST, SmartFrame.data().string(TYPES));
    for (SmartFrame frame = answer(); frame.command() != NamingCommand.END_OF_LIST; frame = next()) {
      if (frame.command() != NamingCommand.LIST || found.size() == MOST_ENTRIES) {
        throw failed(new SmartSoftException(at + " does not list services as a naming service of SmartSoft does"));
      }
      Entry entry = entry(frame);
      ServiceName.parse(entry.name()).flatMap(name -> named(name, entry.value())).ifPresent(found::add);
    }
    return found;
  }

  private static Optional<NamedService> named(ServiceName name, String value) {
    try {
      return Optional.of(new NamedService(name, ServiceAddress.parse(value)));
    } catch (SmartSoftException e) {
      return Optional.empty();
    }
  }

  /**
   * Where a service is.
   *
   * @param name of the service
   * @return empty where it is not entered
   * @throws IOException where no answer comes, or one that is no address
   */
  public synchronized Optional<ServiceAddress> resolve(ServiceName name) throws IOException {
    send(NamingCommand.RESOLVE, SmartFrame.data().string(name.toString()));
    SmartFrame frame = answer();
    return frame.command() == NamingCommand.RESOLVE ? Optional.of(ServiceAddress.parse(entry(frame).value()))
        : Optional.empty();
  }

  /**
   * Enters a service, in place of an entry of its name.
   *
   * @param name of the service
   * @param address where it is; the host 0.0.0.0 stands for that from which this link comes
   * @throws IOException where it is not entered
   */
  public synchronized void bind(ServiceName name, ServiceAddress address) throws IOException {
    send(NamingCommand.REBIND,
        SmartFrame.data().string(name.toString()).string(address.toString()).string(TYPE));
    done("enter", name);
  }

  /**
   * Removes a service.
   *
   * @param name of the service
   * @throws IOException where it is not removed, also where it was not there
   */
  public synchronized void unbind(ServiceName name) throws IOException {
    send(NamingCommand.UNBIND, SmartFrame.data().string(name.toString()));
    done("remove", name);
  }

  private void done(String what, ServiceName name) throws IOException {
    try {
      if (answer().reader().int32("status") != 0) {
        throw new SmartSoftException(at + " did not " + what + " " + name);
      }
    } catch (MessageException e) {
      throw failed(e);
    }
  }

  private record Entry(String name, String value) {}

  private Entry entry(SmartFrame frame) throws IOException {
    try {
      CdrReader reader = frame.reader();
      return new Entry(reader.string("name"), reader.string("value"));
    } catch (MessageException e) {
      throw failed(e);
    }
  }

  private void send(int command, CdrWriter said) throws IOException {
    SmartFrame frame = new SmartFrame(command, ByteOrder.LITTLE_ENDIAN, said.view(), ByteBuffer.allocate(0));
    try {
      socket.getOutputStream().write(framing.bytes(frame));
    } catch (IOException e) {
      throw failed(e);
    }
  }

  /** The first frame of an answer; all others of it have to come within the same time. */
  private SmartFrame answer() throws IOException {
    in.within(patience);
    return next();
  }

  private SmartFrame next() throws IOException {
    try {
      return framing.read(in);
    } catch (IOException e) {
      throw failed(e);
    }
  }

  /** What comes next may belong to anything: the link ends. */
  private IOException failed(Exception cause) {
    Sockets.closeQuietly(socket);
    return new IOException(at + ": " + cause.getMessage(), cause);
  }

  /**
   * Whether nothing can be asked any more.
   *
   * @return true after an error, and after closing
   */
  public boolean isOver() {
    return socket.isClosed();
  }

  @Override
  public void close() {
    Sockets.closeQuietly(socket);
  }
}
