package org.robotui.yarp.internal;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PushbackInputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.time.Duration;
import java.util.Optional;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.CloseableSet;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.Sockets;
import org.robotui.net.socket.TcpListener;
import org.robotui.net.thread.Workers;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.BottleCodec;
import org.robotui.yarp.bottle.YarpFormatException;
import org.robotui.yarp.wire.YarpFraming;
import org.robotui.yarp.wire.YarpMessage;

/** Listens for a port or a name server: what comes says by its first byte which carrier it is. */
public final class PortDoor implements Closeable {
  private static final int MOST = 256;
  private static final int BUFFER = 1 << 14;
  private static final Duration GREETING = Duration.ofSeconds(5);
  private static final Duration REST_OF_MESSAGE = Duration.ofSeconds(10);
  private static final String SERVER = "NAME_SERVER ";
  private static final String PLAIN = "CONNECT ";
  private static final String ACKNOWLEDGED = "CONNACK ";

  private final Served served;
  private final TcpListener listener;
  private final DatagramInputs datagrams;
  private final CloseableSet connections = new CloseableSet();

  /** Listens at once. */
  public PortDoor(InetAddress address, int port, Workers workers, Served served) throws IOException {
    listener = TcpListener.bind(address, port);
    this.served = served;
    this.datagrams = new DatagramInputs(served, workers);
    String name = "yarp " + served.name();
    workers.start(name, () -> listener.acceptAll(name, socket -> accept(socket, workers, name)));
  }

  public int port() {
    return listener.port();
  }

  private void accept(Socket socket, Workers workers, String name) throws IOException {
    if (connections.size() >= MOST || !connections.add(socket)) {
      throw new IOException("there are " + MOST + " connections already");
    }
    Sockets.prepare(socket);
    workers.start(name + " from " + socket.getRemoteSocketAddress(), () -> serve(socket));
  }

  private void serve(Socket socket) {
    try {
      DeadlineInput timed = new DeadlineInput(socket, BUFFER);
      timed.within(GREETING);
      PushbackInputStream in = new PushbackInputStream(timed);
      int first = in.read();
      if (first < 0) {
        return;
      }
      in.unread(first);
      if (first == 'Y') {
        binary(timed, in, socket);
      } else {
        text(timed, in, socket.getOutputStream());
      }
    } catch (IOException e) {
      // who never said who it is, or a text connection that has ended
    } finally {
      connections.close(socket);
    }
  }

  private void binary(DeadlineInput timed, PushbackInputStream in, Socket socket) throws IOException {
    YarpFraming.Header header = YarpFraming.readHeader(in);
    if (header.carrier().datagrams()) {
      datagrams.open(header, socket, in);
      return;
    }
    OutputStream out = socket.getOutputStream();
    out.write(YarpFraming.mark(port()));
    served.opened(header.name());
    String reason = "it was closed";
    try {
      while (true) {
        timed.nextMessage(REST_OF_MESSAGE);
        YarpMessage message = YarpFraming.read(in);
        Optional<Bottle> reply = message.isData() ? served.data(header.name(), message) : Optional.empty();
        if (reply.isPresent()) {
          out.write(BottleCodec.bytes(reply.get()));
        }
        if (header.carrier().acknowledges()) {
          out.write(YarpFraming.mark(0));
        }
        if (message.command().equals("q")) {
          return;
        }
      }
    } catch (YarpFormatException e) {
      reason = "what came cannot be used: " + e.getMessage();
    } catch (IOException e) {
      reason = PeerText.brief(String.valueOf(e.getMessage()));
    } finally {
      served.ended(header.name(), reason);
    }
  }

  private void text(DeadlineInput timed, PushbackInputStream in, OutputStream out) throws IOException {
    String greeting = TextLines.read(in);
    if (greeting.startsWith(SERVER)) {
      String answer = served.names(greeting.substring(SERVER.length()))
          .orElseThrow(() -> new YarpFormatException(served.name() + " is no name server"));
      out.write(TextLines.bytes(answer));
      return;
    }
    boolean acknowledges = greeting.startsWith(ACKNOWLEDGED);
    if (!acknowledges && !greeting.startsWith(PLAIN)) {
      return;
    }
    String from = greeting.substring(PLAIN.length()).strip();
    out.write(TextLines.bytes("Welcome " + from + TextLines.END));
    timed.withoutDeadline();
    for (String line = TextLines.read(in); !line.equals("q"); line = TextLines.read(in)) {
      String answer = switch (line) {
        case "d" -> served.text(from, TextLines.read(in));
        case "a" -> served.admin(TextLines.read(in)) + TextLines.END;
        default -> served.command(line);
      };
      out.write(TextLines.bytes(answer + (acknowledges ? "<ACK>" + TextLines.END : "")));
    }
  }

  /** Takes nothing more of who says something by datagrams; false where it does not. */
  public boolean end(String from) {
    return datagrams.end(from);
  }

  @Override
  public void close() {
    listener.close();
    datagrams.close();
    connections.close();
  }
}
